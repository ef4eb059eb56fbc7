//! How far what is reported may be wrong, and what was left out.

use super::number::Finite;
use crate::model::Form;
use crate::study::{Peel, Turn};

/// The accuracy of a peel as summary.json tells it.
#[derive(Debug, serde::Serialize)]
pub(super) struct AccuracySummary {
    /// Relative.
    asked: Finite,
    /// The largest relative error bound of what is reported.
    reached: Option<Finite>,
    load_limit_points_left_out: usize,
    left_out: Option<&'static str>,
    /// Which unknowns a node has, and whether that leaves anything out.
    form: &'static str,
    form_note: &'static str,
}

impl AccuracySummary {
    pub fn of(peel: &Peel) -> Self {
        Self {
            asked: Finite(peel.asked),
            reached: reached_accuracy(peel).map(Finite),
            load_limit_points_left_out: peel.ripple,
            left_out: left_out(peel),
            form: form_word(peel.choice.form),
            form_note: match peel.choice.form {
                Form::TwoField => "left out: x is minimised out exactly (no effect)",
                Form::ThreeField => "nothing left out: x, y and θ at every node",
            },
        }
    }
}

/// The form in a word.
pub(super) fn form_word(form: Form) -> &'static str {
    match form {
        Form::TwoField => "two-field",
        Form::ThreeField => "three-field",
    }
}

/// The largest relative error bound of the forces and displacements of the limit points and the peaks; `None` where there
/// are none. A limit point around which the force is flat counts with its force alone.
pub fn reached_accuracy(peel: &Peel) -> Option<f64> {
    // zero has no relative error
    let relative = |error: f64, value: f64| if value == 0.0 { 0.0 } else { (error / value).abs() };
    let turns = peel.limit_points.iter().flat_map(|at| {
        let place = if at.flat { 0.0 } else { relative(at.displacement_error, at.displacement) };
        [place, relative(at.force_error, at.force)]
    });
    // a peak that is no limit point is the end of the path
    let at_turn = |force: f64| peel.limit_points.iter().any(|at| at.kind == Turn::Load && at.force == force);
    let peak = peel.peak.filter(|peak| !at_turn(peak.force)).into_iter().flat_map(|peak| {
        [relative(peak.displacement_error, peak.displacement), relative(peak.force_error, peak.force)]
    });
    turns.chain(peak).reduce(f64::max)
}

/// What the list of limit points leaves out, in words.
pub fn left_out(peel: &Peel) -> Option<&'static str> {
    (peel.ripple > 0).then_some("load limit points between which the force changes by less than the accuracy asked for")
}
