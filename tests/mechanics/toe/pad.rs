//! A toe whose lamellae are branches, against bands in one piece and against rigid lamellae.
//!
//! Reference: a dense solution for lamellae that turn without bending; a toe of lamellae with one row each is a lamella.
//! The pad of the reference on rigid lamellae is `verification/toe.csv`, T3. Expected: equal, but for how far the limits of stiffness are taken.

use crate::toe::setup::{COLUMNS, PITCH, STIFFNESS, UM, UN, lamella, table};
use approx::assert_relative_eq;
use nalgebra::{DMatrix, DVector};
use peelkit::toe::{ArrayDrive, ArrayEnd, BandSection, Lamella, RootLaw, Scatter, SetaArray, Toe};
use std::f64::consts::FRAC_PI_2;

const LIFT: ArrayDrive = ArrayDrive::Force { angle: FRAC_PI_2 };

/// The pad of the reference; setae let go together at the limit of a lamella in shear.
fn toe(joined_at: Option<usize>) -> Toe {
    let whole = 60.0 * COLUMNS as f64 * STIFFNESS;
    let limit = 30f64.to_radians().tan() * 2e6 * UN / 12.0;
    let law = RootLaw::Spring { stiffness: STIFFNESS, reach: limit / whole };
    let pad = BandSection { bending: 2e11 * UN * UM * UM, axial: 1.35e8 * UN };
    Toe { lamellae: 12, pitch: 500.0 * UM, pad, lamella: Lamella { law, ..lamella(60) }, joined_at }
}

#[test]
fn rigid_lamellae() {
    let found = toe(None).follow(LIFT, [0.0; 3], 5).unwrap();
    for (number, event) in found.events.iter().enumerate() {
        let wanted = table()[&("T3".to_owned(), format!("end lifted loss {} uN", number + 1))];
        assert_relative_eq!(event.load / UN, wanted, max_relative = 1e-8);
        assert_eq!((event.row, event.setae.len()), (number, 60 * COLUMNS));
    }
}

/// Lamellae that do not bend, joined at one row, turn with the pad: w and θ of its nodes by a dense solution, rows at w + x θ.
#[test]
fn branches_that_do_not_bend() {
    let mut stiff = toe(Some(20));
    stiff.lamella.section.bending *= 1e4;
    let first = stiff.follow(LIFT, [0.0; 3], 1).unwrap().events.remove(0);
    let (row, l, ei) = (COLUMNS as f64 * STIFFNESS, stiff.pitch, stiff.pad.bending);
    // θ in units of 1/l, so that all entries are of one size
    let mut matrix = DMatrix::zeros(24, 24);
    let element = [[12.0, 6.0, -12.0, 6.0], [6.0, 4.0, -6.0, 2.0], [-12.0, -6.0, 12.0, -6.0], [6.0, 2.0, -6.0, 4.0]];
    for node in 0..11 {
        (0..16).for_each(|k| matrix[(2 * node + k / 4, 2 * node + k % 4)] += element[k / 4][k % 4] * ei / l.powi(3));
    }
    let places: Vec<f64> = (0..60).map(|own| (f64::from(own) - 20.0) * PITCH / l).collect();
    for (node, x) in (0..12).flat_map(|node| places.iter().map(move |x| (node, x))) {
        let shape = [1.0, *x];
        (0..4).for_each(|k| matrix[(2 * node + k / 2, 2 * node + k % 2)] += row * shape[k / 2] * shape[k % 2]);
    }
    let mut load = DVector::zeros(24);
    load[0] = 1.0;
    let at = matrix.lu().solve(&load).unwrap();
    let reach = (30f64.to_radians().tan() * 2e6 * UN / 12.0) / (60.0 * row);
    let all = (0..12).flat_map(|node| places.iter().map(move |x| (node, x)));
    let largest = all.map(|(node, x)| at[2 * node] + x * at[2 * node + 1]).fold(0.0, f64::max);
    assert_relative_eq!(first.load, reach / largest, max_relative = 1e-4);
    // its distal end lets go first
    assert_eq!(first.row, 0);
}

/// Lamellae on one row, whose other rows hang on by nothing: the pad is a band on rows.
#[test]
fn branches_on_one_row() {
    let full = toe(Some(0));
    let mut weak = Toe { lamella: Lamella { rows: 2, ..full.lamella.clone() }, ..full };
    weak.lamella.section.bending *= 1e-15;
    let rows = Lamella { rows: 12, pitch: weak.pitch, section: weak.pad, ..weak.lamella.clone() };
    let first = weak.follow(LIFT, [0.0; 3], 1).unwrap().events.remove(0);
    let band = rows.follow(LIFT, [0.0; 3], 1).unwrap().events.remove(0);
    assert_relative_eq!(first.load, band.load, max_relative = 1e-6);
}

/// Joined at the middle of each lamella, every event, and the same numbers from the general call.
#[test]
fn every_event_of_a_small_toe() {
    let scatter = Scatter { strength: 0.2, ..Scatter::default() };
    let band = Lamella { rows: 6, columns: 4, scatter, ..lamella(6) };
    let small = Toe { lamellae: 3, pitch: 8.0 * PITCH, lamella: band, ..toe(Some(2)) };
    let found = small.follow(LIFT, [0.0; 3], usize::MAX).unwrap();
    assert!(found.imbalance < 1e-6 && found.end == ArrayEnd::Mechanism, "{:?} {}", found.end, found.imbalance);
    let pull = SetaArray::Toe(small, LIFT).pull(&|| false).unwrap();
    assert_eq!((pull.events.len(), pull.setae), (found.events.len(), 72));
    assert_relative_eq!(pull.work, pull.released, max_relative = 1e-6);
    // what all rows carry is the load
    let carried: f64 = pull.rows.iter().map(|row| row.force[1]).sum();
    assert_relative_eq!(carried, pull.largest_load, max_relative = 1e-7);
}
