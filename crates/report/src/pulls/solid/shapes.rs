//! The whole solid from the side at some points of its path, as a beam is shown.

use super::fields::chosen;
use crate::chart::picture::{Heading, Picture};
use crate::pictures::shapes::posed::{Posed, shapes_picture};
use peelkit::study::{DeformedShape, SolidPeel, SolidPoint};

/// Fronts that are nearer to one another than this share of what adheres are one picture.
const APART: f64 = 0.05;
/// Distance of the points of an outline, over the thickness of the free end.
const SPACING: f64 = 1.0;

/// At rest, where half of it is off, at its peak, and at the end, as far as the path comes.
pub(super) fn shapes(peel: &SolidPeel, heading: Heading) -> Picture {
    let (first, last) = (peel.points.first(), peel.points.last());
    let between = chosen(peel).into_iter().map(|(_, at)| at);
    let mut shown: Vec<&SolidPoint> = first.into_iter().chain(between).chain(last).collect();
    let apart = APART * peel.body.adhering_length();
    shown.dedup_by(|next, before| (next.front - before.front).abs() < apart);
    let pose = |(k, at): (usize, &&SolidPoint)| Posed {
        number: k + 1,
        displacement: at.displacement,
        force: at.force,
        axis: axis(peel, at),
        thickness: 1.0,
    };
    shapes_picture(&shown.iter().enumerate().map(pose).collect::<Vec<_>>(), peel.body.substrate(), heading)
}

/// The middle of its thickness, with what is above and below it: a spatula is shown in its plane of symmetry.
fn axis(peel: &SolidPeel, at: &SolidPoint) -> DeformedShape {
    let ((places, _), faces) = (peel.body.mesh_lines(), peel.body.faces());
    let mut shape =
        DeformedShape { x: Vec::new(), y: Vec::new(), z: Vec::new(), rotation: Vec::new(), height: Vec::new() };
    let fine = SPACING * peel.body.thickness();
    let within = |pair: &[f64]| {
        let (from, length) = (pair[0], pair[1] - pair[0]);
        let parts = (length / fine).ceil().max(1.0);
        (0..parts as usize).map(move |k| from + length * k as f64 / parts)
    };
    let places = places.windows(2).flat_map(within).chain(places.last().copied());
    for s in places {
        let [[x0, y0], [x1, y1]] = faces.map(|face| peel.body.place_at(at.values(), [s, face]));
        shape.x.push(0.5 * (x0 + x1));
        shape.y.push(0.5 * (y0 + y1));
        shape.rotation.push((x0 - x1).atan2(y1 - y0));
        shape.height.push((x1 - x0).hypot(y1 - y0));
    }
    shape
}
