//! The strip pulled at an angle against collocation, and its steady force against a closed form.

use crate::check::{Check, Measure, Topic, missing};
use crate::suite::reference::{Row, read};
use crate::suite::strip::turns::Turns;
use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::analytic::sliding_force;
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Discretisation, Form, Grip, PeelModel, Pull, Strip, StripModel};
use peelkit::study::{Accuracy, FOLLOWED_ORDER, NotPrepared, Prepared, StopCriteria, peel, prepared};
use rayon::prelude::*;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "pull",
    about: "strips pulled at an angle, adhered under pretension, or in a grip that rotates: collocation, steady force",
    checks,
};

const TABLE: Turns = Turns {
    table: include_str!("../../../verification/pull_angle.csv"),
    source: "verification/pull_angle.py: collocation",
    named: &[
        ("pull_angle_deg", "", " degrees"),
        ("grip_across", "normal to the pull ", ""),
        ("grip_rotation", "rotation ", ""),
        ("line_load", "", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);
const STRETCHED: Turns = Turns {
    table: include_str!("../../../verification/pretension.csv"),
    source: "verification/pretension.py: collocation",
    named: &[
        ("pretension_nN", "pretension ", " nN"),
        ("pull_angle_deg", "", " degrees"),
        ("grip_rotation", "rotation ", ""),
        ("line_load", "", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};
const TURNED: Turns = Turns {
    table: include_str!("../../../verification/turned_grip.csv"),
    source: "verification/turned_grip.py: collocation",
    named: &[
        ("grip_turned_deg", "grip rotated by ", " degrees"),
        ("grip_turn_deg_per_nm", "rotating by ", " degrees/nm"),
        ("pull_angle_deg", "", " degrees"),
        ("grip_across", "normal to the pull ", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("length_nm", "L = ", " nm"),
    ],
};
/// Relative error of the force after a step.
const BEHIND_STEP: f64 = 1e-8;
/// Angles (degrees) of long strips, of this length in nm, whose front is looked at half-way.
const STEADY: [f64; 7] = [20.0, 45.0, 60.0, 90.0, 120.0, 150.0, 170.0];
const LONG: f64 = 2000.0;
/// Angles (degrees) at which the plateau is held against the closed form, and the relative accuracy that is asked for.
const PLATEAUS: [f64; 5] = [30.0, 45.0, 60.0, 90.0, 120.0];
const LEVEL: f64 = 1e-5;

fn checks() -> Vec<Check> {
    let mut checks = TABLE.checks();
    checks.extend(STRETCHED.checks());
    checks.extend(TURNED.checks());
    checks.extend(read(TURNED.table).par_iter().filter_map(turned).collect::<Vec<_>>());
    checks.extend(STEADY.par_iter().map(|&angle| steady(angle)).collect::<Vec<_>>());
    let strips =
        PLATEAUS.map(|angle| (angle, "a strip of 2000 nm", PeelModel::from(StripModel::of_the_paper(LONG, 1.0))));
    let tapes = PLATEAUS.map(|angle| (angle, "a tape of 1 mm", tape()));
    let plateaus: Vec<_> = strips.into_iter().chain(tapes).collect();
    checks.extend(plateaus.into_par_iter().map(|(angle, name, model)| plateau(angle, name, model)).collect::<Vec<_>>());
    checks
}

/// The force along the pull after the rotation of a grip.
fn turned(row: &Row) -> Option<Check> {
    let (expected, model) = (row.number("start_force_nN")?, row.model()?);
    let how = Discretisation::moving(Form::TwoField, FOLLOWED_ORDER);
    let (steps, failure) = match prepared(&model, how, None) {
        Ok(Prepared { steps, .. }) => (steps, None),
        Err(NotPrepared { why, steps }) => (*steps, Some(why)),
    };
    let direction = model.pull.direction();
    let force = steps.ends.first().map(|grip| direction.ahead(grip.forces.horizontal, grip.forces.vertical));
    let name = format!(
        "force after a rotation by {} degrees, L = {} nm",
        row.text("grip_turned_deg")?,
        row.text("length_nm")?
    );
    let missing = || failure.map_or("no step was taken".into(), |why| why.to_string());
    let (source, measure) = (TURNED.source, Measure::Relative);
    Some(Check::new(name, source, force.ok_or_else(missing), expected, measure, BEHIND_STEP))
}

/// A tape of silicone rubber, 1 mm by 20 µm by 1 mm, 2 MPa, under an exponential law of 0.2 J/m² and 1 MPa.
fn tape() -> PeelModel {
    let StripModel { strip, .. } = StripModel::of_the_paper(LONG, 1.0);
    let strip = Strip { length: 1e6, height: 2e4, width: 1e6, material: Material::of(2e-3, 0.49), ..strip };
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        work: Some(0.2),
        strength: Some(1e-3),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap_or(law.equilibrium_distance);
    PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
}

/// The plateau against the force of a film that slides without friction.
fn plateau(degrees: f64, name: &str, mut model: PeelModel) -> Check {
    model.pull = Pull { angle: degrees.to_radians(), ..Pull::UP };
    let peel = peel(&model, &Accuracy::to(LEVEL), &BOUNDS);
    let rest = model.free_end().0 * model.line_law().rest_energy();
    Check::new(
        format!("plateau, nN, {degrees} degrees, {name}"),
        "P (1 - cos α) + P² sin² α/(2EA) = -bΨ(y_eq, 0), from the first integral",
        peel.plateau.map(|at| at.force).ok_or_else(|| missing(&peel.end)),
        sliding_force(rest, model.section().axial, degrees.to_radians()),
        Measure::Relative,
        LEVEL,
    )
}

/// The force where the front of a long strip is half-way.
fn steady(degrees: f64) -> Check {
    let mut model = StripModel::of_the_paper(LONG, 1.0);
    model.pull = Pull { angle: degrees.to_radians(), ..Pull::UP };
    let peel = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    let model = PeelModel::from(model);
    let rest = model.free_end().0 * model.line_law().rest_energy();
    Check::new(
        format!("force with the front half-way, nN, {degrees} degrees, L = {LONG} nm"),
        "P (1 - cos α) + P² sin² α/(2EA) = -bΨ(y_eq, 0), from the first integral",
        peel.nearest_front(0.5 * LONG).map(|index| peel.points[index].force).ok_or_else(|| missing(&peel.end)),
        sliding_force(rest, model.section().axial, degrees.to_radians()),
        Measure::Relative,
        1e-6,
    )
}
