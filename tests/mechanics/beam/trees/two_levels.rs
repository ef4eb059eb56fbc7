//! The tree of two levels with four tips under dead loads, against shooting.
//!
//! Reference: `verification/tree.csv`, from `verification/tree.py`: initial value problems of the strong form with rotation matrices, without
//! elements. The tree is drawn in `setup.rs`; its root is clamped, its tips carry forces, in the last case moments too, which bend it by the
//! order of its own size. Expected: places of the tips and the moment at the root to 1e-9 of the tree's size on elements of order 6; with
//! elements of half the length the error of elements of order 2 falls by 2⁴, as that of 2-stage Gauss collocation does. The forces on the root
//! are those of the tips.

use super::setup::four_tips;
use approx::assert_abs_diff_eq;
use peelkit::beam::{BeamTree, BranchingBeam, JointCondition};
use peelkit::solve::{
    EndConditions, INTERFACE, InitialState, MeasuredBeside, NewtonOptions, Observables, PathConstraint, PathMeasure,
    Problem, State, System, Workspace, solve,
};
use std::sync::Arc;

/// A row of the table: of a tip.
struct Row {
    case: String,
    load: [[f64; 3]; 2],
    place: [f64; 3],
    root_moment: [f64; 3],
}

fn rows() -> Vec<Row> {
    let table = include_str!("../../../../verification/tree.csv");
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let three = |from: usize| std::array::from_fn(|i| cells[from + i].parse().unwrap());
        Row { case: cells[0].into(), load: [three(2), three(5)], place: three(8), root_moment: three(11) }
    };
    table.lines().skip(1).map(row).collect()
}

/// The tree under a share of the loads of its tips, joints 3 to 6, with its root clamped.
fn loaded(order: usize, elements: usize, loads: &[Row], share: f64) -> (Arc<BeamTree>, Problem) {
    let mut conditions = Vec::new();
    for (tip, row) in loads.iter().enumerate() {
        let [force, moment] = row.load.map(|part| part.map(|x| share * x));
        conditions.push(JointCondition::loaded(3 + tip, force, moment));
    }
    let beam = BranchingBeam { conditions, scale: [1e-3, 1e-3], ..four_tips(order, elements) };
    let tree = Arc::new(beam.build().unwrap());
    let problem = Problem {
        grip: EndConditions {
            held: [true, true, false, true, true, true],
            origin: tree.interface_at_rest(),
            scale: [1.0; INTERFACE],
            ..EndConditions::drive(2)
        },
        system: tree.clone(),
        measure: PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force },
        start: InitialState::StressFree,
    };
    (tree, problem)
}

/// The equilibrium under the loads, which grow in steps that are as long as Newton's method bears, from the secant on.
fn equilibrium(order: usize, elements: usize, loads: &[Row]) -> (Arc<BeamTree>, State) {
    let clamped = PathConstraint { weights: Observables::DISPLACEMENT, target: 0.0 };
    let options =
        NewtonOptions { tolerance: 1e-7, largest_update: f64::INFINITY, most_iterations: 12, exact_slope: false };
    let mut at = loaded(order, elements, loads, 0.0).0.stress_free(0);
    let (mut done, mut step) = (0.0, 0.02);
    let mut before = (at.clone(), -step);
    while done < 1.0 {
        let next = f64::min(done + step, 1.0);
        let (tree, problem) = loaded(order, elements, loads, next);
        let ahead = (next - done) / (done - before.1);
        let values = tree.combine(&[&at.values, &before.0.values], &[1.0 + ahead, -ahead]);
        match solve(&problem, State { values, ..at.clone() }, &clamped, &options, &mut Workspace::default()) {
            Ok(solution) => {
                before = (std::mem::replace(&mut at, solution.at), done);
                (done, step) = (next, 1.5 * step);
            }
            Err(error) => {
                step *= 0.4;
                assert!(step > 1e-6, "{error} at {done}");
            }
        }
    }
    (loaded(order, elements, loads, 1.0).0, at)
}

#[test]
fn tips_and_the_root_agree_with_shooting() {
    let rows = rows();
    assert_eq!(rows.len(), 12);
    for loads in rows.chunks(4) {
        let (tree, at) = equilibrium(6, 4, loads);
        for (tip, row) in loads.iter().enumerate() {
            let (place, _) = tree.joint(&at, 3 + tip);
            (0..3).for_each(|i| assert_abs_diff_eq!(place[i], row.place[i], epsilon = 2e-8));
        }
        let root = tree.section(&at, 0, 0);
        for i in 0..3 {
            let force: f64 = loads.iter().map(|row| row.load[0][i]).sum();
            assert_abs_diff_eq!(root.moment[i], loads[0].root_moment[i], epsilon = 2e-7);
            assert_abs_diff_eq!(root.force[i], force, epsilon = 1e-9);
        }
        // and as reactions of what is held
        let reactions = tree.reactions(&at);
        (0..3).for_each(|i| assert_abs_diff_eq!(reactions[i], -root.force[i], epsilon = 1e-9));
        let inside = reactions[6..].iter().fold(0.0f64, |most, r| most.max(r.abs()));
        assert!(inside < 1e-7, "{}: {inside}", loads[0].case);
    }
}

#[test]
fn the_error_falls_with_the_fourth_power_of_elements_of_order_two() {
    let rows = rows();
    let loads = &rows[..4];
    let error = |elements: usize| {
        let (tree, at) = equilibrium(2, elements, loads);
        let of = |(tip, row): (usize, &Row)| {
            let (place, _) = tree.joint(&at, 3 + tip);
            (0..3).map(|i| (place[i] - row.place[i]).abs()).fold(0.0, f64::max)
        };
        loads.iter().enumerate().map(of).fold(0.0, f64::max)
    };
    let [coarse, fine] = [error(3), error(6)];
    assert!(coarse / fine > 12.0 && coarse / fine < 20.0, "{coarse:.2e} {fine:.2e}");
}
