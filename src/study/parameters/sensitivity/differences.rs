//! Central differences with an error estimate.

use super::point::Adjoint;
use super::quantity::NoSensitivities;
use super::quantity::Variation;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::problem::InitialState;
use crate::solve::state::{Mesh, State};
use crate::study::initial::prepared::prepared;

/// A number with a bound on its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Estimate {
    pub value: f64,
    pub error: f64,
}

/// Step of a parameter's coordinate. The error of a difference of the fourth order is a multiple of its fourth power, 1e-13, and round-off is
/// divided by it.
pub(super) const STEP: f64 = 5e-4;
/// Where a parameter is taken, in steps.
pub(super) const STEPS: [f64; 4] = [1.0, -1.0, 2.0, -2.0];
/// Farthest that a parameter is changed for a derivative, in its coordinate.
pub const MOST_CHANGED: f64 = 2.0 * STEP;
/// Multiplies the square of what the second order misses, relative, which is the size of what the fourth order does.
const NEXT_ORDER: f64 = 4.0;
/// Round-off of a function value, relative.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// What changing a parameter does to a number: its derivative to the second and to the fourth order, and the round-off of that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Change {
    second: f64,
    fourth: f64,
    rounded: f64,
}

impl Change {
    /// Of a number whose values at [`STEPS`] times [`STEP`] are given, with the size of the sums that cancel in them.
    pub(crate) fn between(values: [f64; 4], scale: f64) -> Self {
        let [second, far] = [0, 2].map(|k| (values[k] - values[k + 1]) / (2.0 * STEPS[k] * STEP));
        Self { second, fourth: (4.0 * second - far) / 3.0, rounded: ROUNDED * scale / STEP }
    }

    /// With what it may be wrong by.
    pub(crate) fn estimate(&self) -> Estimate {
        let missed = (self.second - self.fourth).abs();
        let size = self.fourth.abs().max(missed);
        let truncated = if size > 0.0 { NEXT_ORDER * missed * missed / size } else { 0.0 };
        Estimate { value: self.fourth, error: truncated + self.rounded }
    }
}

/// Where a function along the path is taken, in steps.
pub(super) const ALONG: [f64; 6] = [1.0, -1.0, 2.0, -2.0, 4.0, -4.0];

/// The derivative of a function whose values at [`ALONG`] times `step` are given: of the sixth order, with what that changes of the fourth.
pub(super) fn along_path(values: [f64; 6], step: f64) -> Estimate {
    let [one, two, four] = [0, 2, 4].map(|k| (values[k] - values[k + 1]) / (2.0 * ALONG[k] * step));
    let [near, far] = [(4.0 * one - two) / 3.0, (4.0 * two - four) / 3.0];
    let value = (16.0 * near - far) / 15.0;
    Estimate { value, error: (value - near).abs() }
}

/// How the change of a number by a parameter changes along the path, from those at [`ALONG`] times `step`.
pub(super) fn change_along_path(changes: [Change; 6], step: f64) -> Estimate {
    let along = along_path(changes.map(|change| change.fourth), step);
    let second = along_path(changes.map(|change| change.second), step).value;
    let rounded = changes.iter().fold(0.0f64, |most, change| most.max(change.rounded)) / step;
    let by_parameter = Change { second, fourth: along.value, rounded }.estimate();
    Estimate { value: along.value, error: along.error + by_parameter.error }
}

impl Estimate {
    /// Of what is not known.
    pub(crate) const NAN: Self = Self { value: f64::NAN, error: f64::NAN };

    /// The quotient.
    pub(crate) fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, error: (self.error + value.abs() * other.error) / other.value.abs() }
    }

    /// Times a number that is known.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, error: factor.abs() * self.error }
    }

    /// The sum.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, error: self.error + other.error }
    }
}

// -- A state of one model as a state of another that differs from it a little --

/// A model beside the one that was peeled, made into what the solver is given.
pub(super) struct Beside {
    problem: BeamProblem,
    /// Where elements have to end, with both ends of the beam, nm
    breaks: Vec<f64>,
}

impl Beside {
    /// Of the model that was peeled.
    pub(crate) fn base(problem: &BeamProblem, model: &PeelModel) -> Self {
        Self { problem: problem.clone(), breaks: with_ends(model) }
    }

    /// Of a model that differs from that by `change` in the parameter `key`. A start that had to be found is found again: displacements count
    /// from there.
    pub(crate) fn varied(
        key: &str,
        change: f64,
        model: &PeelModel,
        base: &BeamProblem,
        how: Discretisation,
    ) -> Result<Self, NoSensitivities> {
        model.check().map_err(|cause| NoSensitivities::AtTheEdge { key: key.to_owned(), change, cause })?;
        let problem = match base.start {
            InitialState::Known { .. } => prepared(model, how, None)
                .map(|prepared| prepared.problem)
                .map_err(|failed| NoSensitivities::NoStart { key: key.to_owned(), change, cause: failed.why })?,
            InitialState::StressFree | InitialState::Settling => model.discretised(how, |_| {})?,
        };
        Ok(Self { problem, breaks: with_ends(model) })
    }

    pub(crate) fn problem(&self) -> &BeamProblem {
        &self.problem
    }

