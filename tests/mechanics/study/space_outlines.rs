//! Bodies whose width, height and direction vary along S, in space.
//!
//! ```text
//!              ____/ grip        y   P along (cos α cos β, sin α, cos α sin β)
//!      pad    / neck             |
//!      ======'                   |_____ x   (z towards the reader)
//! ```
//!
//! Reference: the planar beam; verification/space_peels.csv, collocation of the strong form. A wedge b 40 → 20 nm, h 6 → 12 nm, L = 100 nm; a narrow spatula, 15 nm wide, whose planar path is stable in
//! space; the paper's spatula, whose planar path is not: its planar states are put into the beam in space and solved there.
//! E = 2 GPa, ν = 0.2, A_H = 1e-19 J, r0 = 0.4 nm.
//!
//! Expected: peaks and folds of the planar path to 1e-9 (places of maxima, where the force is flat, to 1e-8); the
//! states of the spatula stay as they were; a pull to the other side peels as the mirror image.
//! Why: one structure in two texts, and two halves of one space.

use approx::assert_relative_eq;
use peelkit::adhesion::SectionShape;
use peelkit::beam::{ALONG_X, turned};
use peelkit::model::{
    BeamProblem, Body, Form, Hold, PeelModel, Piece, Profile, ProfileForm, ProfilePieces, Pull, Space, Spatula,
    Transition,
};
use peelkit::solve::{
    LimitPointKind, NewtonOptions, Observables, Path, PathConstraint, PathEvent, PathOptions, PathTracer, State,
    TraceOptions, Workspace, solve,
};
use peelkit::study::{Accuracy, PathEnd, PathPoint, StopCriteria, peel};
use std::f64::consts::FRAC_PI_2;

const ORDER: usize = 7;

fn pulled(mut model: PeelModel, elevation: f64, rotation: Hold) -> PeelModel {
    model.pull = Pull { angle: elevation.to_radians(), turn: 0.0 };
    model.grip.rotation = rotation;
    model
}

fn wedge(elevation: f64) -> PeelModel {
    let piece = Piece {
        width: [40.0, 20.0],
        height: [6.0, 12.0],
        height_course: Transition::Linear,
        ..Piece::straight(100.0, 40.0, 6.0)
    };
    let form = ProfileForm::Pieces(ProfilePieces::new(vec![piece]).unwrap());
    let body = Body::Profile(Profile { form, material: Spatula::default().material });
    pulled(PeelModel { body, ..Spatula::default().model() }, elevation, Hold::Free)
}

fn narrow(elevation: f64, rotation: Hold) -> PeelModel {
    let spatula = Spatula { tip_width: 15.0, neck_width: 7.5, shaft_diameter: 22.5, ..Spatula::default() };
    pulled(spatula.model(), elevation, rotation)
}

/// Solved with the beam in space, in a grip that holds roll and yaw.
fn in_space(model: &PeelModel) -> BeamProblem {
    let space = Space { roll: Hold::Fixed, yaw: Hold::Fixed, ..Space::default() };
    let model = PeelModel { space: Some(space), ..model.clone() };
    model.check().unwrap();
    model.problem(Form::ThreeField, ORDER).unwrap()
}

fn in_the_plane(model: &PeelModel) -> BeamProblem {
    model.problem(Form::ThreeField, ORDER).unwrap()
}

/// The first two limit points.
fn limits(problem: &BeamProblem, elements: usize) -> Vec<(LimitPointKind, Observables)> {
    let options = PathOptions {
        elements,
        tolerance: 1e-11,
        step_tolerance: 4e-3,
        first_displacement: 0.04,
        ..PathOptions::default()
    };
    let traced = TraceOptions { relative: 1e-8, ..TraceOptions::default() };
    let mut tracer = PathTracer::new(problem, Path::new(problem, options), traced);
    let mut found = Vec::new();
    while found.len() < 2 {
        if let PathEvent::LimitPoint { kind, located, .. } = tracer.advance().unwrap() {
            found.push((kind, located.observables));
        }
    }
    found
}

#[test]
fn a_pull_in_the_plane_has_the_limit_points_of_the_plane() {
    let cases = [(wedge(90.0), 48), (wedge(60.0), 48), (narrow(90.0, Hold::Fixed), 80), (narrow(60.0, Hold::Free), 80)];
    for (model, elements) in cases {
        let (plane, space) = (limits(&in_the_plane(&model), elements), limits(&in_space(&model), elements));
        for ((kind, planar), (same, spatial)) in plane.iter().zip(&space) {
            assert_eq!(kind, same);
            let force = (spatial.force / planar.force - 1.0).abs();
            // where the force is flat u is known to the root of its error
            let place = (spatial.displacement / planar.displacement - 1.0).abs();
            let flat = *kind == LimitPointKind::Load;
            assert!(force < 1e-9 && place < if flat { 1e-8 } else { 1e-9 }, "{planar:?} {force:.1e} {place:.1e}");
        }
    }
}

