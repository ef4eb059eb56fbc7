//! Where rods in space buckle.
//!
//! Reference: S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability (1961): 4.0126 √(EI3 GJ)/L² for the lateral
//! buckling of a cantilever, tan x = x for the twisted rod; J. H. Argyris et al., Comput. Methods Appl. Mech. Eng. 20
//! (1979), for the frame, π/L √(EI3 GJ) for half of it where it is rigid in its plane. Digits:
//! verification/space_benchmarks.csv.
//!
//!     ///o========o--> slides and turns: M      ///o========o P, up         o apex, in its plane of symmetry
//!        twisted                                   deep section           .'
//!                                                                     M ('o    on rollers
//!
//! Expected: critical loads to 1e-9 of themselves, or to round-off where that is more (EI2 = 1e8 EI3, the frame); a
//! twisted rod loses stability twice at once, its inertia jumps by two. Behind lateral buckling the force at five
//! displacements of the tip out of the plane, to 1e-9. Why: the second variation of bending, torsion and their
//! coupling by geometry, with inertia counted by the elimination. The critical loads lie between 4.01 and 7.05 as the
//! plane's deflection before buckling grows.

use super::setup::{Rod, assert_close, problem, rigid, tabulated, tip};
use peelkit::beam::rotation::{exponential, product};
use peelkit::beam::{EndRotation, SpatialRestCurve, SpatialStiffness};
use peelkit::number::root::Bracket;
use peelkit::solve::{
    NewtonOptions, Observables, PathConstraint, Problem, Solution, State, System, Workspace, controlled, solve,
};
use std::cell::RefCell;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

const CLOSE: f64 = 1e-12;

/// Off by at most 1e-9 of itself, or by what round-off makes of this ratio of the stiffest to the softest way to
/// deform.
#[track_caller]
fn assert_near(found: f64, wanted: f64, ratio: f64, what: &str) {
    let (off, most) = ((found / wanted - 1.0).abs(), (50.0 * f64::EPSILON * ratio).max(1e-9));
    assert!(off < most, "{what}: {found} and {wanted}, off by {off:.1e}");
}

/// Few and of order 8: round-off of a stiffness that vanishes is that of the stiffest way an element deforms.
const ELEMENTS: usize = 2;

fn held(problem: &Problem, from: &State, force: f64) -> Solution {
    let found = controlled(problem, from.clone(), Observables::FORCE, &[force], 1e-10);
    found.unwrap_or_else(|error| panic!("at {force}: {error}")).remove(0)
}

/// The load between `low` and `high` at which the first eigenvalue with the load held passes through zero, and how
/// many do.
fn critical(problem: &Problem, elements: usize, [low, high]: [f64; 2]) -> (f64, usize) {
    let start = held(problem, &problem.initial(elements), low);
    let before = start.negative_load;
    let nearest = RefCell::new(start.at);
    let stable = |load: f64| {
        let solution = held(problem, &nearest.borrow(), load);
        let stable = solution.negative_load == before;
        if stable {
            *nearest.borrow_mut() = solution.at;
        }
        stable
    };
    let found = Bracket { low, high }.bisected(stable, |left| left.width().abs() < CLOSE * left.high.abs()).middle();
    let behind = held(problem, &nearest.borrow(), high).negative_load;
    (found, behind - before)
}

fn straight(stiffness: SpatialStiffness) -> Rod {
    Rod::clamped(stiffness, SpatialRestCurve::along_x(0.0), 1.0)
}

#[test]
fn a_twisted_rod_has_a_double_root() {
    for (case, stiff) in [("twisted_1e4", 1e4), ("twisted_1e5", 1e5), ("twisted_1e6", 1e6)] {
        let stiffness = SpatialStiffness::diagonal(stiff, [stiff; 2], 1.0, [1.0; 2]);
        let rod = Rod { rotation: EndRotation::Angles, ..straight(stiffness) };
        let (problem, _) = rod.problem(5, &[1, 2, 3, 4]);
        let (moment, roots) = critical(&problem, 8, [8.5, 9.3]);
        let wanted = tabulated(case, "moment");
        assert_near(moment, wanted, stiff, case);
        assert_eq!(roots, 2, "{case}");
    }
}

/// A cantilever with this EI2, EI3 = GJ = 1, and this compliance of stretching and shear.
fn deep(bending: f64, compliance: f64) -> Rod {
    let stiff = 1.0 / compliance;
    straight(SpatialStiffness::diagonal(stiff, [stiff; 2], 1.0, [bending, 1.0]))
}

/// What holds the right end in its plane, per displacement out of it, and the state: of a problem whose right end is
/// driven along z.
fn lateral_stiffness(problem: &Problem, from: State) -> (f64, State) {
    let options = NewtonOptions { tolerance: 1e-12, largest_update: 1e3, most_iterations: 30, exact_slope: true };
    let in_plane = PathConstraint { weights: Observables::DISPLACEMENT, target: 0.0 };
    let found = solve(problem, from, &in_plane, &options, &mut Workspace::default()).unwrap();
    (found.slope.force / found.slope.displacement, found.at)
}

/// Where the lateral stiffness vanishes, and the state there: by the secant, until round-off. Equilibria in the plane
/// are followed from zero on.
fn vanishes(start: State, near: f64, problem: impl Fn(f64) -> Problem) -> (f64, State) {
    let mut at = start;
    for k in 0..10 {
        at = lateral_stiffness(&problem(0.1 * f64::from(k) * near), at).1;
    }
    let mut last = [(0.99 * near, 0.0), (near, 0.0)];
    for one in &mut last {
        (one.1, at) = lateral_stiffness(&problem(one.0), at);
    }
    for _ in 0..20 {
        let [(before, a), (now, b)] = last;
        let next = now - b * (now - before) / (b - a);
        let (stiffness, there) = lateral_stiffness(&problem(next), at.clone());
        if stiffness.abs() >= b.abs() {
            break;
        }
        (last, at) = ([(now, b), (next, stiffness)], there);
    }
    (last[1].0, at)
}

