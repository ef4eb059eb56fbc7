//! Where a seta comes to rest behind an event, against gradient flow.
//!
//! The rule of `rest.rs` lets the tips that lose their hold go and leads downhill from there. Reference: gradient flow, K + C/Δt with the tips as they
//! are, in steps of at most 0.2 nm and 0.0002 rad, from the loss of stability as it is, with the root pulled on by 1e-3 nm; nothing is said to it of which
//! tip goes first. Expected: the same tips detach, and energy and force are the same to 1e-6. Six setae with four tips, free and held, leaning and
//! upright. Why: where two tips are nearly alike the one whose height is followed to the loss need not be the one that comes to the end of its branch.

use super::advance::{Advance, advance};
use super::loading::SetaOptions;
use super::loss::Critical;
use super::rest::come_to_rest;
use super::standing::{RootDrive, Standing, TipTangent};
use crate::model::seta::normal_pull::{CurvePoint, NormalPull, PullCurve, Sideways};
use crate::model::seta::parameters::{Seta, SetaMesh, SetaModel};
use crate::model::seta::tip_law::TipBranch;
use crate::solve::newton::{NewtonOptions, Solution, damped_step, solve};
use crate::solve::state::{Observables, PathConstraint};
use crate::solve::system::{Coefficients, System};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

const CURVE: [(f64, f64, f64); 7] = [
    (-50.0, -0.4, 0.009),
    (0.0, 0.1, 0.012),
    (100.0, 2.1, 0.035),
    (200.0, 4.7, 0.007),
    (300.0, 5.8, 0.013),
    (361.0, 6.67, 0.0),
    (364.0, 6.5, -0.2),
];
/// Longest step, in units of 10 nm and 0.01 rad
const STEP: f64 = 0.02;
/// How far the root is pulled on, nm
const AHEAD: f64 = 1e-3;

fn model(sideways: Sideways, degrees: f64, scatter: f64, diameter: f64) -> SetaModel {
    let seta = Seta {
        forks: 2,
        tip_pitch: 600.0,
        shaft_length: 4000.0,
        shaft_angle: degrees.to_radians(),
        brush_height: 1500.0,
        brush_angle: (0.7 * degrees).to_radians(),
        shaft_diameter: diameter,
        height_scatter: scatter,
        ..Seta::default()
    };
    let point = |&(displacement, force, slope): &(f64, f64, f64)| CurvePoint { displacement, force, slope };
    let curve = PullCurve::new(CURVE.iter().map(point).collect(), -900.0).unwrap();
    let law = NormalPull { curve, sideways, contact_height: 0.0 };
    SetaModel { mesh: SetaMesh { order: 3, elements: vec![1; 3] }, ..SetaModel::new(seta, Arc::new(law)) }
}

/// Where gradient flow leads to behind a loss, with the root where that is, and the steps that it takes.
fn flow(standing: &mut Standing, drive: &RootDrive, from: &Solution, ws: &mut Workspace) -> (Solution, usize) {
    let displacement = from.observables.displacement;
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: displacement };
    let pulled = PathConstraint { target: displacement + AHEAD, ..held };
    let (mut at, mut time, mut changed) = (from.at.clone(), 1.0, false);
    for step in 0..200_000 {
        let problem = standing.problem(drive, None, TipTangent::Own);
        let newton = NewtonOptions { tolerance: 1e-9, largest_update: 0.1, most_iterations: 9, exact_slope: true };
        if step % 20 == 19
            && changed
            && let Ok(solution) = solve(&problem, at.clone(), &held, &newton, ws)
            && solution.negative == 0
            && solution.correction < 0.1
        {
            return (solution, step);
        }
        let damping = Coefficients { per_damping: time, ..Coefficients::STATIC };
        let mut next = at.clone();
        let (size, (negative, _)) = damped_step(&problem, &mut next, &pulled, damping, f64::INFINITY, ws).unwrap();
        if negative > 0
            || size > STEP
            || (step > 0 && super::rest::energy(&problem, &next) > super::rest::energy(&problem, &at) + 1e-9)
        {
            time *= 0.3;
            continue;
        }
        time *= if size < 0.3 * STEP { 2.0 } else { 1.0 };
        for tip in standing.changing(&next) {
            standing.change(&next, tip);
            changed = true;
        }
        at = next;
    }
    panic!("it does not come to rest");
}

