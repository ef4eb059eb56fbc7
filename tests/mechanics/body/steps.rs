//! What the grip does before the pull, and a grip that turns as it goes.
//!
//!      step by step:  press, lift | drag, push | turn        then the pull, u and P from there
//!      ____________                  _________
//!     |____________|<- grip         |_________|\ θ(L) = θ_rest + turn · u
//!     ==============                ==============
//!
//! References: the pull from rest, of which a pull behind steps is a part on flat ground without friction, whichever steps led there;
//! EA times the strain of a strip that is dragged; the form with three unknowns a node; differences of equilibria; the integral of force
//! and moment against energies.
//! Parameters: the paper's strip, L = 100 nm, and the default spatula; `relative` = 1e-6.
//! Expected: the same within both error bounds, or to what stands beside an assertion. Why: a step moves the origin of what comes
//! behind it, and each of u, w, θ, x and the horizontal force can keep the old one; the moment works as the grip turns, and P is not
//! what the energy's slope is. Collocation has its word in `peel verify --only pull`. Recorded: path points and Newton iterations.

use crate::common::{paper_strip, with_grip};
use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::beam::{GripForces, Material};
use peelkit::model::{Adhesion, BeamProblem, Body, Form, Grip, Hold, PeelModel, Pull, Spatula, Step, Strip};
use peelkit::solve::{
    Observables, Pace, Path, PathConstraint, PathOptions, Problem, State, Workspace, controlled, slopes,
};
use peelkit::study::{Accuracy, Choice, Effort, PathEnd, Peel, StopCriteria, peel};
use std::f64::consts::{FRAC_PI_3, FRAC_PI_4};

pub(super) const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

/// The strip in this grip, behind these steps.
pub(super) fn strip(rotation: Hold, horizontal: Hold, steps: &[Step]) -> PeelModel {
    let model = with_grip(paper_strip(100.0, 1.0), rotation, horizontal);
    PeelModel { steps: steps.to_vec(), ..model.into() }
}

pub(super) fn peeled(model: &PeelModel) -> Peel {
    let peel = peel(model, &Accuracy::to(1e-6), &BOUNDS);
    assert!(!matches!(peel.end, PathEnd::Failed(_)), "{:?}: {:?}", model.steps, peel.end);
    record(&format!("{:?}", model.steps), &peel.effort);
    peel
}

fn record(what: &str, effort: &Effort) {
    println!("{what}: {} points, {} Newton iterations", effort.points, effort.newton_iterations);
}

pub(super) fn failure(model: &PeelModel) -> String {
    match peel(model, &Accuracy::to(1e-6), &BOUNDS).end {
        PathEnd::Failed(why) => why.to_string(),
        end => panic!("{end:?}"),
    }
}

#[track_caller]
pub(super) fn assert_near(what: &str, a: f64, b: f64, bound: f64) {
    assert!((a - b).abs() <= bound, "{what}: {a} and {b}, apart by {:.1e}, bound {bound:.1e}", a - b);
}

/// The second is the first, seen from `ahead` nm on: snap-off, and peak where that lies before it, within both bounds.
#[track_caller]
fn assert_shifted(whole: &Peel, part: &Peel, ahead: f64) {
    let (a, b) = (whole.snap_off.unwrap(), part.snap_off.unwrap());
    assert_near("snap-off", a.displacement - ahead, b.displacement, a.displacement_error + b.displacement_error);
    assert_near("its force", a.force, b.force, a.force_error + b.force_error);
    let a = whole.initiation_peak.unwrap();
    if a.displacement > ahead {
        let b = part.initiation_peak.unwrap();
        assert_near("peak", a.displacement - ahead, b.displacement, a.displacement_error + b.displacement_error);
        assert_near("its force", a.force, b.force, a.force_error + b.force_error);
    }
}

