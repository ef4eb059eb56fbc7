//! What the model says of a measured point, and how that changes with the parameters.

use super::machine_curve::{BranchPoint, MachineCurve};
use super::pulled_curve::PulledCurve;
use super::result::PointPlace;

/// The branch is taken to end this share of its length before its jump: there its slope becomes infinite, and what is interpolated of it good to few digits.
const EDGE: f64 = 1e-3;

/// What the model says of one measured point.
///
/// Before the start of the path the curve is reflected at it, P(U₀ - δ) = 2 P₀ - P(U₀ + δ), which is right to the first order of δ; behind the jump
/// it keeps the force that it has there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Modelled {
    pub place: PointPlace,
    /// P, nN
    pub force: f64,
    /// dP/dU, nN/nm
    pub slope: f64,
    /// Which branch it is on, of a curve with events
    pub branch: usize,
    /// The point of the branch of which that was made
    at: BranchPoint,
}

impl Modelled {
    /// At a displacement of the machine, nm.
    pub fn at(curve: &MachineCurve, machine: f64) -> Self {
        let (start, force_at_start) = curve.start;
        let edge = start + (1.0 - EDGE) * (curve.end.machine - start);
        let (place, on_branch) = if machine < start {
            (PointPlace::BeforeStart, (2.0 * start - machine).min(edge))
        } else if machine > edge {
            (PointPlace::BehindJump, edge)
        } else {
            (PointPlace::OnBranch, machine)
        };
        let at = curve.at(on_branch);
        let machine_slope = curve.machine_slope(&at);
        let (force, slope) = match place {
            PointPlace::BeforeStart => (2.0 * force_at_start - at.force, machine_slope),
            PointPlace::OnBranch => (at.force, machine_slope),
            PointPlace::BehindJump => (at.force, 0.0),
        };
        Self { place, force, slope, branch: 0, at }
    }

    /// The same of a curve that is no peel, between these ends: behind the last one it keeps the force that it has there.
    pub fn of_pull(curve: &PulledCurve, (start, end): (f64, f64), machine: f64) -> Self {
        let (place, on_branch) = if machine < start {
            (PointPlace::BeforeStart, (2.0 * start - machine).min(end))
        } else if machine > end {
            (PointPlace::BehindJump, end)
        } else {
            (PointPlace::OnBranch, machine)
        };
        let found = curve.at(on_branch);
        let (force, slope) = match place {
            PointPlace::BeforeStart => (2.0 * curve.at(start).force - found.force, found.slope),
            PointPlace::OnBranch => (found.force, found.slope),
            PointPlace::BehindJump => (found.force, 0.0),
        };
        let at = BranchPoint { grip: on_branch, force: found.force, slope: found.slope };
        Self { place, force, slope, branch: found.branch, at }
    }

    /// u of the grip at the point of the branch, nm.
    pub fn grip(&self) -> f64 {
        self.at.grip
    }

    /// dP/dx at the measured displacement.
    pub fn derivative(&self, curve: &MachineCurve, change: &Change) -> f64 {
        let stiffness = 1.0 + curve.compliance * change.slope;
        let held = (change.force - change.slope * self.at.force * change.compliance) / stiffness;
        let start = change.compliance * curve.start.1 + curve.compliance * change.force_at_start;
        let slope = change.slope / stiffness;
        match self.place {
            PointPlace::OnBranch => held,
            PointPlace::BeforeStart => 2.0 * change.force_at_start - held - 2.0 * slope * start,
            PointPlace::BehindJump => held + slope * ((1.0 - EDGE) * change.jump + EDGE * start),
        }
    }
}

/// How what a point is made of changes with a parameter's coordinate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Change {
    /// dP/dx at the point's displacement of the grip
    pub force: f64,
    /// dP/du there, nN/nm: of the same solution, because the two grow beyond bounds together at a limit point
    pub slope: f64,
    /// dP/dx where the path begins
    pub force_at_start: f64,
    /// d(1/k)/dx
    pub compliance: f64,
    /// dU*/dx
    pub jump: f64,
}
