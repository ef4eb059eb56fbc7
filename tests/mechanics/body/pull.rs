//! A grip that pulls at an angle to the substrate.
//!
//!      ______________________
//!     |______________________|--> u, P at the angle α     across the pull: free or held
//!     =========================
//!     x(0) = 0 is held
//!
//! References: the same strip with three unknowns a node, where x is one of them and no multiplier; the vertical pull, where H = 0
//! is no unknown; work by quadrature against energies; whole peels at single angles.
//! Parameters: the paper's strip, L = 100 nm, and the default spatula; α from 0 to 180 degrees; `relative` = 1e-6.
//! Expected: the same within both error bounds, or to what stands beside an assertion. Why: the direction enters in three ways, as
//! a force, as a displacement and as a horizontal section force, and each of them can be wrong by a sign. Collocation has its word in
//! `peel verify --only pull`.

use crate::common::{paper_strip, with_grip};
use peelkit::model::{Body, Form, Hold, PeelModel, Pull, Spatula, StripModel};
use peelkit::solve::LimitPointKind;
use peelkit::study::{Accuracy, Choice, LimitPoint, PathEnd, Peel, StopCriteria, TestEnd, observed, peel};

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

fn at_angle(mut model: StripModel, degrees: f64) -> StripModel {
    model.pull = Pull { angle: degrees.to_radians(), ..Pull::UP };
    model
}

fn peeled(model: &PeelModel, form: Form) -> Peel {
    let choice = Choice { form, ..Accuracy::to(1e-6).choice };
    peel(model, &Accuracy::to(1e-6).with(choice), &BOUNDS)
}

/// Peak and turning points of the displacement agree within both bounds.
#[track_caller]
fn assert_agree(a: &Peel, b: &Peel) {
    let turns = |peel: &Peel| -> Vec<LimitPoint> {
        peel.limit_points.iter().filter(|point| point.kind == LimitPointKind::Displacement).copied().collect()
    };
    let (turns_a, turns_b) = (turns(a), turns(b));
    assert_eq!(turns_a.len(), turns_b.len(), "{turns_a:?}\n{turns_b:?}");
    let close = |what: &str, a: f64, b: f64, bound: f64| assert!((a - b).abs() <= bound, "{what}: {a} and {b}");
    for (p, q) in turns_a.iter().zip(&turns_b) {
        close("place", p.displacement, q.displacement, p.displacement_error + q.displacement_error);
        close("force", p.force, q.force, p.force_error + q.force_error);
    }
    let (p, q) = (a.initiation_peak.unwrap(), b.initiation_peak.unwrap());
    close("peak", p.force, q.force, p.force_error + q.force_error);
    assert_eq!(std::mem::discriminant(&a.end), std::mem::discriminant(&b.end));
}

/// Laid down under tension: the same, and work is the change of energy, which at rest is T² L/(2EA) already.
#[test]
fn both_forms_of_a_stretched_strip_agree() {
    for (degrees, tension) in [(90.0, 0.5), (60.0, 0.1), (120.0, 1.0)] {
        let mut model = at_angle(with_grip(paper_strip(100.0, 1.0), Hold::Free, Hold::Fixed), degrees);
        let slack = peeled(&PeelModel::from(model), Form::TwoField);
        model.grip.pretension = Some(tension);
        let model = PeelModel::from(model);
        let (two, three) = (peeled(&model, Form::TwoField), peeled(&model, Form::ThreeField));
        assert_agree(&two, &three);
        let first = two.points[0];
        assert!((first.force - tension * f64::to_radians(degrees).cos()).abs() < 1e-9 * tension, "{first:?}");
        let change = two.initiation_peak.unwrap().force - slack.initiation_peak.unwrap().force;
        assert!(change.abs() > 1e-3 && (degrees > 90.0 || change > 0.0), "{degrees} degrees: {change}");
    }
}

