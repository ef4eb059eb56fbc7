//! Error bounds of the results, and what was left out.

use crate::names::form_word;
use crate::number::Finite;
use peelkit::model::Form;
use peelkit::study::Peel;

/// The accuracy of a peel as summary.json reports it.
#[derive(Debug, serde::Serialize)]
pub(super) struct AccuracySummary {
    /// Relative.
    asked: Finite,
    /// The largest relative error bound of what is reported.
    reached: Option<Finite>,
    /// Whether that is what was asked for; `None` where nothing has a bound.
    met: Option<bool>,
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
            reached: peel.reached_accuracy().map(Finite),
            met: peel.reached_accuracy().map(|reached| reached <= peel.asked),
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

/// What the list of limit points leaves out, in words.
pub fn left_out(peel: &Peel) -> Option<&'static str> {
    (peel.ripple > 0).then_some("load limit points between which the force changes by less than the accuracy asked for")
}
