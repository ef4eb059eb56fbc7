//! Beams given piece by piece.
//!
//!     S = 0            S1          S2                L
//!     |________________|_________,--|_______________|   u, P
//!     |   width, height, roundness, bend of each    |
//!     ===============================================
//!
//! References: the bodies that have a file of their own, a strip and a spatula, of which lists of pieces make the same beam.
//! Parameters: the paper's strip of 100 nm cut in three, in a fixed grip; a spatula that bends where its neck is, 150 nm, of three pieces.
//! Expected: the first peak, the largest one and the snap-off of the one within the sum of both bounds of the other's, and of the
//! spatulae, whose outlines and elements are the same but for rounding, to 1e-10. Why: where a piece ends elements end and a formula with them, and nothing
//! else. Collocation has its word on beams that no other body is, in `peel verify --only spatula`.

use crate::common::paper_strip;
use approx::assert_relative_eq;
use peelkit::model::{Body, Hold, PeelModel, Piece, Profile, ProfileForm, ProfilePieces, Spatula, Transition};
use peelkit::study::{Accuracy, Peel, StopCriteria, peel};

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

/// The model with its body replaced by pieces of the same material.
fn in_pieces(model: &PeelModel, pieces: Vec<Piece>) -> PeelModel {
    let form = ProfileForm::Pieces(ProfilePieces::new(pieces).unwrap());
    PeelModel { body: Body::Profile(Profile { form, material: model.material() }), ..model.clone() }
}

fn peeled(model: &PeelModel) -> Peel {
    peel(model, &Accuracy::to(1e-9), &BOUNDS)
}

/// Numbers of a peel with their bounds.
fn numbers(peel: &Peel) -> [(f64, f64); 6] {
    let (first, largest, snap) = (peel.initiation_peak.unwrap(), peel.peak.unwrap(), peel.snap_off.unwrap());
    [
        (first.displacement, first.displacement_error),
        (first.force, first.force_error),
        (largest.displacement, largest.displacement_error),
        (largest.force, largest.force_error),
        (snap.displacement, snap.displacement_error),
        (snap.force, snap.force_error),
    ]
}

#[test]
fn a_strip_cut_in_three_is_the_strip() {
    let mut strip = paper_strip(100.0, 1.0);
    strip.grip.rotation = Hold::Fixed;
    let whole: PeelModel = strip.into();
    let cut = in_pieces(&whole, [20.0, 33.3, 46.7].map(|length| Piece::straight(length, 1.0, 10.0)).to_vec());
    for ((of_cut, cut_bound), (of_whole, bound)) in numbers(&peeled(&cut)).into_iter().zip(numbers(&peeled(&whole))) {
        println!("{of_cut} +- {cut_bound:.1e} in pieces, {of_whole} +- {bound:.1e} whole");
        assert!((of_cut - of_whole).abs() <= cut_bound + bound, "{of_cut} and {of_whole}");
        assert!(cut_bound + bound < 1e-8 * of_whole);
    }
}

#[test]
fn a_spatula_of_three_pieces_is_the_spatula() {
    let spatula = Spatula { bend_length: 150.0, ..Spatula::default() };
    let pad = Piece { width: [200.0, 50.0], ..Piece::straight(240.0, 200.0, 10.0) };
    let neck = Piece {
        height: [10.0, 50.0],
        roundness: [0.0, 1.0],
        bend: spatula.shaft_angle,
        course: Transition::Smooth,
        ..Piece::straight(150.0, 50.0, 10.0)
    };
    let shaft = Piece { roundness: [1.0; 2], ..Piece::straight(600.0, 50.0, 50.0) };
    let mut strip = paper_strip(100.0, 1.0);
    strip.grip.rotation = Hold::Fixed;
    let whole = PeelModel { body: Body::Spatula(spatula), ..strip.into() };
    let [of_pieces, of_whole] =
        [in_pieces(&whole, vec![pad, neck, shaft]), whole].map(|model| numbers(&peeled(&model)));
    for ((of_pieces, _), (of_whole, _)) in of_pieces.into_iter().zip(of_whole) {
        println!("{of_pieces} in pieces, {of_whole} whole");
        assert_relative_eq!(of_pieces, of_whole, max_relative = 1e-10);
    }
}
