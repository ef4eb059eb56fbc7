//! The picture of the steps before a pull: force along the pull against how far the grip has come in its direction, and the pull behind them.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::writing::error::ReportError;
use peelkit::beam::GripState;
use peelkit::study::Peel;
use plotters::style::RGBColor;
use std::path::{Path, PathBuf};

const HEIGHT: u32 = 440;
/// Colours of the steps, again and again; the pull is blue.
const COLOURS: [RGBColor; 3] = [colour::ORANGE, colour::GREEN, colour::INK];
/// A pull is drawn up to so many times as far as the steps have gone.
const AS_FAR: f64 = 3.0;
/// Points with which each segment of the pull is drawn.
const DENSE: usize = 8;

/// Draws `steps.svg` and `steps.png` into `dir`, where the steps move the grip along the pull: displacement and force count from where it took hold. No
/// files where they do not, or where the grip is free in the direction of the pull.
///
/// Fails where a file cannot be written ([`ReportError::Write`]).
pub fn draw_steps<'h>(peel: &Peel, heading: impl Into<Heading<'h>>, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    match picture(peel, heading.into()) {
        Some(picture) => save(&picture, dir, "steps"),
        None => Ok(Vec::new()),
    }
}

fn picture(peel: &Peel, Heading { title, units }: Heading) -> Option<Picture> {
    let along = |way: &Vec<GripState>| -> Option<Vec<(f64, f64)>> {
        way.iter().map(|grip| peel.model.along_pull(grip).map(|[u, force]| (u, force))).collect()
    };
    let ways: Vec<Vec<(f64, f64)>> = peel.step_ways.iter().map(along).collect::<Option<_>>()?;
    let (low, high) = range(ways.iter().flatten());
    if high - low <= 0.0 {
        return None;
    }
    let pull = pull(peel, ways.last()?.last()?.0, high + (AS_FAR - 1.0) * (high - low));
    let lines = ways.iter().chain([&pull]);
    let x = Axis::around(
        "displacement along the pull, from the first step (nm)",
        lines.clone().flatten().map(|at| at.0),
        false,
    );
    let y = Axis::around("force P (nN)", lines.flatten().map(|at| at.1).chain([0.0]), false);
    let frame = Frame { left: 84.0, top: 40.0, right: f64::from(WIDTH) - 14.0, bottom: f64::from(HEIGHT) - 56.0 };
    let mut panel = Panel::new(frame, x.in_units(units), y.in_units(units));
    let zero = vec![(panel.x.from, 0.0), (panel.x.to, 0.0)];
    panel.lines.push(Line { points: zero, stroke: Stroke::solid(colour::GREY, 0.9), name: None });
    for (index, (way, step)) in ways.iter().zip(&peel.model.steps).enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let name = Some(format!("{}: {step}", index + 1));
        panel.lines.push(Line { points: way.clone(), stroke: Stroke::solid(colour, 3.0), name });
        panel.marks.extend(way.last().map(|&at| Mark::dot(at, colour)));
    }
    // thin, over the steps: where they coincide both are seen
    let name = (!pull.is_empty()).then(|| "pull".to_owned());
    panel.lines.push(Line { points: pull, stroke: Stroke::solid(colour::BLUE, 1.4), name });
    Some(Picture { title: title.into(), height: HEIGHT, panels: vec![panel] })
}

/// The pull behind the steps, which have moved the grip so far along it, as long as it is stable and up to this displacement.
fn pull(peel: &Peel, moved: f64, to: f64) -> Vec<(f64, f64)> {
    let curve = peel.dense_curve(DENSE);
    let first = curve.first().map(|at| at.2);
    let shown = curve.iter().take_while(|at| Some(at.2) == first && moved + at.0 <= to);
    shown.map(|&(u, force, _)| (moved + u, force)).collect()
}

fn range<'a>(points: impl Iterator<Item = &'a (f64, f64)>) -> (f64, f64) {
    points.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at.0), high.max(at.0)))
}