/// A planar state of a beam in space, whose nodes are where those of the plane are.
fn lifted(plane: &BeamProblem, at: &State) -> State {
    let beam = plane.beam.planar().unwrap();
    let (mut values, fields) = (Vec::new(), beam.nodes(&at.values));
    for (place, node) in beam.places(&at.mesh.boundaries).iter().zip(fields.chunks_exact(3)) {
        values.extend([place + node[0], node[1] + 0.5 * beam.height_at(*place), 0.0]);
        values.extend(turned([node[2], 0.0, 0.0], ALONG_X));
    }
    values.extend([fields[2], 0.0, 0.0, fields[fields.len() - 1], 0.0, 0.0]);
    State { values, ..at.clone() }
}

#[test]
fn planar_states_of_the_spatula_are_equilibria_in_space() {
    let model = Spatula::default().model();
    let (plane, space) = (in_the_plane(&model), in_space(&model));
    let options = PathOptions { elements: 40, tolerance: 1e-11, first_displacement: 0.1, ..PathOptions::default() };
    let mut path = Path::new(&plane, options);
    let (mut farthest, mut unstable) = (0.0f64, 0);
    for index in 0..100 {
        let point = path.advance().unwrap();
        // none of them next to a displacement limit point, where a displacement does not say which equilibrium it is
        if index % 25 > 0 {
            continue;
        }
        let wanted = point.observables;
        let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: wanted.displacement };
        let newton = NewtonOptions { tolerance: 1e-12, largest_update: 0.5, most_iterations: 4, exact_slope: false };
        let found = solve(&space, lifted(&plane, &point.at), &constraint, &newton, &mut Workspace::default()).unwrap();
        assert!((found.observables.force / wanted.force - 1.0).abs() < 1e-9, "{}", found.observables.force);
        assert!((found.observables.monitors[0] / wanted.monitors[0] - 1.0).abs() < 1e-9);
        assert!((found.observables.recorded - wanted.recorded).abs() < 1e-12);
        farthest = farthest.max(wanted.displacement);
        unstable = unstable.max(found.negative);
    }
    assert!(farthest > 200.0, "{farthest}");
    // what is stable in its plane leans out of it: the wide neck rolls
    assert!(unstable > 0);
}

#[test]
fn a_pull_to_the_other_side_is_the_mirror_image() {
    let peeled = |azimuth: f64| {
        let mut model = pulled(Spatula::default().model(), 60.0, Hold::Fixed);
        model.space = Some(Space { azimuth: azimuth.to_radians(), ..Space::default() });
        let peel = peel(&model, &Accuracy::to(1e-3), &StopCriteria::after_points(60));
        assert!(!matches!(peel.end, PathEnd::Failed(_)), "{:?}", peel.end);
        peel
    };
    let (left, right) = (peeled(-10.0), peeled(10.0));
    // it starts without a force, and leans to the side to which it is pulled
    for (peel, side) in [(&left, -1.0), (&right, 1.0)] {
        let first = peel.points[0];
        assert!(first.force.abs() < 1e-4 && first.displacement.abs() < 1e-9, "{first:?}");
        let grip = first.in_space.unwrap();
        assert!(side * grip.roll > 1e-3 && side * grip.yaw < -1e-3, "{grip:?}");
        assert_eq!(first.negative_eigenvalues, 0);
    }
    assert_eq!(left.points.len(), right.points.len());
    // what turns does so at the same place, to round-off
    assert!(!left.limit_points.is_empty());
    assert_eq!(left.limit_points.len(), right.limit_points.len());
    for (a, b) in left.limit_points.iter().zip(&right.limit_points) {
        assert_eq!(a.kind, b.kind);
        assert!((a.force / b.force - 1.0).abs() < 1e-10, "{a:?} {b:?}");
        assert!((a.displacement / b.displacement - 1.0).abs() < 1e-10, "{a:?} {b:?}");
    }
    // the points of one lie on the curve through those of the other, far closer than the accuracy asked for: steps are of different
    // lengths where round-off decides them
    for (a, around) in left.points[1..].iter().zip(right.points.windows(3)) {
        let [before, b, behind] = around else { continue };
        // the parabola through three points
        let near = |one: f64, of: &dyn Fn(&PathPoint) -> f64| {
            let weight = |of: &PathPoint, [j, k]: [&PathPoint; 2]| {
                (a.displacement - j.displacement) * (a.displacement - k.displacement)
                    / ((of.displacement - j.displacement) * (of.displacement - k.displacement))
            };
            let [p, q, r] = [weight(before, [b, behind]), weight(b, [before, behind]), weight(behind, [before, b])];
            let other = p * of(before) + q * of(b) + r * of(behind);
            assert!((one / other - 1.0).abs() < 1e-4, "{one} {other}: {a:?} {b:?}");
        };
        let grip = a.in_space.unwrap();
        near(a.force, &|point| point.force);
        near(grip.roll, &|point| -point.in_space.unwrap().roll);
        near(grip.yaw, &|point| -point.in_space.unwrap().yaw);
    }
}

