//! A planar equilibrium as a state of the same strip in space.

use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::spatial::end_rotation::{EndRotation, turned};
use crate::beam::spatial::rest::ALONG_X;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::number::gauss::Rule;
use crate::solve::state::{Mesh, State};
use std::num::NonZeroUsize;

/// Points of the rule with which x' is integrated from node to node.
const POINTS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(7);

/// A planar state, whose front is at S = `front` (nm), on so many elements in space: y and θ as they are, x by
/// quadrature of x', no z, yaw or roll. It is an equilibrium up to what the two kinds of elements differ by.
pub(super) fn embedded(
    (planar, at): (&PlanarBeam, &State),
    spatial: &SpatialBeam,
    front: f64,
    elements: usize,
) -> State {
    let at_front = on_mesh((planar, at), spatial, spatial.mesh_at(front, [0.0; 2], elements));
    let edges = spatial.edges(&at_front, front);
    if edges == [0.0; 2] { at_front } else { on_mesh((planar, at), spatial, spatial.mesh_at(front, edges, elements)) }
}

/// The same on a mesh.
fn on_mesh((planar, at): (&PlanarBeam, &State), spatial: &SpatialBeam, mesh: Mesh) -> State {
    let (rule, order) = (Rule::new(POINTS), spatial.chain.order());
    let (mut values, mut x, mut before) = (Vec::new(), 0.0, 0.0);
    let mut rotations = [0.0; 2];
    for (element, pair) in mesh.boundaries.windows(2).enumerate() {
        let last = usize::from(element + 2 == mesh.boundaries.len());
        for rank in 0..order + last {
            let place = pair[0] + spatial.chain.node_fraction(rank) * (pair[1] - pair[0]);
            x += rule.over(before, place).map(|(s, weight)| weight * planar_at(planar, at, s)[2]).sum::<f64>();
            before = place;
            let [y, rotation, _] = planar_at(planar, at, place);
            values.extend([x, y, 0.0]);
            values.extend(turned([rotation, 0.0, 0.0], ALONG_X));
            rotations[usize::from(place > 0.0)] = rotation;
        }
    }
    for (end, rotation) in spatial.chain.ends.iter().zip(rotations) {
        let own = if end.rotation == EndRotation::Angles { rotation } else { 0.0 };
        values.extend([own, 0.0, 0.0]);
    }
    State { mesh, values, force: at.force, history: None }
}

/// y of the axis, θ and x' at S, of a planar state.
fn planar_at(beam: &PlanarBeam, at: &State, place: f64) -> [f64; 3] {
    let ends = &at.mesh.boundaries;
    let element = ends.partition_point(|&end| end <= place).clamp(1, at.mesh.elements()) - 1;
    let local = 2.0 * (place - ends[element]) / (ends[element + 1] - ends[element]) - 1.0;
    let (values, section) = beam.chain.sample(beam.configuration(at), element, local);
    [values[beam.rotation - 1] + 0.5 * beam.height_at(place), values[beam.rotation], section.horizontal_slope]
}
