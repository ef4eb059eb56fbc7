//! A seta as it stands: its tree of beams, each tip on a branch of its law, and the direction in which its root is moved.

use crate::beam::spatial::rotation::{Matrix3, Quaternion};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::beam::spatial::tree::branching_beam::{EndEnergy, EndResponse, JointCondition, JointUnknown, TreeMonitor};
use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::{AdheringTip, TipBranch};
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem};
use crate::solve::state::State;
use crate::solve::system::INTERFACE;
use crate::study::states::seta_state::TipState;
use nalgebra::{Matrix6, Vector3};
use std::sync::Arc;

/// Height among the unknowns of a joint.
pub(super) const HEIGHT: usize = 1;
/// The unknowns of a tip by which its energy softens: height and rotations.
const SOFTENING: [usize; 4] = [HEIGHT, 3, 4, 5];

/// A seta and its tips.
#[derive(Clone, Debug)]
pub(in crate::study) struct Standing {
    pub model: SetaModel,
    pub tree: BeamTree,
    pub tips: Vec<AdheringTip>,
}

/// Along what the root is moved, and from where.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct RootDrive {
    /// Columns; the first one is the direction
    pub axes: Matrix3,
    /// The root at the beginning, nm
    pub from: [f64; 3],
}

impl RootDrive {
    pub(crate) fn new(direction: [f64; 3], from: [f64; 3]) -> Self {
        let first = Vector3::from(direction).normalize();
        // the axis of space that is farthest from the direction
        let other = Vector3::ith(first.iamin(), 1.0);
        let second = first.cross(&other).normalize();
        let third = first.cross(&second);
        Self { axes: std::array::from_fn(|i| [first[i], second[i], third[i]]), from }
    }

    pub(crate) fn direction(&self) -> [f64; 3] {
        self.axes.map(|row| row[0])
    }

    /// Where the root is after so far, nm.
    pub(crate) fn root(&self, displacement: f64) -> [f64; 3] {
        let direction = self.direction();
        std::array::from_fn(|i| self.from[i] + displacement * direction[i])
    }
}

/// Which tangent of its energy a tip shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum TipTangent {
    Own,
    /// Without the directions in which its force falls as it is pulled
    Convex,
}

/// The energy of a tip without what softens it: the tangent has no negative eigenvalue.
#[derive(Debug)]
struct ConvexTip(AdheringTip);

impl EndEnergy for ConvexTip {
    fn response(&self, place: [f64; 3], directors: Quaternion) -> EndResponse {
        let own = self.0.response(place, directors);
        let is_diagonal = (0..6).all(|i| (0..6).all(|j| i == j || own.hessian[i][j] == 0.0));
        if is_diagonal {
            let mut hessian = own.hessian;
            (0..6).for_each(|i| hessian[i][i] = hessian[i][i].max(0.0));
            return EndResponse { hessian, ..own };
        }
        let hessian = Matrix6::from_fn(|i, j| own.hessian[i][j]);
        let mut eigen = hessian.symmetric_eigen();
        eigen.eigenvalues.apply(|value| *value = value.max(0.0));
        let convex = eigen.recompose();
        EndResponse { hessian: std::array::from_fn(|i| std::array::from_fn(|j| convex[(i, j)])), ..own }
    }
}

/// A tree in the grip that moves its root; its path is measured by the force, of this scale, nN.
pub(super) fn grip_of(tree: Arc<BeamTree>, drive: &RootDrive, force: f64) -> Problem {
    let mut origin = [0.0; INTERFACE];
    for k in 0..3 {
        origin[k] = (0..3).map(|i| drive.axes[i][k] * drive.from[i]).sum();
    }
    let mut held = [true; INTERFACE];
    held[0] = false;
    Problem {
        grip: EndConditions { held, origin, ..EndConditions::drive(0) },
        system: tree,
        measure: PathMeasure { monitors: [f64::INFINITY; 2], force, beside: MeasuredBeside::Force },
        start: InitialState::StressFree,
    }
}

impl Standing {
    pub(crate) fn new(model: &SetaModel, on: TipBranch) -> Result<Self, SetaError> {
        let seta = &model.seta;
        let mut beam = seta.tree(&model.mesh)?;
        beam.conditions = vec![JointCondition::free(0)];
        let mut tips = Vec::with_capacity(seta.tips());
        for tip in 0..seta.tips() {
            let [x, _, z] = seta.joint_place(seta.tip_joint(tip));
            let rest = seta.directors(seta.tip_joint(tip));
            let law = model.law.oriented(rest).unwrap_or_else(|| model.law.clone());
            let own = AdheringTip { law, on, foot: [x, 0.0, z] };
            beam.conditions.push(JointCondition::with_energy(seta.tip_joint(tip), Arc::new(own.clone())));
            tips.push(own);
        }
        Ok(Self { model: model.clone(), tree: beam.build()?, tips })
    }

    /// What is solved while the root is moved; `watched` is the first monitor.
    pub(crate) fn problem(&self, drive: &RootDrive, watched: Option<JointUnknown>, tangent: TipTangent) -> Problem {
        self.problem_of(Arc::new(self.adhering_tree(drive, watched, tangent)), drive)
    }

