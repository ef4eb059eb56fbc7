//! The locus of pull-off of setae: the force on the root along the ground and off it, at the peaks and at the first detachments of a sweep.

use crate::chart::axis::Axis;
use crate::chart::axis::significant;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::chart::symbol::Symbol;
use crate::pictures::sweep::broken;
use crate::swept::{PullRow, SweptKeys};
use crate::writing::error::ReportError;
use peelkit::study::{SetaMoment, SetaResult};
use plotters::style::RGBColor;
use std::path::{Path, PathBuf};

/// Of the values of the second key, one after the other.
const COLOURS: [RGBColor; 5] = [colour::BLUE, colour::VERMILLION, colour::GREEN, colour::ORANGE, colour::INK];
/// The direction that is drawn beside them, degrees to the ground.
const GUIDE: f64 = 30.0;
/// A force along the ground below this share of the largest force is none.
const ALONG: f64 = 1e-3;

/// Force along the ground, forwards above zero, and off it, nN.
fn place(at: SetaMoment) -> (f64, f64) {
    let [x, y, z] = at.on_root;
    (x.hypot(z).copysign(x), y)
}

/// Draws `locus.svg` and `locus.png` into `dir`, where anything pulls along the ground; else nothing. Of two keys there is a line for each value of
/// the second one.
///
/// Fails where a file cannot be written ([`ReportError::Write`]).
pub(super) fn draw_locus(
    dir: &Path,
    keys: SweptKeys,
    rows: &[PullRow<SetaResult>],
    Heading { title, units }: Heading,
) -> Result<Vec<PathBuf>, ReportError> {
    let peaks: Vec<_> = rows.iter().filter_map(|row| row.peak().map(place)).collect();
    let largest = peaks.iter().map(|(along, up)| along.hypot(*up)).fold(0.0, f64::max);
    if peaks.iter().all(|(along, _)| along.abs() <= ALONG * largest) {
        return Ok(Vec::new());
    }
    save(&picture(keys, rows, title).in_units(units), dir, "locus")
}

fn picture(keys: SweptKeys, rows: &[PullRow<SetaResult>], title: &str) -> Picture {
    let mut values: Vec<Option<f64>> = Vec::new();
    for row in rows {
        if !values.contains(&row.second) {
            values.push(row.second);
        }
    }
    let (mut lines, mut marks) = (Vec::new(), Vec::new());
    for (&value, colour) in values.iter().zip(COLOURS.into_iter().cycle()) {
        let own: Vec<&PullRow<SetaResult>> = rows.iter().filter(|row| row.second == value).collect();
        let first =
            |row: &PullRow<SetaResult>| row.found.as_ref().ok().and_then(|found| found.first_detachment).map(place);
        let mut peaks = broken(own.iter().map(|row| row.peak().map(place)), Stroke::solid(colour, 2.0));
        if let (Some(line), Some(name)) = (peaks.first_mut(), name_of(keys, value)) {
            line.name = Some(name);
        }
        // one colour stands for both in the legend
        let named = |name: &str| (value == values[0]).then(|| name.to_owned());
        let mark = |symbol, name: &str, at| Mark { at, symbol, colour, name: named(name), note: None };
        let detached = own.iter().filter_map(|row| first(row));
        marks.extend(detached.map(|at| mark(Symbol::Diamond, "first detachment", at)));
        let tops = own.iter().filter_map(|row| row.peak().map(place));
        marks.extend(tops.map(|at| mark(Symbol::Dot, "peak force", at)));
        lines.extend(peaks);
    }
    let all = |of: fn(&(f64, f64)) -> f64| marks.iter().map(move |mark: &Mark| of(&mark.at)).chain([0.0]);
    let x = Axis::around("force along the ground (nN)", all(|at| at.0), false);
    let y = Axis::around("force off the ground (nN)", all(|at| at.1), false);
    lines.extend(guide(&x, &y));
    let frame = Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: 420.0 };
    Picture { title: title.into(), height: 474, panels: vec![Panel { lines, marks, ..Panel::new(frame, x, y) }] }
}

/// What the second key is, with its value.
fn name_of(keys: SweptKeys, value: Option<f64>) -> Option<String> {
    let (key, value) = (keys.second?, value?);
    let number = significant(value * key.per_usual_unit(), 4);
    let short = if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { &number };
    Some(format!("{}: {short}", key.axis_title()))
}

/// From the origin on, as far as both axes go.
fn guide(x: &Axis, y: &Axis) -> Option<Line> {
    let slope = GUIDE.to_radians().tan();
    let far = x.to.min(y.to / slope);
    let name = Some(format!("{GUIDE} degrees to the ground"));
    let points = vec![(0.0, 0.0), (far, slope * far)];
    (far > 0.0).then(|| Line { points, stroke: Stroke::dotted(colour::GREY, 2.0), name })
}
