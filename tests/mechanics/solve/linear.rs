//! The bordered tangent for any right-hand side, also transposed, against a dense matrix that is put together from the truss and the
//! grip's equations without the solver; and an adjoint derivative against differences of solutions.
//!
//! A truss of three free nodes and a follower that makes the tangent unsymmetric, driven in a direction, with a geared and a held unknown.
//! Expected: to 1e-11 of the largest number of the solution.

use super::dense_truss::Truss;
use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, DVector};
use peelkit::solve::{
    Bordered, Direction, EndConditions, NewtonOptions, Observables, PathConstraint, Problem, State, Tangents,
    Workspace, solve,
};

fn truss() -> Truss {
    Truss {
        nodes: vec![[0.0, 1.0], [1.1, 0.9], [2.0, 1.2], [-0.2, 0.0], [1.0, 0.1], [2.3, -0.1]],
        free: 3,
        bars: vec![
            (0, 1, 2.0),
            (1, 2, 1.5),
            (0, 3, 3.0),
            (0, 4, 1.0),
            (1, 4, 2.5),
            (2, 4, 1.2),
            (2, 5, 2.2),
            (1, 3, 0.7),
        ],
        interface: vec![2, 3, 4, 5],
        monitors: [0, 3],
        follower: 0.3,
    }
}

/// Node 1 is driven at 30 degrees and held across; y of node 2 goes along with the drive, x of node 2 is free.
fn grip() -> EndConditions {
    let (up, along) = 30f64.to_radians().sin_cos();
    let mut held = [false; peelkit::solve::INTERFACE];
    (held[0], held[3]) = (true, true);
    EndConditions {
        across: Some(0),
        direction: Direction { along, up },
        held,
        geared: 3,
        gear: 0.4,
        ..EndConditions::drive(1)
    }
}

const WEIGHTS: Observables =
    Observables { monitors: [0.7, -0.2], displacement: 0.5, force: 0.1, recorded: 0.0, roll: 0.0 };

fn state() -> State {
    State { values: vec![0.02, -0.1, 0.05, 0.03, -0.04, 0.06], force: 0.2, ..State::default() }
}

/// Rows: the six equations of the nodes, those of what is held replaced by its constraint; the path constraint. Columns: six
/// displacements and P.
fn dense(problem: &Problem, at: &State) -> DMatrix<f64> {
    let EndConditions { direction: Direction { along, up }, gear, .. } = problem.grip;
    let tangent = truss().assembled(&at.values).2;
    let mut matrix = DMatrix::zeros(7, 7);
    matrix.view_mut((0, 0), (6, 6)).copy_from(&tangent);
    // the forces on node 1 along the drive are balanced by P; across it, and at y of node 2, displacements are held
    let ahead = along * matrix.row(2) + up * matrix.row(3);
    matrix.set_row(3, &ahead);
    matrix[(3, 6)] = -1.0;
    for (row, entries) in [(2, [(2, up), (3, -along)]), (5, [(2, -gear * along), (3, -gear * up)])] {
        matrix.row_mut(row).fill(0.0);
        entries.into_iter().for_each(|(column, entry)| matrix[(row, column)] = entry);
    }
    matrix[(5, 5)] = 1.0;
    let gradient = problem.system.gradient(at, WEIGHTS.monitors);
    (0..6).for_each(|column| matrix[(6, column)] = gradient[column]);
    matrix[(6, 2)] += WEIGHTS.displacement * along;
    matrix[(6, 3)] += WEIGHTS.displacement * up;
    matrix[(6, 6)] = WEIGHTS.force;
    matrix
}

#[test]
fn many_right_hand_sides_and_their_transpose_are_those_of_a_dense_matrix() {
    let (problem, at, mut ws) = (truss().problem(grip()), state(), Workspace::default());
    let tangents = Tangents::new(&problem, &at, &PathConstraint { weights: WEIGHTS, target: 0.0 }, &mut ws).unwrap();
    let matrix = dense(&problem, &at);
    let Direction { along, up } = problem.grip.direction;
    for k in 0..5 {
        let right: Vec<f64> = (0..6).map(|i| (1.3 * f64::from(i + 2 * k)).sin()).collect();
        let last = f64::from(k) - 2.0;
        let found = tangents.solve(&Bordered { direction: right.clone(), last }, &ws).unwrap();
        // what acts on held unknowns moves nothing
        let mut dense_right = DVector::from_iterator(7, right.iter().copied().chain([last]));
        dense_right[3] = along * right[2] + up * right[3];
        (dense_right[2], dense_right[5]) = (0.0, 0.0);
        let wanted = matrix.clone().lu().solve(&dense_right).unwrap();
        for i in 0..6 {
            assert_abs_diff_eq!(found.direction[i], wanted[i], epsilon = 1e-11 * wanted.amax());
        }
        assert_abs_diff_eq!(found.last, wanted[6], epsilon = 1e-11 * wanted.amax());

        let found = tangents.solve_transposed(&Bordered { direction: right.clone(), last }, &ws).unwrap();
        let functional = DVector::from_iterator(7, right.iter().copied().chain([last]));
        let multipliers = matrix.transpose().lu().solve(&functional).unwrap();
        // of node 1 the multiplier of the force along the drive, in its two components
        let wanted = [0, 1].map(|i| multipliers[i]);
        let nodes = [along * multipliers[3], up * multipliers[3], multipliers[4], 0.0];
        for (i, wanted) in wanted.into_iter().chain(nodes).enumerate() {
            assert_abs_diff_eq!(found.direction[i], wanted, epsilon = 1e-11 * multipliers.amax());
        }
        assert_abs_diff_eq!(found.last, multipliers[6], epsilon = 1e-11 * multipliers.amax());
    }
}

#[test]
fn one_transposed_solve_gives_the_derivatives_by_all_parameters() {
    let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: 0.08 };
    let options = NewtonOptions { tolerance: 1e-14, largest_update: 5.0, most_iterations: 30, exact_slope: true };
    let solved = |truss: Truss| {
        let problem = truss.problem(grip());
        let solution = solve(&problem, problem.initial(0), &constraint, &options, &mut Workspace::default()).unwrap();
        (problem, solution)
    };
    let (problem, solution) = solved(truss());
    let mut ws = Workspace::default();
    let tangents = Tangents::new(&problem, &solution.at, &constraint, &mut ws).unwrap();
    // the derivatives of the force
    let functional = Bordered { direction: vec![0.0; 6], last: 1.0 };
    let multipliers = tangents.solve_transposed(&functional, &ws).unwrap().direction;
    for parameter in 0..truss().bars.len() {
        let by_parameter = truss().residual_by_stiffness(parameter, &solution.at);
        let adjoint: f64 = -multipliers.iter().zip(&by_parameter).map(|(m, r)| m * r).sum::<f64>();
        let step = 1e-4;
        let force = |factor: f64| {
            let mut varied = truss();
            varied.bars[parameter].2 *= factor;
            solved(varied).1.observables.force
        };
        let difference = (force(1.0 + step) - force(1.0 - step)) / (2.0 * step);
        assert_abs_diff_eq!(adjoint, difference, epsilon = 1e-8 * solution.observables.force.abs());
    }
}
