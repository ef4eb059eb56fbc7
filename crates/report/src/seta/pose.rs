//! A seta as it lies in one equilibrium: what pictures, the animation and the files for ParaView are made of.

use peelkit::model::Seta;
use peelkit::study::{SetaBranch, SetaPoint, SetaState};

/// A seta in one equilibrium of its pull-off.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaPose {
    /// The numbers of the equilibrium
    pub point: SetaPoint,
    /// Force on each tip away from the ground, nN: positive where the ground pulls it down; none of one that is detached
    pub tip_loads: Vec<Option<f64>>,
    /// Branch b ends at joint b + 1
    pub branches: Vec<SetaBranch>,
}

impl SetaPose {
    /// Of a state of a seta.
    pub fn of(state: &SetaState, seta: &Seta) -> Self {
        let load = |tip: &peelkit::study::TipState| tip.on.adheres().then_some(-tip.load[1]);
        Self { point: state.point, tip_loads: state.tips.iter().map(load).collect(), branches: state.branches(seta) }
    }
}