/// A number of the table of collocation, with its error.
fn reference(case: &str, quantity: &str) -> (f64, f64) {
    let key = format!("{case},{quantity},");
    let table =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../verification/space_peels.csv")).unwrap();
    let row = table.lines().filter_map(|line| line.strip_prefix(&key)).next().expect("the table has the case");
    let (value, error) = row.split_once(',').unwrap();
    (value.parse().unwrap(), error.parse().unwrap())
}

/// A strip that narrows from 40 to 15 nm, 10 nm high, pulled sideways at 60 degrees.
#[test]
fn a_tapered_strip_pulled_sideways_is_that_of_collocation() {
    let piece = Piece { width: [40.0, 15.0], ..Piece::straight(100.0, 40.0, 10.0) };
    let form = ProfileForm::Pieces(ProfilePieces::new(vec![piece]).unwrap());
    let body = Body::Profile(Profile { form, material: Spatula::default().material });
    let mut model = pulled(PeelModel { body, ..Spatula::default().model() }, 60.0, Hold::Free);
    model.space = Some(Space { azimuth: 90f64.to_radians(), ..Space::default() });
    let found = limits(&model.problem(Form::ThreeField, ORDER).unwrap(), 36);
    let first = |wanted| found.iter().find(|(kind, _)| *kind == wanted).expect("one of each kind").1;
    for (kind, point) in [(LimitPointKind::Load, "peak"), (LimitPointKind::Displacement, "fold")] {
        let at = first(kind);
        for (value, quantity) in [(at.force, "force_nN"), (at.displacement, "displacement_nm")] {
            let (exact, error) = reference("taper", &format!("{point}_{quantity}"));
            assert!((value - exact).abs() < 1e-8 * exact + error, "{point} {quantity}: {value}, not {exact}");
        }
    }
}

#[test]
fn an_ellipse_is_the_section_of_a_strip() {
    let space = Space { section: SectionShape::Ellipse, ..Space::default() };
    let model = PeelModel { space: Some(space), ..Spatula::default().model() };
    assert_eq!(model.check().unwrap_err().key(), "strip.section");
}

/// A beam that lies on the ground, the same turned about its axis until it stands on its edge, and that lifted by 25 r0: what moves it by 1 nm is as
/// large at its corner as where it lies, and 26 times smaller above.
#[test]
fn places_are_measured_by_the_lowest_point_of_a_section() {
    let form = ProfileForm::Pieces(ProfilePieces::new(vec![Piece::straight(100.0, 40.0, 10.0)]).unwrap());
    let body = Body::Profile(Profile { form, material: Spatula::default().material });
    let model =
        PeelModel { body, space: Some(Space { azimuth: 1.0, ..Space::default() }), ..Spatula::default().model() };
    let problem = model.problem(Form::ThreeField, ORDER).unwrap();
    let r0 = model.adhesion.equilibrium_distance;
    let lying = problem.system.stress_free(4);
    let moved: Vec<f64> = (0..problem.system.unknowns(&lying)).map(|k| f64::from(u8::from(k % 6 == 2))).collect();
    let rolled = |roll: f64, lift: f64| {
        let mut at = lying.clone();
        let nodes = at.values.len() - 6;
        for node in at.values[..nodes].chunks_exact_mut(7) {
            node[1] += 20.0 * roll.sin().abs() + 5.0 * (roll.cos().abs() - 1.0) + lift;
            node[3..].copy_from_slice(&turned([0.0, 0.0, roll], ALONG_X));
        }
        problem.system.size(&moved, &at)
    };
    assert_relative_eq!(rolled(0.0, 0.0), 1.0 / r0, max_relative = 1e-12);
    for roll in [0.3f64, 1.0, -1.5] {
        assert_relative_eq!(rolled(roll, 0.0), 1.0 / r0, max_relative = 1e-12);
        assert_relative_eq!(rolled(roll, 25.0 * r0), 1.0 / (26.0 * r0), max_relative = 1e-12);
    }
}

/// Pulled sideways the pad of a spatula rolls and hangs by a corner of its tip, past five limit points within a nanometre: the path comes through on
/// the first mesh.
#[test]
fn the_spatula_pulled_sideways_takes_one_mesh() {
    let mut model = pulled(Spatula::default().model(), 60.0, Hold::Fixed);
    model.space = Some(Space { azimuth: FRAC_PI_2, ..Space::default() });
    let result = peel(&model, &Accuracy::default(), &StopCriteria::default());
    let turns = result.limit_points.iter().filter(|point| point.kind == LimitPointKind::Displacement).count();
    assert_eq!((result.end.clone(), turns), (PathEnd::Pivoting, 5));
    assert!(result.effort.newton_iterations < 1500, "{:?}", result.effort);
}
