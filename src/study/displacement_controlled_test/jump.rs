//! A jump with its numbers and the bounds on their errors.

use super::result::{Jump, JumpEnd, JumpKind};
use super::stable_branch::{LoadingDirection, Machine};
use crate::beam::planar::planar_beam::FRONT;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::newton::on_more_elements;
use crate::solve::points::locate::Located;
use crate::solve::relax::{Relaxed, relaxed_on_more_elements};
use crate::solve::state::Observables;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::{DIFFERENCE_BOUND_FACTOR, ROUND_OFF, bound_floor, least};
use crate::study::peel::contact::Adhering;

/// From where stability is lost to where the strip comes to rest.
pub(super) fn described(
    machine: &Machine,
    limit: &Located,
    relaxed: &Relaxed,
    way: LoadingDirection,
    ws: &mut Workspace,
) -> Jump {
    let (problem, landed, o) = (machine.problem, &relaxed.solution, &limit.observables);
    let share = ROUND_OFF + bound_floor(limit, machine.relative);
    let machine_error = DIFFERENCE_BOUND_FACTOR * limit.difference.displacement.abs() + share * o.displacement.abs();
    let (before, before_difference) = at_limit(machine, limit, machine_error, share, ws);
    let floor = ROUND_OFF + least(machine.relative);
    let (after, after_difference) = at_rest(machine, landed, machine_error, floor, ws);
    let energies = DIFFERENCE_BOUND_FACTOR * (before_difference + after_difference)
        + floor * before.energy.abs().max(after.energy.abs());
    let kind = if after.front < before.front { JumpKind::SnapOff } else { JumpKind::IntoContact };
    Jump {
        kind,
        way,
        machine: o.displacement,
        machine_error,
        before,
        after,
        released: before.energy - after.energy,
        released_error: energies + (before.force - after.force).abs() * machine_error,
        detached: problem.beam.is_clear(&landed.at, machine.far),
        steps: relaxed.steps,
    }
}

/// The limit point: place and force as they were located; the energy of the solution next to it with P dU from there. Of the
/// energy the difference to more elements, both with the force held, at which it is E - P U that has an error of second order; infinite where
/// there is no equilibrium on those.
fn at_limit(machine: &Machine, limit: &Located, machine_error: f64, share: f64, ws: &mut Workspace) -> (JumpEnd, f64) {
    let (problem, near, o) = (machine.problem, &limit.solution, &limit.observables);
    let adheres = machine.adhering(near);
    let ahead = o.displacement - near.observables.displacement;
    let energy = problem.energy(&near.at, near.energy) + near.observables.force * ahead;
    let enthalpy = |s: &Solution| problem.energy(&s.at, s.energy) - s.observables.force * s.observables.displacement;
    let force_error = DIFFERENCE_BOUND_FACTOR * limit.difference.force.abs() + share * o.force.abs();
    let finer = on_more_elements(problem, near, Observables::FORCE, ws);
    let difference = finer.map_or(f64::INFINITY, |finer| (enthalpy(&finer) - enthalpy(near)).abs());
    (end(problem, o, (machine_error, force_error), energy, adheres), difference)
}

/// Where the strip comes to rest, and the difference of its energy to that on more elements at the same displacement; infinite where there is no
/// equilibrium on those.
fn at_rest(machine: &Machine, landed: &Solution, machine_error: f64, floor: f64, ws: &mut Workspace) -> (JumpEnd, f64) {
    let problem = machine.problem;
    let finer = relaxed_on_more_elements(problem, landed, ws);
    let o = &landed.observables;
    let energy = problem.energy(&landed.at, landed.energy);
    let differences = finer
        .map(|finer| (finer.observables.force - o.force, (problem.energy(&finer.at, finer.energy) - energy).abs()));
    let (difference, energy_difference) = differences.unwrap_or((f64::INFINITY, f64::INFINITY));
    let along = (landed.slope.force / landed.slope.displacement).abs() * machine_error;
    let force_error = DIFFERENCE_BOUND_FACTOR * difference.abs() + along + floor * o.force.abs();
    (end(problem, o, (machine_error, force_error), energy, machine.adhering(landed)), energy_difference)
}

fn end(
    problem: &BeamProblem,
    o: &Observables,
    (machine_error, force_error): (f64, f64),
    energy: f64,
    adheres: Adhering,
) -> JumpEnd {
    let compliance = problem.grip.compliance;
    let through_spring = if compliance > 0.0 { compliance * force_error } else { 0.0 };
    JumpEnd {
        displacement: o.displacement - compliance * o.force,
        force: o.force,
        displacement_error: machine_error + through_spring,
        force_error,
        energy,
        front: o.monitors[FRONT],
        adheres,
    }
}

impl Jump {
    /// No bound is less than twice the difference to the same jump on another mesh.
    pub(super) fn widen(&mut self, twin: &Self) {
        let widened = |error: f64, here: f64, there: f64| error.max(DIFFERENCE_BOUND_FACTOR * (here - there).abs());
        self.machine_error = widened(self.machine_error, self.machine, twin.machine);
        self.released_error = widened(self.released_error, self.released, twin.released);
        for (end, other) in [(&mut self.before, &twin.before), (&mut self.after, &twin.after)] {
            end.force_error = widened(end.force_error, end.force, other.force);
            end.displacement_error = widened(end.displacement_error, end.displacement, other.displacement);
        }
    }
}
