//! Points of a path: those of its curve, limit points, branch points and peaks, and the shape of the beam there.

use crate::model::problem::beam_problem::SpatialGrip;
use crate::solve::points::kind::LimitPointKind;
use serde::{Deserialize, Serialize};

/// One equilibrium of the path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from where the path begins, aJ; of a grip that turns as it goes ∫ P du + M dθ
    pub work: f64,
    /// Negative eigenvalues of the tangent with the grip held at its displacement.
    pub negative_eigenvalues: usize,
    /// The same with the force held.
    pub negative_eigenvalues_load: usize,
    /// S of the peeling front, nm: the adhesion energy that is left over that of a unit length at rest.
    pub front: f64,
    /// Newton iterations it took.
    pub iterations: usize,
    /// The grip of a strip in space; none in the plane
    #[serde(default)]
    pub in_space: Option<SpatialGrip>,
}

/// A limit point of the path, located and not sampled.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LimitPoint {
    /// Of the displacement or of the force
    pub kind: LimitPointKind,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from where the path begins, aJ; of a grip that turns as it goes ∫ P du + M dθ
    pub work: f64,
    /// Bound on the error of `displacement`, nm
    pub displacement_error: f64,
    /// Bound on the error of `force`, nN
    pub force_error: f64,
    /// Bound on the error of `work`, aJ; none where the load has no potential or there is friction, where the work is an integral over the
    /// path, where a term of the model was left out, and where half as many elements again have no solution beside this one
    pub work_error: Option<f64>,
    /// Whether the force is so flat around it that its displacement cannot be determined any better and does not matter.
    pub flat: bool,
    /// It lies between `points[after]` and `points[after + 1]` of the path.
    pub after: usize,
    /// The grip of a strip in space, at the solution next to the point; none in the plane
    #[serde(default)]
    pub in_space: Option<SpatialGrip>,
}

/// Where another branch of equilibria meets the path although the displacement does not turn, located: an eigenvalue passes through zero there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BranchPoint {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Bound on the error of `displacement`, nm
    pub displacement_error: f64,
    /// Bound on the error of `force`, nN
    pub force_error: f64,
    /// Negative eigenvalues with the displacement held, before it and behind it
    pub negative_eigenvalues: [usize; 2],
    /// It lies between `points[after]` and `points[after + 1]` of the path.
    pub after: usize,
}

/// A largest force: a limit point of the path, located.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// θ(L), rad
    pub end_rotation: f64,
    /// Bound on the error of the force, nN
    pub force_error: f64,
    /// Bound on the error of the displacement, nm
    pub displacement_error: f64,
}

/// The axis of the beam at one equilibrium, sampled: x, y and in space z in nm, the rotation in rad, and the height of the section in nm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformedShape {
    /// Of the axis, nm
    pub x: Vec<f64>,
    /// Of the axis, nm
    pub y: Vec<f64>,
    /// Of the axis sideways, nm; empty in the plane
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub z: Vec<f64>,
    /// θ, rad; in space the elevation of the axis
    pub rotation: Vec<f64>,
    /// h, nm
    pub height: Vec<f64>,
}
