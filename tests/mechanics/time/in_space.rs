//! A cantilever of viscous material in space, as a chain and as a branch of a tree, and the same one in the plane.
//!
//!     /|===============| moved across
//!
//! Reference: the planar beam, which is checked against collocation in `spin_up.rs`. Parameters: L = 10, EA = 1e4, GA = 4e3, EI = 100 (of the other
//! bending 170, of torsion 90), ρA = 1, ρI = 0.3, its end moved by a quarter of its length within 2 units of time and held.
//! Expected: the same force, place and energies to 1e-10, step by step. Why: strains in the axes of the directors.

use crate::beam::spatial::setup::{PLAIN, Rod};
use approx::assert_relative_eq;
use peelkit::beam::{
    BeamInertia, BeamTree, Branch, BranchingBeam, EndRotation, JointCondition, ReferenceCurve, Section, SpatialBeam,
    SpatialInertia, SpatialRestCurve, SpatialStiffness, Viscosity,
};
use peelkit::model::{Drive as Driven, MovingBeam, RodModel, Support};
use peelkit::solve::time::{
    Drive, DynamicProblem, DynamicSystem, EnergyBalance, MaterialRate, Motion, Ramp, StepControl, StepTerms,
    TimeIntegrator, TimeOptions,
};
use peelkit::solve::{
    Coefficients, EndConditions, InitialState, MeasuredBeside, NodalTerms, PathMeasure, Problem, State, System,
    Workspace,
};
use std::sync::Arc;

const LENGTH: f64 = 10.0;
const SECTION: Section = Section { axial: 1e4, shear: 4e3, bending: 100.0 };
const ORDER: usize = 7;
const ELEMENTS: usize = 14;

fn in_space(viscosity: Viscosity) -> SpatialBeam {
    let rest = SpatialRestCurve { start: [0.0; 3], directors: PLAIN, curvature: [0.0; 3] };
    let Section { axial, shear, bending } = SECTION;
    let stiffness = SpatialStiffness::diagonal(axial, [shear, 5e3], 90.0, [170.0, bending]);
    let rod = Rod { order: ORDER, ..Rod::clamped(stiffness, rest, LENGTH) };
    SpatialBeam { inertia: Some(SpatialInertia::uniform(1.0, [0.4, 0.5, 0.3], viscosity)), ..rod.beam() }
}

/// As so many branches of a tree, whose root is its right end and whose tip its left one.
pub fn as_tree(viscosity: Viscosity, cuts: usize) -> BeamTree {
    let Section { axial, shear, bending } = SECTION;
    let stiffness = SpatialStiffness::diagonal(axial, [shear, 5e3], 90.0, [170.0, bending]);
    let place = |k: usize| [LENGTH * k as f64 / cuts as f64, 0.0, 0.0];
    let branch =
        |k: usize| Branch::straight([k, k + 1], [place(k), place(k + 1)], [0.0, 1.0, 0.0], stiffness, ELEMENTS / cuts);
    let clamped = JointCondition { rotation: EndRotation::Angles, held: [Some(0.0); 6], ..JointCondition::free(0) };
    let tree = BranchingBeam {
        conditions: vec![clamped],
        order: ORDER,
        scale: [0.1, 0.01],
        ..BranchingBeam::new((0..cuts).map(branch).collect(), cuts)
    };
    tree.build().unwrap().with_viscosity(viscosity)
}

pub fn in_grip<S: DynamicSystem + 'static>(system: S) -> DynamicProblem {
    let (system, grip) = (Arc::new(system), EndConditions::drive(1));
    let measure = PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force };
    let problem = Problem { system: system.clone(), grip, measure, start: InitialState::StressFree };
    DynamicProblem::new(problem, system)
}

/// Force and energies after each tenth part of 3 units of time, in so many steps.
pub fn moved(problem: &DynamicProblem, at: State, steps: usize) -> Vec<(f64, EnergyBalance)> {
    let still = vec![0.0; problem.system.unknowns(&at)];
    let memory = problem.system.relaxed_memory(&at);
    let motion = Motion::new(0.0, at, still.clone(), still, memory);
    let drive = Drive::ramp(Ramp::new(0.0, 0.25 * LENGTH, 0.25 * LENGTH / 1.5, 0.3));
    let options = TimeOptions { newton: 1e-13, ..TimeOptions::new(StepControl::Fixed(3.0 / steps as f64)) };
    let mut run = TimeIntegrator::new(problem, drive, motion, options, Workspace::default());
    let mut found = Vec::new();
    for _ in 0..10 {
        for _ in 0..steps / 10 {
            run.advance(10.0).unwrap();
        }
        found.push((run.motion().at.force, *run.balance()));
    }
    found
}

