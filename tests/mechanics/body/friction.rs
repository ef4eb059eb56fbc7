//! A strip that friction holds along the substrate.
//!
//!      ____________________
//!     |____________________|   u, P at the angle α; nothing else holds the strip along the substrate
//!     ->->->->->->->->->->      t on the face that looks down, at most τ(d)
//!     =====================
//!
//! References: finite differences of the force of friction; work of the grip by quadrature against energies and what is dissipated;
//! the balance of steady peeling, P (1 - cos α) + P²/(2EA) = w b + D', with what is dissipated per length, of which Kendall's law is
//! the case D' = 0; the friction of the whole face, τ0 b L, which is all that pulls back a strip dragged along the substrate.
//! Parameters: the paper's strip, L = 100 or 200 nm; τ0 = 50 MPa unless told otherwise.
//! Expected: what stands beside each assertion. Why: friction has a memory, so that an error anywhere on the way stays in every
//! later number. Collocation has its word in `peel verify --only friction`.

use crate::common::{paper_law, paper_strip};
use approx::assert_relative_eq;
use peelkit::adhesion::{FrictionLaw, GroundLaw, LineLoad, Substrate};
use peelkit::beam::{BeamOnGround, EnergyDensity, Point, PointResponse, Profile};
use peelkit::model::{Adhesion, BeamProblem, Form, Friction, Hold, PeelModel, Pull, Step};
use peelkit::solve::{Observables, Pace, Path, PathOptions, Solution, controlled};
use peelkit::study::{Accuracy, Choice, PathEnd, StopCriteria, peel};
use std::sync::Arc;

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

fn rubbing(length: f64, degrees: f64, strength: f64) -> PeelModel {
    PeelModel {
        pull: Pull { angle: degrees.to_radians(), ..Pull::UP },
        friction: Friction { strength: Some(strength), ..Friction::NONE },
        ..paper_strip(length, 1.0).into()
    }
}

/// The tangent of the beam with friction is the derivative of its force, at places where the face sticks, slides and turns back.
#[test]
fn the_tangent_is_the_derivative() {
    let law = paper_law(LineLoad::Full, true);
    let friction = FrictionLaw::new(law.half_space, 0.05, 0.3, None);
    let section = paper_strip(100.0, 1.0).section();
    let beam = BeamOnGround {
        profile: Profile::uniform(section, 1.0, 10.0),
        ground: GroundLaw { law, substrate: Substrate::Flat },
        friction: Some(friction),
    };
    let respond = |value: [f64; 3], slip: [f64; 2]| {
        let mut response = PointResponse::<f64, 3>::zero();
        let mut point = Point { place: 40.0, value, ..Point::zero() };
        point.memory[..2].copy_from_slice(&slip[..2]);
        beam.add_remembered(&point, &mut response);
        response
    };
    for (value, slip) in [
        ([0.001, 0.253, 0.0], [40.0, 0.0]),
        ([0.1, 0.26, 0.01], [40.0, 0.2]),
        ([-0.01, 0.27, -0.02], [40.0, 0.9]),
        ([1.0, 0.31, 0.3], [40.2, -0.5]),
    ] {
        let at = respond(value, slip);
        for g in 0..3 {
            let d = 1e-6;
            let moved = |sign: f64| {
                let mut value = value;
                value[g] += sign * d;
                respond(value, slip).by_value
            };
            let (ahead, behind) = (moved(1.0), moved(-1.0));
            for f in 0..3 {
                let slope = (ahead[f] - behind[f]) / (2.0 * d);
                assert_relative_eq!(at.value_value[f][g], slope, epsilon = 1e-7, max_relative = 1e-5);
            }
        }
    }
}

/// Points of a path up to a displacement, with steps of `stride` times their length.
fn walk(model: &PeelModel, stride: f64, far: f64) -> (BeamProblem, Vec<Arc<Solution>>) {
    let problem = model.problem(Form::ThreeField, 7).unwrap();
    let options = PathOptions {
        elements: 60,
        step_tolerance: 1e-2,
        stride,
        longest: None,
        prediction: 8,
        tolerance: 1e-9,
        first_displacement: 0.008,
        pace: Pace::Quick,
    };
    let mut path = Path::new(&problem, options);
    while path.points().last().is_none_or(|point| point.observables.displacement < far) {
        path.advance().unwrap();
    }
    let points = path.points().to_vec();
    (problem, points)
}