    /// A state of `base` as one of this: with every number but those of the grip, which stays where it was along the drive. Elements end at the same
    /// shares of what lies between breaks.
    pub(crate) fn carried(&self, base: &Self, at: &State) -> Option<State> {
        let (own, other) = (&self.problem, &base.problem);
        let place = |s: f64| {
            let k = base.breaks.partition_point(|&end| end < s).clamp(1, base.breaks.len() - 1);
            let share = (s - base.breaks[k - 1]) / (base.breaks[k] - base.breaks[k - 1]);
            self.breaks[k - 1] + share * (self.breaks[k] - self.breaks[k - 1])
        };
        if self.breaks.len() != base.breaks.len() {
            return None;
        }
        let boundaries: Vec<f64> = at.mesh.boundaries.iter().map(|&s| place(s)).collect();
        let moved = State { mesh: Mesh { boundaries, ..at.mesh.clone() }, ..at.clone() };
        if own.system.interface().len() != other.system.interface().len()
            || own.system.unknowns(&moved) != other.system.unknowns(at)
        {
            return None;
        }
        Some(own.grip.carried(&other.grip, &*other.system, &*own.system, moved))
    }
}

/// Where the elements of a model have to end, with both ends, ascending.
fn with_ends(model: &PeelModel) -> Vec<f64> {
    let length = model.length();
    let mut breaks = vec![0.0];
    breaks.extend(model.breaks().into_iter().filter(|&s| s > 0.0 && s < length));
    breaks.push(length);
    breaks
}

// -- How the residual and the energy of a state that stays change with a parameter, by central differences of the fourth order --
//
// The model is built anew at four values of the parameter: every number of a scene can be one, whatever it goes into, and no law, body or grip
// has a derivative of its own that could be wrong.

/// The model that was peeled, and those beside it in one parameter.
pub(super) struct Stencil<'b> {
    base: &'b Beside,
    beside: &'b [Beside; 4],
}

impl<'b> Stencil<'b> {
    /// The models beside one in a parameter.
    pub(crate) fn beside(
        variation: &Variation,
        base: &Beside,
        how: Discretisation,
    ) -> Result<[Beside; 4], NoSensitivities> {
        let one = |k: usize| {
            let change = STEPS[k] * STEP;
            Beside::varied(&variation.key, change, &(variation.model)(change), base.problem(), how)
        };
        Ok([one(0)?, one(1)?, one(2)?, one(3)?])
    }

    pub(crate) fn new(base: &'b Beside, beside: &'b [Beside; 4]) -> Self {
        Self { base, beside }
    }

    /// Whether all of the models have the unknowns of a state of the one that was peeled.
    pub(crate) fn has_unknowns_of(&self, at: &State) -> bool {
        self.beside.iter().all(|beside| beside.carried(self.base, at).is_some())
    }

    /// Change of what is not held at a point. What the grip exerts stays along the drive and across it.
    pub(crate) fn force(&self, point: &Adjoint) -> Change {
        let mut scale = 0.0f64;
        let values = std::array::from_fn(|k| {
            let Some(at) = self.beside[k].carried(self.base, &point.at) else { return f64::NAN };
            let problem = self.beside[k].problem();
            let mut residual = problem.system.residual(&at);
            problem.grip.turn_rows(&*problem.system, &at, &mut residual);
            let moved = problem.grip.grip_displacement(&problem.system.interface_values(&at));
            let products = || residual.iter().zip(&point.multipliers).map(|(r, m)| r * m);
            scale = scale.max(products().map(f64::abs).sum());
            products().sum::<f64>() + point.of_displacement * moved
        });
        Change::between(values, scale)
    }

    /// ∂Π/∂x at an equilibrium with dΠ/du = `power`, nN, whose grip stays along the drive.
    pub(crate) fn energy(&self, at: &State, power: f64) -> Change {
        self.energy_of(at, power, |_| 0.0)
    }

    /// The same where the path begins: its grip is where the beam is stress-free.
    pub(crate) fn energy_at_start(&self, at: &State, power: f64) -> Change {
        self.energy_of(at, power, |problem| problem.displacement(&problem.initial(at.mesh.elements())))
    }

    fn energy_of(&self, at: &State, power: f64, place: impl Fn(&BeamProblem) -> f64) -> Change {
        let mut scale = 0.0f64;
        let values = std::array::from_fn(|k| {
            let Some(at) = self.beside[k].carried(self.base, at) else { return f64::NAN };
            let problem = self.beside[k].problem();
            let direction = vec![0.0; problem.system.unknowns(&at)];
            let energy = problem.energy(&at, problem.system.evaluate(&at, &direction).0.energy);
            scale = scale.max(energy.abs());
            let moved = problem.grip.grip_displacement(&problem.system.interface_values(&at));
            energy + power * (place(problem) - moved)
        });
        Change::between(values, scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// e^(3x) and a sum that cancels: errors are as estimated or less.
    #[test]
    fn differences_hold_their_bounds() {
        let found = Change::between(STEPS.map(|k| (3.0 * k * STEP).exp()), 1.0).estimate();
        assert!((found.value - 3.0).abs() <= found.error && found.error < 1e-10, "{found:?}");
        let found = Change::between(STEPS.map(|k| 1e6 + (k * STEP).sin() - 1e6), 1e6).estimate();
        assert!((found.value - 1.0).abs() <= found.error && found.error < 1e-5, "{found:?}");
        let found = along_path(ALONG.map(|k| (1.0 + 0.01 * k).ln()), 0.01);
        assert!((found.value - 1.0).abs() <= found.error && found.error < 1e-6, "{found:?}");
    }

    #[test]
    fn errors_of_quotients_add_up() {
        let (one, other) = (Estimate { value: 2.0, error: 0.1 }, Estimate { value: -4.0, error: 0.2 });
        let found = one.over(other);
        assert!((found.value + 0.5).abs() < 1e-15 && (found.error - 0.05).abs() < 1e-15, "{found:?}");
    }
}
