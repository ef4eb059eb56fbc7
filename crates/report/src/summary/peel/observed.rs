//! The displacement-controlled test, as an object of summary.json.

use super::place::{Place, known};
use crate::names::{jump_word, test_end_reason, test_end_word};
use crate::number::Finite;
use peelkit::study::{Balance, Jump, JumpEnd, Observed, PullOff, UnknownJumpError};
use serde::Serialize;

/// The object `observed` of summary.json; `None` where a thing does not occur or was not reached.
#[derive(Debug, Serialize)]
pub struct ObservedSummary {
    end: &'static str,
    /// Of every end but `closed`.
    reason: Option<String>,
    #[serde(rename = "pull_off_force_nN")]
    pull_off_force: Option<Finite>,
    #[serde(rename = "pull_off_error_nN")]
    pull_off_error: Option<Finite>,
    /// What adheres there: pad, edge or end face.
    pull_off_adheres: Option<&'static str>,
    /// The largest force before the beam stood on the face of its end; `None` where it never does.
    before_upright: Option<ForceLine>,
    /// ∮ P dU
    #[serde(rename = "hysteresis_aJ")]
    hysteresis: Option<Finite>,
    jumps: Vec<JumpLine>,
    work_balance: Balances,
    accuracy_reached: Option<Finite>,
    effort: Effort,
}

#[derive(Debug, Serialize)]
struct JumpLine {
    kind: &'static str,
    way: &'static str,
    #[serde(rename = "machine_displacement_nm")]
    machine: Finite,
    #[serde(rename = "error_nm")]
    machine_error: Finite,
    before: EndLine,
    after: EndLine,
    #[serde(rename = "released_aJ")]
    released: Finite,
    #[serde(rename = "released_error_aJ")]
    released_error: Option<Finite>,
    landed: &'static str,
    /// The code of what is unknown of it.
    warning: Option<&'static str>,
    relaxation_steps: usize,
}

#[derive(Debug, Serialize)]
struct EndLine {
    #[serde(flatten)]
    place: Place,
    #[serde(rename = "energy_aJ")]
    energy: Finite,
    #[serde(rename = "front_nm")]
    front: Finite,
    adheres: &'static str,
}

/// A largest force of a stretch of the test.
#[derive(Debug, Serialize)]
struct ForceLine {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    #[serde(rename = "machine_displacement_nm")]
    machine: Finite,
    adheres: &'static str,
}

impl From<PullOff> for ForceLine {
    fn from(peak: PullOff) -> Self {
        Self {
            force: Finite(peak.force),
            force_error: Finite(peak.force_error),
            machine: Finite(peak.machine),
            adheres: peak.adheres.word(),
        }
    }
}

#[derive(Debug, Serialize)]
struct Balances {
    retreat: Option<BalanceLine>,
    cycle: Option<BalanceLine>,
}

#[derive(Debug, Serialize)]
struct BalanceLine {
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "energy_change_aJ")]
    energy_change: Finite,
    #[serde(rename = "released_aJ")]
    released: Finite,
    /// What is not accounted for, over the largest term.
    relative_error: Finite,
}

#[derive(Debug, Serialize)]
struct Effort {
    points: usize,
    newton_iterations: usize,
    relaxation_steps: usize,
    elements: usize,
    order: usize,
    solve_s: Finite,
}

impl ObservedSummary {
    /// Of a test that took so many seconds.
    pub fn new(test: &Observed, solve_s: f64) -> Self {
        Self {
            end: test_end_word(&test.end),
            reason: test_end_reason(&test.end),
            pull_off_force: test.pull_off.map(|peak| Finite(peak.force)),
            pull_off_error: test.pull_off.map(|peak| Finite(peak.force_error)),
            pull_off_adheres: test.pull_off.map(|peak| peak.adheres.word()),
            before_upright: test.before_upright.map(ForceLine::from),
            hysteresis: test.hysteresis.map(Finite),
            jumps: test.jumps.iter().map(JumpLine::from).collect(),
            work_balance: Balances {
                retreat: test.retreat.map(BalanceLine::from),
                cycle: test.cycle.map(BalanceLine::from),
            },
            accuracy_reached: Some(test.reached).filter(|reached| reached.is_finite()).map(Finite),
            effort: Effort {
                points: test.effort.points,
                newton_iterations: test.effort.newton_iterations,
                relaxation_steps: test.effort.relaxation_steps,
                elements: test.effort.elements,
                order: test.effort.order,
                solve_s: Finite(solve_s),
            },
        }
    }
}

impl From<&Jump> for JumpLine {
    fn from(jump: &Jump) -> Self {
        Self {
            kind: jump_word(jump.kind),
            way: jump.way.word(),
            machine: Finite(jump.machine),
            machine_error: Finite(jump.machine_error),
            before: EndLine::from(&jump.before),
            after: EndLine::from(&jump.after),
            released: Finite(jump.released),
            released_error: known(jump.released_error),
            landed: if jump.detached { "detached" } else { "adhered" },
            warning: (!jump.released_error.is_finite()).then_some(UnknownJumpError::CODE),
            relaxation_steps: jump.steps,
        }
    }
}

impl From<&JumpEnd> for EndLine {
    fn from(end: &JumpEnd) -> Self {
        Self {
            place: Place::from(end),
            energy: Finite(end.energy),
            front: Finite(end.front),
            adheres: end.adheres.word(),
        }
    }
}

impl From<Balance> for BalanceLine {
    fn from(balance: Balance) -> Self {
        Self {
            work: Finite(balance.work),
            energy_change: Finite(balance.energy_change),
            released: Finite(balance.released),
            relative_error: Finite(balance.error()),
        }
    }
}