/// What the grip has done and what of it is neither stored nor dissipated, aJ, at the end of a walk.
fn balance(model: &PeelModel, stride: f64) -> (f64, f64, usize) {
    let (problem, points) = walk(model, stride, 2.0);
    // the trapezoidal rule with its correction by slopes
    let work: f64 = points
        .windows(2)
        .map(|pair| {
            let (a, b) = (&pair[0], &pair[1]);
            let way = b.observables.displacement - a.observables.displacement;
            let bend = |s: &Solution| s.slope.force / s.slope.displacement;
            0.5 * way * (a.observables.force + b.observables.force) + way * way / 12.0 * (bend(a) - bend(b))
        })
        .sum();
    let energy = |s: &Solution| problem.energy(&s.at, s.energy);
    let last = &points[points.len() - 1];
    let dissipated = problem.system.commit(&last.at).unwrap().dissipated;
    (work, work - (energy(last) - energy(&points[0])) - dissipated, points.len())
}

/// What of the work is missing falls with the length of the steps.
#[test]
fn work_is_stored_or_dissipated() {
    for degrees in [20.0, 60.0, 120.0] {
        let model = rubbing(100.0, degrees, 0.05);
        let found = [1.0, 0.5, 0.25].map(|stride| balance(&model, stride));
        println!("{degrees} degrees: work, missing (aJ), points: {found:?}");
        let [first, _, last] = found.map(|(work, missing, _)| (missing / work).abs());
        assert!(last < 3e-4 && last < 0.3 * first, "{degrees} degrees: {found:?}");
    }
}

/// P (1 - cos α) + P²/(2EA) - w b is what friction takes per length. It never vanishes: where the front opens the face goes by (h/2) θ.
#[test]
fn steady_peeling_balances() {
    let strength = 0.05;
    let model = rubbing(300.0, 30.0, strength);
    // what is dissipated is known to first order in the steps
    let accuracy = Accuracy::to(1e-4).with(Choice { step: Some(1e-4), ..Accuracy::to(1e-4).choice });
    let peel = peel(&model, &accuracy, &StopCriteria { displacement: Some(44.0), ..BOUNDS });
    let at = |front: f64| {
        let index = peel.nearest_front(front).unwrap();
        (peel.points[index].front, peel.sliding_at(index).unwrap().dissipated, peel.points[index].force)
    };
    let ((ahead, some, _), (behind, more, force)) = (at(110.0), at(90.0));
    let taken = (more - some) / (ahead - behind);
    let (section, work) = (model.section(), -model.line_law().rest_energy());
    let over = force * (1.0 - 30f64.to_radians().cos()) + force * force / (2.0 * section.axial) - work;
    println!("{strength} GPa: P = {force} nN, over Kendall's {over:.6}, dissipated {taken:.6} nN, {:?}", peel.effort);
    assert_relative_eq!(over, taken, max_relative = 0.02);
    assert!(over > 0.2 * work, "{over}");
}

/// Dragged along the substrate a strip slides as a whole at τ0 b L but for its ends. There, back and there again, short of that, the
/// loop closes on itself, the way back the mirror image of the way there (Masing) but for what the force's lever of h/2 does to the gap.
#[test]
fn a_dragged_strip_slides_at_its_strength_and_loops_close() {
    let model = rubbing(100.0, 0.0, 0.05);
    let peel = peel(&model, &Accuracy::to(1e-5), &BOUNDS);
    assert_eq!(peel.end, PathEnd::Sliding);
    let force = peel.largest_computed_force.unwrap().force;
    assert_eq!(peel.peak, None, "no end of a path is a peak");
    assert!((force / (0.05 * 100.0) - 1.0).abs() < 0.01, "{force}");
    let problem = model.problem(Form::ThreeField, 7).unwrap();
    let way = |from: f64, to: f64| (1..=60).map(move |k| from + (to - from) * k as f64 / 60.0);
    let targets: Vec<f64> = way(0.0, 4.0).chain(way(4.0, -4.0)).chain(way(-4.0, 4.0)).collect();
    let found = controlled(&problem, problem.initial(80), Observables::DISPLACEMENT, &targets, 1e-9).unwrap();
    let at = |k: usize| found[k].observables.force;
    println!("slides at {force}; there {}, back {}, again {}", at(59), at(119), at(179));
    assert!(at(59) > 0.5 * force, "{}", at(59));
    assert_relative_eq!(at(119), -at(59), max_relative = 0.1);
    assert_relative_eq!(at(179), at(59), max_relative = 2e-3);
}