#[test]
fn a_pull_behind_a_press_or_a_lift_is_a_part_of_that_from_rest() {
    for (rotation, horizontal) in [(Hold::Free, Hold::Free), (Hold::Fixed, Hold::Fixed)] {
        let whole = peeled(&strip(rotation, horizontal, &[]));
        for (step, ahead) in [(Step::Press(0.05), -0.05), (Step::Lift(0.1), 0.1), (Step::Lift(3.0), 3.0)] {
            let part = peeled(&strip(rotation, horizontal, &[step, Step::Hold]));
            assert_shifted(&whole, &part, ahead);
            let (behind, held) = (part.steps[0], part.steps[1]);
            assert_eq!(behind, held, "nothing moves in a hold");
            assert_near("y", behind.y, ahead, 1e-15);
            assert_eq!(behind.x, (horizontal == Hold::Fixed).then_some(0.0));
            let first = part.points[0];
            assert_eq!((first.displacement, first.work), (0.0, 0.0));
            assert_near("force behind the step", behind.forces.vertical, first.force, 1e-5 * first.force.abs());
        }
    }
}

/// Work up to the snap-off, from rest and from half-way: the difference is the work of the step, by dense points of the first path.
#[test]
fn work_counts_from_where_the_pull_begins() {
    let whole = peeled(&strip(Hold::Free, Hold::Free, &[]));
    let part = peeled(&strip(Hold::Free, Hold::Free, &[Step::Lift(3.0)]));
    let curve = whole.dense_curve(64);
    let until = curve.iter().take_while(|point| point.0 < 3.0).count();
    let spent: f64 = curve[..until + 1].windows(2).map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0.min(3.0) - w[0].0)).sum();
    let works = [&whole, &part].map(|peel| peel.snap_off.unwrap().work);
    assert_near("work", works[0] - works[1], spent, 2e-4 * spent);
}

#[test]
fn a_way_round_leads_to_the_same() {
    for horizontal in [Hold::Free, Hold::Fixed] {
        let turn = |degrees: f64| Step::Turn(degrees.to_radians());
        let direct = peeled(&strip(Hold::Fixed, horizontal, &[turn(6.0)]));
        let round = [turn(2.0), Step::Lift(0.1), Step::Drag(0.1), turn(4.0), Step::Press(0.1), Step::Push(0.1)];
        let round = peeled(&strip(Hold::Fixed, horizontal, &round));
        assert_shifted(&direct, &round, 0.0);
        let (a, b) = (direct.points[0], round.points[0]);
        assert_near("force where the pull begins", a.force, b.force, 1e-5 * a.force.abs());
        let (a, b) = (direct.steps[0], *round.steps.last().unwrap());
        assert_near("θ", a.rotation, 6f64.to_radians(), 1e-15);
        assert_near("θ", b.rotation, a.rotation, 1e-15);
        assert_near("y", b.y, 0.0, 1e-15);
        // a grip that is free along the substrate has not let go yet of the place of its last step
        if horizontal == Hold::Fixed {
            assert_near("V", a.forces.vertical, b.forces.vertical, 1e-9);
            assert_near("M", a.forces.moment, b.forces.moment, 1e-9);
        }
    }
}

/// Pressed or lifted and let go of, a strip is where it lay.
#[test]
fn a_release_finds_the_height_without_a_force() {
    let whole = peeled(&strip(Hold::Free, Hold::Free, &[]));
    for step in [Step::Press(0.05), Step::Lift(0.1)] {
        let part = peeled(&strip(Hold::Free, Hold::Free, &[step, Step::Release]));
        assert_near("y", part.steps[1].y, 0.0, 1e-10);
        assert_near("V", part.steps[1].forces.vertical, 0.0, 1e-10);
        assert_shifted(&whole, &part, 0.0);
    }
    let again = peeled(&strip(Hold::Free, Hold::Free, &[Step::Release]));
    assert_eq!(again.steps[0].y, 0.0);
}

