//! The picture of several results.

use super::measured::Measured;
use super::result::{Kind, ResultFile};
use crate::chart::RGBColor;
use crate::chart::axis::Axis;
use crate::chart::canvas::{Dash, Stroke};
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::chart::symbol::Symbol;
use crate::writing::error::ReportError;
use std::path::{Path, PathBuf};

const HEIGHT: u32 = 470;
/// Of the results, in their order: Okabe and Ito's palette.
const COLOURS: [RGBColor; 7] = [
    colour::BLUE,
    colour::VERMILLION,
    colour::GREEN,
    colour::ORANGE,
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    colour::GREY,
];

/// Draws `plot.svg` and `plot.png` into `dir`: results of one kind with a legend, what is unstable under displacement control dashed, and
/// measured points over them. Axes are logarithmic where `log` says so, x first.
///
/// Fails where there is nothing to draw ([`ReportError::Draw`]) or a file cannot be written ([`ReportError::Write`]).
pub fn draw_overlay<'h>(
    results: &[ResultFile],
    measured: &[Measured],
    heading: impl Into<Heading<'h>>,
    log: [bool; 2],
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let Some(first) = results.first() else {
        return Err(ReportError::Draw { path: dir.join("plot.svg"), reason: "there are no results".into() });
    };
    let Heading { title, units } = heading.into();
    let key = first.key;
    let scale = key.map_or(1.0, |key| key.per_usual_unit());
    let titles = match first.kind {
        Kind::Curve => ("displacement u (nm)".to_owned(), "force P (nN)"),
        Kind::Sweep => (key.map_or_else(|| "varied value".to_owned(), |key| key.axis_title()), "peak force P (nN)"),
    };
    let scaled = |points: &[(f64, f64)]| -> Vec<(f64, f64)> { points.iter().map(|&(x, y)| (scale * x, y)).collect() };
    let mut panel = Panel::new(
        Frame { left: 88.0, top: 40.0, right: f64::from(WIDTH) - 18.0, bottom: f64::from(HEIGHT) - 56.0 },
        Axis::linear("", 0.0, 1.0),
        Axis::linear("", 0.0, 1.0),
    );
    for (index, result) in results.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let mut name = Some(result.name.clone());
        for (unstable, points) in &result.pieces {
            let stroke = if *unstable { Stroke::dashed(colour, 1.8) } else { Stroke::solid(colour, 1.8) };
            let name = if *unstable { None } else { name.take() };
            panel.lines.push(Line { points: scaled(points), stroke, name });
        }
        // one that is unstable from its beginning on has a name as well
        if let (Some(name), Some(line)) = (name, panel.lines.last_mut()) {
            line.name = Some(name);
        }
    }
    for (index, points) in measured.iter().enumerate() {
        let symbol = [Symbol::Dot, Symbol::Diamond, Symbol::Triangle][index % 3];
        let mark = |at| Mark { at, symbol, colour: colour::INK, name: Some(points.name.clone()), note: None };
        panel.marks.extend(scaled(&points.points).into_iter().map(mark));
    }
    let at = || panel.lines.iter().flat_map(|line| &line.points).copied().chain(panel.marks.iter().map(|mark| mark.at));
    let x = Axis::around(&titles.0, at().map(|point| point.0), log[0]);
    let y = Axis::around(titles.1, at().map(|point| point.1), log[1]);
    (panel.x, panel.y) = (x, y);
    let dashed = panel.lines.iter().any(|line| line.stroke.dash == Dash::Dashed);
    let caption = if dashed { "\nDashed: unstable under displacement control." } else { "" };
    let picture = Picture { title: format!("{title}{caption}"), height: HEIGHT, panels: vec![panel] };
    save(&picture.in_units(units), dir, "plot")
}
