//! The run behind [`super::peel`]: a mesh from the accuracy asked for, the path on it, and, where the error bounds say
//! so, a finer mesh and the path again.

use super::follow::{Followed, Unusable, follow};
use super::plateau::plateau;
use super::trace::Trace;
use super::{Accuracy, Bounds, Effort, End, LimitPoint, PathPoint, Peak, Peel};
use crate::model::{Form, StripModel};
use crate::solve::{
    Equilibrium, PathOptions, Problem, Solution, Stretch, Turn, Workspace, difference_on_twice_the_elements,
};
use std::sync::Arc;
use std::time::Instant;

/// Error bounds are the difference to twice the elements times this.
const SAFETY: f64 = 1.5;
/// Round-off of a reported number, relative; see `verification/README.md`.
const ROUND_OFF: f64 = 2e-12;
/// How much the place of a turn of the force counts behind the first one: on a plateau it is ill-conditioned, and its own
/// error bound says how much.
const WEAK: f64 = 1e-2;
/// Most meshes tried.
const MOST_MESHES: usize = 8;
/// Most elements of a mesh.
const MOST_ELEMENTS: usize = 400;

/// Elements and steps for an accuracy.
#[derive(Clone, Copy, Debug)]
struct Resolution {
    order: usize,
    elements: usize,
    step_tolerance: f64,
}

impl Resolution {
    fn first(model: &StripModel, relative: f64) -> Self {
        let order = if relative > 3e-4 { 5 } else { 7 };
        let span = (model.strip.length / model.process_length()).max(1.0).asinh();
        let digits = -relative.log10();
        let elements = (2.0 + span * (0.6 + 0.23 * digits)).ceil() as usize;
        let elements = std::env::var("NE").map_or(elements, |v| v.parse().unwrap());
        let order = std::env::var("OR").map_or(order, |v| v.parse().unwrap());
        let st = std::env::var("ST").map_or(1e-2, |v| v.parse().unwrap());
        Self { order, elements: elements.clamp(4, MOST_ELEMENTS), step_tolerance: st }
    }

    /// Finer, by what the theory of order 2p asks for to reduce an error of `worst` times the wanted one.
    fn finer(self, worst: f64) -> Self {
        let growth = (1.5 * worst).powf(0.5 / self.order as f64).clamp(1.2, 2.0);
        Self { elements: (self.elements as f64 * growth).ceil() as usize, ..self }
    }
}

/// Follows the peel from rest to its end.
pub(super) fn run(model: &StripModel, accuracy: &Accuracy, bounds: &Bounds) -> Peel {
    let started = Instant::now();
    let mut resolution = Resolution::first(model, accuracy.relative);
    let problem = Arc::new(model.problem(Form::TwoField, resolution.order));
    let far = 10.0 * model.adhesion.equilibrium_distance;
    let mut best: Option<Peel> = None;
    let mut iterations = 0;
    let mut trouble = String::new();
    for _ in 0..(if std::env::var("NORETRY").is_ok() { 1 } else { MOST_MESHES }) {
        if resolution.elements > MOST_ELEMENTS {
            break;
        }
        let options = PathOptions {
            elements: resolution.elements,
            step_tolerance: resolution.step_tolerance,
            tolerance: (1e-3 * accuracy.relative).clamp(1e-12, 1e-6),
            first_displacement: 0.02 * model.adhesion.equilibrium_distance,
        };
        if std::env::var("DBG").is_ok() {
            eprintln!("try {resolution:?} {trouble} {iterations} {:?}", started.elapsed());
        }
        match follow(&problem, options, far, bounds, accuracy.relative, started) {
            Ok(followed) => {
                iterations += followed.iterations;
                let mut peel = report(model, &problem, &followed);
                peel.trace = Some(Trace { problem: problem.clone(), points: followed.points });
                peel.effort = Effort {
                    points: peel.points.len(),
                    newton_iterations: iterations,
                    elements: resolution.elements,
                    order: resolution.order,
                };
                peel.solve_s = started.elapsed().as_secs_f64();
                let worst = worst_error(&peel) / accuracy.relative;
                if worst <= 1.0
                    || !matches!(peel.end, End::Detached | End::Pivoting | End::TurnedBack | End::Bound(_))
                        && best.is_some()
                {
                    return peel;
                }
                trouble = format!(
                    "the error bounds are {worst:.1} times what was asked for on {} elements of order {}",
                    resolution.elements, resolution.order
                );
                resolution = resolution.finer(worst);
                best = Some(peel);
            }
            Err(Unusable::Coarse(error)) => {
                trouble = error.to_string();
                resolution.elements += resolution.elements.div_ceil(2);
            }
            Err(Unusable::Missed { after }) => {
                trouble = format!(
                    "the number of negative eigenvalues changes behind path point {after} without a turning point there"
                );
                resolution.step_tolerance *= 0.3;
                resolution.elements += resolution.elements.div_ceil(4);
            }
        }
        if bounds.time_s.is_some_and(|most| started.elapsed().as_secs_f64() > most) {
            break;
        }
    }
    let reason = format!("{trouble}; try a larger accuracy.relative than {:e}", accuracy.relative);
    let mut peel = best.unwrap_or_else(|| empty(model));
    peel.end = End::Failed(reason);
    peel.solve_s = started.elapsed().as_secs_f64();
    peel
}

