//! Extrapolation along the path with the order and the step that measured errors allow.
//!
//! Stored points are compared at equal mesh coordinates, so nothing is interpolated between meshes. Along the path they
//! are labelled by one linear functional of the observables, the same for all points of one prediction, so that labels
//! are a smooth function of position.

use crate::number::root::Bracket;
use crate::solve::newton::Solution;
use crate::solve::problem::Problem;
use crate::solve::state::{MONITORS, State, weighted_sum};
use std::sync::Arc;

/// The most points an extrapolation uses.
pub const MOST_POINTS: usize = 8;

/// Share of the force's relative error in that of a prediction: Newton's method does not mind it, the curve does.
const FORCE: f64 = 0.3;

/// Lagrange weights at `at` for the nodes `labels`.
pub(crate) fn lagrange_weights(labels: &[f64], at: f64) -> Vec<f64> {
    (0..labels.len())
        .map(|i| (0..labels.len()).filter(|&j| j != i).map(|j| (at - labels[j]) / (labels[i] - labels[j])).product())
        .collect()
}

/// Combination of stored points with the given weights; the mesh follows the combined monitors.
pub(crate) fn combine(problem: &Problem, points: &[Arc<Solution>], weights: &[f64]) -> State {
    on_mesh_of(problem, points, weights, followed(problem, points, weights))
}

/// The state a step on from the newest point, extrapolated through the newest `count` points; the mesh moves on even where a single point is
/// taken, because the error of a prediction is measured on the mesh that its solution has.
pub(crate) fn predicted(problem: &Problem, points: &[Arc<Solution>], labels: &[f64], count: usize, step: f64) -> State {
    let moving = count.max(2).min(points.len());
    let followed = followed(problem, &points[..moving], &lagrange_weights(&labels[..moving], step));
    on_mesh_of(problem, &points[..count], &lagrange_weights(&labels[..count], step), followed)
}

/// What a mesh follows, extrapolated: the monitors, and the numbers of its own.
fn followed(problem: &Problem, points: &[Arc<Solution>], weights: &[f64]) -> ([f64; MONITORS], Vec<f64>) {
    let mut monitors = [0.0; MONITORS];
    for (point, &weight) in points.iter().zip(weights) {
        (0..MONITORS).for_each(|k| monitors[k] += weight * point.observables.monitors[k]);
    }
    let own: Vec<&[f64]> = points.iter().map(|point| &*point.aligned(problem).mesh.follows).collect();
    (monitors, weighted_sum(&own, weights))
}

fn on_mesh_of(
    problem: &Problem,
    points: &[Arc<Solution>],
    weights: &[f64],
    (monitors, follows): ([f64; MONITORS], Vec<f64>),
) -> State {
    let states: Vec<&[f64]> = points.iter().map(|point| &*point.aligned(problem).values).collect();
    let force = points.iter().zip(weights).fold(0.0, |sum, (point, &weight)| sum + weight * point.at.force);
    State {
        mesh: problem.system.mesh_for(monitors, &follows, &points[0].at.mesh),
        values: problem.system.combine(&states, weights),
        force,
        history: points[0].at.history.clone(),
    }
}

/// Errors at `solution` of the extrapolations through the newest 1, 2, … points (newest first, at `labels`), relative as
/// in [`crate::solve::System::size`], or of the force, relative to itself and its scale.
pub(crate) fn errors(
    problem: &Problem,
    points: &[Arc<Solution>],
    labels: &[f64],
    solution: &Solution,
    at: f64,
) -> Vec<f64> {
    let force_scale = solution.at.force.abs() + problem.measure.force;
    let aligned = solution.aligned(problem);
    let reached = &*aligned.values;
    let per_unit = problem.system.per_unit(aligned);
    let states: Vec<&[f64]> = points.iter().map(|point| &*point.aligned(problem).values).collect();
    let mut update = Vec::with_capacity(reached.len());
    (1..=points.len())
        .map(|count| {
            let weights = lagrange_weights(&labels[..count], at);
            let mut force = solution.at.force;
            for (point, weight) in points[..count].iter().zip(&weights) {
                force -= weight * point.at.force;
            }
            problem.system.miss(reached, &states[..count], &weights, &mut update);
            largest(&update, &per_unit, FORCE * force.abs() / force_scale)
        })
        .collect()
}

/// Numbers that are compared side by side.
const LANES: usize = 8;

/// The largest of `least` and of the sizes of `update`, each times its unit; one that is no number counts nothing.
fn largest(update: &[f64], per_unit: &[f64], least: f64) -> f64 {
    let larger = |largest: f64, size: f64| if size > largest { size } else { largest };
    let ((updates, rest), (units, units_rest)) = (update.as_chunks::<LANES>(), per_unit.as_chunks::<LANES>());
    let mut sizes = [least; LANES];
    for (update, unit) in updates.iter().zip(units) {
        for l in 0..LANES {
            sizes[l] = larger(sizes[l], (update[l] * unit[l]).abs());
        }
    }
    let rest = rest.iter().zip(units_rest).map(|(update, unit)| (update * unit).abs());
    sizes.into_iter().chain(rest).fold(least, larger)
}

/// The longest step that keeps the error of an extrapolation through `count` points at `tolerance`, given the error it
/// made at the newest point. `labels`: of the newest point (0) and those behind it (negative), newest first.
///
/// The error of an extrapolation is proportional to the product of the distances from its points.
pub fn longest_step(labels: &[f64], count: usize, error: f64, tolerance: f64, most: f64) -> f64 {
    let product = |at: f64| distances(labels, count, at);
    let allowed = tolerance * last_distances(labels, count) / error.max(f64::MIN_POSITIVE);
    if product(most) <= allowed {
        return most;
    }
    // a step need not be sharp
    let is_short = |step: f64| product(step) <= allowed;
    Bracket { low: 0.0, high: most }.bisected(is_short, |left| left.width() <= 1e-2 * left.high).low
}

/// The error that an extrapolation through `count` points is expected to make a step on, given the one that it made at the newest point.
pub(crate) fn expected_error(labels: &[f64], count: usize, error: f64, step: f64) -> f64 {
    error * distances(labels, count, step) / last_distances(labels, count)
}

/// Product of the distances from the newest `count` points.
fn distances(labels: &[f64], count: usize, at: f64) -> f64 {
    labels[..count].iter().map(|label| at - label).product()
}

/// The same of the newest point from the `count` points before it.
fn last_distances(labels: &[f64], count: usize) -> f64 {
    labels[1..=count].iter().map(|label| labels[0] - label).product()
}
