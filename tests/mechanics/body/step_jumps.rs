//! Jumps in the steps before the pull.
//!
//!      lift over the snap-off, and press down again            the pull behind them is that from rest
//!         P |  /|                                                 P |  /|
//!           | / |<- jumps off                                       | / |
//!           |/  |____.   jumps on ->|    /                          |/  |____
//!           +-------------- y        +-------------- y              +-------------- u
//!
//! References: the displacement-controlled test of the same strip, which jumps at the same places; the pull from rest, which is the same behind a
//! cycle. Parameters: the paper's strip, L = 100 nm, `relative` = 1e-6.
//! Expected: places to 1e-6 nm beside the bounds of the test; forces, and what is released, to 1e-4, as the mesh of a step knows them. Why: a
//! step that jumps takes another form where x is condensed, and counts its way from where it has come to rest.

use super::steps::{BOUNDS, assert_near, failure, peeled, strip};
use peelkit::beam::StepJump;
use peelkit::model::{Hold, Step};
use peelkit::study::{Accuracy, Jump, PathEnd, observed, peel};

const RELEASED: f64 = 1e-4;

/// The strip of this grip is lifted so far, nm, and pressed down again: it jumps where the machine's does, and its pull is that from rest.
fn cycle(hold: Hold, lift: f64) -> (Vec<StepJump>, Vec<Jump>) {
    let rest = strip(hold, hold, &[]);
    let cycled = peeled(&strip(hold, hold, &[Step::Lift(lift), Step::Press(lift)]));
    let (whole, test) = (peeled(&rest), observed(&rest, &Accuracy::to(1e-6), &BOUNDS).unwrap());
    let (a, b) = (whole.initiation_peak.unwrap(), cycled.initiation_peak.unwrap());
    assert_near("peak", a.force, b.force, a.force_error + b.force_error);
    assert_near("its place", a.displacement, b.displacement, a.displacement_error + b.displacement_error);
    assert_eq!(whole.limit_points.len(), cycled.limit_points.len());
    (cycled.step_jumps, test.jumps)
}

/// The jumps of the steps are those of the machine at the same places.
#[track_caller]
fn assert_jumps(steps: &[StepJump], machine: &[Jump]) {
    for step in steps {
        let (before, after) = (step.before.forces.vertical, step.after.forces.vertical);
        let near = |jump: &&Jump| (jump.machine - step.before.y).abs() < 1e-6 + jump.machine_error;
        let jump = machine.iter().find(near).unwrap_or_else(|| panic!("none at {} nm: {machine:?}", step.before.y));
        let share = RELEASED * before.max(after);
        assert_near("released", step.released, jump.released, RELEASED * jump.released);
        assert_near("force before", before, jump.before.force, share);
        assert_near("force after", after, jump.after.force, share);
    }
}

#[test]
fn a_cycle_over_the_snap_off_jumps_where_the_machine_does() {
    let (steps, machine) = cycle(Hold::Free, 60.0);
    assert_eq!(steps.iter().map(|jump| jump.step).collect::<Vec<_>>(), [1, 2]);
    assert_jumps(&steps, &machine);
}

/// With x condensed the horizontal force is a multiplier, and the energy has no minimum: such steps are taken with x at every node.
#[test]
fn a_grip_that_is_held_along_the_ground_jumps_as_well() {
    let (steps, machine) = cycle(Hold::Fixed, 70.0);
    assert_eq!(steps.iter().map(|jump| jump.step).collect::<Vec<_>>(), [1, 1, 2]);
    assert_jumps(&steps, &machine);
}

#[test]
fn a_beam_that_jumps_off_has_nothing_to_be_pulled_off() {
    let off = peel(&strip(Hold::Fixed, Hold::Fixed, &[Step::Lift(70.0)]), &Accuracy::to(1e-6), &BOUNDS);
    let PathEnd::Failed(why) = &off.end else { panic!("{:?}", off.end) };
    let why = why.to_string();
    assert!(why.contains("step 1 of drive.steps, \"lift 70 nm\", comes to a limit point at 21.8037"), "{why}");
    assert!(why.contains("nothing adheres where the pull begins"), "{why}");
    assert_eq!((off.step_jumps.len(), off.step_ways.len(), off.points.len()), (2, 1, 0), "what was found is kept");
}

/// Where a step has no end that is a beam's, it says so.
#[test]
fn a_jump_into_the_substrate_is_refused() {
    let why = failure(&strip(Hold::Free, Hold::Free, &[Step::Press(1.0)]));
    assert!(why.contains("comes to where the beam jumps, at -0.693177 nm") && why.contains("collapses"), "{why}");
}
