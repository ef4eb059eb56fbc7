//! What a test would record: where stability is lost under control of the machine's displacement U = u + P/k, where the strip
//! comes to rest, what it releases, and that work and energy balance.
//!
//!          U          machine
//!          |
//!          ≷ k        spring (none: rigid)
//!          | u, P     grip
//!     _____|          strip
//!     ///////         substrate
//!
//! References: a rigid flat punch under the traction of eq. (18), written a second time here, in closed form and by quadrature;
//! the path of equilibria of the same strip without a spring, its snap-off, its slope by finite differences and its stable
//! branches; the inertia with the displacement and with the force held; other steps of the relaxation.
//! Parameters: A_H = 1e-19 J, r0 = 0.4 nm, h = 10 nm, E = 2 GPa (the punch 1e6 GPa), L = 100 nm (the punch 5 nm), EI × 1, 1e-2
//! and 1e-4, k from 1e-9 to 1e9 N/m, `relative` = 1e-6.
//! Expected: the same to what stands beside each assertion; work against energy to 1e-6 of the largest term. Why: what a machine
//! records follows from the equilibria and their energies alone, whatever finds them.

use crate::common::{PAPER, paper_strip, traction, with_grip, with_load};
use peelkit::adhesion::LineLoad;
use peelkit::beam::FRONT;
use peelkit::model::{Form, Hold, StripModel};
use peelkit::solve::{
    EndConditions, Held, LimitPointKind, NewtonOptions, Observables, Pace, Path, PathConstraint, PathOptions,
    PathSegment, Problem, RelaxOptions, Relaxed, Solution, Workspace, brackets, disturbed, locate, relax, solve,
};
use peelkit::study::{
    Accuracy, Bound, Jump, JumpKind, LoadingDirection, NoTest, Observed, Stage, StopCriteria, StopReason, TestEnd,
    observed, peel,
};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

fn on_a_spring(mut model: StripModel, stiffness: f64) -> StripModel {
    model.grip.stiffness = Some(stiffness);
    model
}

fn guided(factor: f64) -> StripModel {
    with_grip(paper_strip(100.0, factor), Hold::Fixed, Hold::Free)
}

fn test_of(model: &StripModel) -> Observed {
    observed(model, &Accuracy::to(1e-6), &BOUNDS).unwrap()
}

#[track_caller]
fn assert_close(what: &str, found: f64, expected: f64, relative: f64) {
    let off = (found / expected - 1.0).abs();
    assert!(off <= relative, "{what}: {found} is {off:.1e} from {expected}");
}

/// Work and energy balance there and back, every jump releases energy, and the cycle is that of all jumps.
#[track_caller]
fn assert_balanced(test: &Observed) {
    assert_eq!(test.end, TestEnd::Closed);
    for balance in [test.retreat.unwrap(), test.cycle.unwrap()] {
        assert!(balance.error() <= 1e-6, "{balance:?} is off by {:.1e}", balance.error());
    }
    let released: f64 = test.jumps.iter().map(|jump| jump.released).sum();
    assert_close("hysteresis", test.hysteresis.unwrap(), released, 1e-6);
    assert!(test.jumps.iter().all(|jump| jump.released > jump.released_error && jump.released_error > 0.0));
}

/// A rigid punch: P = -L T(y), U = y - y0 + P/k for the gap y of its lower face.
struct Punch {
    length: f64,
    height: f64,
    stiffness: f64,
    rest: f64,
}

impl Punch {
    fn force(&self, gap: f64) -> f64 {
        -self.length * (traction(&PAPER, gap) - traction(&PAPER, gap + self.height))
    }

    fn machine(&self, gap: f64) -> f64 {
        gap - self.rest + self.force(gap) / self.stiffness
    }

    /// dU/dy by differences of second order, extrapolated: good to 1e-9.
    fn slope(&self, gap: f64) -> f64 {
        let central = |h: f64| (self.machine(gap + h) - self.machine(gap - h)) / (2.0 * h);
        (4.0 * central(1e-4) - central(2e-4)) / 3.0
    }

