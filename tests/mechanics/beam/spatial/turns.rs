//! Ends that turn by more than half a turn.
//!
//! Reference: a straight rod whose right end is turned on about its axis by 20 degrees at a time, up to 400 degrees, and back: the roll is what
//! it was turned by. With the angles as unknowns it is their number, where the end turns freely the directors and a count say so, and so they do
//! in a state that is extrapolated from two others.

use super::setup::{PLAIN, Rod};
use peelkit::beam::{EndRotation, SpatialRestCurve, SpatialStiffness};
use peelkit::solve::System;

const STEP: f64 = 20.0;

#[test]
fn a_roll_is_counted_beyond_half_a_turn() {
    for rotation in [EndRotation::Free, EndRotation::Angles] {
        let stiffness = SpatialStiffness::diagonal(100.0, [40.0; 2], 3.0, [5.0, 7.0]);
        let rest = SpatialRestCurve { start: [0.0; 3], directors: PLAIN, curvature: [0.0; 3] };
        let beam = Rod { rotation, ..Rod::clamped(stiffness, rest, 3.0) }.beam();
        let mut at = beam.stress_free(2);
        let count = beam.unknowns(&at);
        // the roll is the first turn about the directors, and the last of the angles
        let slot = count - if rotation == EndRotation::Free { 3 } else { 1 };
        let mut direction = vec![0.0; count];
        direction[slot] = STEP.to_radians();
        let roll = |at: &_| beam.angles_of_grip(at)[2].to_degrees();
        let (mut before, mut expected) = (at.clone(), 0.0);
        for (sign, steps) in [(1.0, 20), (-1.0, 40), (1.0, 20)] {
            for _ in 0..steps {
                before = at.clone();
                beam.retract(&mut at, &direction, sign);
                expected += sign * STEP;
                assert!((roll(&at) - expected).abs() < 1e-9, "{rotation:?}: {} for {expected}", roll(&at));
                let mut ahead = at.clone();
                ahead.values = beam.combine(&[&at.values, &before.values], &[1.5, -0.5]);
                let further = expected + 0.5 * sign * STEP;
                assert!((roll(&ahead) - further).abs() < 1.0, "{rotation:?}: {} for {further}", roll(&ahead));
            }
        }
        assert!(roll(&at).abs() < 1e-9 && roll(&before) < 0.0);
    }
}
