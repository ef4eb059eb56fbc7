//! The picture of the law of a tip: the normal force over the displacement, with the limits.

use crate::chart::axis::{Axis, significant};
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{colour, order_shade};
use crate::chart::symbol::Symbol;
use crate::writing::error::ReportError;
use peelkit::study::coarsening::{PadEnd, Sheet, TipPlace, TipSheet, TipTable};
use std::path::{Path, PathBuf};

/// Curves in a panel, and points of each.
const CURVES: usize = 5;
const POINTS: usize = 240;
/// A branch that is shorter than this share of the other one cannot be seen.
const SHORT: f64 = 0.1;

/// Draws `tip_law.svg` and `tip_law.png` into `dir`: the normal force at several rotations, and beside it at several v, or the moment where the pad slides.
///
/// Fails where a file cannot be written ([`ReportError::Write`]).
pub fn draw_tip_law<'h>(
    table: &TipTable,
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let range = &table.options.range;
    let rotations: Vec<Place> = spread(range.rotation)
        .map(|rotation| {
            (TipPlace { rotation, ..TipPlace::default() }, Some(format!("θ = {} rad", significant(rotation, 2))))
        })
        .collect();
    let force = |index: usize, places: &[Place]| panel(table, index, places, 0, "normal force P (nN)");
    let second = match table.options.pad_end {
        // the legend of the first panel is that of both
        PadEnd::Sliding => {
            let unnamed: Vec<Place> = rotations.iter().map(|(place, _)| (*place, None)).collect();
            panel(table, 1, &unnamed, 2, "moment M (nN nm)")
        }
        PadEnd::Held => {
            let lateral = spread(range.lateral).map(|lateral| {
                (TipPlace { lateral, ..TipPlace::default() }, Some(format!("v = {} nm", significant(lateral, 2))))
            });
            force(1, &lateral.collect::<Vec<_>>())
        }
    };
    let Heading { title, units } = heading.into();
    save(&Picture::of(title, vec![force(0, &rotations), second]).in_units(units), dir, "tip_law")
}

/// Evenly over a range.
fn spread([from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..CURVES).map(move |k| from + (to - from) * k as f64 / (CURVES - 1) as f64)
}

/// Where a curve is drawn, and its name in the legend.
type Place = (TipPlace, Option<String>);

fn panel(table: &TipTable, index: usize, places: &[Place], component: usize, label: &str) -> Panel {
    let (mut lines, mut marks) = (Vec::new(), Vec::new());
    for (k, (place, name)) in places.iter().enumerate() {
        let shade = order_shade(k, places.len());
        let attached = curve(&table.attached, *place, component);
        marks.extend(attached.last().map(|&at| Mark {
            at,
            symbol: Symbol::Diamond,
            colour: colour::VERMILLION,
            name: name.as_ref().map(|_| "snaps off".to_owned()),
            note: None,
        }));
        let far = width(&attached);
        lines.push(Line { points: attached, stroke: Stroke::solid(shade, 1.8), name: name.clone() });
        let detached = curve(table.sheet(TipSheet::Detached), *place, component);
        // a table that ends where the tip lets go has no more than a dot of it
        if width(&detached) > SHORT * far {
            let name = name.as_ref().map(|_| "detached".to_owned());
            lines.push(Line { points: detached, stroke: Stroke::dotted(shade, 1.6), name });
        }
    }
    let all = || lines.iter().flat_map(|line| line.points.iter());
    let x = Axis::around("displacement u (nm)", all().map(|at| at.0), false);
    let y = Axis::around(label, all().map(|at| at.1), false);
    Panel { lines, marks, ..Panel::new(Frame::column(index, 2), x, y) }
}

/// How far a curve goes in x.
fn width(curve: &[(f64, f64)]) -> f64 {
    curve.first().zip(curve.last()).map_or(0.0, |(first, last)| (last.0 - first.0).abs())
}

/// A component of the forces along a branch.
fn curve(sheet: &Sheet, place: TipPlace, component: usize) -> Vec<(f64, f64)> {
    let [begin, end] = sheet.ends(place);
    let at = |k: usize| {
        // finer towards the limit, where the force has a vertical tangent
        let left = 1.0 - k as f64 / POINTS as f64;
        let normal = end - (end - begin) * left * left;
        (normal, sheet.response(TipPlace { normal, ..place }).force[component])
    };
    (0..=POINTS).map(at).collect()
}
