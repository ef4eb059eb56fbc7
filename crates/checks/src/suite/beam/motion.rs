//! Rigid motions store no energy and change none.

use super::rods::{cantilever, problem};
use crate::check::{Check, Measure};
use peelkit::beam::{Configuration, PlanarBeam, ReferenceCurve};
use peelkit::model::{BeamProblem, Drive, RodModel, Support};

const ELEMENTS: usize = 5;
const AXIAL: f64 = 1e4;

pub(super) fn checks() -> Vec<Check> {
    let straight = RodModel { left: Support::FREE, ..cantilever(AXIAL, 0.4 * AXIAL, Drive::Y) };
    let arch = RodModel { rest: ReferenceCurve::arc(1.0, -2.0), ..straight };
    let at_most =
        |name: String, computed| Check::new(name, "zero: rigid motion", computed, 0.0, Measure::AtMost, 1e-12);
    let mut checks = Vec::new();
    for turn in [1e-3, 1.0, 3.0, 100.0] {
        let moved = problem(&straight, 7).map(|p| (moved(&p, &p.initial(ELEMENTS).values, turn), p));
        checks.push(at_most(
            format!("stored energy over EA L, straight rod turned by {turn} rad and moved by (3, -2) L"),
            moved.as_ref().map(|(state, p)| energy(p, state) / AXIAL).map_err(String::clone),
        ));
        checks.push(at_most(
            format!("largest section force over EA, straight rod turned by {turn} rad and moved by (3, -2) L"),
            moved.map(|(state, p)| largest_force(&p, &state) / AXIAL),
        ));
    }
    for turn in [1.0, 100.0] {
        checks.push(at_most(
            format!("relative change of the stored energy of a bent, stretched and sheared arch turned by {turn} rad"),
            problem(&arch, 7).map(|p| {
                let state = deformed(&p);
                (energy(&p, &moved(&p, &state, turn)) / energy(&p, &state) - 1.0).abs()
            }),
        ));
    }
    checks.push(at_most(
        "stored energy over EA L, arch of 2 rad at rest, 5 elements of order 7".into(),
        problem(&arch, 7).map(|p| energy(&p, &p.initial(ELEMENTS).values) / AXIAL),
    ));
    checks
}

/// A rod lies in the plane.
fn planar(problem: &BeamProblem) -> &PlanarBeam {
    problem.beam.planar().expect("a rod lies in the plane")
}

fn energy(problem: &BeamProblem, state: &[f64]) -> f64 {
    let beam = planar(problem);
    let ends = beam.ends(0.0, ELEMENTS);
    beam.chain
        .energy(Configuration { ends: &ends, state, axial_multiplier: 0.0, history: None, strains: None }, state)
        .0
        .total
}

fn largest_force(problem: &BeamProblem, state: &[f64]) -> f64 {
    let beam = planar(problem);
    let ends = beam.ends(0.0, ELEMENTS);
    let states = beam.chain.node_states(
        Configuration { ends: &ends, state, axial_multiplier: 0.0, history: None, strains: None },
        0..ends.len() - 1,
    );
    states.iter().map(|s| s.section.horizontal_force.abs().max(s.section.vertical_force.abs())).fold(0.0, f64::max)
}

/// The state turned about the origin and moved by (3, -2).
fn moved(problem: &BeamProblem, state: &[f64], turn: f64) -> Vec<f64> {
    let (sin, cos) = turn.sin_cos();
    on_nodes(problem, state, |[x, y, rotation]| [3.0 + cos * x - sin * y, -2.0 + sin * x + cos * y, rotation + turn])
}

/// A state whose nodes are where `moved` brings x, y and θ of those of another one.
fn on_nodes(problem: &BeamProblem, state: &[f64], moved: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<f64> {
    let places = planar(problem).places(&planar(problem).ends(0.0, ELEMENTS));
    let node = |(node, s): (&[f64; 3], f64)| {
        let [x, y, rotation] = moved([s + node[0], node[1], node[2]]);
        [x - s, y, rotation]
    };
    state.as_chunks::<3>().0.iter().zip(places).flat_map(node).collect()
}

/// The rest state with a wave of a tenth of the length in every field: strains of order one, no equilibrium.
fn deformed(problem: &BeamProblem) -> Vec<f64> {
    let rest = problem.initial(ELEMENTS).values;
    on_nodes(problem, &rest, |[x, y, rotation]| {
        [x + 0.1 * (3.0 * y).cos(), y + 0.1 * (4.0 * x).sin(), rotation + 0.3 * x * x]
    })
}
