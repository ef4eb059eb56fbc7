//! What a grip shifts, rolls, yaws and holds in space: closed forms, the plane, and mirror images.

use crate::check::{Check, Measure, Topic};
use crate::suite::reference;
use peelkit::beam::{ForcesInSpace, GripState, PlaceInSpace};
use peelkit::model::{Body, Hold, PeelModel, Space, Step, StripModel};
use peelkit::study::{Accuracy, LimitPoint, LimitPointKind, Peel, StopCriteria, peel};
use std::f64::consts::PI;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "grip-in-space",
    about: "what a grip shifts, rolls, yaws and holds in space: closed forms, planar collocation, mirror images",
    checks,
};

const PULLED: &str = include_str!("../../../verification/pull_angle.csv");
const STRIPS: &str = include_str!("../../../verification/strip.csv");
/// L, h and b, nm
const LENGTH: f64 = 100.0;
const HEIGHT: f64 = 10.0;
const WIDE: f64 = 40.0;
const SQUARE: f64 = 10.0;
/// E and k G, GPa
const YOUNG: f64 = 2.0;
const SHEAR: f64 = YOUNG / 2.4;
const CORRECTION: f64 = 5.0 / 6.0;
const ASKED: f64 = 1e-6;
/// So small that what is left out of the closed forms is of the order 1e-7 of them: nm and rad.
const SHIFT: f64 = 0.01;
const ROLL: f64 = 1e-4 * PI / 180.0;
/// Not small.
const YAW: f64 = PI / 6.0;
/// Beside the vertical plane of the strip, where the problem is one in space and its solution is that of the plane, rad.
const BESIDE: f64 = 1e-10;
/// Of forces that are zero, nN.
const NO_FORCE: f64 = 1e-7;

fn checks() -> Vec<Check> {
    [shifted(), shifted_at_a_held_yaw(), shifted_at_a_hinge(), rolled(), yawed(), held_in_the_plane(), mirrored()]
        .concat()
}

fn strip(width: f64, elevation: f64, space: Space, steps: Vec<Step>) -> PeelModel {
    let mut model = PeelModel::from(StripModel::of_the_paper(LENGTH, 1.0));
    if let Body::Strip(strip) = &mut model.body {
        strip.width = width;
    }
    model.pull.angle = elevation.to_radians();
    PeelModel { space: Some(space), steps, ..model }
}

/// Pulled sideways, up to its first fold at most.
fn sideways() -> Space {
    Space { azimuth: PI / 2.0, ..Space::default() }
}

fn peeled(model: &PeelModel) -> Peel {
    peel(model, &Accuracy::to(ASKED), &StopCriteria::after_points(120))
}

/// The grip behind the only step of a strip that is then pulled by a little.
fn behind(space: Space, step: Step) -> Result<(GripState, PlaceInSpace, ForcesInSpace), String> {
    let stop = StopCriteria { displacement: Some(0.1), ..StopCriteria::after_points(120) };
    let peel = peel(&strip(WIDE, 60.0, space, vec![step]), &Accuracy::to(ASKED), &stop);
    let grip = peel.steps.first().copied();
    let all = grip.and_then(|grip| Some((grip, grip.in_space?, grip.forces.in_space?)));
    all.ok_or_else(|| "the step before the pull has no end".to_owned())
}

/// P/w of a cantilever that is bent across its width, by a force at its end.
fn lateral_stiffness() -> f64 {
    let bending = YOUNG * HEIGHT * WIDE.powi(3) / 12.0;
    let shear = CORRECTION * SHEAR * WIDE * HEIGHT;
    (LENGTH.powi(3) / (3.0 * bending) + LENGTH / shear).recip()
}

const CANTILEVER: &str = "closed form: a cantilever in the plane of the substrate, s / (L³/3EI3 + L/GA)";

/// Free to yaw: the left end holds the yaw.
fn shifted() -> Vec<Check> {
    let grip = behind(sideways(), Step::Shift(SHIFT));
    let force = lateral_stiffness() * SHIFT;
    let bending = YOUNG * HEIGHT * WIDE.powi(3) / 12.0;
    let yaw = -force * LENGTH.powi(2) / (2.0 * bending);
    let relative = |what: &str, number, expected| {
        let name = format!("{what} behind a shift by {SHIFT} nm, free to yaw");
        Check::new(name, CANTILEVER, number, expected, Measure::Relative, ASKED)
    };
    vec![
        relative("lateral force (nN)", grip.clone().map(|grip| grip.2.lateral), force),
        relative("yaw (rad)", grip.map(|grip| grip.1.yaw), yaw),
    ]
}

