//! What the grip of a strip in space does before the pull.
//!
//! ```text
//!      y                      lift, press: y   drag, push: x   shift: z        then the pull, u and P from there
//!      |______________        roll ρ, yaw ψ, turn θ of the right end
//!      |==============|<- grip
//!      z                      b × h = 10..20 × 10 nm, L = 100 nm, E = 2 GPa, ν = 0.2, A_H = 1e-19 J, r0 = 0.4 nm
//! ```
//!
//! References: verification/space_peels.csv, Gauss collocation of the strong form, where u counts from the level strip; the pull from rest, of
//! which a pull behind steps is a part on ground without friction; EA times the strain of a strip that is dragged.
//! Expected: peaks and folds within their bounds of 1e-6, and torque and height without a force to 1e-7; what is free exerts nothing where
//! the pull begins, and the force along the pull is that behind the last step. Why: the right end moves along other axes in a step than in the
//! pull, and each of its places, its angles and its forces can keep the old ones.

use peelkit::adhesion::SectionShape;
use peelkit::beam::{ForcesInSpace, GripState, PlaceInSpace};
use peelkit::model::{Body, Hold, PeelModel, Space, Step, StripModel};
use peelkit::solve::LimitPointKind;
use peelkit::study::{Accuracy, Choice, PathEnd, Peel, StopCriteria, peel};

/// A number of the table.
fn reference(case: &str, quantity: &str) -> f64 {
    let key = format!("{case},{quantity},");
    let rows = include_str!("../../../verification/space_peels.csv").lines();
    let row = rows.filter_map(|line| line.strip_prefix(&key)).next().expect("the table has it");
    row.split(',').next().unwrap().parse().unwrap()
}

/// A strip of this width (nm), pulled at an elevation and azimuth in degrees.
fn strip(width: f64, [elevation, azimuth]: [f64; 2], space: Space, steps: &[Step]) -> PeelModel {
    let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    if let Body::Strip(strip) = &mut model.body {
        strip.width = width;
        if space.section == SectionShape::Ellipse {
            strip.material.shear_correction = 0.9;
        }
    }
    model.pull.angle = elevation.to_radians();
    model.space = Some(Space { azimuth: azimuth.to_radians(), ..space });
    model.steps = steps.to_vec();
    model
}

const ROLLED: Space =
    Space { azimuth: 0.0, lateral: Hold::Free, roll: Hold::Fixed, yaw: Hold::Free, section: SectionShape::Rectangle };

fn degrees(step: fn(f64) -> Step, angle: f64) -> Step {
    step(angle.to_radians())
}

/// Up to a displacement, nm.
fn peeled(model: &PeelModel, relative: f64, displacement: f64) -> Peel {
    let stop = StopCriteria { displacement: Some(displacement), ..StopCriteria::after_points(400) };
    let peel = peel(model, &Accuracy::to(relative), &stop);
    assert!(matches!(peel.end, PathEnd::Bound(_)), "{:?}: {:?}", model.steps, peel.end);
    peel
}

#[track_caller]
fn assert_near(what: &str, a: f64, b: f64, bound: f64) {
    assert!((a - b).abs() <= bound, "{what}: {a} and {b}, apart by {:.1e}, bound {bound:.1e}", a - b);
}

fn in_space(grip: &GripState) -> (PlaceInSpace, ForcesInSpace) {
    grip.in_space.zip(grip.forces.in_space).expect("the grip is in space")
}

/// Lifted, rolled and let go of its height, it is where the table begins; the pull from there has the table's peak.
#[track_caller]
fn rolls(case: &str, model: &PeelModel, [roll, yaw]: [f64; 2]) {
    let peel = peeled(model, 1e-6, 1.0);
    let behind = peel.steps.last().unwrap();
    let (place, forces) = in_space(behind);
    let start = reference(case, "start_displacement_nm");
    assert_near("height without a force", behind.y, start, 1e-8);
    assert_near("vertical force", behind.forces.vertical, 0.0, 1e-9);
    assert_near("torque", forces.torque, reference(case, "start_torque_nN_nm"), 1e-6);
    assert_near("roll", place.roll, roll.to_radians(), 1e-14);
    if yaw.is_finite() {
        assert_near("yaw", place.yaw, yaw.to_radians(), 1e-14);
    }
    let first = peel.points[0];
    assert_eq!((first.displacement, first.work), (0.0, 0.0));
    let peak = peel.limit_points.iter().find(|point| point.kind == LimitPointKind::Load).expect("a peak");
    let (force, place) = (reference(case, "peak_force_nN"), reference(case, "peak_displacement_nm") - start);
    assert_near("peak", peak.force, force, peak.force_error);
    assert_near("its place", peak.displacement, place, peak.displacement_error);
    assert!(peak.force_error <= 1e-6 * force && peak.displacement_error <= 1e-6 * place, "{peak:?}");
    let torque = peak.in_space.unwrap().torque;
    assert_near("torque at the peak", torque, reference(case, "peak_torque_nN_nm"), 1e-4 * torque.abs());
}

