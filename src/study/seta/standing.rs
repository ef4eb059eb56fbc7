//! A seta as it stands: its tree of beams, each tip on a branch of its law, and the direction in which its root is moved.

use crate::beam::spatial::rotation::{Matrix3, Quaternion, conjugate, inner, matrix, normalised, product};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::beam::spatial::tree::branching_beam::{EndEnergy, EndResponse, JointCondition, JointUnknown};
use crate::beam::spatial::tree::read::BranchSection;
use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::{Seta, SetaModel};
use crate::model::seta::tip_law::{AdheringTip, TipBranch};
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem};
use crate::solve::state::State;
use crate::solve::system::INTERFACE;
use nalgebra::{Matrix6, Vector3};
use serde::{Deserialize, Serialize};
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
    pub fn new(direction: [f64; 3], from: [f64; 3]) -> Self {
        let first = Vector3::from(direction).normalize();
        // the axis of space that is farthest from the direction
        let other = Vector3::ith(first.iamin(), 1.0);
        let second = first.cross(&other).normalize();
        let third = first.cross(&second);
        Self { axes: std::array::from_fn(|i| [first[i], second[i], third[i]]), from }
    }

    pub fn direction(&self) -> [f64; 3] {
        self.axes.map(|row| row[0])
    }

    /// Where the root is after so far, nm.
    pub fn root(&self, displacement: f64) -> [f64; 3] {
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

impl Standing {
    pub fn new(model: &SetaModel, on: TipBranch) -> Result<Self, SetaError> {
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
    pub fn problem(&self, drive: &RootDrive, watched: Option<JointUnknown>, tangent: TipTangent) -> Problem {
        self.problem_of(Arc::new(self.adhering_tree(drive, watched, tangent)), drive)
    }

    /// The tree with its tips as they are.
    pub fn adhering_tree(&self, drive: &RootDrive, watched: Option<JointUnknown>, tangent: TipTangent) -> BeamTree {
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
        tree.with_root_axes(drive.axes).with_monitors([watched, None])
    }

    /// A tree in the grip that moves its root.
    pub fn problem_of(&self, tree: Arc<BeamTree>, drive: &RootDrive) -> Problem {
        let mut origin = [0.0; INTERFACE];
        for k in 0..3 {
            origin[k] = (0..3).map(|i| drive.axes[i][k] * drive.from[i]).sum();
        }
        let mut held = [true; INTERFACE];
        held[0] = false;
        Problem {
            grip: EndConditions { held, origin, ..EndConditions::drive(0) },
            system: tree,
            measure: PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force },
            start: InitialState::StressFree,
        }
    }

    /// Place and directors of a tip in a state.
    pub fn place(&self, at: &State, tip: usize) -> ([f64; 3], Quaternion) {
        self.tree.joint(at, self.model.seta.tip_joint(tip))
    }

    /// The branch that a tip goes over to in a state; its own where it stays.
    pub fn branch(&self, at: &State, tip: usize) -> TipBranch {
        let (place, directors) = self.place(at, tip);
        self.tips[tip].branch(place, directors)
    }

    /// Which tips would change between adhering and being detached in a state.
    pub fn changing(&self, at: &State) -> Vec<usize> {
        let changes = |&tip: &usize| {
            let (own, (place, directors)) = (&self.tips[tip], self.place(at, tip));
            own.adheres(place, directors) != own.on.adheres()
        };
        (0..self.tips.len()).filter(changes).collect()
    }

    /// Lets a tip go over to the other branch where it is.
    pub fn change(&mut self, at: &State, tip: usize) -> TipBranch {
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
    pub fn note(&mut self, at: &State) {
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
    pub fn response(&self, at: &State, tip: usize) -> EndResponse {
        let (place, directors) = self.place(at, tip);
        self.tips[tip].response(place, directors)
    }

    /// ∂²E/∂y² of a tip that moves along a direction of the seta: h = (∂²E along the height and the rotations of its end) over the square of its
    /// height, nN/nm. A tip whose energy does not depend on its rotation has its own ∂²E/∂y². What holds it along the ground does not count.
    pub fn softening(&self, response: &EndResponse, tip: usize, direction: &[f64]) -> f64 {
        let own = &direction[self.model.seta.tip_joint(tip) * SPATIAL_UNKNOWNS..][..SPATIAL_UNKNOWNS];
        let rate = |i: usize| own[i] / own[HEIGHT];
        let term = |i: usize, j: usize| {
            if response.hessian[i][j] == 0.0 { 0.0 } else { response.hessian[i][j] * rate(i) * rate(j) }
        };
        SOFTENING.iter().map(|&i| SOFTENING.iter().map(|&j| term(i, j)).sum::<f64>()).sum()
    }

    /// Force of the ground on a tip, nN.
    pub fn load(&self, at: &State, tip: usize) -> [f64; 3] {
        let gradient = self.response(at, tip).gradient;
        std::array::from_fn(|i| -gradient[i])
    }

    pub fn tip_states(&self, at: &State) -> Vec<TipState> {
        let state = |(tip, own): (usize, &AdheringTip)| TipState {
            on: self.branch(at, tip),
            foot: own.foot,
            load: self.load(at, tip),
        };
        self.tips.iter().enumerate().map(state).collect()
    }

    /// Which way along the height a tip comes to the end of its branch: 1 up, where it adheres, -1 down, where the ground draws it on.
    pub fn way_out(&self, tip: usize) -> f64 {
        if self.tips[tip].on.adheres() { 1.0 } else { -1.0 }
    }

    /// Whether a detached tip comes to the end of its branch when it goes down by so much, nm.
    pub fn snaps_on_within(&self, at: &State, tip: usize, distance: f64) -> bool {
        let ([x, y, z], directors) = self.place(at, tip);
        !self.tips[tip].on.adheres() && self.tips[tip].adheres([x, y - distance, z], directors)
    }

    /// How many tips are where their law is an extrapolation.
    pub fn outside(&self, at: &State) -> usize {
        let is_outside = |&tip: &usize| {
            let (place, directors) = self.place(at, tip);
            !self.tips[tip].is_known(place, directors)
        };
        (0..self.tips.len()).filter(is_outside).count()
    }

    pub fn attached(&self) -> usize {
        self.tips.iter().filter(|tip| tip.on.adheres()).count()
    }
}

// -- The branches of a seta in an equilibrium, section by section, from its joints and from the forces on its tips alone --
//
// Nothing loads a branch between its joints, and a tree is statically determinate: the section force of a branch is the sum of the forces on
// the tips behind it, and its moment at a place the sum of the moments of these forces about that place. Between two ends of elements the axis
// is the cubic with the place and the direction of both, which is exact for a slender element that turns little.

/// Lines along a branch behind so many forks: those of the paper's seta, 1 700 on 256 tips.
const LINES: [usize; 9] = [12, 8, 6, 6, 4, 4, 4, 3, 3];

/// A branch of a seta in an equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaBranch {
    /// Forks between it and the root: 0 of the shaft
    pub generation: usize,
    /// Of its round section, nm
    pub radius: f64,
    /// From the joint nearer to the root on, evenly
    pub sections: Vec<BranchSection>,
    /// The tip that it ends with, if it does
    pub tip: Option<usize>,
    /// Whether a tip behind it adheres
    pub attached: bool,
}

impl SetaState {
    /// A seta that nothing loads, where the plane of its tips is the ground.
    pub fn stress_free(seta: &Seta) -> Self {
        let joint = |joint: usize| JointPlace { place: seta.joint_place(joint), directors: seta.directors(joint) };
        let tip = |tip: usize| TipState {
            on: TipBranch::Detached,
            foot: seta.joint_place(seta.tip_joint(tip)),
            load: [0.0; 3],
        };
        Self {
            point: SetaPoint::default(),
            location: None,
            joints: (0..2 * seta.tips()).map(joint).collect(),
            between: vec![Vec::new(); 2 * seta.tips() - 1],
            tips: (0..seta.tips()).map(tip).collect(),
        }
    }

    /// All branches: branch b ends at joint b + 1.
    pub fn branches(&self, seta: &Seta) -> Vec<SetaBranch> {
        (1..2 * seta.tips()).map(|joint| self.branch(seta, joint)).collect()
    }

    /// Of the branch that ends at a joint: its axis.
    pub(super) fn axis(&self, seta: &Seta, joint: usize) -> Axis {
        let (near, far) = (self.joints[joint / 2], self.joints[joint]);
        // from the directors of the joint to those of the branch: as they are at rest
        let angle = product(conjugate(seta.directors(joint / 2)), seta.directors(joint));
        let from = product(near.directors, angle);
        let length = (place(seta.joint_place(joint)) - place(seta.joint_place(joint / 2))).norm();
        let near = JointPlace { directors: from, ..near };
        let places: Vec<_> = [near].into_iter().chain(self.between[joint - 1].iter().copied()).chain([far]).collect();
        let piece = |ends: &[JointPlace]| Cubic::new([ends[0], ends[1]], length / (places.len() - 1) as f64);
        Axis { pieces: places.windows(2).map(piece).collect(), length }
    }

    /// The branch that ends at a joint.
    fn branch(&self, seta: &Seta, joint: usize) -> SetaBranch {
        let generation = joint.ilog2() as usize;
        let ahead = seta.forks - generation;
        let behind = (joint << ahead) - seta.tips()..((joint + 1) << ahead) - seta.tips();
        let axis = self.axis(seta, joint);
        let count = LINES[generation.min(LINES.len() - 1)];
        let sections = (0..=count).map(|k| {
            let (at, directors) = axis.at(k as f64 / count as f64);
            let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
            for tip in behind.clone() {
                let load = place(self.tips[tip].load);
                force += load;
                moment += (place(self.joints[seta.tip_joint(tip)].place) - at).cross(&load);
            }
            BranchSection { place: at.into(), directors, force: force.into(), moment: moment.into() }
        });
        SetaBranch {
            generation,
            radius: 0.5 * seta.diameter(generation),
            sections: sections.collect(),
            tip: (generation == seta.forks).then(|| joint - seta.tips()),
            attached: behind.clone().any(|tip| self.tips[tip].on.adheres()),
        }
    }
}

fn place(at: [f64; 3]) -> Vector3<f64> {
    Vector3::from(at)
}

/// The axis of a branch.
pub(super) struct Axis {
    /// One after the other, of equal length at rest
    pieces: Vec<Cubic>,
    /// At rest, nm
    pub length: f64,
}

impl Axis {
    /// Place and directors at a share of the length.
    pub fn at(&self, share: f64) -> (Vector3<f64>, Quaternion) {
        let along = share * self.pieces.len() as f64;
        let piece = (along as usize).min(self.pieces.len() - 1);
        self.pieces[piece].at(along - piece as f64)
    }
}

/// The axis between two ends of elements.
struct Cubic {
    places: [Vector3<f64>; 2],
    /// By the share of the length
    slopes: [Vector3<f64>; 2],
    directors: [Quaternion; 2],
}

impl Cubic {
    fn new(ends: [JointPlace; 2], length: f64) -> Self {
        let directors = ends.map(|end| end.directors);
        let slopes = directors.map(|q| length * place(matrix(q).map(|row| row[0])));
        Self { places: ends.map(|end| place(end.place)), slopes, directors }
    }

    /// Place and directors at a share of the length.
    fn at(&self, t: f64) -> (Vector3<f64>, Quaternion) {
        let ([a, b], [da, db]) = (self.places, self.slopes);
        let u = 1.0 - t;
        let at = a * (u * u * (1.0 + 2.0 * t)) + da * (t * u * u) + b * (t * t * (3.0 - 2.0 * t)) - db * (t * t * u);
        let [p, q] = self.directors;
        // q and -q are the same directors
        let sign = if inner(p, q) < 0.0 { -1.0 } else { 1.0 };
        (at, normalised(std::array::from_fn(|i| u * p[i] + sign * t * q[i])))
    }
}

// -- A seta in an equilibrium: its numbers, its joints and its tips --

/// A stable equilibrium of a seta.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SetaPoint {
    /// Number of the step
    pub step: usize,
    /// How far the root has moved in the step, nm
    pub displacement: f64,
    /// Where the root is from where it was when the plane of the tips is the ground, nm
    pub root: [f64; 3],
    /// On the root along x, y and z, nN: what holds it
    pub force: [f64; 3],
    /// Of this, along the direction of the step: positive where the root is pulled
    pub force_along: f64,
    /// On the root about x, y and z, nN·nm
    pub moment: [f64; 3],
    /// Tips that adhere
    pub attached: usize,
    /// Tips that are where their law is an extrapolation
    pub outside: usize,
    /// Stored and of adhesion; zero of a detached stress-free seta, aJ
    pub energy: f64,
    /// Of the root from the start, aJ: the integral of the force between events
    pub work: f64,
    /// At events from the start, aJ
    pub released: f64,
}

/// Where a joint is, or a place of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct JointPlace {
    /// nm
    pub place: [f64; 3],
    /// Of the branch that leads to the root
    pub directors: Quaternion,
}

impl From<([f64; 3], Quaternion)> for JointPlace {
    fn from((place, directors): ([f64; 3], Quaternion)) -> Self {
        Self { place, directors }
    }
}

/// A tip in a state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TipState {
    /// The branch of its law that it is on
    pub on: TipBranch,
    /// Its place of adhesion, nm
    pub foot: [f64; 3],
    /// Force of the ground on it, nN: negative along y where the ground pulls it down
    pub load: [f64; 3],
}

/// How far an equilibrium that was looked for may lie from the one that was found: where the force has a maximum, or just before an event. It is
/// an error of that search alone, with the mesh and the law of the tips as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LocationError {
    /// Of the force along the direction of the step, nN
    pub force: f64,
    /// Of the displacement, nm
    pub displacement: f64,
}

/// A seta in an equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaState {
    /// Its numbers
    pub point: SetaPoint,
    /// Where it was looked for: its error
    pub location: Option<LocationError>,
    /// Joint by joint, as [`crate::model::Seta::joint_place`] counts them
    pub joints: Vec<JointPlace>,
    /// Branch by branch between its joints, where its elements meet: evenly
    pub between: Vec<Vec<JointPlace>>,
    /// Tip by tip
    pub tips: Vec<TipState>,
}