/// H = EA d/L; let go, a grip that is free along the substrate springs back, and nothing is left of the drag.
#[test]
fn a_strip_that_lies_flat_is_dragged_by_its_stiffness() {
    let whole = peeled(&strip(Hold::Free, Hold::Free, &[]));
    for (step, force) in [(Step::Drag(1.0), 0.2), (Step::Push(3.0), -0.6)] {
        let part = peeled(&strip(Hold::Free, Hold::Free, &[step]));
        assert_near("H", part.steps[0].forces.horizontal, force, 1e-10);
        assert_shifted(&whole, &part, 0.0);
        let held = peeled(&strip(Hold::Free, Hold::Fixed, &[step]));
        assert_near("H", held.steps[0].forces.horizontal, force, 1e-10);
        // laid down under that tension it is the same strip: pull.rs
        let mut stretched = with_grip(paper_strip(100.0, 1.0), Hold::Free, Hold::Fixed);
        stretched.grip.pretension = (force > 0.0).then_some(force);
        if force > 0.0 {
            assert_shifted(&peeled(&stretched.into()), &held, 0.0);
        }
    }
}

/// Steps, angle, turn and a held place all at once, in the form with a multiplier and in that with x; the spatula as well.
#[test]
fn both_forms_agree() {
    let turn = Step::Turn(-0.05);
    let mut model = strip(Hold::Fixed, Hold::Fixed, &[Step::Lift(0.05), Step::Drag(0.1), turn]);
    model.pull = Pull { angle: FRAC_PI_3, turn: 0.01 };
    let free = PeelModel { steps: vec![Step::Lift(0.05)], ..strip(Hold::Free, Hold::Free, &[]) };
    let free = PeelModel { pull: Pull { angle: 2.0 * FRAC_PI_3, turn: 0.0 }, ..free };
    let spatula = PeelModel { body: Body::Spatula(Spatula::default()), ..model.clone() };
    for (model, bounds) in
        [(model, BOUNDS), (free, BOUNDS), (spatula, StopCriteria { displacement: Some(20.0), ..BOUNDS })]
    {
        let [two, three] = [Form::TwoField, Form::ThreeField].map(|form| {
            let peel = peel(&model, &Accuracy::to(1e-6).with(Choice { form, ..Accuracy::to(1e-6).choice }), &bounds);
            assert!(!matches!(peel.end, PathEnd::Failed(_)), "{:?}", peel.end);
            record(&format!("{form:?}"), &peel.effort);
            peel
        });
        for (a, b) in two.steps.iter().zip(&three.steps) {
            assert_near("x", a.x.unwrap(), b.x.unwrap(), 1e-8);
            assert_near("H", a.forces.horizontal, b.forces.horizontal, 1e-7);
            assert_near("V", a.forces.vertical, b.forces.vertical, 1e-7);
            assert_near("M", a.forces.moment, b.forces.moment, 1e-6);
        }
        let (a, b) = (two.points[0], three.points[0]);
        assert_near("force where the pull begins", a.force, b.force, 1e-6 * a.force.abs().max(0.1));
        match (two.snap_off, three.snap_off) {
            (Some(_), Some(_)) => assert_shifted(&two, &three, 0.0),
            (None, None) => {}
            other => panic!("{other:?}"),
        }
    }
}

fn turning() -> Vec<PeelModel> {
    let grip = |horizontal, angle, turn: f64| PeelModel {
        pull: Pull { angle, turn: turn.to_radians() },
        ..strip(Hold::Fixed, horizontal, &[])
    };
    vec![grip(Hold::Free, FRAC_PI_3, 0.5), grip(Hold::Fixed, 1.2, -0.5), grip(Hold::Free, Pull::UP.angle, 1.0)]
}

fn moment(peel: &Peel, index: usize) -> f64 {
    peel.sections(index).last().unwrap().section.moment
}

/// Trapezium rule over close points: P alone misses it.
#[test]
fn work_of_a_turning_grip_is_that_of_force_and_moment() {
    for model in turning() {
        let choice = Choice { step: Some(1e-5), ..Accuracy::to(1e-6).choice };
        let peel = peel(&model, &Accuracy::to(1e-6).with(choice), &BOUNDS);
        record("short steps", &peel.effort);
        let last = peel.snap_off.unwrap().after;
        let (mut of_force, mut of_moment) = (0.0, 0.0);
        for i in 0..last {
            let (a, b) = (peel.points[i], peel.points[i + 1]);
            of_force += 0.5 * (a.force + b.force) * (b.displacement - a.displacement);
            of_moment += 0.5 * (moment(&peel, i) + moment(&peel, i + 1)) * (b.end_rotation - a.end_rotation);
            assert_near("θ", b.end_rotation, model.pull.turn * b.displacement, 1e-12);
        }
        let work = peel.points[last].work;
        assert_near("work", of_force + of_moment, work, 5e-4 * work);
        assert!(of_moment.abs() > 1e-2 * work, "the moment matters: {of_moment} of {work} aJ");
    }
}

