//! A seta in an equilibrium: its numbers, its joints and its tips, and its branches, section by section.

use crate::beam::spatial::rotation::{Quaternion, conjugate, inner, matrix, normalised, product};
use crate::beam::spatial::tree::read::BranchSection;
use crate::model::seta::parameters::Seta;
use crate::model::seta::tip_law::TipBranch;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

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
    /// Tip by tip where spatulae are beams, else empty
    #[serde(default)]
    pub spatulae: Vec<SpatulaState>,
    /// By how much all joints stand higher than those of the seta, nm: on spatulae that are beams
    #[serde(default)]
    pub raised: f64,
}

/// A spatula that is a beam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpatulaState {
    /// Half of the height of its section in the middle, nm
    pub radius: f64,
    /// From the end of its shaft to its free end
    pub sections: Vec<BranchSection>,
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
    /// Of its round section; of a spatula half of its height, nm
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
            joints: (0..seta.joints()).map(joint).collect(),
            between: vec![Vec::new(); seta.joints() - 1],
            tips: (0..seta.tips()).map(tip).collect(),
            spatulae: Vec::new(),
            raised: 0.0,
        }
    }

    /// The same with all its joints higher, nm.
    pub fn raised_by(mut self, height: f64) -> Self {
        self.joints.iter_mut().for_each(|joint| joint.place[1] += height);
        Self { raised: self.raised + height, ..self }
    }

    /// All branches: branch b ends at joint b + 1. Spatulae that are beams come behind them.
    pub fn branches(&self, seta: &Seta) -> Vec<SetaBranch> {
        let spatulae = self.spatulae.iter().zip(&self.tips).map(|(own, tip)| SetaBranch {
            generation: seta.forks + 1,
            radius: own.radius,
            sections: own.sections.clone(),
            tip: None,
            attached: tip.on.adheres(),
        });
        (1..seta.joints()).map(|joint| self.branch(seta, joint)).chain(spatulae).collect()
    }

    /// Of the branch that ends at a joint: its axis.
    pub(in crate::study) fn axis(&self, seta: &Seta, joint: usize) -> Axis {
        let parent = seta.parent(joint);
        let (near, far) = (self.joints[parent], self.joints[joint]);
        // from the directors of the joint to those of the branch: as they are at rest
        let angle = product(conjugate(seta.directors(parent)), seta.directors(joint));
        let from = product(near.directors, angle);
        let length = (place(seta.joint_place(joint)) - place(seta.joint_place(parent))).norm();
        let near = JointPlace { directors: from, ..near };
        let places: Vec<_> = [near].into_iter().chain(self.between[joint - 1].iter().copied()).chain([far]).collect();
        let piece = |ends: &[JointPlace]| Cubic::new([ends[0], ends[1]], length / (places.len() - 1) as f64);
        Axis { pieces: places.windows(2).map(piece).collect(), length }
    }

    /// The branch that ends at a joint.
    fn branch(&self, seta: &Seta, joint: usize) -> SetaBranch {
        let generation = seta.generation(joint);
        let behind = seta.tips_behind(joint);
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
            radius: 0.5 * seta.branch_diameter(joint),
            sections: sections.collect(),
            tip: seta.tip_at(joint),
            attached: behind.clone().any(|tip| self.tips[tip].on.adheres()),
        }
    }
}

fn place(at: [f64; 3]) -> Vector3<f64> {
    Vector3::from(at)
}

/// The axis of a branch.
pub(in crate::study) struct Axis {
    /// One after the other, of equal length at rest
    pieces: Vec<Cubic>,
    /// At rest, nm
    pub length: f64,
}

impl Axis {
    /// Place and directors at a share of the length.
    pub(crate) fn at(&self, share: f64) -> (Vector3<f64>, Quaternion) {
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
