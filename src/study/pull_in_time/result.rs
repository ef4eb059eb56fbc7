//! What a pull in time gives.

use crate::model::problem::motion::NotInTime;
use crate::solve::error::SolveError;
use crate::solve::time::dynamic_system::EnergyBalance;
use crate::solve::time::integrator::TimeError;

/// The beam at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InTimePoint {
    /// t since the pull began, ns
    pub time: f64,
    /// U of what moves the grip, nm
    pub displacement: f64,
    /// P of the grip, nN
    pub force: f64,
    /// The peeling front, nm: how long the free end's adhesion would have to go on
    pub front: f64,
    /// Energies, aJ
    pub balance: EnergyBalance,
}

/// The largest force of the pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InTimePeak {
    /// ns
    pub time: f64,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
}

/// A pull in time.
#[derive(Clone, Debug)]
pub struct PullInTime {
    /// Every step, from rest on
    pub points: Vec<InTimePoint>,
    /// The largest force, by a parabola through the three points next to it; none where the force is largest at an end
    pub peak: Option<InTimePeak>,
    /// When nothing adhered any more for the first time, ns
    pub contact_lost: Option<f64>,
    /// Elements of the mesh
    pub elements: usize,
    /// Newton iterations
    pub iterations: usize,
    /// Steps that were tried, those that were refused among them
    pub tried: usize,
}

impl PullInTime {
    /// The last point.
    pub fn last(&self) -> InTimePoint {
        self.points.last().copied().unwrap_or_default()
    }

    /// The largest force of any point, nN.
    pub fn largest_force(&self) -> f64 {
        let largest = self.points.iter().map(|point| point.force).fold(f64::NEG_INFINITY, f64::max);
        self.peak.map_or(largest, |peak| peak.force.max(largest))
    }

    /// The largest defect of the balance, over the largest work: work = stored + kinetic + adhesion + dissipated.
    pub fn balance_error(&self) -> f64 {
        let Some(start) = self.points.first() else { return 0.0 };
        let defect = |point: &InTimePoint| point.balance.defect(&start.balance).abs();
        let largest = |of: &dyn Fn(&InTimePoint) -> f64| self.points.iter().map(of).fold(0.0, f64::max);
        largest(&defect) / largest(&|point| point.balance.work.abs()).max(f64::MIN_POSITIVE)
    }

    /// Finds the peak among the points.
    pub(super) fn find_peak(&mut self) {
        let forces = self.points.iter().map(|point| point.force).enumerate();
        let Some((k, _)) = forces.max_by(|a, b| a.1.total_cmp(&b.1)) else { return };
        if k == 0 || k + 1 == self.points.len() {
            return;
        }
        let [before, here, after] = [self.points[k - 1], self.points[k], self.points[k + 1]];
        let (a, b) = (here.time - before.time, after.time - here.time);
        let (down, up) = ((here.force - before.force) / a, (after.force - here.force) / b);
        let bend = (up - down) / (a + b);
        // the parabola's slope at the middle point
        let slope = down + bend * a;
        let shift = (-0.5 * slope / bend).clamp(-a, b);
        let rate = (after.displacement - before.displacement) / (a + b);
        self.peak = Some(InTimePeak {
            time: here.time + shift,
            displacement: here.displacement + rate * shift,
            force: here.force + shift * (slope + bend * shift),
        });
    }
}

/// Why a pull was not followed to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum InTimeFailureKind {
    #[error(transparent)]
    Model(#[from] NotInTime),
    #[error("{what} is {value}; it must be {wanted}")]
    OutOfRange { what: &'static str, value: f64, wanted: &'static str },
    #[error(
        "there is no equilibrium at u = {displacement:.6} nm, where the pull in time begins: {cause}; try another `from`"
    )]
    NoStart { displacement: f64, cause: SolveError },
    #[error(transparent)]
    Step(#[from] TimeError),
    #[error(
        "{steps} steps were not enough for the pull: it is at t = {time:.6e} ns of {end:.6e} ns; try a larger tolerance"
    )]
    TooManySteps { steps: usize, time: f64, end: f64 },
}

/// A failure with what was reached.
#[derive(Clone, Debug)]
pub struct InTimeFailure {
    /// Why
    pub why: InTimeFailureKind,
    /// Up to there
    pub reached: Option<Box<PullInTime>>,
}