fn points(problem: &Problem, until: f64) -> Vec<std::sync::Arc<peelkit::solve::Solution>> {
    let options = PathOptions {
        elements: 24,
        step_tolerance: 1e-2,
        stride: 1.0,
        longest: None,
        prediction: 8,
        tolerance: 1e-11,
        first_displacement: 0.008,
        pace: Pace::Quick,
    };
    let path = Path::new(problem, options).map(Result::unwrap);
    path.take_while(|point| point.observables.displacement < until && point.slope.displacement > 0.0).collect()
}

/// dΠ/du: the force along the pull, and of a grip that turns as it goes the work of the moment besides.
fn slope_of_energy(problem: &BeamProblem, at: &State) -> f64 {
    at.force + problem.grip.gear * problem.beam.grip_forces(at).moment
}

/// The tangent of the path, and the number of negative eigenvalues with the force held, against differences of equilibria on one mesh:
/// the one is the slope of P, the other falls where P + turn M does.
#[test]
fn slope_and_stability_of_a_turning_grip_are_those_of_its_equilibria() {
    for model in turning() {
        let problem = model.problem(Form::TwoField, 7).unwrap();
        let mut seen = [false; 2];
        for point in points(&problem, 15.0).iter().skip(3).step_by(3) {
            let u = point.observables.displacement;
            let way = 1e-4 * u;
            let targets = [u - way, u + way];
            let at = controlled(&problem, point.at.clone(), Observables::DISPLACEMENT, &targets, 1e-12).unwrap();
            let slope = |of: &dyn Fn(usize) -> f64| (of(1) - of(0)) / (2.0 * way);
            let force = slope(&|i| at[i].observables.force);
            let condition = PathConstraint { weights: Observables::DISPLACEMENT, target: u };
            let (_, found) = slopes(&problem, &point.at, &condition, &mut Workspace::default()).unwrap();
            assert_near("dP/du", found, force, 1e-5 * force.abs() + 1e-6);
            let power = slope(&|i| slope_of_energy(&problem, &at[i].at));
            let energy = slope(&|i| problem.energy(&at[i].at, at[i].energy));
            assert_near("dΠ/du", energy, slope_of_energy(&problem, &point.at), 1e-6);
            if power.abs() > 1e-4 {
                assert_eq!((point.negative, point.negative_load), (0, usize::from(power < 0.0)), "u = {u} nm");
                seen[usize::from(power < 0.0)] = true;
            }
        }
        assert_eq!(seen, [true; 2]);
    }
}

/// A grip that rises by 0.1 pm a radian peels by its rotation alone: up to where it snaps off it is in the state to which a step
/// turns it at its place, and beyond that it collapses.
#[test]
fn rotation_alone_peels() {
    let fast = strip(Hold::Fixed, Hold::Free, &[]);
    let fast = peeled(&PeelModel { pull: Pull { turn: 1e4, ..Pull::UP }, ..fast });
    assert_eq!(fast.peak, None, "it pushes all the way");
    let snap_off = fast.snap_off.unwrap();
    for angle in [1.0, 2.0, 2.654] {
        let turned = peeled(&strip(Hold::Fixed, Hold::Free, &[Step::Turn(angle)]));
        let forces = turned.steps[0].forces;
        let curve = fast.dense_curve(20);
        let behind = curve.iter().position(|at| at.0 * 1e4 >= angle).unwrap();
        let ((u0, p0, _), (u1, p1, _)) = (curve[behind - 1], curve[behind]);
        let force = p0 + (p1 - p0) * (angle * 1e-4 - u0) / (u1 - u0);
        assert_near("force", forces.vertical, force, 2e-3 * force.abs());
    }
    assert_near("snap-off", snap_off.end_rotation, 2.655, 1e-4);
    let beyond = failure(&strip(Hold::Fixed, Hold::Free, &[Step::Turn(2.66)]));
    assert!(beyond.contains("the beam jumps, at 2.65500"), "{beyond}");
}

