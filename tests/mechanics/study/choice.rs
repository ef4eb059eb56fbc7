//! What a user may fix of the discretisation: order, elements, steps, the fixed mesh, the form with three fields.
//!
//! Reference: verification/strip.csv, the 100 nm strip, collocation without finite elements.
//!
//!      ______________________
//!     |______________________|/ ^ u, P
//!     =========================
//!
//! Parameters: the paper's strip, L = 100 nm.
//!
//! Expected: what is fixed is what was computed with; where the elements are fixed the result is reported with bounds that
//! hold, as wrong as it may be; every mesh and form comes to the same peak and snap-off, within its bounds. Why: a choice that
//! is not honoured, or bounds that hold for the program's own choice alone, would make every comparison of choices worthless.

use crate::common::paper_strip;
use peelkit::beam::MeshKind;
use peelkit::model::Form;
use peelkit::study::{Accuracy, Choice, PathEnd, Peel, StopCriteria, peel};

/// (u, P) of peak and snap-off, strip.csv.
const PEAK: (f64, f64) = (0.249601344023, 0.341121483196);
const SNAP_OFF: (f64, f64) = (48.2156178228, 0.0375627292271);

fn run(relative: f64, choice: Choice) -> Peel {
    let bounds = StopCriteria::after_points(20_000);
    peel(&paper_strip(100.0, 1.0), &Accuracy::to(relative).with(choice), &bounds)
}

/// The largest relative error of peak and snap-off; each is within its bound.
#[track_caller]
fn error(peel: &Peel) -> f64 {
    let (peak, snap) = (peel.initiation_peak.expect("a peak"), peel.snap_off.expect("a snap-off"));
    let numbers = [
        (peak.displacement, peak.displacement_error, PEAK.0),
        (peak.force, peak.force_error, PEAK.1),
        (snap.displacement, snap.displacement_error, SNAP_OFF.0),
        (snap.force, snap.force_error, SNAP_OFF.1),
    ];
    numbers.iter().fold(0.0, |worst, &(value, bound, exact)| {
        let error = (value - exact).abs();
        assert!(error <= bound + 1e-11 * exact, "{value} ± {bound:.1e}, expected {exact}: {:?}", peel.effort);
        f64::max(worst, error / exact)
    })
}

fn free() -> Choice {
    Accuracy::to(1e-6).choice
}

#[test]
fn what_is_fixed_is_computed_with() {
    for order in 3..=8 {
        let found = run(1e-6, Choice { order: Some(order), elements: Some(25), ..free() });
        assert_eq!((found.effort.order, found.effort.elements), (order, 25));
        assert_eq!(found.end, PathEnd::Pivoting);
        let error = error(&found);
        assert!(error < [1.0, 1.0, 1.0, 3e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-8][order], "order {order}: {error:.1e}");
    }
}

/// Effort: a hundredth of the step tolerance takes more points, though long steps are halved where the curve needs it, and gives
/// the same numbers.
#[test]
fn shorter_steps_take_more_points() {
    let [long, short] = [1e-1, 1e-3].map(|step| run(1e-6, Choice { step: Some(step), ..free() }));
    assert!(2 * short.points.len() > 3 * long.points.len(), "{:?} {:?}", long.effort, short.effort);
    assert!(error(&long) < 1e-6 && error(&short) < 1e-6);
}

/// Coarse as the elements are, they stay, and the bounds say so.
#[test]
fn fixed_elements_are_kept_and_bounded() {
    let found = run(1e-9, Choice { elements: Some(9), ..free() });
    assert_eq!((found.effort.elements, &found.end), (9, &PathEnd::Pivoting));
    let error = error(&found);
    assert!((1e-7..1e-3).contains(&error), "{error:.1e}");
}

#[test]
fn meshes_that_stay_and_three_fields_agree() {
    for (mesh, form, elements) in [
        (MeshKind::Graded, Form::TwoField, 60),
        (MeshKind::Uniform, Form::TwoField, 120),
        (MeshKind::Moving, Form::ThreeField, 20),
    ] {
        let found = run(1e-6, Choice { mesh, form, elements: Some(elements), ..free() });
        assert_eq!(found.end, PathEnd::Pivoting, "{mesh:?} {form:?}");
        let error = error(&found);
        assert!(error < 1e-6, "{mesh:?} {form:?}: {error:.1e}");
    }
}

/// Where nothing is fixed, every accuracy is met.
#[test]
fn every_accuracy_is_met() {
    for digits in 2..=10 {
        let relative = 10f64.powi(-digits);
        let error = error(&run(relative, free()));
        assert!(error <= relative, "{relative:e}: {error:.1e}");
    }
}
