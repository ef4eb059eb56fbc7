//! What ends, points and forms are called in outputs.

use peelkit::model::Form;
use peelkit::study::{
    Bound, Jump, JumpKind, LeftModel, LimitPointKind, ModelLimit, PathEnd, Peel, PeelQuantity, TestEnd,
};
use peelkit_scene::{Described, Scene};

/// The name of an end in outputs.
pub fn end_word(end: &PathEnd) -> &'static str {
    match end {
        PathEnd::Detached => "detached",
        PathEnd::Pivoting => "pivoting",
        PathEnd::Pushing => "pushing",
        PathEnd::TurnedBack => "turned-back",
        PathEnd::BackInPlane => "back-in-plane",
        PathEnd::Sliding => "sliding",
        PathEnd::Snapped => "snapped",
        PathEnd::BondedPartUnstable(_) => "bonded-part-unstable",
        PathEnd::Upright(_) => "upright-section",
        PathEnd::Bound(Bound::Event { .. }) => "event",
        PathEnd::Bound(_) => "bound",
        PathEnd::Failed(failure) if failure.is_refusal() => "refused",
        PathEnd::Failed(_) => "failed",
    }
}

/// Why a path ended where it did, if that was not by itself.
pub fn end_reason(end: &PathEnd) -> Option<String> {
    match end {
        PathEnd::BondedPartUnstable(loss) => Some(loss.to_string()),
        PathEnd::Upright(upright) => Some(upright.to_string()),
        PathEnd::Bound(bound) => Some(bound.to_string()),
        PathEnd::Failed(failure) => Some(failure.to_string()),
        PathEnd::Detached
        | PathEnd::Pivoting
        | PathEnd::Pushing
        | PathEnd::TurnedBack
        | PathEnd::BackInPlane
        | PathEnd::Sliding
        | PathEnd::Snapped => None,
    }
}

/// What the first displacement limit point of a peel is called in print and pictures: its snap-off where nothing else detaches the beam, unless the path
/// was not to be followed further, so that nobody knows.
pub fn first_jump_word(peel: &Peel) -> &'static str {
    let elsewhere = |place: f64| peel.snap_off.is_some_and(|first| first.displacement != place);
    let detached = peel.pad_detachment.into_iter().chain(peel.detachment);
    let unknown = matches!(peel.end, PathEnd::Bound(Bound::Until(_))) && peel.detachment.is_none();
    if unknown || detached.into_iter().any(|at| elsewhere(at.displacement)) { "first jump" } else { "snap-off" }
}

/// The name of a limit point's kind in outputs.
pub fn limit_point_kind_word(kind: LimitPointKind) -> &'static str {
    match kind {
        LimitPointKind::Displacement => "displacement",
        LimitPointKind::Load => "load",
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
        TestEnd::Off => "off",
        TestEnd::Bound(Bound::Event { .. }) => "event",
        TestEnd::Bound(_) => "bound",
        TestEnd::LeftModel(LeftModel { limit: ModelLimit::Bonded(_), .. }) => "bonded-part-unstable",
        TestEnd::LeftModel(LeftModel { limit: ModelLimit::Collapsed(_), .. }) => "collapsed",
        TestEnd::Failed(_) => "failed",
    }
}

/// Why a test ended where it did, if that was not by itself.
pub fn test_end_reason(end: &TestEnd) -> Option<String> {
    match end {
        TestEnd::Closed | TestEnd::Off => None,
        TestEnd::Returned(elsewhere) => Some(elsewhere.to_string()),
        TestEnd::Bound(bound) => Some(bound.to_string()),
        TestEnd::LeftModel(left) => Some(left.to_string()),
        TestEnd::Failed(failure) => Some(failure.to_string()),
    }
}

/// What a jump is called among all jumps of its test, by its number: `snap-off` is the name of a path's point.
pub fn jump_title(jumps: &[Jump], number: usize) -> &'static str {
    match jumps[number].kind {
        JumpKind::IntoContact => "jump into contact",
        JumpKind::SnapOff if jumps[..number].iter().all(|jump| jump.kind == JumpKind::IntoContact) => "first jump",
        JumpKind::SnapOff => "jump",
    }
}

/// The kind of a jump, as files have it.
pub fn jump_word(kind: JumpKind) -> &'static str {
    match kind {
        JumpKind::SnapOff => "snap-off",
        JumpKind::IntoContact => "jump into contact",
    }
}

// -- Which part of the errors of a scene's results is not known --

/// Which part of the errors of the results of a scene has no bound, in words; nothing of a peel, whose peels are as accurate as
/// `accuracy.relative` asks for.
pub fn unknown_error(scene: &Scene) -> Option<&'static str> {
    Some(match scene.describes() {
        Described::Rate(_, None) => {
            "the errors of the mesh and of the steps in time have no bound: compare with another accuracy.elements and a \
             smaller time.tolerance"
        }
        Described::Rate(_, Some(_)) => {
            "the errors of the mesh, of the steps in time and of the law of the tips have no bound: compare with a \
             smaller time.tolerance"
        }
        Described::Solid(_) => "the errors of the mesh of the solid have no bound: compare with a smaller solid.along",
        Described::Array(_) => {
            "events are exact for the law of the setae that is given; how wrong that law is stands beside no result"
        }
        Described::Seta(_) => {
            "the bound on the error of the largest force is that of the mesh of the branches; the error of the law of the \
             tips is not in it, and other results have no bound"
        }
        Described::Peel => return None,
    })
}

/// A number of a run as the title of an axis: "initiation peak, force (nN)".
pub(crate) fn quantity_title(of: PeelQuantity) -> String {
    let name = of.name();
    let words = name.strip_suffix(of.unit()).unwrap_or(name).trim_end_matches('_');
    format!("{} ({})", words.replace('.', ", ").replace('_', " "), of.unit())
}