    /// The tree with its tips as they are.
    pub(crate) fn adhering_tree(
        &self,
        drive: &RootDrive,
        watched: Option<JointUnknown>,
        tangent: TipTangent,
    ) -> BeamTree {
        let seta = &self.model.seta;
        // a tip that does not adhere softens as well where it is drawn down
        let energy = |(tip, own): (usize, &AdheringTip)| {
            let energy: Option<Arc<dyn EndEnergy>> = match tangent {
                TipTangent::Own => Some(Arc::new(own.clone())),
                TipTangent::Convex => Some(Arc::new(ConvexTip(own.clone()))),
            };
            (seta.tip_joint(tip), energy)
        };
        let tree = self.tree.with_energies(self.tips.iter().enumerate().map(energy));
        tree.with_root_axes(drive.axes).with_monitors([watched.map(TreeMonitor::Joint), None])
    }

    /// A tree in the grip that moves its root.
    pub(crate) fn problem_of(&self, tree: Arc<BeamTree>, drive: &RootDrive) -> Problem {
        grip_of(tree, drive, 1.0)
    }

    /// Place and directors of a tip in a state.
    pub(crate) fn place(&self, at: &State, tip: usize) -> ([f64; 3], Quaternion) {
        self.tree.joint(at, self.model.seta.tip_joint(tip))
    }

    /// The branch that a tip goes over to in a state; its own where it stays.
    pub(crate) fn branch(&self, at: &State, tip: usize) -> TipBranch {
        let (place, directors) = self.place(at, tip);
        self.tips[tip].branch(place, directors)
    }

    /// Which tips would change between adhering and being detached in a state.
    pub(crate) fn changing(&self, at: &State) -> Vec<usize> {
        let changes = |&tip: &usize| {
            let (own, (place, directors)) = (&self.tips[tip], self.place(at, tip));
            own.adheres(place, directors) != own.on.adheres()
        };
        (0..self.tips.len()).filter(changes).collect()
    }

    /// Lets a tip go over to the other branch where it is.
    pub(crate) fn change(&mut self, at: &State, tip: usize) -> TipBranch {
        let ([x, _, z], _) = self.place(at, tip);
        let own = &mut self.tips[tip];
        own.on = if own.on.adheres() {
            TipBranch::Detached
        } else {
            own.foot = [x, 0.0, z];
            TipBranch::Attached
        };
        own.on
    }

    /// Takes note of where on its branch each tip is in equilibrium.
    pub(crate) fn note(&mut self, at: &State) {
        for tip in 0..self.tips.len() {
            let on = self.branch(at, tip);
            if on.adheres() == self.tips[tip].on.adheres() {
                self.tips[tip].on = on;
            }
            let (place, directors) = self.place(at, tip);
            self.tips[tip].note(tip, place, directors);
        }
    }

    /// Energy of a tip with its derivatives in a state.
    pub(crate) fn response(&self, at: &State, tip: usize) -> EndResponse {
        let (place, directors) = self.place(at, tip);
        self.tips[tip].response(place, directors)
    }

    /// ∂²E/∂y² of a tip that moves along a direction of the seta: h = (∂²E along the height and the rotations of its end) over the square of its
    /// height, nN/nm. A tip whose energy does not depend on its rotation has its own ∂²E/∂y². What holds it along the ground does not count.
    pub(crate) fn softening(&self, response: &EndResponse, tip: usize, direction: &[f64]) -> f64 {
        let own = &direction[self.model.seta.tip_joint(tip) * SPATIAL_UNKNOWNS..][..SPATIAL_UNKNOWNS];
        let rate = |i: usize| own[i] / own[HEIGHT];
        let term = |i: usize, j: usize| {
            if response.hessian[i][j] == 0.0 { 0.0 } else { response.hessian[i][j] * rate(i) * rate(j) }
        };
        SOFTENING.iter().map(|&i| SOFTENING.iter().map(|&j| term(i, j)).sum::<f64>()).sum()
    }

    /// Force of the ground on a tip, nN.
    pub(crate) fn load(&self, at: &State, tip: usize) -> [f64; 3] {
        let gradient = self.response(at, tip).gradient;
        std::array::from_fn(|i| -gradient[i])
    }

    pub(crate) fn tip_states(&self, at: &State) -> Vec<TipState> {
        let state = |(tip, own): (usize, &AdheringTip)| TipState {
            on: self.branch(at, tip),
            foot: own.foot,
            load: self.load(at, tip),
        };
        self.tips.iter().enumerate().map(state).collect()
    }

    /// Which way along the height a tip comes to the end of its branch: 1 up, where it adheres, -1 down, where the ground draws it on.
    pub(crate) fn way_out(&self, tip: usize) -> f64 {
        if self.tips[tip].on.adheres() { 1.0 } else { -1.0 }
    }

    /// Whether a detached tip comes to the end of its branch when it goes down by so much, nm.
    pub(crate) fn snaps_on_within(&self, at: &State, tip: usize, distance: f64) -> bool {
        let ([x, y, z], directors) = self.place(at, tip);
        !self.tips[tip].on.adheres() && self.tips[tip].adheres([x, y - distance, z], directors)
    }

    /// How many tips are where their law is an extrapolation.
    pub(crate) fn outside(&self, at: &State) -> usize {
        let is_outside = |&tip: &usize| {
            let (place, directors) = self.place(at, tip);
            !self.tips[tip].is_known(place, directors)
        };
        (0..self.tips.len()).filter(is_outside).count()
    }

    pub(crate) fn attached(&self) -> usize {
        self.tips.iter().filter(|tip| tip.on.adheres()).count()
    }
}