fn empty(model: &StripModel) -> Peel {
    Peel {
        model: *model,
        points: Vec::new(),
        limit_points: Vec::new(),
        initiation_peak: None,
        peak: None,
        plateau: None,
        snap_off: None,
        end: End::Failed(String::new()),
        effort: Effort::default(),
        solve_s: 0.0,
        trace: None,
    }
}

/// The largest relative error bound of what is reported.
fn worst_error(peel: &Peel) -> f64 {
    let first_load = peel.limit_points.iter().position(|p| p.kind == Turn::Load);
    let turns = peel.limit_points.iter().enumerate().flat_map(|(i, p)| {
        let place = p.displacement_error / p.displacement.abs();
        let weight = match p.kind {
            Turn::Load if p.flat => 0.0,
            Turn::Load if Some(i) != first_load => WEAK,
            _ => 1.0,
        };
        [weight * place, p.force_error / p.force.abs()]
    });
    let peaks = peel.peak.iter().map(|p| p.force_error / p.force.abs());
    turns.chain(peaks).fold(0.0, f64::max)
}

/// What a user is told of a path.
fn report(model: &StripModel, problem: &Problem, followed: &Followed) -> Peel {
    let works = works(problem, &followed.points);
    let points = followed.points.iter().zip(&works).map(|(s, &work)| PathPoint {
        displacement: s.observables.displacement,
        force: s.observables.force,
        end_rotation: s.observables.grip_rotation,
        work,
        negative_eigenvalues: s.negative,
        negative_eigenvalues_load: s.negative_load,
        front: s.observables.front,
        iterations: s.iterations,
    });
    let limit_points: Vec<LimitPoint> = followed
        .turns
        .iter()
        .map(|(kind, after, located)| LimitPoint {
            kind: *kind,
            displacement: located.observables.displacement,
            force: located.observables.force,
            end_rotation: located.observables.grip_rotation,
            work: work_near(problem, &followed.points, &works, *after, located),
            displacement_error: bound(located.difference.displacement, located.observables.displacement),
            force_error: bound(located.difference.force, located.observables.force),
            flat: located.flat,
            after: *after,
        })
        .collect();
    let mut peel = Peel { points: points.collect(), end: followed.end.clone(), limit_points, ..empty(model) };
    fill_special_points(&mut peel, problem, followed);
    peel
}