/// At a held yaw the left end is the hinge: the same stiffness, and the moment F L.
fn shifted_at_a_held_yaw() -> Vec<Check> {
    let grip = behind(Space { yaw: Hold::Fixed, ..sideways() }, Step::Shift(SHIFT));
    let force = lateral_stiffness() * SHIFT;
    let relative = |what: &str, number, expected| {
        let name = format!("{what} behind a shift by {SHIFT} nm, yaw held");
        Check::new(name, CANTILEVER, number, expected, Measure::Relative, ASKED)
    };
    vec![
        relative("lateral force (nN)", grip.clone().map(|grip| grip.2.lateral), force),
        relative("moment on the yaw (nN nm)", grip.map(|grip| grip.2.yaw_moment), force * LENGTH),
    ]
}

/// Held sideways and along itself, and free to yaw: a hinge at either end, the strip turns and stretches.
fn shifted_at_a_hinge() -> Vec<Check> {
    const TURNED: &str = "closed form: a rod between two hinges";
    let shift = 100.0 * SHIFT;
    let grip = behind(Space { lateral: Hold::Fixed, ..sideways() }, Step::Shift(shift));
    let longer = LENGTH.hypot(shift);
    let tension = YOUNG * WIDE * HEIGHT * (longer / LENGTH - 1.0);
    let check = |what: &str, number, expected| {
        let name = format!("{what} behind a shift by {shift} nm between two hinges");
        Check::new(name, TURNED, number, expected, Measure::Relative, ASKED)
    };
    vec![
        check("yaw (rad)", grip.clone().map(|grip| grip.1.yaw), -(shift / LENGTH).atan()),
        check("horizontal force (nN)", grip.clone().map(|grip| grip.0.forces.horizontal), tension * LENGTH / longer),
        check("lateral force (nN)", grip.map(|grip| grip.2.lateral), tension * shift / longer),
    ]
}

/// Twisted on the adhesion, at the height at which that exerts no force: φ √(GJ κ) tanh(L √(κ/GJ)).
fn rolled() -> Vec<Check> {
    const TWISTED: &str = "closed form: torsion of a strip on its adhesion, φ √(GJ κ) tanh(L √(κ/GJ))";
    let (twist, rotation) = (SHEAR * torsion_constant(), rotational_stiffness());
    let expected = ROLL * (twist * rotation).sqrt() * (LENGTH * (rotation / twist).sqrt()).tanh();
    let grip = behind(Space { roll: Hold::Fixed, ..sideways() }, Step::Roll(ROLL));
    let torque = grip.map(|grip| grip.2.torque);
    vec![Check::new(
        "torque (nN nm) behind a roll by 1e-4 degrees",
        TWISTED,
        torque,
        expected,
        Measure::Relative,
        ASKED,
    )]
}

/// J of the rectangle by Saint-Venant's series.
fn torsion_constant() -> f64 {
    let term = |n: f64| (n * PI * WIDE / (2.0 * HEIGHT)).tanh() / n.powi(5);
    let series: f64 = (0..200).rev().map(|k| term(2.0 * f64::from(k) + 1.0)).sum();
    WIDE * HEIGHT.powi(3) * (1.0 / 3.0 - 64.0 * HEIGHT / (PI.powi(5) * WIDE) * series)
}

/// κ per length of the flat strip, b³/12 Ψ_yy - b h Ψ_c, from W of eq. (21) and its derivatives at both faces.
fn rotational_stiffness() -> f64 {
    let StripModel { adhesion, .. } = StripModel::of_the_paper(LENGTH, 1.0);
    let (constant, distance) = (adhesion.hamaker_constant, adhesion.equilibrium_distance);
    // the n-th derivative of W at r
    let potential = |r: f64, n: i32| {
        let falling =
            |power: i32| (0..n).map(|k| -f64::from(power + k) / r).product::<f64>() * (distance / r).powi(power);
        constant / (2.0 * PI * distance.powi(2)) * (falling(8) / 360.0 - falling(2) / 6.0)
    };
    let between = |y: f64, n| potential(y - HEIGHT / 2.0, n) - potential(y + HEIGHT / 2.0, n);
    let rest = (0..20).fold(HEIGHT / 2.0 + 0.63 * distance, |y, _| y - between(y, 1) / between(y, 2));
    let tilt =
        -between(rest, 0) - HEIGHT / 2.0 * (potential(rest - HEIGHT / 2.0, 1) + potential(rest + HEIGHT / 2.0, 1));
    WIDE.powi(3) / 12.0 * between(rest, 2) - WIDE * tilt
}

