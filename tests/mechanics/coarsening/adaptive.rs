//! A table that is backed by its spatula: where it is not good enough the spatula itself is solved, and the table grows.
//!
//! Reference: the spatula solved at the same place; a table that was made as wide to begin with.
//! Parameters: the default spatula with a pad that slides; θ within ±0.05 rad, to 1e-2.
//! Expected: within the table nothing is solved; outside, and where the error allowed is below that of the table, it is, with forces that agree where
//! the table is known; a table that has grown holds the place; what cannot be is an error with its numbers.

use super::{at, spatula};
use peelkit::study::coarsening::{
    AdaptiveTable, Coarsening, CoarseningError, CoarseningOptions, HeldError, OptionsError, PadEnd, TipRange, TipSheet,
    coarsen,
};

fn options() -> CoarseningOptions {
    let range = TipRange { press: 10.0, rotation: [-0.05, 0.05], ..TipRange::SLIDING };
    CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) }
}

#[test]
fn it_solves_the_spatula_where_the_table_ends_and_grows() {
    let coarsening = Coarsening::new(&spatula(), &options()).unwrap();
    let mut adaptive = AdaptiveTable::new(coarsening, 1e-2).unwrap();
    let inside = at(200.0, 0.0, 0.02);
    adaptive.response(TipSheet::Attached, inside).unwrap();
    assert_eq!((adaptive.record().asked, adaptive.record().resolved), (1, 0));
    let outside = at(200.0, 0.0, 0.08);
    assert!(!adaptive.table().contains(TipSheet::Attached, outside));
    let solved = adaptive.response(TipSheet::Attached, outside).unwrap();
    assert_eq!(adaptive.record().resolved, 1);
    assert!(adaptive.record().changed[0] > 0.0);
    adaptive.grow().unwrap();
    assert!(adaptive.table().contains(TipSheet::Attached, outside));
    let grown = adaptive.response(TipSheet::Attached, outside).unwrap();
    assert_eq!((adaptive.record().resolved, adaptive.record().grown), (1, 1));
    let bound = adaptive.table().attached_errors.force;
    for i in [0, 2] {
        assert!((grown.force[i] - solved.force[i]).abs() <= bound[i], "{i}: {grown:?} {solved:?}");
        assert!((grown.stiffness[i][i] - solved.stiffness[i][i]).abs() < 0.02 * solved.stiffness[i][i].abs());
    }
    assert!((grown.energy - solved.energy).abs() < 0.1, "{} {}", grown.energy, solved.energy);
}

#[test]
fn it_grows_where_a_tip_is_pressed_farther() {
    let mut adaptive = AdaptiveTable::new(Coarsening::new(&spatula(), &options()).unwrap(), 1e-2).unwrap();
    let pressed = at(-60.0, 0.0, 0.01);
    assert!(!adaptive.table().contains(TipSheet::Attached, pressed));
    adaptive.response(TipSheet::Attached, pressed).unwrap();
    adaptive.grow().unwrap();
    assert!(adaptive.table().contains(TipSheet::Attached, pressed));
    let wide = TipRange { press: 100.0, ..options().range };
    let wide = coarsen(&spatula(), &CoarseningOptions { range: wide, ..options() }).unwrap();
    let [grown, made] = [adaptive.table(), &wide].map(|table| table.response(TipSheet::Attached, pressed));
    let bound = adaptive.table().attached_errors.force[0] + wide.attached_errors.force[0];
    assert!((grown.force[0] - made.force[0]).abs() <= bound, "{grown:?} {made:?}");
}

#[test]
fn where_less_error_is_allowed_every_tip_is_solved() {
    let coarsening = Coarsening::new(&spatula(), &options()).unwrap();
    let mut adaptive = AdaptiveTable::new(coarsening, 1e-6).unwrap();
    let [begin, end] = adaptive.table().detached.ends(at(0.0, 0.0, -0.01));
    let near = 0.5 * (begin + end);
    for (on, normal) in [(TipSheet::Attached, 120.0), (TipSheet::Attached, 330.0), (TipSheet::Detached, near)] {
        let place = at(normal, 0.0, -0.01);
        let solved = adaptive.response(on, place).unwrap();
        let table = adaptive.table();
        let found = table.response(on, place);
        let bound = table.errors(on).force;
        assert!((found.force[0] - solved.force[0]).abs() <= bound[0], "{found:?} {solved:?}");
        assert!((found.force[2] - solved.force[2]).abs() <= bound[2], "{found:?} {solved:?}");
    }
    assert_eq!(adaptive.record().resolved, 3);
    assert!(adaptive.response(TipSheet::Attached, at(500.0, 0.0, 0.0)).is_err());
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
