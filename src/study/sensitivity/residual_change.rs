//! How the residual and the energy of a state that stays change with a parameter, by central differences of the fourth order.
//!
//! The model is built anew at four values of the parameter: every number of a scene can be one, whatever it goes into, and no law, body or grip
//! has a derivative of its own that could be wrong.

use super::Variation;
use super::carried::Beside;
use super::differences::{Change, STEP, STEPS};
use super::error::NoSensitivities;
use super::point::Adjoint;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::state::State;

/// The model that was peeled, and those beside it in one parameter.
pub(super) struct Stencil<'b> {
    base: &'b Beside,
    beside: &'b [Beside; 4],
}

impl<'b> Stencil<'b> {
    /// The models beside one in a parameter.
    pub fn beside(variation: &Variation, base: &Beside, how: Discretisation) -> Result<[Beside; 4], NoSensitivities> {
        let one = |k: usize| {
            let change = STEPS[k] * STEP;
            Beside::varied(&variation.key, change, &(variation.model)(change), base.problem(), how)
        };
        Ok([one(0)?, one(1)?, one(2)?, one(3)?])
    }

    pub fn new(base: &'b Beside, beside: &'b [Beside; 4]) -> Self {
        Self { base, beside }
    }

    /// Whether all of the models have the unknowns of a state of the one that was peeled.
    pub fn has_unknowns_of(&self, at: &State) -> bool {
        self.beside.iter().all(|beside| beside.carried(self.base, at).is_some())
    }

    /// Change of what is not held at a point. What the grip exerts stays along the drive and across it.
    pub fn force(&self, point: &Adjoint) -> Change {
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
    pub fn energy(&self, at: &State, power: f64) -> Change {
        self.energy_of(at, power, |_| 0.0)
    }

    /// The same where the path begins: its grip is where the beam is stress-free.
    pub fn energy_at_start(&self, at: &State, power: f64) -> Change {
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
