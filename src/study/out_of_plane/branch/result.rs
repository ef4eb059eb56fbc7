//! The branch on which a strip leaves its plane.

use crate::model::check::error::ModelError;
use crate::solve::error::SolveError;
use crate::solve::points::search::LimitPointKind;
use crate::study::out_of_plane::result::{OutOfPlaneError, OutOfPlaneLoss};
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::LimitPoint;

/// The branch on which a strip that is free to leave its plane goes on from the first loss of its stability, followed in
/// space. It has a mirror image: to the other side the strip does the same, with all rolls, yaws and z the other way.
#[derive(Clone, Debug)]
pub struct OutOfPlaneBranch {
    /// Where it begins on the planar path, with bounds
    pub loss: OutOfPlaneLoss,
    /// How it begins
    pub start: BranchStart,
    /// The branch from its first point on, in space. Displacements and works count from rest.
    pub peel: Peel,
    /// Where the branch comes back to the planar path and ends, with bounds: at the point of that path at which it regains its
    /// stability. Nothing where the branch ends otherwise.
    pub rejoins: Option<OutOfPlaneLoss>,
}

impl OutOfPlaneBranch {
    /// The limit point of the force that is the peak of the branch, if it has one.
    pub fn peak(&self) -> Option<&LimitPoint> {
        let peak = self.peel.peak?;
        let is = |at: &&LimitPoint| at.kind == LimitPointKind::Load && at.displacement == peak.displacement;
        self.peel.limit_points.iter().find(is)
    }
}

/// A branch at the point where it begins, to second order in the roll a of the grip: u = u* + u₂ a², P = P* + P₂ a².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BranchStart {
    /// u* as the branch has it for a → 0, nm
    pub displacement: f64,
    /// P* likewise, nN
    pub force: f64,
    /// u₂, nm/rad²: above zero where the branch goes on to larger displacements
    pub displacement_by_roll: f64,
    /// P₂, nN/rad²
    pub force_by_roll: f64,
    /// Yaw of the grip per roll
    pub yaw_by_roll: f64,
    /// Roll of the grip at the first point of the branch, rad
    pub roll: f64,
}

impl BranchStart {
    /// dP/du with which the branch leaves the planar path, nN/nm.
    pub fn slope(&self) -> f64 {
        self.force_by_roll / self.displacement_by_roll
    }
}

/// Why a branch out of the plane was not followed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum OutOfPlaneBranchError {
    /// Where it begins is not known.
    #[error("{0}")]
    Loss(#[from] OutOfPlaneError),
    /// The model is none that is computed in space.
    #[error("the strip is not computed in space: `{}` {}", .0.key(), .0.found())]
    NotInSpace(ModelError),
    /// There is no stable path to leave.
    #[error(
        "the planar path is unstable out of the plane from its beginning on: there is no point at which it is left"
    )]
    FromTheBeginning,
    /// Newton's method failed.
    #[error("no equilibrium was found on the branch that leaves the plane at u = {displacement:.6} nm: {cause}")]
    NoEquilibrium { displacement: f64, cause: SolveError },
    /// The expansion at the branch point failed.
    #[error("the terms of second order of the branch that leaves the plane were not found: {0}")]
    NotSwitched(SolveError),
    /// No roll is small enough.
    #[error(
        "the branch that leaves the plane is not described by its terms of second order: they miss the displacement at a roll of \
         {roll:.3e} rad by {share:.1e} of them, known from rolls up to {known:.3e} rad"
    )]
    HigherOrder { roll: f64, share: f64, known: f64 },
    /// The branch begins somewhere else.
    #[error(
        "the branch begins at u = {displacement:.6} nm, P = {force:.6} nN, and not where the planar path loses its stability, \
         u = {expected_displacement:.6} nm, P = {expected_force:.6} nN"
    )]
    Elsewhere { displacement: f64, force: f64, expected_displacement: f64, expected_force: f64 },
    /// The first point is back in the plane.
    #[error("the first point of the branch, u = {displacement:.6} nm, is in the plane: its roll is {roll:.1e} rad")]
    InThePlane { displacement: f64, roll: f64 },
    /// The number of negative eigenvalues is not what the theory of bifurcations says.
    #[error(
        "the first point of the branch, u = {displacement:.6} nm, has {found:?} negative eigenvalues with displacement and with force \
         held, and not {expected:?}"
    )]
    Inertia { displacement: f64, found: [usize; 2], expected: [usize; 2] },
}