#[test]
fn a_grip_that_is_rolled_and_held() {
    let steps = |lift: f64, roll: f64| vec![Step::Lift(lift), degrees(Step::Roll, roll), Step::Release];
    let yawless = Space { yaw: Hold::Fixed, ..ROLLED };
    let up = [90.0, 0.0];
    let ellipse = Space { section: SectionShape::Ellipse, ..yawless };
    let mut level = strip(20.0, up, ROLLED, &steps(0.3, 2.0));
    level.grip.rotation = Hold::Fixed;
    let free = f64::NAN;
    for (case, model, [roll, yaw], force) in [
        ("rolled", strip(10.0, up, yawless, &steps(0.5, 5.0)), [5.0, 0.0], 1e-8),
        ("rolled_yaw_free", strip(10.0, up, ROLLED, &steps(0.4, 5.0)), [5.0, free], 1e-8),
        ("ellipse_rolled", strip(20.0, up, ellipse, &steps(0.1, 5.0)), [5.0, 0.0], 1e-8),
        // wide and level, it is 0.25 nm from the ground with its edge alone
        ("rolled_level", level, [2.0, free], 1e-4),
    ] {
        rolls(case, &model, [roll, yaw]);
        // on as many elements as the steps have, about, the pull begins as they end
        let fine = Accuracy::to(1e-6).with(Choice { elements: Some(64), ..Choice::NOTHING });
        let start = peel(&model, &fine, &StopCriteria::after_points(3)).points[0].force;
        assert_near(&format!("{case}: force where the pull begins"), start, 0.0, force);
    }
}

/// Turned as a whole about the normal, a strip that its grip alone holds against that is the strip that lies straight.
#[test]
fn a_strip_that_is_yawed_is_pulled_as_before() {
    let space = Space { roll: Hold::Free, yaw: Hold::Fixed, ..ROLLED };
    let peel = peeled(&strip(10.0, [90.0, 0.0], space, &[degrees(Step::Yaw, 30.0)]), 1e-6, 1.0);
    let (place, forces) = in_space(&peel.steps[0]);
    assert_near("yaw", place.yaw, 30f64.to_radians(), 1e-14);
    assert_near("its moment", forces.yaw_moment, 0.0, 1e-9);
    let behind = &peel.steps[0];
    assert_near("x", behind.x.unwrap(), 100.0 * (30f64.to_radians().cos() - 1.0), 1e-9);
    assert_near("z", place.z, -100.0 * 30f64.to_radians().sin(), 1e-9);
    let peak = peel.initiation_peak.expect("a peak");
    assert_near("peak", peak.force, reference("upright", "peak_force_nN"), peak.force_error);
    let ahead = reference("upright", "peak_displacement_nm");
    assert_near("its place", peak.displacement, ahead, peak.displacement_error);
}

/// Held in all directions, where the grip is says what it exerts: two ways there lead to the same, and the pull begins with the force behind
/// them, at an angle and an azimuth.
#[test]
fn a_way_round_leads_to_the_same() {
    let space = Space { lateral: Hold::Fixed, yaw: Hold::Fixed, ..ROLLED };
    let [roll, yaw] = [|angle| degrees(Step::Roll, angle), |angle| degrees(Step::Yaw, angle)];
    let direct = [Step::Lift(0.3), roll(3.0), yaw(2.0), Step::Drag(0.1), Step::Shift(0.5)];
    let round = [Step::Shift(-0.5), Step::Lift(0.6), yaw(3.0), Step::Push(0.4), roll(3.0), Step::Drag(0.5)];
    let round = [&round[..], &[yaw(-1.0), Step::Hold, Step::Shift(1.0), Step::Press(0.3)]].concat();
    let peels = [&direct[..], &round[..]].map(|steps| {
        let mut model = strip(10.0, [60.0, 30.0], space, steps);
        (model.grip.rotation, model.grip.horizontal) = (Hold::Fixed, Hold::Fixed);
        peeled(&model, 1e-6, 0.3)
    });
    let [a, b] = [0, 1].map(|k: usize| *peels[k].steps.last().unwrap());
    let [(place, forces), (other, others)] = [&a, &b].map(in_space);
    for (what, a, b) in [
        ("x", a.x.unwrap(), 0.1),
        ("y", a.y, 0.3),
        ("z", place.z, 0.5),
        ("x", b.x.unwrap(), 0.1),
        ("y", b.y, 0.3),
        ("z", other.z, 0.5),
    ] {
        assert_near(what, a, b, 1e-12);
    }
    for (what, a, b) in [
        ("H", a.forces.horizontal, b.forces.horizontal),
        ("V", a.forces.vertical, b.forces.vertical),
        ("sideways", forces.lateral, others.lateral),
        ("M", a.forces.moment, b.forces.moment),
        ("on the yaw", forces.yaw_moment, others.yaw_moment),
        ("on the roll", forces.torque, others.torque),
    ] {
        assert_near(what, a, b, 1e-8);
    }
    let (sin, cos) = 60f64.to_radians().sin_cos();
    let (aside, along) = 30f64.to_radians().sin_cos();
    let level = |x: f64, z: f64| along * x + aside * z;
    let first = peels[0].points[0];
    let ahead = cos * level(a.forces.horizontal, forces.lateral) + sin * a.forces.vertical;
    assert_near("P", first.force, ahead, 1e-6 * ahead);
    let across = sin * level(a.forces.horizontal, forces.lateral) - cos * a.forces.vertical;
    assert_near("across", first.in_space.unwrap().across, across, 1e-6 * ahead);
    let lateral = along * forces.lateral - aside * a.forces.horizontal;
    assert_near("lateral", first.in_space.unwrap().lateral, lateral, 1e-6 * ahead);
    let [a, b] = peels.each_ref().map(|peel| peel.initiation_peak.expect("a peak"));
    assert_near("peak", a.force, b.force, a.force_error + b.force_error);
}