/// The ground resists no turn about its normal: the strip turns as a whole, and is peeled as in the plane.
fn yawed() -> Vec<Check> {
    const TURNED: &str = "the strip turned as a whole";
    let held = Space { yaw: Hold::Fixed, ..sideways() };
    let grip = behind(held, Step::Yaw(YAW));
    let absolute = |what: &str, number: Result<f64, String>, expected: f64, tolerance: f64| {
        let name = format!("{what} behind a yaw by 30 degrees");
        Check::new(name, TURNED, number, expected, Measure::Absolute, tolerance)
    };
    let peak = first_peak(&peeled(&strip(SQUARE, 90.0, held, vec![Step::Yaw(YAW)])));
    let mut checks = vec![
        absolute("x (nm)", grip.clone().map(|grip| grip.0.x.unwrap_or(f64::NAN)), LENGTH * (YAW.cos() - 1.0), 1e-8),
        absolute("z (nm)", grip.clone().map(|grip| grip.1.z), -LENGTH * YAW.sin(), 1e-8),
        absolute("lateral force (nN)", grip.clone().map(|grip| grip.2.lateral), 0.0, NO_FORCE),
        absolute("moment on the yaw (nN nm)", grip.map(|grip| grip.2.yaw_moment), 0.0, NO_FORCE),
    ];
    checks.extend(against_the_plane("straight up behind a yaw by 30 degrees", 90.0, peak));
    checks
}

/// Held sideways, in roll and in yaw, a pull along the strip is that of the plane.
fn held_in_the_plane() -> Vec<Check> {
    let held = Space { azimuth: BESIDE, lateral: Hold::Fixed, roll: Hold::Fixed, yaw: Hold::Fixed, ..Space::default() };
    let peak = first_peak(&peeled(&strip(SQUARE, 60.0, held, Vec::new())));
    against_the_plane("at 60 degrees in space, lateral, roll and yaw held", 60.0, peak)
}

/// A peak of the strip that is as wide as high, against that of the collocation in the plane at this angle of the pull.
fn against_the_plane(what: &str, angle: f64, peak: Result<LimitPoint, String>) -> Vec<Check> {
    const PLANE: &str = "verification/pull_angle.py, strip_collocation.py: planar collocation";
    let is_meant = |row: &&reference::Row| {
        row.number("length_nm") == Some(LENGTH)
            && row.number("bending_stiffness_factor") == Some(1.0)
            && row.number("pull_angle_deg").unwrap_or(90.0) == angle
            && (row.text("grip_rotation"), row.text("line_load")) == (Some("free"), Some("full"))
            && row.text("grip_across") != Some("fixed")
            && row.text("far_face") != Some("false")
    };
    let rows = [PULLED, STRIPS].map(reference::read).concat();
    let row = rows.iter().find(is_meant);
    let known = |column| row.and_then(|row| row.number(column)).unwrap_or(f64::NAN);
    let relative = |of: &str, number, expected| {
        let name = format!("{of} of the peak {what}, b = {SQUARE} nm");
        Check::new(name, PLANE, number, expected, Measure::Relative, ASKED)
    };
    vec![
        relative("displacement (nm)", peak.clone().map(|at| at.displacement), known("peak_displacement_nm")),
        relative("force (nN)", peak.map(|at| at.force), SQUARE * known("peak_force_nN")),
    ]
}

/// Shifted to the other side and pulled to the other side: the same peak, with torque and reaction the other way.
fn mirrored() -> Vec<Check> {
    let pulled = |side: f64| {
        let held = Space { azimuth: side * PI / 3.0, lateral: Hold::Fixed, roll: Hold::Fixed, ..Space::default() };
        first_peak(&peeled(&strip(WIDE, 60.0, held, vec![Step::Shift(side * 2.0)])))
    };
    let (right, left) = (pulled(1.0), pulled(-1.0));
    let check = |what: &str, of: fn(&LimitPoint) -> f64, sign: f64| {
        let name = format!("{what} of the peak behind a shift by -2 nm at azimuth -60 degrees, lateral and roll held");
        let number = left.as_ref().map(of).map_err(String::clone);
        let expected = right.as_ref().map_or(f64::NAN, |at| sign * of(at));
        Check::new(name, "the mirror image, shifted by 2 nm", number, expected, Measure::Relative, ASKED)
    };
    vec![
        check("displacement (nm)", |at| at.displacement, 1.0),
        check("force (nN)", |at| at.force, 1.0),
        check("torque (nN nm)", |at| at.in_space.map_or(f64::NAN, |grip| grip.torque), -1.0),
        check("lateral reaction (nN)", |at| at.in_space.map_or(f64::NAN, |grip| grip.lateral), -1.0),
    ]
}

fn first_peak(peel: &Peel) -> Result<LimitPoint, String> {
    let peak = peel.limit_points.iter().find(|point| point.kind == LimitPointKind::Load);
    peak.copied().ok_or_else(|| "no peak was located".to_owned())
}
