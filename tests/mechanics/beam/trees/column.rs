//! A column of three branches under displacement of its root: the path is followed and its inertia says when it buckles.
//!
//! ```text
//!   |/ tip o------o------o------o root  <-- u, free to move sideways and to turn
//! ```
//!
//! Reference: Euler's load of a column that is clamped at one end and free at the other, π² EI / 4 L², of the two planes in which it bends. The
//! straight column under the force P is shortened by P L / EA; further loads are 3², 5² and so on times the first of a plane. Parameters: L = 30,
//! EA = GA = 1e5, EI = 100 and 800; shortening and shear change each load by less than 1e-3 of itself. Expected: as many negative eigenvalues as there are
//! loads below the force. Predictions on a straight path are exact, so that the force grows up to 4.5 times from point to point: points are bound
//! to lie below the first load and between it and the second, 8 times the first.

use approx::assert_relative_eq;
use peelkit::beam::{Branch, BranchingBeam, JointCondition, SpatialStiffness};
use peelkit::solve::{EndConditions, INTERFACE, InitialState, MeasuredBeside, Path, PathMeasure, PathOptions, Problem};
use std::f64::consts::PI;
use std::sync::Arc;

const LENGTH: f64 = 30.0;
const AXIAL: f64 = 1e5;
const BENDING: [f64; 2] = [100.0, 800.0];

fn column() -> Problem {
    let stiffness = SpatialStiffness::diagonal(AXIAL, [AXIAL; 2], 50.0, BENDING);
    let place = |k: usize| [0.0, 0.0, LENGTH * k as f64 / 3.0];
    let branch = |k: usize| Branch::straight([k, k + 1], [place(k), place(k + 1)], [0.0, 1.0, 0.0], stiffness, 2);
    let beam = BranchingBeam {
        conditions: vec![JointCondition::clamped(3, place(3))],
        order: 5,
        scale: [1e-4, 1e-3],
        ..BranchingBeam::new((0..3).map(branch).collect(), 0)
    };
    let tree = beam.build().unwrap();
    let origin = tree.interface_at_rest();
    let load = PI * PI * BENDING[0] / (4.0 * LENGTH * LENGTH);
    // steps of no more than a share of the first load
    let scale = [0.1 * load * LENGTH / AXIAL; INTERFACE];
    Problem {
        system: Arc::new(tree),
        grip: EndConditions { origin, scale, ..EndConditions::drive(2) },
        measure: PathMeasure { monitors: [f64::INFINITY; 2], force: 0.1 * load, beside: MeasuredBeside::Force },
        start: InitialState::StressFree,
    }
}

#[test]
fn a_column_of_branches_buckles_at_eulers_loads() {
    let problem = column();
    let [soft, stiff] = BENDING.map(|bending| PI * PI * bending / (4.0 * LENGTH * LENGTH));
    let loads = [soft, stiff, 9.0 * soft, 25.0 * soft, 49.0 * soft, 9.0 * stiff];
    let options = PathOptions {
        elements: 0,
        step_tolerance: 1e-2,
        tolerance: 1e-8,
        first_displacement: 0.02 * loads[0] * LENGTH / AXIAL,
        ..PathOptions::default()
    };
    let mut seen = [0; 7];
    for point in Path::new(&problem, options).take(400) {
        let point = point.unwrap();
        let (force, displacement) = (point.observables.force, point.observables.displacement);
        assert_relative_eq!(force, displacement * AXIAL / LENGTH, max_relative = 1e-6, epsilon = 1e-7);
        let beyond = loads.iter().filter(|load| force > **load * (1.0 + 1e-3)).count();
        let below = loads.iter().filter(|load| force > **load * (1.0 - 1e-3)).count();
        if beyond == below {
            assert_eq!(point.negative, beyond, "at P = {force} of {loads:?}");
            seen[beyond] += 1;
        }
        if force > 1.3 * loads[2] {
            break;
        }
    }
    assert!(seen[0] > 0 && seen[1] > 0 && seen[3..].iter().sum::<usize>() > 0, "{seen:?}");
}
