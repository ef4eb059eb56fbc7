//! Tips that detach at once by symmetry.
//!
//! The small seta of `setup.rs`, upright and without scatter: its tips are alike. The common motion of all tips is softer than any in which they
//! part where the shaft is slender in tension and stiff in bending, so that they lose their hold at once. Reference: the closed form of four
//! equal tips in series with the stretch of shaft and branches, whose compliance is read off two equilibria, does not bend: all tips carry the
//! same load at all times. Expected: one event with four tips, each with the same load to 1e-9, and four times that load on the root.

use super::setup::{along_normal, model, pulled, small};
use approx::assert_relative_eq;
use peelkit::model::{Seta, Sideways};
use peelkit::study::{SetaEnd, SetaStart, StepEnd};

#[test]
fn four_tips_that_are_alike_detach_at_once() {
    let upright = Seta { shaft_angle: 0.0, brush_angle: 0.0, height_scatter: 0.0, shaft_length: 500.0, ..small() };
    let whole =
        pulled(&model(upright, Sideways::Free), SetaStart::Adhering, &[along_normal(1.0, StepEnd::Detached(5000.0))]);
    assert_eq!(whole.end, SetaEnd::Completed);
    assert_eq!(whole.points.last().unwrap().attached, 0);
    let first = &whole.events[0];
    let load = first.tips[0].load[1];
    println!("{} events, the first one of {} tips at {load} nN each", whole.events.len(), first.tips.len());
    assert_eq!(first.tips.len(), 4);
    first.tips.iter().for_each(|tip| assert_relative_eq!(tip.load[1], load, max_relative = 1e-9));
    assert_relative_eq!(first.before.force[1], -4.0 * load, max_relative = 1e-6);
}
