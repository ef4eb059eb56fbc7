//! Where the snap-back of a stiff strip vanishes.
//!
//! Reference: `verification/cusp.csv`, the two turning points of the displacement of the paper's strip of 100 nm at five
//! bending stiffnesses below the cusp, by collocation without finite elements. Near a cusp the square of the difference of
//! their forces is a smooth function of EI that vanishes there: its polynomial through five values, carried on to zero,
//! is off by a fifth power of small distances.
//!
//! Expected: the EI that `cusp` finds by following du/dP = d²u/dP² = 0, to 1e-7, within a bound that does not depend on the
//! accuracy asked for; and peels on either side of it that have a snap-off, or none.

use peelkit::model::StripModel;
use peelkit::study::{Accuracy, StopCriteria, cusp, peel};
use peelkit_checks::suite::reference;

fn strip(factor: f64) -> StripModel {
    StripModel::of_the_paper(100.0, factor)
}

/// EI over EI0 at which the squared difference of the forces vanishes: inverse interpolation.
fn extrapolated() -> f64 {
    let rows = reference::read(include_str!("../../verification/cusp.csv"));
    let squares: Vec<(f64, f64)> = rows
        .iter()
        .map(|row| {
            let number = |column| row.number(column).unwrap();
            (number("bending_stiffness_factor"), (number("lp1_force_nN") - number("lp2_force_nN")).powi(2))
        })
        .collect();
    assert_eq!(squares.len(), 5);
    let weight = |i: usize| -> f64 {
        (0..5).filter(|&j| j != i).map(|j| squares[j].1 / (squares[j].1 - squares[i].1)).product()
    };
    (0..5).map(|i| weight(i) * squares[i].0).sum()
}

#[test]
fn the_cusp_is_where_the_turning_points_of_a_collocation_meet() {
    let found = cusp(&strip, 60.0, &Accuracy::to(1e-8)).unwrap();
    let expected = extrapolated();
    println!("EI/EI0 = {:.9} +- {:.1e}, extrapolated {expected:.9}", found.value, found.error);
    assert!((found.value / expected - 1.0).abs() < 1e-7);
    let coarse = cusp(&strip, 66.0, &Accuracy::to(1e-6)).unwrap();
    println!("EI/EI0 = {:.9} +- {:.1e}", coarse.value, coarse.error);
    assert!((coarse.value - found.value).abs() <= coarse.error + found.error);
}

#[test]
fn peels_on_either_side_have_a_snap_off_or_none() {
    let bounds = StopCriteria::after_points(5000);
    for relative in [1e-4, 1e-6, 1e-8] {
        let [below, above] = [74.609, 74.611].map(|factor| peel(&strip(factor), &Accuracy::to(relative), &bounds));
        assert!(below.snap_off.is_some(), "{relative:e}");
        assert_eq!(above.snap_off, None, "{relative:e}");
    }
}

#[test]
fn without_a_snap_back_to_begin_with_there_is_no_cusp() {
    let error = cusp(&strip, 100.0, &Accuracy::to(1e-6)).unwrap_err().to_string();
    assert!(error.contains("no snap-back"), "{error}");
}
