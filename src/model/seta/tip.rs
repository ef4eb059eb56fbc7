//! A tip on a branch of its law, as an energy of a joint.

use super::tip_law::{TipBranch, TipLaw};
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::tree::branching_beam::{EndEnergy, EndResponse};
use std::sync::Arc;

/// A tip on a branch of its law.
#[derive(Clone, Debug)]
pub struct AdheringTip {
    /// Its law
    pub law: Arc<dyn TipLaw>,
    /// The branch that it is on
    pub on: TipBranch,
    /// Its place of adhesion, nm: where its end is when nothing pulls it
    pub foot: [f64; 3],
}

impl AdheringTip {
    /// Place of its end from its place of adhesion, nm.
    fn offset(&self, place: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| place[i] - self.foot[i])
    }

    /// The branch that it goes on by with its end at a place, nm.
    pub fn branch(&self, place: [f64; 3], directors: Quaternion) -> TipBranch {
        self.law.branch(self.on, self.offset(place), directors)
    }

    /// Whether it goes on adhering, or begins to, with its end at a place, nm.
    pub fn adheres(&self, place: [f64; 3], directors: Quaternion) -> bool {
        self.law.adheres(self.on, self.offset(place), directors)
    }

    /// Whether its law is known with its end at a place, nm, and no extrapolation.
    pub fn is_known(&self, place: [f64; 3], directors: Quaternion) -> bool {
        self.law.is_known(self.on, self.offset(place), directors)
    }

    /// Takes note that it, the tip of this number, is in equilibrium with its end at a place, nm.
    pub fn note(&self, tip: usize, place: [f64; 3], directors: Quaternion) {
        self.law.note(tip, self.on, self.offset(place), directors);
    }
}

impl EndEnergy for AdheringTip {
    fn response(&self, place: [f64; 3], directors: Quaternion) -> EndResponse {
        self.law.response(self.on, self.offset(place), directors)
    }
}
