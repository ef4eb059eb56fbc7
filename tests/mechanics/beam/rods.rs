//! Rods, beams to which nothing adheres: their tangents, and what the solver makes of them.
//!
//! Reference: dual numbers (num-dual) through ½EA Γ1² + ½GA_s Γ2² + ½EI (θ' - κ0(S))²; central differences of the energy of
//! one element.
//!
//!     clamped //|_____________  S = L   P along x or y, or a moment
//!             //|             ) κ0(S): stress-free curvature
//!
//! Parameters: sections, states and rest curves at random (a fixed seed); L = 1 nm, EI = 1 nN nm², orders 1 to 8.
//!
//! Expected: derivatives equal to 1e-9 of their scale; the rest curve is an equilibrium without force or energy; Newton's
//! updates fall like a square under every drive; the order of convergence of the tip is 2p. Why: a rod goes through the
//! same solver as a peeling strip, and here its results are known.

use crate::common::stored_energy;
use nalgebra::SVector;
use num_dual::{Dual2SVec64, hessian};
use peelkit::beam::{
    ChainFactors, Configuration, ConstraintGradient, EnergyDensity, Point, ReferenceCurve, ReissnerRod, Section,
};
use peelkit::model::{Drive, Hold, RodModel, Support};
use peelkit::solve::{
    LimitPointKind, NewtonOptions, Observables, Pace, PathConstraint, PathOptions, SolveError, Workspace, controlled,
    solve,
};
use peelkit::study::{RodFailure, follow_rod};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

const FORCE: Observables = Observables::FORCE;

fn runner() -> TestRunner {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[11; 32]);
    TestRunner::new_with_rng(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() }, rng)
}

/// A cantilever, curved at rest.
fn rod(drive: Drive) -> RodModel {
    RodModel {
        length: 1.0,
        section: Section { axial: 100.0, shear: 30.0, bending: 1.0 },
        rest: ReferenceCurve { start: [0.2, -0.1, 0.4], curvature: [0.5, -1.0, 2.0] },
        left: Support::CLAMPED,
        right: Support::FREE,
        drive,
    }
}

#[test]
fn the_density_is_the_stored_energy_of_a_curved_rod() {
    let numbers = prop::array::uniform9(-1.0..1.0f64);
    runner()
        .run(&(numbers, 0.0..3.0f64), |([a, s, b, rotation, dx, dy, k0, k1, k2], place)| {
            let section = Section { axial: 10f64.powf(a), shear: 10f64.powf(s), bending: 10f64.powf(b) };
            let density = ReissnerRod { section, rest: ReferenceCurve { start: [0.0; 3], curvature: [k0, k1, k2] } };
            let at = SVector::from([3.0 * rotation, 1.0 + dx, dy, 0.7]);
            let rest = k0 + k1 * place + k2 * place * place;
            let (energy, gradient, tangent) =
                hessian(|v: SVector<Dual2SVec64<4>, 4>| stored_energy(&section, v[0], v[1], v[2], v[3] - rest), &at);
            // of the fields, of which the first is x - S
            let slope = [at[1] - 1.0, at[2], at[3]];
            let r = density.response(place, [5.0, -7.0, at[0]], slope, 0.0);
            let size = section.axial + section.shear + section.bending;
            let close = |computed: f64, expected: f64| {
                let fine = (computed - expected).abs() <= 1e-9 * size;
                if fine { Ok(()) } else { Err(TestCaseError::fail(format!("{computed:e}, expected {expected:e}"))) }
            };
            close(r.energy, energy)?;
            close(r.by_value[2], gradient[0])?;
            close(r.value_value[2][2], tangent[(0, 0)])?;
            for i in 0..3 {
                close(r.by_slope[i], gradient[1 + i])?;
                close(r.value_slope[2][i], tangent[(0, 1 + i)])?;
                close(r.slope_value[i][2], tangent[(1 + i, 0)])?;
                for j in 0..3 {
                    close(r.slope_slope[i][j], tangent[(1 + i, 1 + j)])?;
                }
            }
            // the section, from slopes and back from forces
            let point = Point { place, value: [0.0, 0.0, at[0]], slope, ..Point::zero() };
            let state = density.section_state(&point, 0.0);
            let forces = [state.horizontal_force, state.vertical_force, state.moment];
            let back = density.section_state_from_forces(place, [0.0, 0.0, at[0]], forces, 0.0);
            let soft = size / section.axial.min(section.shear).min(section.bending);
            for (one, other) in [
                (state.horizontal_slope, back.horizontal_slope),
                (state.vertical_slope, back.vertical_slope),
                (state.curvature, back.curvature),
            ] {
                prop_assert!((one - other).abs() <= 1e-12 * soft, "{one:e} and {other:e}");
            }
            prop_assert!((state.stored - back.stored).abs() <= 1e-12 * soft * size);
            Ok(())
        })
        .unwrap();
}

