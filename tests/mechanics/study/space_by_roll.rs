//! A path in space that is measured by the roll of the grip as well.
//!
//! ```text
//!   P |      __ peak                     seen from the end, at rest and behind the peak:
//!     |     /  \
//!     |    /    \                         ________            ____
//!     |   /                              |________|      ____/    /   roll
//!     |  /                                              /____----
//!     |_/________ u
//! ```
//!
//! Reference: the same path measured without the roll. Equilibria do not depend on what measures the way between them. Parameters:
//! L × b × h = 75.445 × 25.503 × 8.541 nm, E = 4.746 GPa, A_H = 7.34e-20 J, r0 = 0.2696 nm, pulled at 65.87 degrees, 8.033 degrees aside, with an end
//! that does not turn in the plane and stays above its place: behind the peak a bifurcation is rounded off, where the roll goes forward alone.
//! Expected: the first peak is the same to 1e-9; the roll is counted where it measures, and nowhere else.

use peelkit::model::{Body, Form, Hold, PeelModel, Space, StripModel};
use peelkit::solve::{
    LimitPointKind, MeasuredBeside, Pace, Path, PathOptions, PathSegment, Problem, Solution, Workspace, locate,
};
use std::sync::Arc;

fn model() -> PeelModel {
    let mut model = PeelModel::from(StripModel::of_the_paper(75.44532, 1.0));
    if let Body::Strip(strip) = &mut model.body {
        (strip.width, strip.height, strip.material.youngs_modulus) = (25.50295, 8.541441, 4.745877);
    }
    (model.adhesion.hamaker_constant, model.adhesion.equilibrium_distance) = (0.07340213, 0.2695842);
    (model.grip.rotation, model.grip.horizontal) = (Hold::Fixed, Hold::Fixed);
    model.pull.angle = 65.870f64.to_radians();
    model.space = Some(Space { azimuth: (-8.033f64).to_radians(), ..Space::default() });
    model
}

/// The points of a path as far as it leads, or to this displacement behind its peak, nm.
fn followed(problem: &Problem, until: f64) -> Vec<Arc<Solution>> {
    let options = PathOptions { elements: 28, pace: Pace::Wary, ..PathOptions::default() };
    let mut path = Path::new(problem, options);
    while path.points().len() < 400 && path.points().last().is_none_or(|point| point.observables.displacement < until) {
        if path.advance().is_err() {
            break;
        }
    }
    path.points().to_vec()
}

fn peak(problem: &Problem, points: &[Arc<Solution>]) -> [f64; 2] {
    let after = points.iter().position(|point| point.slope.force < 0.0).expect("the force has a peak") - 1;
    let segment = PathSegment::around(problem, points, after);
    let whole = (0.0, segment.end());
    let located = locate(problem, &segment, LimitPointKind::Load, whole, None, &mut Workspace::default()).unwrap();
    [located.observables.displacement, located.observables.force]
}

#[test]
fn the_roll_measures_the_same_path() {
    let by_front = model().problem(Form::TwoField, 7).unwrap();
    let by_roll = by_front.measured_beside(MeasuredBeside::Roll);
    let [one, other] = [followed(&by_front, 1.4), followed(&by_roll, 1.4)];
    let peaks = peak(&by_front, &one).into_iter().zip(peak(&by_roll, &other));
    for (one, other) in peaks {
        assert!((one - other).abs() < 1e-9 * one, "{one} and {other}");
    }
    assert!(other.last().is_some_and(|point| point.observables.roll.abs() > 1e-6));
    assert!(one.iter().all(|point| point.observables.roll == 0.0));
}
