//! The first stable branch of a path as a machine with a spring records it.

use super::pulled_curve::PulledCurve;
use crate::number::root::Bracket;
use crate::solve::path::hermite::Hermite;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::search::LimitPointKind;
use crate::study::parameters::fit::result::PointPlace;
use crate::study::parameters::sensitivity::force::{ForceOnBranch, forces_on_branch};
use crate::study::parameters::sensitivity::quantity::Variation;
use crate::study::parameters::sensitivity::quantity::{NoSensitivities, PeelQuantity};
use crate::study::parameters::sensitivity::run::sensitivities;
use crate::study::peel::result::Peel;

/// A point of the branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study::parameters::fit) struct BranchPoint {
    /// u of the grip, nm
    pub grip: f64,
    /// P, nN
    pub force: f64,
    /// dP/du, nN/nm
    pub slope: f64,
}

/// Where the branch ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study::parameters::fit) struct BranchEnd {
    /// U* of the machine, nm
    pub machine: f64,
    /// What is computed there
    pub at: BranchPoint,
    /// Whether U turns there: the beam jumps. Else the path was not followed any further.
    pub jumps: bool,
}

/// (U, P) from the start of a path to its first jump.
#[derive(Clone, Debug)]
pub(in crate::study::parameters::fit) struct MachineCurve {
    steps: Vec<Step>,
    /// 1/k, nm/nN
    pub compliance: f64,
    /// U and P where the path begins
    pub start: (f64, f64),
    pub end: BranchEnd,
    /// The branch is solved for up to here, nm: next to a limit point of u, where its slope is not infinite yet
    furthest: f64,
}

/// One step of the path, by a label that is 0 at its beginning.
#[derive(Clone, Debug)]
struct Step {
    displacement: Hermite,
    force: Hermite,
    /// U at its beginning, nm
    machine: f64,
    /// Label at its end, or at that of the branch
    until: f64,
}

/// Places of a step at which the slope of U is looked at.
const LOOKS: usize = 32;
/// How far before a limit point of u the branch is solved for, over its place.
const BEFORE_LIMIT: f64 = 1e-7;
/// How sharp a place is looked for, over a step.
const SHARP: f64 = 1e-15;

impl MachineCurve {
    /// Of a path whose solutions are known; nothing where it has no step.
    pub(crate) fn of(peel: &Peel) -> Option<Self> {
        let history = peel.trace.as_ref()?;
        let compliance = peel.model.grip.stiffness.map_or(0.0, f64::recip);
        let turn = peel.limit_points.iter().find(|point| point.kind == LimitPointKind::Displacement);
        let last = turn.map_or(history.points.len().checked_sub(2)?, |turn| turn.after);
        let furthest = match turn {
            Some(turn) => turn.displacement - BEFORE_LIMIT * turn.displacement.abs(),
            None => history.points.last()?.observables.displacement,
        };
        let mut curve = Self {
            furthest,
            steps: Vec::with_capacity(last + 1),
            compliance,
            start: (0.0, 0.0),
            end: BranchEnd { machine: 0.0, at: BranchPoint { grip: 0.0, force: 0.0, slope: 0.0 }, jumps: false },
        };
        for index in 0..=last {
            let segment = PathSegment::around(&history.problem, &history.points, index);
            let middle = 0.5 * segment.end();
            let mut step = Step {
                displacement: segment.observable(|o| o.displacement, middle),
                force: segment.observable(|o| o.force, middle),
                machine: 0.0,
                until: segment.end(),
            };
            step.machine = step.machine_at(0.0, compliance).0;
            let turned = step.turning_point(compliance, segment.end());
            step.until = turned.unwrap_or(segment.end());
            curve.steps.push(step);
            if turned.is_some() {
                curve.end.jumps = true;
                break;
            }
        }
        let (first, newest) = (curve.steps.first()?, curve.steps.last()?);
        curve.start = (first.machine, first.force.at(0.0).0);
        curve.end.machine = newest.machine_at(newest.until, compliance).0;
        curve.end.at = newest.at(newest.until);
        if let Some(turn) = turn.filter(|_| compliance == 0.0) {
            (curve.end.jumps, curve.end.machine) = (true, turn.displacement);
            (curve.end.at.grip, curve.end.at.force) = (turn.displacement, turn.force);
        }
        Some(curve)
    }

    /// Where the machine is at U, which lies between start and end of the branch.
    pub(crate) fn at(&self, machine: f64) -> BranchPoint {
        let step = self.steps.partition_point(|step| step.machine <= machine).max(1) - 1;
        let step = &self.steps[step];
        let is_before = |label: f64| step.machine_at(label, self.compliance).0 < machine;
        let narrow = SHARP * step.until;
        let label = Bracket { low: 0.0, high: step.until }.bisected(is_before, |left| left.width() <= narrow).middle();
        let at = step.at(label);
        BranchPoint { grip: at.grip.min(self.furthest), ..at }
    }