/// Vertical peeling hardly feels it, pulls at small angles do: the force with friction over that without.
#[test]
fn small_angles_gain() {
    let force = |model: &PeelModel| {
        peel(model, &Accuracy::to(1e-4), &StopCriteria { displacement: Some(8.0), ..BOUNDS })
            .initiation_peak
            .unwrap()
            .force
    };
    let gain = |degrees: f64| {
        let held = rubbing(100.0, degrees, 0.05);
        let free = PeelModel { friction: Friction::NONE, ..held.clone() };
        force(&held) / force(&free)
    };
    let gains = [90.0, 45.0, 20.0].map(gain);
    println!("gain at 90, 45 and 20 degrees: {gains:?}");
    assert!(gains[0] < 1.15 && gains[2] > gains[1] && gains[1] > gains[0], "{gains:?}");
}

/// What the grip did before the pull stays in the strip: dragged along the substrate before it is pulled straight up it holds more, and
/// pushed back again less. Without friction steps there and back change nothing.
#[test]
fn steps_before_the_pull_are_remembered() {
    let force = |strength: Option<f64>, steps: Vec<Step>| {
        let mut model = PeelModel { steps, ..rubbing(100.0, 90.0, 0.05) };
        model.grip.horizontal = Hold::Fixed;
        model.friction.strength = strength;
        let peel = peel(&model, &Accuracy::to(1e-4), &StopCriteria { displacement: Some(3.0), ..BOUNDS });
        peel.initiation_peak.unwrap().force
    };
    let there_and_back = || vec![Step::Drag(0.5), Step::Push(0.5)];
    let [plain, dragged, back] =
        [vec![], vec![Step::Drag(0.5)], there_and_back()].map(|steps| force(Some(0.05), steps));
    println!("first peak {plain}, dragged before {dragged}, dragged and pushed back {back}");
    assert!(dragged > 1.2 * plain && (back / plain - 1.0).abs() > 1e-2, "{plain} {dragged} {back}");
    let [free, moved] = [vec![], there_and_back()].map(|steps| force(None, steps));
    assert_relative_eq!(free, moved, max_relative = 1e-4);
}

/// A strip of half a micrometre whose force is level for a hundred nanometres: what the steps make of that level is no limit point. Its peak is the one
/// that is found on the path up to there, with any steps; before, all of it was lost because two choices of steps had other ripple.
#[test]
fn a_level_force_has_no_limit_points_and_the_peak_is_kept() {
    let model = PeelModel {
        pull: Pull { angle: 45f64.to_radians(), ..Pull::UP },
        friction: Friction { strength: Some(0.02), coefficient: 0.3, ..Friction::NONE },
        ..paper_strip(500.0, 1.0).into()
    };
    let found = peel(&model, &Accuracy::to(1e-4), &BOUNDS);
    assert_eq!(found.end, PathEnd::Snapped);
    let (peak, jump) = (found.peak.unwrap(), found.snap_off.unwrap());
    // with 1e-6 and a path that is stopped behind the peak: 0.5865717604 ± 1e-9 at u = 0.37973227 ± 1e-8
    assert!((peak.force - 0.586_571_760_4).abs() <= peak.force_error && peak.force_error < 1e-6, "{peak:?}");
    assert!((peak.displacement - 0.379_732_27).abs() <= peak.displacement_error, "{peak:?}");
    // with 1e-6: 141.5578 ± 1e-4
    assert!((jump.displacement - 141.5578).abs() <= jump.displacement_error + 1e-4, "{jump:?}");
    assert_eq!(found.limit_points.len(), 2, "{:?}", found.limit_points);
}

/// Behind the peak of a short strip most of what slid turns back at once, and Newton's method overshoots from one side of the corner of the law to the
/// other with any step: with a part of its updates it goes on. How many limit points lie on the way depends on the steps, and what all steps have in common is kept.
#[test]
fn a_strip_whose_face_turns_back_at_once_is_followed_on() {
    let mut strip = paper_strip(52.955, 1.0);
    (strip.strip.height, strip.strip.material.youngs_modulus) = (4.679, 2.464);
    strip.adhesion = Adhesion::of_half_space(0.2463, 0.395);
    let model = PeelModel {
        pull: Pull { angle: 23.4f64.to_radians(), ..Pull::UP },
        friction: Friction { strength: Some(0.0462), ..Friction::NONE },
        ..strip.into()
    };
    let found = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    // where it was lost before
    assert!(found.points.last().unwrap().displacement > 1.01 * 1.795_633, "{:?}", found.end);
    // located before that place, on another mesh: 1.3921138647 ± 3e-10
    let peak = found.initiation_peak.unwrap();
    assert!((peak.force - 1.392_113_864_7).abs() <= peak.force_error + 3e-10 && peak.force_error < 1e-8, "{peak:?}");
}
