//! A seta with four tips on the ground, against shooting; work and energy.
//!
//! Reference: `verification/seta.csv`, from `verification/seta.py`: initial value problems of the strong form with rotation matrices, without
//! elements. The seta is drawn in `setup.rs`. Expected: force on the root and places of the tips in equilibria on the way to 1e-7, where the first
//! tip loses its hold to the error with which that is located, and the equilibrium behind it: there every number depends on which tip let go.
//! Between events work and change of energy are the same to 1e-8, the accuracy that was asked for, and every event releases energy.

use super::setup::{along_normal, model, pulled, small};
use approx::assert_abs_diff_eq;
use peelkit::model::Sideways;
use peelkit::study::{
    SetaEnd, SetaLoading, SetaOptions, SetaPoint, SetaStart, SetaState, StepEnd, StopCriteria, pull_off,
};

/// A row of the table: of a tip.
struct Row {
    displacement: f64,
    force: [f64; 3],
    place: [f64; 3],
}

fn rows(case: &str) -> Vec<Row> {
    let table = include_str!("../../../verification/seta.csv");
    let cells = |line: &str| line.split(',').map(str::to_string).collect::<Vec<String>>();
    let number = |cell: &String| cell.parse::<f64>().unwrap();
    let row = |cells: Vec<String>| Row {
        displacement: number(&cells[2]),
        force: std::array::from_fn(|i| number(&cells[3 + i])),
        place: std::array::from_fn(|i| number(&cells[6 + i])),
    };
    table.lines().map(cells).filter(|cells| cells[0] == case).map(row).collect()
}

#[track_caller]
fn assert_same(point: &SetaPoint, row: &Row, bound: f64) {
    (0..3).for_each(|i| assert_abs_diff_eq!(point.force[i], row.force[i], epsilon = bound));
}

#[track_caller]
fn assert_places(state: &SetaState, rows: &[Row], bound: f64) {
    for (tip, row) in rows.iter().enumerate() {
        (0..3).for_each(|i| assert_abs_diff_eq!(state.joints[4 + tip].place[i], row.place[i], epsilon = bound));
    }
}

#[test]
fn equilibria_and_the_first_loss_of_a_tip_agree_with_shooting() {
    for (name, sideways) in [("free", Sideways::Free), ("held", Sideways::Held(0.5))] {
        let model = model(small(), sideways);
        for on_the_way in rows(name).chunks(4) {
            let until = StepEnd::Travel(on_the_way[0].displacement);
            let there = pulled(&model, SetaStart::Adhering, &[along_normal(1.0, until)]);
            assert_eq!(there.end, SetaEnd::Completed);
            let last = there.last.unwrap();
            assert_same(&last.point, &on_the_way[0], 1e-7);
            assert_places(&last, on_the_way, 1e-5);
        }
        let (loss, after) = (rows(&format!("{name} loss")), rows(&format!("{name} after")));
        let whole = pulled(&model, SetaStart::Adhering, &[along_normal(1.0, StepEnd::Detached(5000.0))]);
        let first = &whole.events[0];
        println!("{name}: {} nm, reference {} nm", first.before.displacement, loss[0].displacement);
        assert_abs_diff_eq!(first.before.displacement, loss[0].displacement, epsilon = 1e-5);
        assert_same(&first.before, &loss[0], 1e-4);
        assert_places(&whole.first_detachment.unwrap(), &loss, 1e-2);
        assert_eq!(first.tips.len(), 1);
        assert_same(&first.after, &after[0], 1e-5);
    }
}

#[test]
fn the_work_of_the_root_is_stored_or_released() {
    for sideways in [Sideways::Free, Sideways::Held(0.5)] {
        let whole =
            pulled(&model(small(), sideways), SetaStart::Adhering, &[along_normal(1.0, StepEnd::Detached(5000.0))]);
        assert_eq!(whole.end, SetaEnd::Completed);
        assert_eq!(whole.points.last().unwrap().attached, 0);
        assert!(whole.imbalance() < 1e-8, "{:.2e}", whole.imbalance());
        assert!(whole.events.iter().all(|event| event.released > 0.0));
        // nothing is left of the stored energy or of the adhesion
        let last = whole.points.last().unwrap();
        assert_abs_diff_eq!(last.energy, 0.0, epsilon = 1e-9);
        let largest = whole.points.iter().map(|point| point.force_along).fold(0.0, f64::max);
        assert_eq!(whole.peak.unwrap().point.force_along, largest);
    }
}

/// Peak and first detachment of a pull-off whose steps are short and long.
///
/// Reference: the run whose steps are held to 1e-9. Expected: the same force and displacement, to what each run says of its errors and 1e-8 besides.
#[test]
fn the_peak_does_not_depend_on_the_steps() {
    let model = model(small(), Sideways::Free);
    let loading = SetaLoading { start: SetaStart::Adhering, steps: vec![along_normal(1.0, StepEnd::Detached(5000.0))] };
    let found = |balance| {
        let options = SetaOptions { balance, ..SetaOptions::default() };
        let run = pull_off(&model, &loading, &options, &StopCriteria::default()).unwrap();
        [run.peak.unwrap(), run.first_detachment.unwrap()].map(|state| (state.point, state.location.unwrap()))
    };
    let exact = found(1e-9);
    for balance in [1e-3, 1e-4, 1e-6] {
        for ((point, error), (known, own)) in found(balance).into_iter().zip(&exact) {
            let force = (point.force_along - known.force_along).abs();
            let displacement = (point.displacement - known.displacement).abs();
            println!("{balance}: {} nN, {force:.1e} {displacement:.1e} off, said {error:?}", point.force_along);
            assert!(force <= error.force + own.force + 1e-8 * known.force_along);
            assert!(displacement <= error.displacement + own.displacement + 1e-8 * known.displacement);
        }
    }
}
