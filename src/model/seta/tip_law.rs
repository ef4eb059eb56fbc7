//! What adheres a tip of a seta: an energy of the place and the rotation of its end, on branches that it leaves by jumps.
//!
//! While it adheres, the spatula at a tip follows one branch of its equilibria, with an energy E(r, q); at the end of that branch it snaps off.
//! A tip that is detached adheres again when it comes back into contact. So the law has a memory, the branch, and on each branch an energy.

use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::tree::branching_beam::{EndEnergy, EndResponse};
use serde::{Deserialize, Serialize};
use std::fmt::Debug;
use std::sync::Arc;

/// Where on its law a tip is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum TipBranch {
    /// It adheres, and its force grows as it is pulled.
    Attached,
    /// It adheres, and its force falls as it is pulled on: stable as long as the grip is stiffer. The same branch of the law.
    Detaching,
    /// It does not adhere.
    Detached,
}

impl TipBranch {
    /// Whether it adheres.
    pub fn adheres(self) -> bool {
        self != Self::Detached
    }
}

/// A law of the adhesion of tips. Places are counted from the place of adhesion of the tip, nm: y is the height of its end above that, x and z
/// how far it has been taken along the ground.
pub trait TipLaw: Send + Sync + Debug {
    /// Energy and derivatives on a branch; attached and detaching are one branch of the energy. Twice differentiable by place and rotation
    /// everywhere, also a little beyond the end of the branch. A tip that is free and far away has the energy zero.
    fn response(&self, on: TipBranch, place: [f64; 3], directors: Quaternion) -> EndResponse;

    /// The branch on which a tip is that has been on `before`: at the end of that it leaves it.
    fn branch(&self, before: TipBranch, place: [f64; 3], directors: Quaternion) -> TipBranch;

    /// Whether a tip that has been on `before` adheres there: what [`TipLaw::branch`] says of that.
    fn adheres(&self, before: TipBranch, place: [f64; 3], directors: Quaternion) -> bool {
        self.branch(before, place, directors).adheres()
    }

    /// Takes note that the tip of this number is in equilibrium there.
    fn note(&self, _tip: usize, _on: TipBranch, _place: [f64; 3], _directors: Quaternion) {}

    /// Whether energy and branch of a tip there are what was computed of the tip, and no extrapolation.
    fn is_known(&self, _on: TipBranch, _place: [f64; 3], _directors: Quaternion) -> bool {
        true
    }

    /// The law of a tip that has these directors in the stress-free configuration of the seta; none where rotations are of no account.
    fn oriented(&self, _rest: Quaternion) -> Option<Arc<dyn TipLaw>> {
        None
    }
}

// -- A tip on a branch of its law, as an energy of a joint --

/// A tip on a branch of its law.
#[derive(Clone, Debug)]
pub(crate) struct AdheringTip {
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
    pub(crate) fn branch(&self, place: [f64; 3], directors: Quaternion) -> TipBranch {
        self.law.branch(self.on, self.offset(place), directors)
    }

    /// Whether it goes on adhering, or begins to, with its end at a place, nm.
    pub(crate) fn adheres(&self, place: [f64; 3], directors: Quaternion) -> bool {
        self.law.adheres(self.on, self.offset(place), directors)
    }

    /// Whether its law is known with its end at a place, nm, and no extrapolation.
    pub(crate) fn is_known(&self, place: [f64; 3], directors: Quaternion) -> bool {
        self.law.is_known(self.on, self.offset(place), directors)
    }

    /// Takes note that it, the tip of this number, is in equilibrium with its end at a place, nm.
    pub(crate) fn note(&self, tip: usize, place: [f64; 3], directors: Quaternion) {
        self.law.note(tip, self.on, self.offset(place), directors);
    }
}

impl EndEnergy for AdheringTip {
    fn response(&self, place: [f64; 3], directors: Quaternion) -> EndResponse {
        self.law.response(self.on, self.offset(place), directors)
    }
}