#[test]
fn both_forms_of_the_strip_agree() {
    for (degrees, across) in [(30.0, Hold::Free), (60.0, Hold::Fixed), (120.0, Hold::Free), (150.0, Hold::Fixed)] {
        let model = PeelModel::from(at_angle(with_grip(paper_strip(100.0, 1.0), Hold::Free, across), degrees));
        let (two, three) = (peeled(&model, Form::TwoField), peeled(&model, Form::ThreeField));
        assert!(!matches!(two.end, PathEnd::Failed(_)), "{degrees} degrees: {:?}", two.end);
        assert_agree(&two, &three);
    }
}

#[test]
fn both_forms_of_the_spatula_agree() {
    let strip = paper_strip(100.0, 1.0);
    for degrees in [30.0, 120.0] {
        let spatula = PeelModel { body: Body::Spatula(Spatula::default()), ..at_angle(strip, degrees).into() };
        let bounded = StopCriteria { displacement: Some(40.0), ..BOUNDS };
        let of =
            |form| peel(&spatula, &Accuracy::to(1e-6).with(Choice { form, ..Accuracy::to(1e-6).choice }), &bounded);
        let (two, three) = (of(Form::TwoField), of(Form::ThreeField));
        let (a, b) = (two.points.last().unwrap(), three.points.last().unwrap());
        let force = |peel: &Peel, u: f64| {
            let curve = peel.dense_curve(16);
            let after = curve.iter().position(|point| point.0 > u).unwrap();
            let (from, to) = (curve[after - 1], curve[after]);
            from.1 + (u - from.0) / (to.0 - from.0) * (to.1 - from.1)
        };
        let u = 0.9 * a.displacement.min(b.displacement);
        let (p, q) = (force(&two, u), force(&three, u));
        // linear interpolation between points of the dense curve
        assert!((p / q - 1.0).abs() < 2e-4, "{degrees} degrees, u = {u} nm: {p} and {q} nN");
    }
}

/// A right angle, however it is rounded, is the vertical pull bit for bit; angles beside it are on average the same.
#[test]
fn a_right_angle_is_straight_up() {
    let up = paper_strip(100.0, 1.0);
    assert_eq!(at_angle(up, 90.0).pull.direction(), up.pull.direction());
    let peak = |degrees: f64| peel(&at_angle(up, degrees), &Accuracy::to(1e-9), &BOUNDS).initiation_peak.unwrap().force;
    let (vertical, beside) = (peak(90.0), 0.5 * (peak(89.99) + peak(90.01)));
    assert!((beside / vertical - 1.0).abs() < 1e-7, "{beside} and {vertical}");
}

/// The energies at the points are the work of the force along the pull, whether the grip is free or held across it.
#[test]
fn work_is_the_integral_of_the_force_along_the_pull() {
    for (degrees, across) in [(45.0, Hold::Free), (70.0, Hold::Fixed), (135.0, Hold::Free)] {
        let model = at_angle(with_grip(paper_strip(100.0, 1.0), Hold::Free, across), degrees);
        let peel = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
        let last = peel.snap_off.unwrap().after;
        let until = &peel.points[last];
        let curve = peel.dense_curve(64);
        let end = curve.iter().position(|p| (p.0, p.1) == (until.displacement, until.force)).unwrap();
        let work: f64 = curve[..=end].windows(2).map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0)).sum();
        assert!((work / until.work - 1.0).abs() < 1e-4, "{degrees} degrees: {work} and {} aJ", until.work);
    }
}

/// Jumps, landings and the way back at an angle: work and energy balance (to 1e-6, or there is no end).
#[test]
fn a_test_at_an_angle_closes() {
    for degrees in [60.0, 120.0] {
        let model = at_angle(with_grip(paper_strip(100.0, 1.0), Hold::Fixed, Hold::Free), degrees);
        let test = observed(&model, &Accuracy::to(1e-6), &BOUNDS).unwrap();
        assert_eq!(test.end, TestEnd::Closed, "{degrees} degrees");
        assert!(test.retreat.unwrap().error() <= 1e-6 && test.cycle.unwrap().error() <= 1e-6);
    }
}