pub fn planar(inertia: [f64; 2], viscosity: Viscosity) -> MovingBeam {
    let rod = RodModel {
        length: LENGTH,
        section: SECTION,
        rest: ReferenceCurve::default(),
        left: Support::CLAMPED,
        right: Support::FREE,
        drive: Driven::Y,
    };
    let [per_length, rotary] = inertia;
    rod.in_time(ORDER, BeamInertia::uniform(per_length, rotary, viscosity)).unwrap()
}

/// To 1e-10 of the largest force and of the work.
pub fn assert_same(found: &[(f64, EnergyBalance)], wanted: &[(f64, EnergyBalance)]) {
    let force = wanted.iter().map(|at| at.0.abs()).fold(0.0, f64::max);
    let work = wanted.iter().map(|at| at.1.work.abs()).fold(0.0, f64::max);
    for (found, wanted) in found.iter().zip(wanted) {
        assert_relative_eq!(found.0, wanted.0, epsilon = 1e-10 * force);
        let of = |balance: &EnergyBalance| [balance.work, balance.stored, balance.kinetic, balance.dissipated];
        for (found, wanted) in of(&found.1).into_iter().zip(of(&wanted.1)) {
            assert_relative_eq!(found, wanted, epsilon = 1e-10 * work);
        }
    }
}

pub const MATERIALS: [Viscosity; 3] = [
    Viscosity::Elastic,
    Viscosity::KelvinVoigt { retardation_time: 0.3 },
    Viscosity::StandardLinearSolid { relaxation_time: 0.5, stiffness_ratio: 2.5 },
];

#[test]
fn a_viscous_cantilever_in_space_is_the_planar_one() {
    for viscosity in MATERIALS {
        let planar = planar([1.0, 0.3], viscosity);
        let wanted = moved(&planar.dynamics, planar.statics.initial(ELEMENTS), 150);
        let beam = in_space(viscosity);
        let at = beam.stress_free(ELEMENTS);
        assert_same(&moved(&in_grip(beam), at, 150), &wanted);
        let EnergyBalance { dissipated, work, .. } = wanted.last().unwrap().1;
        assert_eq!(dissipated > 0.01 * work, viscosity.is_viscous(), "{dissipated} of {work}");
    }
}

/// Without mass, and of second order: half the step, a quarter of the error.
#[test]
fn a_viscous_tree_of_one_branch_is_the_planar_beam() {
    for viscosity in MATERIALS {
        let planar = planar([0.0; 2], viscosity);
        let wanted = moved(&planar.dynamics, planar.statics.initial(ELEMENTS), 60);
        let tree = as_tree(viscosity, 1);
        let at = tree.stress_free(0);
        let problem = in_grip(tree);
        assert_same(&moved(&problem, at.clone(), 60), &wanted);
        if viscosity.is_viscous() {
            // while the end moves at its full rate
            let [a, b, c] = [100, 200, 400].map(|steps| moved(&problem, at.clone(), steps)[4].0);
            assert_relative_eq!((a - b) / (b - c), 4.0, max_relative = 0.1);
        }
    }
}

/// The room of an elimination is used again: what a step in time remembers is none of a statics behind it, bit for bit.
#[test]
fn statics_behind_a_step_in_time_know_nothing_of_it() {
    let viscosity = MATERIALS[1];
    let (beam, tree) = (in_space(viscosity), as_tree(viscosity, 2));
    let states = [beam.stress_free(ELEMENTS), tree.stress_free(0)];
    let systems: [&dyn DynamicSystem; 2] = [&beam, &tree];
    for (system, at) in systems.into_iter().zip(&states) {
        let known: Vec<f64> = system.relaxed_memory(at).iter().map(|strain| strain + 0.01).collect();
        let rate = MaterialRate { per_time: 2.0, known: known.into() };
        let statics = |ws: &mut Workspace| system.factorise(at, Coefficients::STATIC, [0.0; 2], ws).unwrap();
        let (mut used, mut fresh) = (Workspace::default(), Workspace::default());
        let step = system.factorise_step(at, &StepTerms { nodal: NodalTerms::NONE, rate: &rate }, &mut used).unwrap();
        let [behind, alone] = [statics(&mut used), statics(&mut fresh)];
        assert_eq!((behind.matrix, behind.residual), (alone.matrix, alone.residual));
        assert_ne!(step.residual, alone.residual);
    }
}
