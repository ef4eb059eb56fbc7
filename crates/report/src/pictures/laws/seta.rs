//! The picture of the law of a seta: what holds its root over the displacement, along each pull, with the exit.

use crate::chart::axis::Axis;
use crate::chart::canvas::Stroke;
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{colour, order_shade};
use crate::records::of_many::seta_law::SetaLawFound;
use crate::writing::error::ReportError;
use peelkit::study::coarsening::{SetaLaw, SetaSheet};
use std::path::{Path, PathBuf};

/// Pieces of a curve.
const PIECES: usize = 60;
/// Most equilibria of a pull that are shown.
const DOTS: f64 = 12.0;
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
        "Lines: the law of degree {}, within {:.2} % of the largest force. Dots: the resolved seta. Dashed: the first tip lets go.",
        law.degree,
        100.0 * law.errors.force
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
        let points = exit(law, *angle).into_iter().flat_map(|end| {
            (0..=PIECES).map(move |piece| force(law, *angle, end * piece as f64 / PIECES as f64, component))
        });
        // one legend for both panels
        let name = (index == 0).then(|| format!("at {:.0} deg", angle.to_degrees()));
        lines.push(Line { points: points.collect(), stroke: Stroke::solid(shade, 1.6), name });
        let dots = path.points.iter().map(|point| (point.root[0].hypot(point.root[1]), point.force[component]));
        marks.extend(apart(dots.collect()).into_iter().map(|at| Mark::dot(at, shade)));
    }
    let angles = || paths.iter().map(|(angle, _)| *angle);
    let (least, most) = (angles().fold(f64::INFINITY, f64::min), angles().fold(f64::NEG_INFINITY, f64::max));
    let ends = (0..=PIECES).filter_map(|piece| {
        let angle = least + (most - least) * piece as f64 / PIECES as f64;
        Some(force(law, angle, exit(law, angle)?, component))
    });
    lines.push(Line::plain(ends.collect(), Stroke::dashed(colour::INK, 1.4)));
    let all = || lines.iter().flat_map(|line| &line.points).chain(marks.iter().map(|mark| &mark.at));
    let x = Axis::around("displacement of the root (nm)", all().map(|at| at.0), false);
    // a force that is nothing beside the other one looks like nothing
    let small = SMALL * law.largest_force;
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

/// How far the root is pulled at an angle until the first tip lets go, nm; none where that leads away from the exit plane.
fn exit(law: &SetaLaw, angle: f64) -> Option<f64> {
    let [along, normal] = law.exit.direction;
    let nearer = angle.cos() * along + angle.sin() * normal;
    (nearer > 0.0).then(|| law.exit.distance / nearer)
}

/// A component of the force of the law where the root is pulled so far at an angle.
fn force(law: &SetaLaw, angle: f64, displacement: f64, component: usize) -> (f64, f64) {
    let root = [displacement * angle.cos(), displacement * angle.sin()];
    (displacement, law.response(SetaSheet::Adhering, root).force[component])
}
