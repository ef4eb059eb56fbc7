//! The two branches of a spatula of which there is a table, and where their equilibria begin.

use super::column::{Column, followed};
use super::error::HeldError;
use super::held_spatula::{HeldSpatula, HeldState};
use super::place::TipPlace;
use serde::{Deserialize, Serialize};

/// A branch of the law of a tip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TipSheet {
    /// The pad adheres, from where the tip is pressed to where it snaps off.
    Attached,
    /// It does not, from where the attraction begins to count to where it snaps on.
    Detached,
}

/// Equilibria of a branch, begun where the table begins.
pub(super) enum BranchStart {
    /// From the state at rest, so far below the height without a normal force, nm.
    Attached { spatula: HeldSpatula, rest: HeldState, press: f64 },
    /// From a state far away, down from where the substrate attracts the spatula with this force, nN.
    Detached { spatula: HeldSpatula, far: HeldState, force: f64 },
}

impl BranchStart {
    /// The spatula that is held.
    pub fn spatula(&self) -> &HeldSpatula {
        match self {
            Self::Attached { spatula, .. } | Self::Detached { spatula, .. } => spatula,
        }
    }

    /// The normal force with which it begins, nN.
    pub fn force(&self) -> f64 {
        match self {
            Self::Attached { rest, .. } => rest.solution.at.force,
            Self::Detached { force, .. } => *force,
        }
    }

    /// The normal force at the limit point of a branch from far away, at θ, nN.
    pub fn force_at_limit(spatula: &HeldSpatula, far: &HeldState, rotation: f64) -> Result<f64, HeldError> {
        let place = TipPlace { rotation, ..far.place };
        let lifted = spatula.moved(far, place, &mut spatula.workspace())?;
        let (_, located) = followed(spatula, &spatula.problem_at(place), &lifted, true)?;
        Ok(located.observables.force)
    }

    /// The branch at v and θ.
    pub fn column(&self, lateral: f64, rotation: f64) -> Result<Column, HeldError> {
        let mut ws = self.spatula().workspace();
        match self {
            Self::Attached { spatula, rest, press } => {
                let to = TipPlace { lateral, rotation, ..rest.place };
                let unloaded = spatula.under_force(rest, 0.0, to, &mut ws)?;
                let normal = unloaded.place.normal - press;
                let pressed = spatula.moved(&unloaded, TipPlace { normal, ..unloaded.place }, &mut ws)?;
                Column::traced(spatula, &pressed, false)
            }
            Self::Detached { spatula, far, force } => {
                let lifted = spatula.moved(far, TipPlace { lateral, rotation, ..far.place }, &mut ws)?;
                let problem = spatula.problem_at(lifted.place);
                let (points, _) = followed(spatula, &problem, &lifted, true)?;
                let away = |force_here: f64| (force_here.max(f64::MIN_POSITIVE) / force).ln().abs();
                let nearest = points.iter().min_by(|a, b| away(a.at.force).total_cmp(&away(b.at.force)));
                let Some(nearest) = nearest else { return Err(HeldError::Level { at: lifted.place }) };
                let place = TipPlace { normal: nearest.observables.displacement, ..lifted.place };
                let near = HeldState { place, solution: nearest.as_ref().clone() };
                let start = spatula.under_force(&near, *force, place, &mut ws)?;
                Column::traced(spatula, &start, true)
            }
        }
    }
}