    /// u of the grip where the branch ends, as far as it is solved for, nm.
    pub(crate) fn last_grip(&self) -> f64 {
        self.end.at.grip.min(self.furthest)
    }

    /// dP/dU at a point of it, nN/nm.
    pub(crate) fn machine_slope(&self, at: &BranchPoint) -> f64 {
        at.slope / (1.0 + self.compliance * at.slope)
    }

    /// (U, P) at so many places of each step, to be drawn.
    pub(crate) fn points(&self, per_step: usize) -> Vec<(f64, f64)> {
        let place = |step: &Step, k: usize| {
            let label = step.until * k as f64 / per_step as f64;
            (step.machine_at(label, self.compliance).0, step.force.at(label).0)
        };
        let inner = self.steps.iter().flat_map(|step| (0..per_step).map(move |k| place(step, k)));
        inner.chain([(self.end.machine, self.end.at.force)]).collect()
    }
}

impl Step {
    /// U and its slope by the label.
    fn machine_at(&self, label: f64, compliance: f64) -> (f64, f64) {
        let (u, p) = (self.displacement.at(label), self.force.at(label));
        (u.0 + compliance * p.0, u.1 + compliance * p.1)
    }

    fn at(&self, label: f64) -> BranchPoint {
        let (u, p) = (self.displacement.at(label), self.force.at(label));
        BranchPoint { grip: u.0, force: p.0, slope: p.1 / u.1 }
    }

    /// The first label at which U turns.
    fn turning_point(&self, compliance: f64, end: f64) -> Option<f64> {
        let slope = |label: f64| self.machine_at(label, compliance).1;
        let place = |k: usize| end * k as f64 / LOOKS as f64;
        let after = (1..=LOOKS).find(|&k| slope(place(k)) <= 0.0)?;
        let narrow = SHARP * end;
        let bracket = Bracket { low: place(after - 1), high: place(after) };
        Some(bracket.bisected(|label| slope(label) > 0.0, |left| left.width() <= narrow).middle())
    }
}

// -- What the model says of a measured point, and how that changes with the parameters --

/// The branch is taken to end this share of its length before its jump: there its slope becomes infinite, and what is interpolated of it good to few digits.
const EDGE: f64 = 1e-3;

/// What the model says of one measured point.
///
/// Before the start of the path the curve is reflected at it, P(U₀ - δ) = 2 P₀ - P(U₀ + δ), which is right to the first order of δ; behind the jump
/// it keeps the force that it has there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::study::parameters::fit) struct Modelled {
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
    pub(crate) fn at(curve: &MachineCurve, machine: f64) -> Self {
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
    pub(crate) fn of_pull(curve: &PulledCurve, (start, end): (f64, f64), machine: f64) -> Self {
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

    /// The same with a force zero, nN.
    pub(crate) fn above(self, force_zero: f64) -> Self {
        Self { force: self.force + force_zero, ..self }
    }

    /// u of the grip at the point of the branch, nm.
    pub(crate) fn grip(&self) -> f64 {
        self.at.grip
    }

    /// dP/dx at the measured displacement.
    pub(crate) fn derivative(&self, curve: &MachineCurve, change: &Change) -> f64 {
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
pub(in crate::study::parameters::fit) struct Change {
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

// -- How the displacement of the first jump changes with the parameters --

/// dU*/dx of the first jump, a number a variation: 0 where the path ends without one. `compliance` is d(1/k)/dx.
///
/// U = u + P/k is largest there, so that only what U depends on directly counts: dU*/dx = P d(1/k)/dx + du/dx at held P. Of a rigid machine it
/// is that of the limit point; else du/dx = -(dP/dx at held u)/(dP/du), both at one solution, because a stiff machine jumps where both are large.
pub(in crate::study::parameters::fit) fn jump_derivatives(
    peel: &Peel,
    curve: &MachineCurve,
    variations: &[Variation],
    compliance: &[f64],
) -> Result<Vec<f64>, NoSensitivities> {
    if !curve.end.jumps {
        return Ok(vec![0.0; variations.len()]);
    }
    if curve.compliance == 0.0 {
        let found = sensitivities(peel, &[PeelQuantity::FirstJumpDisplacement], variations)?;
        let own =
            |k: usize| found.of(PeelQuantity::FirstJumpDisplacement, k).map_or(0.0, |derivative| derivative.value);
        let changed = compliance.iter().map(|change| change * curve.end.at.force);
        return Ok(changed.enumerate().map(|(k, direct)| own(k) + direct).collect());
    }
    let at_end = forces_on_branch(peel, &[curve.last_grip()], variations)?;
    let one = |at: &ForceOnBranch| {
        let changes = at.derivatives.iter().zip(compliance);
        changes.map(|(force, change)| change * at.force - force / at.slope).collect()
    };
    Ok(at_end.first().map_or_else(Vec::new, one))
}