#[test]
fn a_step_that_cannot_be_taken_says_how_far_it_came() {
    let why = failure(&strip(Hold::Free, Hold::Free, &[Step::Lift(1.0), Step::Press(2.0)]));
    assert!(why.contains("step 2 of drive.steps, \"press 2 nm\", comes to where the beam jumps, at"), "{why}");
    let place: f64 = why.split("jumps, at ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert_near("where it turns", place, -1.693177, 1e-5);
    assert!(why.contains("V = -4.309") && why.contains("Try a shorter step"), "{why}");
    let why = failure(&strip(Hold::Fixed, Hold::Free, &[Step::Press(1.0)]));
    assert!(why.contains("step 1 of drive.steps, \"press 1 nm\", leads through the surface"), "{why}");
    let peel = peel(&strip(Hold::Fixed, Hold::Free, &[Step::Hold, Step::Press(1.0)]), &Accuracy::to(1e-6), &BOUNDS);
    assert_eq!((peel.steps.len(), peel.points.len()), (1, 0));
}

/// scenes/loop.toml: half of a loop tack test. Of what adheres flat, far from the front, and of the section in the grip the first integral
/// H x' + V y' + M θ' - stored - Ψ is one number: H + H²/2EA + w b at the one, the forces of the grip at the other.
#[test]
fn a_tape_that_is_bent_to_a_loop_has_its_first_integral() {
    first_integral_of_loop(2.0);
}

/// Of a softer one the end of a step is found from its last equilibrium in shorter steps alone.
#[test]
fn a_loop_of_soft_tape_comes_down() {
    first_integral_of_loop(1.357);
}

fn first_integral_of_loop(youngs_modulus: f64) {
    let (height, width, work) = (5e4, 2.5e7, 20.0);
    let material = Material::of(youngs_modulus, 0.35);
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        work: Some(work),
        strength: Some(1e-4),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap();
    let strip = Strip { length: 3e7, height, width, material, crack: None, layers: None };
    let grip = Grip { rotation: Hold::Fixed, horizontal: Hold::Fixed, ..Grip::FREE };
    let (mm, quarter) = (1e6, FRAC_PI_4);
    let steps = [
        Step::Lift(3.0 * mm),
        Step::Turn(quarter),
        Step::Push(5.0 * mm),
        Step::Lift(5.0 * mm),
        Step::Turn(quarter),
        Step::Push(5.0 * mm),
        Step::Lift(4.0 * mm),
        Step::Push(5.0 * mm),
        Step::Lift(4.0 * mm),
        Step::Push(5.0 * mm),
        Step::Lift(4.0 * mm),
        Step::Press(6.0 * mm),
    ];
    let model = PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, grip);
    let looped = peeled(&PeelModel { steps: steps.to_vec(), ..model });
    let axial = youngs_modulus * width * height;
    let bending = youngs_modulus * width * height.powi(3) / 12.0;
    let shearing = material.shear_correction * axial / (2.0 * (1.0 + 0.35));
    for (step, at) in steps.iter().zip(&looped.steps) {
        let (GripForces { horizontal, vertical, moment, .. }, (sin, cos)) = (at.forces, at.rotation.sin_cos());
        let (normal, shear) = (horizontal * cos + vertical * sin, vertical * cos - horizontal * sin);
        let (stretch, slide) = (1.0 + normal / axial, shear / shearing);
        let along = horizontal * (stretch * cos - slide * sin) + vertical * (stretch * sin + slide * cos);
        let stored = normal * normal / axial + shear * shear / shearing - moment * moment / bending;
        let adhering = horizontal + horizontal * horizontal / (2.0 * axial) + work * width;
        assert_near(&format!("{step:?}"), along - 0.5 * stored, adhering, 1e-8 * adhering);
    }
}