fn fill_special_points(peel: &mut Peel, problem: &Problem, followed: &Followed) {
    let maximum = |p: &&LimitPoint| p.kind == Turn::Load && followed.points[p.after].slope.force > 0.0 && p.force > 0.0;
    let turns_back =
        |p: &&LimitPoint| p.kind == Turn::Displacement && followed.points[p.after].slope.displacement > 0.0;
    let first_maximum = peel.limit_points.iter().find(maximum).copied();
    peel.initiation_peak = first_maximum.as_ref().map(peak_of);
    peel.snap_off = peel.limit_points.iter().find(turns_back).copied();
    let order = |p: &LimitPoint| peel.limit_points.iter().position(|q| q == p).unwrap_or(0);
    let until = peel.snap_off.as_ref().map_or(peel.limit_points.len(), |s| order(s) + 1);
    let at_turns = peel.limit_points[..until].iter().map(peak_of);
    let at_end = match (&peel.snap_off, followed.points.last()) {
        (None, Some(last)) => peak_at(problem, last),
        _ => None,
    };
    peel.peak = at_turns.chain(at_end).max_by(|a, b| a.force.total_cmp(&b.force));
    if let Some(first) = first_maximum {
        let last = followed.points.len().saturating_sub(2);
        let snap = peel.snap_off.map_or(last, |s| s.after);
        peel.plateau = plateau(problem, followed, &peel.limit_points, first.after, snap);
    }
}

fn peak_of(p: &LimitPoint) -> Peak {
    Peak {
        displacement: p.displacement,
        force: p.force,
        end_rotation: p.end_rotation,
        force_error: p.force_error,
        displacement_error: p.displacement_error,
    }
}

/// The end of a path as its peak, with the error of its force at that displacement.
fn peak_at(problem: &Problem, last: &Arc<Solution>) -> Option<Peak> {
    let difference = difference_on_twice_the_elements(problem, last, &mut Workspace::default()).ok()?;
    let o = last.observables;
    Some(Peak {
        displacement: o.displacement,
        force: o.force,
        end_rotation: o.grip_rotation,
        force_error: bound(difference.force, o.force),
        displacement_error: ROUND_OFF * o.displacement.abs(),
    })
}

fn bound(difference: f64, value: f64) -> f64 {
    SAFETY * difference.abs() + ROUND_OFF * value.abs()
}

/// Work of the grip from rest to each point: the energy it changed, or, where the load has no potential, ∫ P du.
fn works(problem: &Problem, points: &[Arc<Solution>]) -> Vec<f64> {
    if problem.conservative {
        let energy = |s: &Solution| s.energy.total + border_energy(problem, &s.at);
        return points.iter().map(|s| energy(s) - energy(&points[0])).collect();
    }
    let mut works = vec![0.0];
    for i in 0..points.len().saturating_sub(1) {
        let stretch = Stretch::around(problem, points, i);
        works.push(works[i] + work_between(&stretch, 0.0, stretch.end()));
    }
    works
}

/// A held grip's multiplier H adds H L to the energy.
fn border_energy(problem: &Problem, at: &Equilibrium) -> f64 {
    at.border * problem.length
}

/// ∫ P du between two labels of a stretch, by Simpson's rule on 16 parts of the interpolants.
fn work_between(stretch: &Stretch, from: f64, to: f64) -> f64 {
    let middle = 0.5 * (from + to);
    let (u, p) = (stretch.observable(|o| o.displacement, middle), stretch.observable(|o| o.force, middle));
    let integrand = |k: usize| {
        let at = from + (to - from) * k as f64 / 16.0;
        p.at(at).0 * u.at(at).1
    };
    let inner: f64 = (1..16).map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * integrand(k)).sum();
    (integrand(0) + inner + integrand(16)) * (to - from) / 48.0
}

/// Work at a located point.
fn work_near(
    problem: &Problem,
    points: &[Arc<Solution>],
    works: &[f64],
    after: usize,
    located: &crate::solve::Located,
) -> f64 {
    let s = &located.solution;
    if problem.conservative {
        let rest = points[0].energy.total + border_energy(problem, &points[0].at);
        let ahead = s.observables.force * (located.observables.displacement - s.observables.displacement);
        return s.energy.total + border_energy(problem, &s.at) - rest + ahead;
    }
    let mut stretch = Stretch::around(problem, points, after);
    let label = stretch.insert(s.clone());
    works[after] + work_between(&stretch, 0.0, label)
}
