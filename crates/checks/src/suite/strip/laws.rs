//! Strips under other laws of adhesion against collocation, and their steady force against the work of adhesion.

use crate::check::{Check, Measure, Topic, missing};
use crate::suite::reference::{Row, read};
use crate::suite::strip::turns::Turns;
use peelkit::adhesion::{CohesiveShape, LineLoad};
use peelkit::analytic::kendall_force;
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Attraction, Body, Grip, PeelModel, Strip, StripModel};
use peelkit::study::{Accuracy, FollowedUntil, Peel, StationAt, StationQuantity, StopCriteria, peel};
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "laws",
    about: "other laws of adhesion, with a shear strength too, and strips of rubber: collocation, steady force of those with a potential, initial cracks",
    checks,
};

const TABLE: Turns = Turns {
    table: include_str!("../../../verification/laws.csv"),
    source: "verification/laws.py: collocation",
    named: &[
        ("law", "", ""),
        ("line_load", "", ""),
        ("far_face", "far face ", ""),
        ("grip_rotation", "rotation ", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("youngs_modulus_GPa", "E = ", " GPa"),
        ("pull_angle_deg", "", " degrees"),
        ("length_nm", "L = ", " nm"),
    ],
};
const SHEARED: Turns = Turns {
    table: include_str!("../../../verification/sheared.csv"),
    source: "verification/sheared.py: collocation",
    named: &[
        ("law", "", ""),
        ("shear_strength_GPa", "shear strength ", " GPa"),
        ("shear_work_J_per_m2", "work in shear ", " J/m²"),
        ("grip_rotation", "rotation ", ""),
        ("grip_across", "normal to the pull ", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("pull_angle_deg", "", " degrees"),
        ("length_nm", "L = ", " nm"),
    ],
};
const STRETCHED: Turns = Turns {
    table: include_str!("../../../verification/stretched.csv"),
    source: "verification/stretched.py: collocation",
    named: &[
        ("stretch", "", ""),
        ("youngs_modulus_GPa", "E = ", " GPa"),
        ("shear_strength_GPa", "shear strength ", " GPa"),
        ("grip_rotation", "rotation ", ""),
        ("grip_across", "normal to the pull ", ""),
        ("pull_angle_deg", "", " degrees"),
    ],
};
/// Length of the strips that peel steadily, nm.
const LONG: f64 = 1000.0;
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);

fn checks() -> Vec<Check> {
    let mut checks = TABLE.checks();
    checks.extend(SHEARED.checks());
    checks.extend(STRETCHED.checks());
    checks.extend(CohesiveShape::ALL.par_iter().map(|&shape| steady(shape)).collect::<Vec<_>>());
    checks.extend(of_cracks());
    checks
}

/// The plateau of a long strip: Kendall's force, with the stretch of the free part.
fn steady(shape: CohesiveShape) -> Check {
    let mut model = StripModel::of_the_paper(LONG, 1.0);
    model.adhesion.attraction = Attraction::Cohesive(shape);
    let peel = peel(&model, &Accuracy::to(1e-6), &BOUNDS);
    let strip = model.strip;
    let model = PeelModel::from(model);
    let work = -model.line_law().rest_energy();
    Check::new(
        format!("plateau, nN, {shape:?}, L = {LONG} nm"),
        "P + P²/(2EA) = w b, from the first integral",
        peel.plateau.map(|plateau| plateau.force).ok_or_else(|| missing(&peel.end)),
        kendall_force(work, strip.material.youngs_modulus, strip.height, strip.width, FRAC_PI_2),
        Measure::Relative,
        1e-6,
    )
}

// -- Double cantilever beams and a T-peel with an initial crack, against a boundary value problem --

const CRACKS: &str = include_str!("../../../verification/double_cantilever.csv");
const FILMS: &str = include_str!("../../../verification/t_peel.csv");
const OF_CRACKS: &str = "verification/double_cantilever.py: boundary value problem";
/// The table is good to this.
const GOOD: f64 = 1e-7;

/// mm, MPa and N/mm in nm, GPa and J/m²; the shear modulus of 5.2 GPa by the shear correction.
const ARM: Strip = Strip {
    length: 1e8,
    height: 1.5e6,
    width: 2e7,
    material: Material { shear_correction: 5.0 / 6.0 * 5.2 / (135.3 / 2.48), ..Material::of(135.3, 0.24) },
    crack: None,
    layers: None,
};
const HALF_OF_THE_WORK: f64 = 140.0;
/// One arm of scenes/t-peel.toml, its work and its strength.
const FILM: Strip = Strip {
    length: 1.5e7,
    height: 7.5e4,
    width: 2.5e7,
    material: Material::of(3.5, 0.35),
    crack: Some(5e6),
    layers: None,
};
const FILM_WORK: f64 = 100.0;
const FILM_STRENGTH: f64 = 0.5;
const NM_PER_MM: f64 = 1e6;
const GPA_PER_MPA: f64 = 1e-3;
const NN_PER_N: f64 = 1e9;

/// The largest forces of double cantilever beams, and the forces of a T-peel.
fn of_cracks() -> Vec<Check> {
    let mut checks: Vec<Check> = read(CRACKS).par_iter().filter_map(peak_of_crack).collect();
    checks.extend(of_films());
    checks
}

/// Forces of a T-peel at the openings of the table.
fn of_films() -> Vec<Check> {
    let found = peeled(FILM, FILM_WORK, FILM_STRENGTH, FollowedUntil::End);
    let one = |row: &Row| {
        let (opening, expected) = (row.number("opening_mm")?, row.number("force_N")?);
        let at = StationAt { quantity: StationQuantity::Displacement, value: NM_PER_MM * opening };
        let force = found.stations(at).found.first().map(|at| at.force / NN_PER_N).ok_or_else(|| missing(&found.end));
        let name = format!("force of a T-peel at the opening of {opening} mm (N)");
        Some(Check::new(name, OF_CRACKS, force, expected, Measure::Relative, GOOD))
    };
    read(FILMS).iter().filter_map(one).collect()
}

fn peak_of_crack(row: &Row) -> Option<Check> {
    let (strength, crack, expected) = (row.number("strength_MPa")?, row.number("crack_mm")?, row.number("peak_N")?);
    let found = of_arm(strength, crack);
    let force = found.peak.as_ref().map(|peak| peak.force / NN_PER_N).ok_or_else(|| missing(&found.end));
    let name = format!("peak of a double cantilever beam, crack of {crack} mm, {strength} MPa (N)");
    Some(Check::new(name, OF_CRACKS, force, expected, Measure::Relative, GOOD))
}

/// The path of a cantilever up to its first jump.
fn of_arm(strength: f64, crack: f64) -> Peel {
    peeled(Strip { crack: Some(NM_PER_MM * crack), ..ARM }, HALF_OF_THE_WORK, strength, FollowedUntil::FirstJump)
}

/// The path of an arm under the exponential law.
fn peeled(arm: Strip, work: f64, strength: f64, until: FollowedUntil) -> Peel {
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        line_load: LineLoad::AxisGap,
        work: Some(work),
        strength: Some(GPA_PER_MPA * strength),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap_or(law.equilibrium_distance);
    let model = PeelModel::of(Body::Strip(arm), Adhesion { equilibrium_distance, ..law }, Grip::FREE);
    let stop = StopCriteria { until, ..StopCriteria::default() };
    peel(&model, &Accuracy::to(GOOD), &stop)
}
