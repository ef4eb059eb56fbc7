//! The picture of the law of a seta: what holds its root over the displacement, along each pull, with its first exit.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{colour, order_shade};
use crate::records::of_many::seta_law::SetaLawFound;
use crate::writing::error::ReportError;
use peelkit::study::coarsening::{ExitPlane, SetaLaw};
use std::path::{Path, PathBuf};

/// Pieces of a curve on one sheet.
const PIECES: usize = 30;
/// Most equilibria of a pull that are shown.
const DOTS: f64 = 24.0;
/// What is nothing, over the largest force: an axis then shows so much on both sides of zero.
const SMALL: f64 = 0.05;

/// Draws `seta_law.svg` and `seta_law.png` into `dir`: the force off the ground and along it, of the law and of the resolved seta.
///
/// Fails where a file cannot be written ([`ReportError::Write`]).
pub fn draw_seta_law<'h>(
    found: &SetaLawFound,
    heading: impl Into<Heading<'h>>,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let (law, Heading { title, units }) = (&found.law, heading.into());
    let caption = format!(
        "Lines: the law of {}, its peaks within {:.1} %. Dots: the resolved seta. Dashed: the first tip lets go.",
        if law.sheets.len() == 1 { "one sheet".to_owned() } else { format!("{} sheets", law.sheets.len()) },
        100.0 * law.errors.peak
    );
    let panels = vec![panel(found, 0, 1, "normal force (nN)"), panel(found, 1, 0, "force along the ground (nN)")];
    save(&Picture::of(&format!("{title}\n{caption}"), panels).in_units(units), dir, "seta_law")
}

/// A component of the force over how far the root is pulled.
fn panel(found: &SetaLawFound, index: usize, component: usize, label: &str) -> Panel {
    let SetaLawFound { law, paths, .. } = found;
    let (mut lines, mut marks) = (Vec::new(), Vec::new());
    for (k, (angle, path)) in paths.iter().enumerate() {
        let shade = order_shade(k, paths.len());
        let points = pulled(law, *angle, component);
        // one legend for both panels
        let name = (index == 0).then(|| format!("at {:.0} deg", angle.to_degrees()));
        lines.push(Line { points, stroke: Stroke::solid(shade, 1.6), name });
        let dots = path.points.iter().map(|point| (point.root[0].hypot(point.root[1]), point.force[component]));
        marks.extend(apart(dots.collect()).into_iter().map(|at| Mark::dot(at, shade)));
    }
    let angles = || paths.iter().map(|(angle, _)| *angle);
    let (least, most) = (angles().fold(f64::INFINITY, f64::min), angles().fold(f64::NEG_INFINITY, f64::max));
    let ends = (0..=PIECES).filter_map(|piece| {
        let angle = least + (most - least) * piece as f64 / PIECES as f64;
        Some(force(law, 0, angle, exit(&law.first_exit(), angle)?, component))
    });
    lines.push(Line::plain(ends.collect(), Stroke::dashed(colour::INK, 1.4)));
    let all = || lines.iter().flat_map(|line| &line.points).chain(marks.iter().map(|mark| &mark.at));
    let x = Axis::around("displacement of the root (nm)", all().map(|at| at.0), false);
    // a force that is nothing beside the other one looks like nothing
    let small = SMALL * all().map(|at| at.1.abs()).fold(law.largest_force, f64::max);
    let beside = [-small, small].into_iter().filter(|_| all().all(|at| at.1.abs() < small));
    let y = Axis::around(label, all().map(|at| at.1).chain(beside), false);
    Panel { lines, marks, ..Panel::new(Frame::column(index, 2), x, y) }
}

/// The last of the points, just before the loss, and of those before it the ones that are not too near to one another.
fn apart(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    let gap = points.last().map_or(0.0, |last| last.0 / DOTS);
    for at in points.into_iter().rev() {
        if kept.last().is_none_or(|before| before.0 - at.0 >= gap) {
            kept.push(at);
        }
    }
    kept
}

/// How far the root is pulled at an angle until it is on a plane, nm; none where that leads away from it.
fn exit(plane: &ExitPlane, angle: f64) -> Option<f64> {
    plane.ahead([0.0; 2], [angle.cos(), angle.sin()])
}

/// A component of the force of the law on a sheet where the root is pulled so far at an angle.
fn force(law: &SetaLaw, sheet: usize, angle: f64, displacement: f64, component: usize) -> (f64, f64) {
    let root = [displacement * angle.cos(), displacement * angle.sin()];
    (displacement, law.response(sheet, root).force[component])
}

/// The force along a pull until the seta is detached, sheet by sheet.
fn pulled(law: &SetaLaw, angle: f64, component: usize) -> Vec<(f64, f64)> {
    let (mut points, mut from) = (Vec::new(), 0.0);
    for (number, sheet) in law.sheets.iter().enumerate() {
        let Some(until) = exit(&sheet.exit, angle) else { return points };
        if until > from {
            let at = |piece: usize| from + (until - from) * piece as f64 / PIECES as f64;
            points.extend((0..=PIECES).map(|piece| force(law, number, angle, at(piece), component)));
            from = until;
        }
    }
    points.push((from, 0.0));
    points
}
