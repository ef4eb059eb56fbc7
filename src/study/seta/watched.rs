//! What a branch is followed by where the displacement of the root turns: the place of a joint that goes on.

use super::standing::{HEIGHT, Standing};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::branching_beam::JointUnknown;
use crate::solve::newton::Solution;
use crate::solve::state::State;

/// A place of a joint along x, y or z that grows or falls along a branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched {
    pub unknown: JointUnknown,
    /// 1 where it grows, -1 where it falls: the parameter is the place times this
    sign: f64,
    /// The tip whose height it is, if it is one that goes on to the end of its branch: adheres and goes up, or is detached and goes down
    pub tip: Option<usize>,
    /// du over the change of the parameter above which the branch can be followed by the displacement again; none where it is followed up to
    /// its end
    pub passed: Option<f64>,
    /// First step of the parameter, nm, where no better one is known
    pub first: f64,
}

/// First step of a tip, nm.
const FIRST: f64 = 1.0;
/// Behind the place where the displacement nearly turns it has to go on this many times faster than where it was left.
const PASSED: f64 = 2.0;
/// A tip that is so many times as fast as the one that is watched is watched in its place.
const FASTER: f64 = 1.2;
/// The first step, over what the tangent says of the step that was refused.
const SHARE: f64 = 0.1;

impl Watched {
    /// The height of a tip that adheres and goes up, or of one that is detached and goes down.
    pub fn tip(standing: &Standing, tip: usize) -> Self {
        let unknown = JointUnknown { joint: standing.model.seta.tip_joint(tip), slot: HEIGHT };
        Self { unknown, sign: standing.way_out(tip), tip: Some(tip), passed: None, first: FIRST }
    }

    /// The place that changes the most with the displacement, and by how much of it; `ahead` is the step that was refused, nm.
    pub fn fastest(standing: &Standing, here: &Solution, ahead: f64) -> (Self, f64) {
        let per = |k: usize| here.tangent.direction[k] / here.slope.displacement;
        let places = (1..standing.tree.joints()).flat_map(|joint| (0..3).map(move |slot| JointUnknown { joint, slot }));
        let mut fastest = (JointUnknown { joint: 0, slot: 0 }, 0.0f64);
        for unknown in places {
            let rate = per(unknown.joint * SPATIAL_UNKNOWNS + unknown.slot);
            if rate.abs() > fastest.1.abs() {
                fastest = (unknown, rate);
            }
        }
        let (unknown, rate) = fastest;
        let tips = standing.model.seta.tips();
        let tip = (unknown.joint >= tips && unknown.slot == HEIGHT && rate > 0.0).then(|| unknown.joint - tips);
        let tip = tip.filter(|&tip| standing.tips[tip].on.adheres());
        let first = (SHARE * ahead * rate.abs()).max(FIRST);
        (Self { unknown, sign: rate.signum(), tip, passed: Some(PASSED / rate.abs()), first }, rate.abs())
    }

    /// The tip that goes on to the end of its branch the fastest, if it is faster than this place.
    pub fn faster_tip(&self, standing: &Standing, here: &Solution) -> Option<Self> {
        let attached = (0..standing.tips.len()).filter(|&tip| standing.tips[tip].on.adheres());
        let rates =
            attached.map(|tip| Self::tip(standing, tip)).map(|own| (own.rate(here) / here.slope.displacement, own));
        let (rate, fastest) = rates.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let own = self.rate(here) / here.slope.displacement;
        (fastest.unknown != self.unknown && rate > FASTER * own.max(0.0)).then_some(fastest)
    }

    /// Its change with the parameter of a solution.
    pub fn rate(&self, solution: &Solution) -> f64 {
        self.sign * solution.tangent.direction[self.unknown.joint * SPATIAL_UNKNOWNS + self.unknown.slot]
    }

    /// What it is in a state, nm.
    pub fn value(&self, standing: &Standing, at: &State) -> f64 {
        self.sign * standing.tree.joint(at, self.unknown.joint).0[self.unknown.slot]
    }

    /// The place itself where the parameter has a value, nm.
    pub fn place(&self, value: f64) -> f64 {
        self.sign * value
    }

    /// Change of the parameter with the place.
    pub fn sign(&self) -> f64 {
        self.sign
    }
}