/// One element of order 1 with its left end clamped: what is left of it are the derivatives by the right end's fields.
#[test]
fn an_element_agrees_with_central_differences_of_its_energy() {
    let problem = rod(Drive::Y).problem(1).unwrap();
    let mut at = problem.initial(1);
    for (s, change) in at.values[3..].iter_mut().zip([0.1, -0.2, 0.3]) {
        *s += change;
    }
    let energy = |state: &[f64]| {
        let configuration =
            Configuration { ends: &at.mesh.boundaries, state, axial_multiplier: 0.0, history: None, strains: None };
        problem.beam.planar().unwrap().chain.energy(configuration, state).0.total
    };
    let (row, mut factors) = (ConstraintGradient::default(), ChainFactors::default());
    let root = problem
        .beam
        .planar()
        .unwrap()
        .chain
        .eliminate(problem.beam.planar().unwrap().configuration(&at), &row, &mut factors)
        .unwrap();
    let moved = |changes: &[(usize, f64)]| {
        let mut state = at.values.clone();
        changes.iter().for_each(|&(f, by)| state[3 + f] += by);
        energy(&state)
    };
    for i in 0..3 {
        let h = 1e-5;
        let gradient = (moved(&[(i, h)]) - moved(&[(i, -h)])) / (2.0 * h);
        assert!((root.matrix[i][3] - gradient).abs() < 1e-7, "{i}: {} and {gradient}", root.matrix[i][3]);
        for j in 0..3 {
            let h = 1e-4;
            let corner = |a: f64, b: f64| moved(&[(i, a * h), (j, b * h)]);
            let tangent =
                (corner(1.0, 1.0) - corner(1.0, -1.0) - corner(-1.0, 1.0) + corner(-1.0, -1.0)) / (4.0 * h * h);
            assert!((root.matrix[i][j] - tangent).abs() < 3e-5, "{i} {j}: {} and {tangent}", root.matrix[i][j]);
        }
    }
}

#[test]
fn the_rest_curve_is_an_equilibrium_without_force() {
    for drive in [Drive::X, Drive::Y, Drive::Rotation] {
        let problem = rod(drive).problem(7).unwrap();
        let found = controlled(&problem, problem.initial(4), FORCE, &[0.0], 1e-12).unwrap();
        assert!(found[0].energy < 1e-20, "{:e}", found[0].energy);
        assert!(found[0].observables.displacement.abs() < 1e-12, "{:e}", found[0].observables.displacement);
    }
}

#[test]
fn newtons_method_converges_quadratically_under_every_drive() {
    for drive in [Drive::X, Drive::Y, Drive::Rotation] {
        for order in 1..=8 {
            let problem = rod(drive).problem(order).unwrap();
            let start = controlled(&problem, problem.initial(4), FORCE, &[0.5], 1e-12).unwrap().remove(0);
            let condition = PathConstraint { weights: FORCE, target: 0.6 };
            let mut sizes = Vec::new();
            for most_iterations in 1..=10 {
                let options =
                    NewtonOptions { tolerance: 0.0, largest_update: 10.0, most_iterations, exact_slope: false };
                match solve(&problem, start.at.clone(), &condition, &options, &mut Workspace::default()) {
                    Err(SolveError::NotConverged { update, .. }) => sizes.push(update),
                    Err(error) => panic!("{drive:?}, order {order}: {error}"),
                    Ok(_) => break,
                }
            }
            let case = format!("{drive:?}, order {order}: {sizes:?}");
            assert!(sizes[sizes.len() - 1] < 1e-10, "{case}");
            // a rod's constant is its stretching stiffness over that of bending
            for pair in sizes.windows(2).filter(|p| p[0] < 0.1) {
                assert!(pair[1] <= 100.0 * pair[0] * pair[0] + 1e-11, "{case}");
            }
        }
    }
}

/// The tip of a cantilever on meshes of n and 2n elements, against a mesh that is far finer: order 2p in 1/n.
#[test]
fn the_tip_converges_with_order_2p() {
    let tip = |order: usize, elements: usize| {
        let problem =
            RodModel { rest: ReferenceCurve::straight(0.2, -0.1, 0.4), ..rod(Drive::Y) }.problem(order).unwrap();
        controlled(&problem, problem.initial(elements), FORCE, &[4.0], 1e-13).unwrap()[0].observables.displacement
    };
    let exact = tip(8, 12);
    for (order, elements) in [(1, 16), (2, 8), (3, 4), (4, 3)] {
        let ratio = (tip(order, elements) - exact) / (tip(order, 2 * elements) - exact);
        let rate = ratio.log2();
        assert!((rate - 2.0 * order as f64).abs() < 0.4, "order {order}: the error falls with the power {rate:.2}");
    }
}

/// A shallow arch presses through two limit loads and no limit of the displacement; what stays unreached is said.
#[test]
fn an_arch_snaps_through_and_a_short_path_says_so() {
    let opening = 0.4;
    let arch = RodModel {
        section: Section { axial: 400.0, shear: 140.0, bending: 1.0 },
        rest: ReferenceCurve::arc(opening, -opening),
        left: Support::HINGED,
        right: Support { x: Hold::Fixed, y: Hold::Free, rotation: Hold::Fixed },
        ..rod(Drive::Y)
    };
    let problem = arch.problem(5).unwrap();
    let rise = arch.rest.at(1.0)[1];
    let options = PathOptions {
        elements: 6,
        step_tolerance: 1e-3,
        stride: 1.0,
        longest: None,
        prediction: 8,
        tolerance: 1e-11,
        first_displacement: -0.01 * rise,
        pace: Pace::Quick,
    };
    let path = follow_rod(&problem, options, 500, |p| -p.observables.displacement > 2.0 * rise).unwrap();
    let kinds: Vec<LimitPointKind> = path.turns.iter().map(|turn| turn.kind).collect();
    assert_eq!(kinds, [LimitPointKind::Load, LimitPointKind::Load]);
    // between them the dead load's equilibrium is unstable, the prescribed displacement's is not
    let (first, second) = (path.turns[0].after, path.turns[1].after);
    for (k, point) in path.points.iter().enumerate() {
        assert_eq!((point.negative, point.negative_load), (0, usize::from(k > first && k <= second)), "point {k}");
    }
    // effort: a change that makes the path much longer is seen
    assert!(path.points.len() < 120, "{} points", path.points.len());
    let short = follow_rod(&problem, options, 5, |_| false);
    assert!(matches!(short, Err(RodFailure::TooLong { points: 5 })));
}