#[test]
fn tips_that_let_go_lead_where_gradient_flow_leads() {
    let options = SetaOptions { balance: 1e-6, ..SetaOptions::default() };
    let (mut same, mut other_places) = (0, 0);
    for (sideways, degrees, scatter, diameter) in [
        (Sideways::Free, 30.0, 20.0, 250.0),
        (Sideways::Held(0.5), 30.0, 20.0, 250.0),
        (Sideways::Free, 0.0, 5.0, 250.0),
        (Sideways::Free, 0.0, 40.0, 600.0),
        (Sideways::Held(0.5), 10.0, 2.0, 350.0),
        (Sideways::Held(2.0), 50.0, 10.0, 400.0),
    ] {
        let model = model(sideways, degrees, scatter, diameter);
        let mut standing = Standing::new(&model, TipBranch::Attached).unwrap();
        let drive = RootDrive::new([0.0, 1.0, 0.0], model.seta.joint_place(0));
        let (mut ws, at) = (Workspace::default(), standing.tree.stress_free(0));
        let rested = come_to_rest(&mut standing, &drive, (at, 0.0), &[], 1e-9, &mut ws);
        let (mut here, mut ahead, mut softest) = (rested.ok().unwrap().solution, 5.0, None);
        while standing.attached() > 0 {
            let (last, tips) = match advance(&standing, &drive, (&here, ahead), (softest, None), &options, &mut ws).0 {
                Advance::Shorter { ahead: shorter, .. } => {
                    ahead = shorter;
                    continue;
                }
                Advance::Taken { taken, next, .. } => {
                    for reached in taken {
                        standing.note(&reached.solution.at);
                        here = reached.solution;
                    }
                    ahead = next.min(50.0);
                    continue;
                }
                Advance::Contact { taken, tips } => (taken.solution, tips),
                Advance::Lost(loss) => {
                    softest = loss.slope.or(softest);
                    let last = loss.taken.last().unwrap().solution.clone();
                    match loss.critical {
                        Critical::Tips(tips) => (last, tips),
                        Critical::Passed => {
                            standing.note(&last.at);
                            here = last;
                            continue;
                        }
                        Critical::Shape(_) => panic!("beams buckle"),
                    }
                }
            };
            standing.note(&last.at);
            ahead = ahead.max(options.first_step);
            let (displacement, mut flowing) = (last.observables.displacement, standing.clone());
            let (flowed, steps) = flow(&mut flowing, &drive, &last, &mut ws);
            let start = (last.at.clone(), displacement);
            let rested = come_to_rest(&mut standing, &drive, start, &tips, 1e-9, &mut ws).ok().unwrap();
            let adhering =
                |standing: &Standing| standing.tips.iter().map(|tip| tip.on.adheres()).collect::<Vec<bool>>();
            let (one, other) = (&rested.solution, &flowed);
            let forces = [one, other].map(|at| at.observables.force);
            let is_same = adhering(&standing) == adhering(&flowing)
                && (one.energy - other.energy).abs() < 1e-6 * (1.0 + other.energy.abs())
                && (forces[0] - forces[1]).abs() < 1e-6;
            let changes: Vec<usize> = rested.changes.iter().map(|change| change.tip).collect();
            println!(
                "{sideways:?} {degrees} {scatter} {diameter}: at {displacement:.3} nm {tips:?} first, {changes:?}; flow leaves {:?} in {steps} steps; {forces:?} nN, the same: {is_same}",
                adhering(&flowing)
            );
            *if is_same { &mut same } else { &mut other_places } += 1;
            here = rested.solution;
        }
    }
    println!("{same} events lead to the same place, {other_places} do not");
    assert_eq!((same, other_places), (23, 0));
}
