//! What ends, points and forms are called in outputs.

use peelkit::model::Form;
use peelkit::study::{End, JumpKind, TestEnd, Turn};

/// The name of an end in outputs.
pub fn end_word(end: &End) -> &'static str {
    match end {
        End::Detached => "detached",
        End::Pivoting => "pivoting",
        End::TurnedBack => "turned-back",
        End::Sliding => "sliding",
        End::Snapped => "snapped",
        End::Bound(_) => "bound",
        End::Failed(_) => "failed",
    }
}

/// Why a path ended where it did, if that was not by itself.
pub fn end_reason(end: &End) -> Option<&str> {
    match end {
        End::Bound(reason) | End::Failed(reason) => Some(reason),
        End::Detached | End::Pivoting | End::TurnedBack | End::Sliding | End::Snapped => None,
    }
}

/// The name of a limit point's kind in outputs.
pub fn turn_word(turn: Turn) -> &'static str {
    match turn {
        Turn::Displacement => "displacement",
        Turn::Load => "load",
    }
}

/// The form in a word.
pub fn form_word(form: Form) -> &'static str {
    match form {
        Form::TwoField => "two-field",
        Form::ThreeField => "three-field",
    }
}

/// The name of the end of an observed test.
pub fn test_end_word(end: &TestEnd) -> &'static str {
    match end {
        TestEnd::Closed => "closed",
        TestEnd::Returned(_) => "returned",
        TestEnd::Bound(_) => "bound",
        TestEnd::Failed(_) => "failed",
    }
}

/// The name of a jump.
pub fn jump_word(kind: JumpKind) -> &'static str {
    match kind {
        JumpKind::SnapOff => "snap-off",
        JumpKind::IntoContact => "jump into contact",
    }
}