    /// Energy with the spring at one gap less that at another: ∫ P dy by Simpson's rule, and ½P²/k.
    fn energy_difference(&self, from: f64, to: f64) -> f64 {
        let n = 20_000;
        let step = (to - from) / n as f64;
        let weight = |i: usize| {
            if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        let work: f64 = (0..=n).map(|i| weight(i) * self.force(from + i as f64 * step)).sum::<f64>() * step / 3.0;
        work + 0.5 * (self.force(to).powi(2) - self.force(from).powi(2)) / self.stiffness
    }
}

/// The zero of a function between two places at which it differs in sign.
fn zero(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let rising = f(low) < 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == rising { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[test]
fn a_rigid_strip_on_a_spring_is_a_punch() {
    let mut model = with_grip(paper_strip(5.0, 1.0), Hold::Fixed, Hold::Free);
    model.strip.material.youngs_modulus = 1e6;
    let stiffness = 0.5;
    let punch = Punch { length: 5.0, height: 10.0, stiffness, rest: model.line_law().rest_gap() };
    let test = test_of(&on_a_spring(model, stiffness));
    assert_balanced(&test);
    let [off, into] = test.jumps[..] else { panic!("{:?}", test.jumps) };
    assert_eq!((off.kind, off.way), (JumpKind::SnapOff, LoadingDirection::Retreat));
    assert_eq!((into.kind, into.way), (JumpKind::IntoContact, LoadingDirection::Approach));
    // 1 + P'(y)/k = 0 on both sides of the steepest place; the other branch at the same U
    let steepest = zero(|gap| punch.slope(gap + 1e-3) - punch.slope(gap - 1e-3), 0.3, 0.7);
    let inner = zero(|gap| punch.slope(gap), 0.26, steepest);
    let outer = zero(|gap| punch.slope(gap), steepest, 3.0);
    let landed_off = zero(|gap| punch.machine(gap) - punch.machine(inner), outer, 100.0);
    let landed_in = zero(|gap| punch.machine(gap) - punch.machine(outer), 0.2, inner);
    for (jump, from, to) in [(off, inner, landed_off), (into, outer, landed_in)] {
        // 3e-7 is the strip's own compliance; it and round-off move the force at a turning point most
        assert_close("U", jump.machine, punch.machine(from), 1e-6);
        assert_close("P before", jump.before.force, punch.force(from), 3e-6);
        assert_close("P after", jump.after.force, punch.force(to), 1e-6);
        assert_close("released", jump.released, -punch.energy_difference(from, to), 1e-6);
    }
    // the spring is stiffer than where the force is largest, so that this lies on the stable retreat
    let peak = zero(|gap| punch.force(gap + 1e-5) - punch.force(gap - 1e-5), 0.26, 0.7);
    assert_close("pull-off force", test.pull_off.unwrap().force, punch.force(peak), 1e-6);
}

/// The path of a strip, up to `most` points.
fn path_of(problem: &Problem, elements: usize, most: usize) -> Vec<Arc<Solution>> {
    let options = PathOptions {
        elements,
        step_tolerance: 1e-2,
        stride: 1.0,
        longest: None,
        tolerance: 1e-9,
        prediction: 8,
        first_displacement: 0.008,
        pace: Pace::Quick,
    };
    Path::new(problem, options).take(most).map_while(Result::ok).collect()
}

#[test]
fn the_inertia_with_a_spring_lies_between_that_of_held_displacement_and_held_force() {
    let options = NewtonOptions { tolerance: 1e-11, largest_update: 0.5, most_iterations: 10, exact_slope: true };
    let grips = [(Hold::Free, Hold::Free), (Hold::Fixed, Hold::Free), (Hold::Free, Hold::Fixed)];
    let (mut unstable, mut between) = (0, 0);
    for ((rotation, horizontal), form) in
        grips.into_iter().flat_map(|grip| [Form::TwoField, Form::ThreeField].map(|form| (grip, form)))
    {
        let model = with_grip(paper_strip(100.0, 1.0), rotation, horizontal);
        let rigid = model.problem(form, 7).unwrap();
        for point in path_of(&rigid, 16, 60).iter().skip(2) {
            let held = |problem: &Problem| {
                let condition =
                    PathConstraint { weights: Observables::DISPLACEMENT, target: problem.displacement(&point.at) };
                solve(problem, point.at.clone(), &condition, &options, &mut Workspace::default())
            };
            // next to a turning point Newton's method at held u goes elsewhere
            let Ok(here) = held(&rigid) else { continue };
            if here.correction > 1e-3 {
                continue;
            }
            let slope = here.slope.force;
            for k in [1e-9, 1e-3, 0.01, 0.03, 0.1, 1.0, 1e9] {
                let sprung = rigid.with_grip(EndConditions { compliance: 1.0 / k, ..rigid.grip });
                let Ok(found) = held(&sprung) else { continue };
                if found.correction > 1e-3 || (slope + k).abs() < 1e-4 * k {
                    continue;
                }
                let expected = here.negative + usize::from(slope + k < 0.0);
                assert_eq!(found.negative, expected, "k = {k}, dP/du = {slope}, {form:?}, {rotation:?} {horizontal:?}");
                unstable += expected;
                between += usize::from(here.negative != here.negative_load);
                match k {
                    1e-9 => assert_eq!(found.negative, here.negative_load),
                    1e9 => assert_eq!(found.negative, here.negative),
                    _ => {}
                }
            }
        }
    }
    assert!(unstable > 200 && between > 200, "{unstable} {between}: the paths have little to tell");
}

#[test]
fn a_hundred_nanometres_in_a_free_grip_snap_off_where_the_path_turns() {
    let model = paper_strip(100.0, 1.0);
    let test = test_of(&model);
    assert_balanced(&test);
    let path = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    let (snap_off, first) = (path.snap_off.unwrap(), test.jumps[0]);
    assert!((first.machine - snap_off.displacement).abs() <= first.machine_error + snap_off.displacement_error);
    assert!((first.before.force - snap_off.force).abs() <= first.before.force_error + snap_off.force_error);
    assert_eq!(first.before.displacement, first.machine);
    // the flat strip at rest has the energy -w L
    let rest = model.strip.width * model.line_law().rest_energy() * 100.0;
    assert_close("work", first.before.energy - rest, snap_off.work, 1e-8);
    assert_close("released", first.released, snap_off.work - (first.after.energy - rest), 1e-8);
    // it lands where the path comes by again behind its second turning point, the edge of the free end still holding
    assert!(!first.detached);
    // its curve is interpolated between points, which lie closer where more digits are asked for
    let fine = peel(&model, &Accuracy::to(1e-9), &BOUNDS);
    let after: Vec<_> = fine.dense_curve(40).into_iter().skip_while(|p| p.2 == 0).skip_while(|p| p.2 > 0).collect();
    let off = first.after.force - force_at(&after, first.machine);
    assert!(off.abs() <= 1e-8 * path.peak.unwrap().force, "P after is off by {off:.1e} nN");
    // upright it tilts without a jump as the machine comes back
    assert_eq!(test.jumps.len(), 6);
    // in the end it stands upright on the face of its end, and that comes off
    let last = test.jumps.iter().rfind(|jump| jump.way == LoadingDirection::Retreat).unwrap();
    assert!(last.detached && last.kind == JumpKind::SnapOff);
    let largest =
        test.points.iter().filter(|p| p.way == LoadingDirection::Retreat).map(|p| p.force).fold(0.0, f64::max);
    let pull_off = test.pull_off.unwrap();
    assert!(pull_off.force >= largest - pull_off.force_error && pull_off.force < 1.001 * largest, "{pull_off:?}");
}

/// P at u on a curve along which u rises, by a cubic through the four points around it.
fn force_at(curve: &[(f64, f64, usize)], u: f64) -> f64 {
    let i = curve.iter().position(|p| p.0 > u).unwrap();
    let around = &curve[i - 2..i + 2];
    let weight = |a: usize| -> f64 {
        (0..4).filter(|&b| b != a).map(|b| (u - around[b].0) / (around[a].0 - around[b].0)).product()
    };
    (0..4).map(|a| weight(a) * around[a].1).sum()
}

#[test]
fn on_a_soft_spring_it_jumps_where_the_force_falls_as_steeply_as_the_spring() {
    let model = guided(1.0);
    let path = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    let curve = path.dense_curve(40);
    for k in [0.02, 0.05, 0.1] {
        let test = test_of(&on_a_spring(model, k));
        assert_balanced(&test);
        let first: Jump = test.jumps[0];
        // the peak is stable and the same as without the spring
        let (peak, pull_off) = (path.peak.unwrap(), test.pull_off.unwrap());
        assert!((pull_off.force - peak.force).abs() <= pull_off.force_error + peak.force_error);
        assert_close("U", first.machine, first.before.displacement + first.before.force / k, 1e-9);
        assert!(first.before.displacement < path.snap_off.unwrap().displacement);
        // dP/du of the path without a spring by differences of its curve, from its peak on
        let from = curve.windows(2).position(|p| p[1].1 < p[0].1).unwrap();
        let slope = |u: f64| (force_at(&curve[..], u + 1e-3) - force_at(&curve[..], u - 1e-3)) / 2e-3;
        let steep = curve[from..].iter().find(|p| slope(p.0) < -k).unwrap().0;
        let expected = zero(|u| slope(u) + k, curve[from].0, steep);
        // differences of a curve between path points
        assert_close("u", first.before.displacement, expected, 2e-4);
        assert_close("P", first.before.force, force_at(&curve, expected), 1e-5);
    }
}

/// Relaxed from the first turning point of the displacement with steps of the size `largest_update`.
fn landed(problem: &Problem, largest_update: f64) -> (f64, Relaxed) {
    let mut work = Workspace::default();
    let points = path_of(problem, 90, 400);
    let found = (0..points.len() - 1).find_map(|index| {
        let segment = PathSegment::around(problem, &points, index);
        let found = brackets(problem, &points, index, &segment, LimitPointKind::Displacement, 1e-6, &mut work).unwrap();
        found.first().map(|&bracket| (segment, bracket))
    });
    let (segment, bracket) = found.unwrap();
    let limit = locate(problem, &segment, LimitPointKind::Displacement, bracket, None, &mut work).unwrap();
    let (start, displacement) = (disturbed(problem, &limit.solution), limit.observables.displacement);
    (
        displacement,
        relax(problem, start, Held::Displacement(displacement), &RelaxOptions::by(largest_update), &mut work).unwrap(),
    )
}

#[test]
fn soft_strips_come_to_rest_in_the_same_place_whatever_the_steps() {
    for (model, front) in [(paper_strip(100.0, 1e-2), 2.5), (paper_strip(100.0, 1e-4), 0.5), (guided(1.0), 0.5)] {
        let problem = model.problem(Form::TwoField, 7).unwrap();
        let (displacement, usual) = landed(&problem, 0.1);
        let (_, short) = landed(&problem, 0.02);
        assert!(short.steps > 2 * usual.steps, "{} {}", short.steps, usual.steps);
        for relaxed in [&usual, &short] {
            let o = relaxed.solution.observables;
            assert_eq!(relaxed.solution.negative, 0, "it comes to rest where it is stable");
            assert!((o.displacement - displacement).abs() <= 1e-10 * displacement);
            assert!(o.monitors[FRONT] > front, "something adheres: {} nm", o.monitors[FRONT]);
            // round-off of the energy, some 3 aJ
            let rise = relaxed.energies.windows(2).map(|e| e[1] - e[0]).fold(f64::NEG_INFINITY, f64::max);
            assert!(rise <= 1e-12, "the energy rises by {rise:.1e} aJ");
        }
        let (usual, short) = (usual.solution.observables, short.solution.observables);
        // their meshes differ
        assert_close("P", short.force, usual.force, 1e-4);
        assert_close("front", short.monitors[FRONT], usual.monitors[FRONT], 1e-4);
    }
}

#[test]
fn work_and_energy_balance_in_other_grips() {
    for model in [guided(1.0), with_grip(paper_strip(100.0, 1.0), Hold::Free, Hold::Fixed), guided(1e-2)] {
        let test = test_of(&model);
        assert_balanced(&test);
        // U goes up, then down, and stands still in a jump
        for pair in test.points.windows(2) {
            let ahead = pair[1].machine - pair[0].machine;
            let forward = if pair[1].way == LoadingDirection::Retreat { ahead } else { -ahead };
            assert!(if pair[1].jumped { ahead.abs() < 1e-8 * pair[0].machine } else { forward >= -1e-9 }, "{pair:?}");
        }
        assert_eq!(test.points.iter().filter(|p| p.jumped).count(), test.jumps.len());
    }
}

#[test]
fn a_load_without_a_potential_has_no_test() {
    let model = with_load(paper_strip(100.0, 1.0), LineLoad::ForceOnly);
    assert_eq!(observed(&model, &Accuracy::to(1e-6), &BOUNDS).err(), Some(NoTest::NoPotential));
}

#[test]
fn the_bounds_of_the_scene_end_a_test() {
    for (bounds, word) in [
        (StopCriteria { points: 20, ..BOUNDS }, "bounds.points = 20"),
        (StopCriteria { displacement: Some(30.0), ..BOUNDS }, "bounds.displacement = 30 nm"),
    ] {
        let test = observed(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &bounds).unwrap();
        let TestEnd::Bound(bound) = test.end else { panic!("{:?}", test.end) };
        assert_eq!(bound.to_string(), word);
        assert!(test.points.len() > 10 && test.jumps.is_empty() && test.cycle.is_none());
    }
}

/// Whenever a bound is reached, also before the first point of a piece or right behind a jump.
#[test]
fn a_bound_may_come_at_any_point() {
    let model = guided(1.0);
    let late = BOUNDS.or_when(|stage| (stage == Stage::Path).then_some(StopReason::Time { seconds: 1e-9 }));
    let out_of_time = observed(&model, &Accuracy::to(1e-4), &late).unwrap();
    assert_eq!(out_of_time.end, TestEnd::Bound(Bound::Time { seconds: 1e-9 }));
    for points in 1..60 {
        let test = observed(&model, &Accuracy::to(1e-4), &StopCriteria { points, ..BOUNDS }).unwrap();
        assert!(!matches!(test.end, TestEnd::Failed(_)), "bounds.points = {points}: {:?}", test.end);
        assert!(!test.points.is_empty());
    }
}

/// Whenever a caller stops it, also in the middle of a jump: what was found before is kept.
#[test]
fn a_test_may_be_stopped_anywhere() {
    let model = guided(1.0);
    let asked = Arc::new(AtomicUsize::new(0));
    let stopped_after = |most: usize| {
        asked.store(0, Ordering::Relaxed);
        let asked = asked.clone();
        let stop = BOUNDS.or_when(move |stage| {
            let late = stage == Stage::Path && asked.fetch_add(1, Ordering::Relaxed) >= most;
            late.then_some(StopReason::Interrupted)
        });
        observed(&model, &Accuracy::to(1e-4), &stop).unwrap()
    };
    let whole = stopped_after(usize::MAX);
    let all = asked.load(Ordering::Relaxed);
    let ends = (0..40).map(|part| stopped_after(part * all / 40));
    let found: Vec<_> = ends.map(|test| (test.end, test.points.len(), test.jumps.len())).collect();
    for (end, points, _) in &found {
        assert_eq!(*end, TestEnd::Bound(Bound::Interrupted));
        assert!((1..=whole.points.len()).contains(points));
    }
    // with a jump ahead of it most of the time goes into relaxing: no points come meanwhile
    let standing = found.windows(2).filter(|pair| pair[0].1 == pair[1].1).count();
    assert!(standing >= 5 && found.iter().any(|&(_, _, jumps)| jumps > 0), "{found:?}");
}
