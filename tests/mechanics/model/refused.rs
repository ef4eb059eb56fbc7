//! What the analyses give of a model that cannot be computed.
//!
//! Expected: each says what is wrong in the words of the check, and computes nothing; values of a sweep that can be computed are.

use peelkit::model::{ModelError, PeelModel, StripModel};
use peelkit::study::{
    Accuracy, Choice, NoTest, PathEnd, PeelResult, PointKind, Remark, Spacing, StopCriteria, cusp, follow_point,
    observed, peel, sweep,
};

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

fn of_length(length: f64) -> PeelModel {
    StripModel::of_the_paper(length, 1.0).into()
}

fn error(model: &PeelModel) -> ModelError {
    model.check().unwrap_err()
}

#[test]
fn a_peel_ends_as_failed() {
    for length in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        let model = of_length(length);
        let peel = peel(&model, &Accuracy::default(), &BOUNDS);
        let PathEnd::Failed(why) = &peel.end else { panic!("{:?}", peel.end) };
        let (error, why) = (error(&model), why.to_string());
        assert!(why.contains(&error.to_string()) && why.contains(&error.remedy()), "{why}");
        assert!(peel.points.is_empty() && peel.limit_points.is_empty() && peel.effort.newton_iterations == 0);
    }
    let accuracy = Accuracy::default().with(Choice { order: Some(9), ..Choice::NOTHING });
    let peel = peel(&of_length(100.0), &accuracy, &BOUNDS);
    assert!(
        matches!(&peel.end, PathEnd::Failed(why) if why.to_string().contains("`accuracy.order` is 9")),
        "{:?}",
        peel.end
    );
}

#[test]
fn there_is_no_test_and_no_cusp() {
    let model = of_length(0.0);
    let refused = observed(&model, &Accuracy::default(), &BOUNDS).unwrap_err();
    assert_eq!((refused.clone(), refused.remedy()), (NoTest::Model(error(&model)), error(&model).remedy()));
    let why = cusp(&of_length, -1.0, &Accuracy::default()).unwrap_err().to_string();
    assert!(why.contains("`strip.length` is -1 nm"), "{why}");
}

#[test]
fn bad_values_of_a_sweep_are_told_and_the_others_computed() {
    let values = [60.0, 50.0, 0.0, 70.0];
    let accuracy = Accuracy::to(1e-4);
    let followed =
        follow_point(PointKind::InitiationPeak, &values, Spacing::Linear, &of_length, &accuracy, &|| BOUNDS, &|_| ());
    let found: Vec<bool> = followed.rows.iter().map(|row| row.point.is_some()).collect();
    assert_eq!(found, [true, true, false, true]);
    let [Remark::NotFound { value, reason, .. }] = &followed.remarks[..] else { panic!("{:?}", followed.remarks) };
    assert!(*value == 0.0 && reason.to_string().contains("`strip.length` is 0 nm"), "{reason}");

    let found = |&length: &f64| PeelResult::from(&peel(&of_length(length), &accuracy, &BOUNDS));
    let rows = sweep(&[0.0, 50.0], &|| true, &found);
    let failed: Vec<bool> = rows.iter().map(|found| matches!(found.end, PathEnd::Failed(_))).collect();
    assert_eq!(failed, [true, false]);
}
