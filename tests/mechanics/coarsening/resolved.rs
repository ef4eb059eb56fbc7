//! The spatula itself, solved where a table is known, and where it is not.
//!
//! Reference: the table, within its bounds; a wider table.
//! Parameters: the default spatula with a pad that slides; θ within ±0.05 rad, to 1e-2.
//! Expected: forces within the bounds of the table; outside of it, those of a table that is wide enough; what cannot be is an error with its numbers.

use super::{at, spatula};
use peelkit::study::coarsening::{
    Coarsening, CoarseningError, CoarseningOptions, HeldError, OptionsError, PadEnd, TipRange, TipSheet, coarsen,
};

fn options() -> CoarseningOptions {
    let range = TipRange { press: 10.0, rotation: [-0.05, 0.05], ..TipRange::SLIDING };
    CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) }
}

#[test]
fn within_a_table_the_spatula_is_within_its_bounds() {
    let mut coarsening = Coarsening::new(&spatula(), &options()).unwrap();
    let table = coarsening.table().unwrap();
    let [begin, end] = table.detached.ends(at(0.0, 0.0, -0.01));
    let near = 0.5 * (begin + end);
    for (on, normal) in [(TipSheet::Attached, 120.0), (TipSheet::Attached, 330.0), (TipSheet::Detached, near)] {
        let place = at(normal, 0.0, -0.01);
        let solved = coarsening.resolve(on, place).unwrap();
        let found = table.response(on, place);
        let bound = table.errors(on).force;
        assert!((found.force[0] - solved.force[0]).abs() <= bound[0], "{found:?} {solved:?}");
        assert!((found.force[2] - solved.force[2]).abs() <= bound[2], "{found:?} {solved:?}");
    }
    assert!(coarsening.resolve(TipSheet::Attached, at(500.0, 0.0, 0.0)).is_err());
}

#[test]
fn outside_of_a_table_it_is_what_a_wider_one_says() {
    let mut coarsening = Coarsening::new(&spatula(), &options()).unwrap();
    let table = coarsening.table().unwrap();
    let turned = TipRange { rotation: [-0.05, 0.08], ..options().range };
    let pressed = TipRange { press: 100.0, ..options().range };
    for (outside, range) in [(at(200.0, 0.0, 0.08), turned), (at(-60.0, 0.0, 0.01), pressed)] {
        assert!(!table.contains(TipSheet::Attached, outside));
        let solved = coarsening.resolve(TipSheet::Attached, outside).unwrap();
        let extrapolated = table.response(TipSheet::Attached, outside);
        assert!((extrapolated.force[0] - solved.force[0]).abs() > 0.0);
        let wider = coarsen(&spatula(), &CoarseningOptions { range, ..options() }).unwrap();
        assert!(wider.contains(TipSheet::Attached, outside));
        let known = wider.response(TipSheet::Attached, outside);
        let bound = wider.attached_errors.force;
        for i in [0, 2] {
            assert!((known.force[i] - solved.force[i]).abs() <= bound[i], "{i}: {known:?} {solved:?}");
            assert!((known.stiffness[i][i] - solved.stiffness[i][i]).abs() < 0.02 * solved.stiffness[i][i].abs());
        }
        assert!((known.energy - solved.energy).abs() < 0.1, "{} {}", known.energy, solved.energy);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let wrong = CoarseningOptions { tolerance: 0.0, ..options() };
    let refused = |options: &CoarseningOptions| coarsen(&spatula(), options).unwrap_err();
    assert!(matches!(refused(&wrong), CoarseningError::Options(OptionsError::Tolerance { .. })));
    let range = TipRange { rotation: [0.1, 0.2], ..options().range };
    let wrong = CoarseningOptions { range, ..options() };
    assert!(matches!(refused(&wrong), CoarseningError::Options(OptionsError::Range { name: "rotation", .. })));
    let mut model = spatula();
    model.steps = vec![peelkit::model::Step::Press(0.1)];
    assert!(matches!(coarsen(&model, &options()), Err(CoarseningError::Refused { .. })));
    // turned so far down that nothing holds it: no table, and where that is
    let range = TipRange { press: 50.0, rotation: [-0.1, 1.4], ..options().range };
    let wide = CoarseningOptions { range, ..options() };
    let why = coarsen(&spatula(), &wide).unwrap_err();
    assert!(matches!(why, CoarseningError::Held(_)) && why.to_string().contains("rad"), "{why}");
    let _: fn(HeldError) -> CoarseningError = CoarseningError::from;
}