/// A grip that is free along the substrate has nothing left of a drag and a shift once it lets go, whatever the direction of the pull behind.
#[test]
fn what_is_free_lets_go() {
    let free = Space { roll: Hold::Free, ..ROLLED };
    let steps = [Step::Drag(0.3), Step::Shift(0.2), Step::Lift(0.1), Step::Release];
    let pulls = [&[][..], &steps[..]].map(|steps| peeled(&strip(10.0, [60.0, 30.0], free, steps), 1e-6, 3.0));
    let [dragged, shifted, lifted, released] = pulls[1].steps[..] else { panic!("four steps") };
    assert_near("EA times the strain", dragged.forces.horizontal, 0.6, 1e-9);
    assert_near("H behind the next step", shifted.forces.horizontal, 0.0, 1e-8);
    assert!(in_space(&shifted).1.lateral > 1e-4, "{shifted:?}");
    assert_near("sideways behind the next step", in_space(&lifted).1.lateral, 0.0, 1e-8);
    assert_near("where it lies", released.y, 0.0, 1e-8);
    let force = |peel: &Peel| {
        let curve = peel.dense_curve(16);
        let k = curve.windows(2).position(|pair| pair[1].0 >= 2.9).unwrap();
        let ((u, p, _), (v, q, _)) = (curve[k], curve[k + 1]);
        p + (q - p) * (2.9 - u) / (v - u)
    };
    let [a, b] = pulls.each_ref().map(force);
    assert_near("P at 2.9 nm", a, b, 1e-5 * a);
    // held in one of its two directions alone, at an azimuth, it is free in the other
    let held = Space { lateral: Hold::Fixed, ..free };
    let steps = [Step::Lift(0.2), Step::Drag(0.3), Step::Shift(0.2), Step::Lift(0.1)];
    let peel = peeled(&strip(10.0, [60.0, 30.0], held, &steps), 1e-4, 0.1);
    let last = peel.steps.last().unwrap();
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let forces = in_space(last).1;
    assert_near("what is free", cos * last.forces.horizontal + sin * forces.lateral, 0.0, 1e-8);
    let held = |grip: &GripState| cos * in_space(grip).0.z - sin * grip.x.unwrap();
    assert_near("what is held", held(last), held(&peel.steps[2]), 1e-12);
}

/// Rolled as it lies, a corner goes into the ground: the step says where it stops, in the unit in which it is written, and what the grip
/// exerts there.
#[test]
fn a_corner_that_meets_the_ground_ends_a_step() {
    let held = Space { yaw: Hold::Fixed, ..ROLLED };
    let limits: Vec<f64> = [(degrees(Step::Roll, 8.0), "deg"), (Step::Roll(0.14), "rad")]
        .map(|(step, unit)| {
            let mut model = strip(10.0, [90.0, 0.0], held, &[step]);
            model.grip.rotation = Hold::Fixed;
            let PathEnd::Failed(why) = peel(&model, &Accuracy::to(1e-4), &StopCriteria::after_points(100)).end else {
                panic!("the corner would be below the ground")
            };
            let why = why.to_string();
            for part in [&format!("step 1 of drive.steps, \"{step}\","), "on the roll "] {
                assert!(why.contains(part), "{part} is not in {why}");
            }
            let limit = why.split(&format!(" {unit} (H = ")).next().and_then(|before| before.split(' ').next_back());
            limit.and_then(|limit| limit.parse().ok()).unwrap_or_else(|| panic!("no limit in {unit}: {why}"))
        })
        .to_vec();
    assert_near("the limit", limits[0], limits[1].to_degrees(), 0.2);
}