#[test]
fn lateral_buckling_at_five_ratios_of_the_stiffnesses() {
    for (case, bending, near) in [
        ("lateral_1e8", 1e8, 4.0),
        ("lateral_1e4", 1e4, 4.0),
        ("lateral_100", 100.0, 4.0),
        ("lateral_10", 10.0, 4.6),
        ("lateral_4", 4.0, 7.0),
    ] {
        let [force] = rigid(2e-3, |compliance| {
            let rod = Rod { order: 8, ..deep(bending, compliance) };
            let under = |force: f64| Rod { load: [[0.0, force, 0.0], [0.0; 3]], ..rod.clone() }.problem(2, &[]).0;
            [vanishes(rod.beam().stress_free(ELEMENTS), near, under).0]
        });
        let wanted = tabulated(case, "force");
        assert_near(force, wanted, bending, case);
    }
}

/// The force under which the tip is so far out of the plane, and its place; what holds it there vanishes.
fn buckled(compliance: f64, displacements: &[f64]) -> Vec<[f64; 3]> {
    let rod = deep(100.0, compliance);
    // from one force to another in short steps, then to where the tip is held
    let across = |(from, force): (f64, f64), at: &State, z: f64| {
        let steps = ((force - from).abs() / 0.02).ceil().max(1.0);
        let mut at = at.clone();
        for k in 1..=steps as usize {
            let load = [[0.0, from + (force - from) * k as f64 / steps, 0.0], [0.0; 3]];
            let (problem, _) = Rod { load, ..rod.clone() }.problem(2, &[]);
            at = controlled(&problem, at, Observables::DISPLACEMENT, &[z], 1e-12).unwrap().remove(0).at;
        }
        at
    };
    let (mut force, mut at) = (4.0, across((0.0, 4.0), &rod.beam().stress_free(8), displacements[0]));
    let mut found = Vec::new();
    for &z in displacements {
        at = across((force, force), &at, z);
        let ahead = across((force, force + 0.02), &at, z);
        let mut last = [(force, at), (force + 0.02, ahead)];
        for _ in 0..30 {
            let [(before, a), (now, b)] = &last;
            let next = now - b.force * (now - before) / (b.force - a.force);
            if !next.is_finite() || (next - now).abs() < 1e-12 {
                break;
            }
            let there = across((*now, next), b, z);
            last = [last[1].clone(), (next, there)];
        }
        let [_, reached] = last;
        (force, at) = reached;
        let [x, y, _] = tip(&at);
        found.push([force, x, y]);
    }
    found
}

#[test]
fn behind_lateral_buckling() {
    let displacements = [0.05, 0.1, 0.2, 0.3, 0.4];
    for (k, z) in displacements.into_iter().enumerate() {
        let found = rigid(1e-3, |compliance| buckled(compliance, &displacements[..=k])[k]);
        let wanted = ["force", "tip_x", "tip_y"].map(|name| tabulated("lateral_100", &format!("{name}_at_z_{z}")));
        assert_close(&found, &wanted, 1e-9, &format!("z = {z}"));
    }
}

/// The moment under which half of the frame leaves its plane, at a rotation of its support near this one. From the
/// support, which slides along x and is turned about z, to the apex, which stays on the plane of symmetry and turns
/// about x.
fn frame(in_plane: f64, torsion: f64, near: f64) -> f64 {
    let stiffness = SpatialStiffness::diagonal(1_282_320.0, [407_862.595_419_847_3; 2], torsion, [in_plane, 38_469.6]);
    let length = 240.0;
    let flat = SpatialRestCurve::along_x(0.0);
    let rest = SpatialRestCurve {
        start: [-FRAC_1_SQRT_2 * length, 0.0, 0.0],
        directors: product(exponential([0.0, 0.0, FRAC_PI_4]), flat.directors),
        ..flat
    };
    let held_left = [false, true, true, true, true, true];
    let rod = Rod { held_left, order: 8, rotation: EndRotation::Angles, ..Rod::clamped(stiffness, rest, length) };
    let turned = |rotation: f64| {
        let mut beam = rod.beam();
        beam.chain.held_left[3] = Some(rotation);
        problem(beam, 2, &[0, 3, 4]).0
    };
    let (_, at) = vanishes(rod.beam().stress_free(ELEMENTS), near, turned);
    let mut beam = rod.beam();
    beam.chain.held_left = [None; 6];
    beam.residual(&at)[3]
}

#[test]
fn a_right_angle_frame_under_moments_of_both_signs() {
    let (in_plane, torsion) = (96_174_000.0, 58_732.213_740_458_01);
    // the moment is nearly the same all along the leg
    let rotation = |in_plane: f64, sign: f64| sign * 622.0 * 240.0 / in_plane;
    for (quantity, sign) in [("moment_closing", -1.0), ("moment_opening", 1.0)] {
        let of = |in_plane: f64, torsion: f64| frame(in_plane, torsion, rotation(in_plane, sign)) * sign;
        for (case, found) in [
            ("frame", of(in_plane, torsion)),
            ("frame_rigid_in_plane", rigid(1e-2, |compliance| [of(in_plane / compliance, torsion)])[0]),
            ("frame_J_exact", of(in_plane, 57_991.895_506_226_254)),
        ] {
            let wanted = tabulated(case, quantity);
            assert_near(found, wanted, 1_282_320.0 * 240.0 * 240.0 / 38_469.6, &format!("{case}, {quantity}"));
        }
    }
}
