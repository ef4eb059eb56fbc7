//! The first integral along the beam at the points of a path: what it spreads by is the error of a mesh between its points.

use crate::beam::planar::chain::NodeState;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::problem::beam_problem::{Beam, BeamProblem};
use crate::solve::newton::Solution;
use crate::solve::state::State;
use std::ops::Range;
use std::sync::Arc;

/// The largest spread of the first integral along the beam at any point of the path, over the work of adhesion: zero where
/// a mesh resolves the beam. Without a potential, along a beam of varying outline and on ground that is not flat there is
/// no such integral.
pub(super) fn worst_spread(problem: &BeamProblem, points: &[Arc<Solution>]) -> f64 {
    if !problem.system.is_conservative() {
        return 0.0;
    }
    let spread = |point: &Arc<Solution>| match &problem.beam {
        Beam::Planar(beam) => planar(beam, &point.at),
        Beam::Spatial(beam) => spatial(beam, &point.at),
    };
    points.iter().map(spread).fold(0.0, f64::max) / problem.beam.rest_adhesion().abs()
}

/// What is lost on the way shows at the two ends, and most of it is lost in the element at an edge.
fn at_ends(at: &State) -> [Range<usize>; 2] {
    let last = at.mesh.elements() - 1;
    [0..1, last..last + 1]
}

fn planar(beam: &PlanarBeam, at: &State) -> f64 {
    if matches!(beam.rest, ReferenceConfiguration::Varying(_)) || !beam.substrate.is_flat() {
        return 0.0;
    }
    let sections = at_ends(at).map(|elements| beam.chain.node_states(beam.configuration(at), elements));
    range(sections.iter().flatten().map(NodeState::first_integral))
}

/// Forces along the ground spread by round-off alone, up to 2e-9 of the adhesion in a strip that is 40 nm wide: what the first integral has of
/// that is taken off.
fn spatial(beam: &SpatialBeam, at: &State) -> f64 {
    let Some(rest_curvature) = beam.uniform_rest_curvature() else { return 0.0 };
    let sections = at_ends(at).map(|elements| beam.end_states(at, elements));
    let integrals: Vec<_> = sections.iter().flatten().map(|section| section.integrals(rest_curvature)).collect();
    let along = |k: usize| range(integrals.iter().map(|at| at.force[k]));
    (range(integrals.iter().map(|at| at.energy)) - along(0) - along(1)).max(0.0)
}

/// Largest less least.
fn range(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    high - low
}
