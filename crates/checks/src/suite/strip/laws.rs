//! Strips under other laws of adhesion against collocation, and their steady force against the work of adhesion.

use crate::check::{Check, Measure, Topic, missing};
use crate::suite::reference::{Row, read};
use crate::suite::strip::turns::Turns;
use peelkit::adhesion::{CohesiveShape, LineLoad};
use peelkit::analytic::kendall_force;
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Attraction, Body, Grip, PeelModel, Step, Strip, StripModel};
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
        ("mixing_exponent", "η = ", ""),
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
const UNHEALED: &str = include_str!("../../../verification/unhealed.csv");
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
    checks.extend(of_ways_back());
    checks
}

/// Forces of arms that do not heal, opened and brought back a way: the rows of one arm follow each other.
fn of_ways_back() -> Vec<Check> {
    let rows = read(UNHEALED);
    let arm = |row: &Row| ["length_mm", "strength_MPa", "crack_mm", "opened_mm"].map(|column| row.number(column));
    let arms: Vec<&[Row]> = rows.chunk_by(|a, b| arm(a) == arm(b)).collect();
    arms.par_iter().flat_map_iter(|rows| of_way_back(rows).unwrap_or_default()).collect()
}

fn of_way_back(rows: &[Row]) -> Option<Vec<Check>> {
    let openings: Vec<f64> = rows.iter().map(|row| row.number("opening_mm")).collect::<Option<_>>()?;
    let (strength, crack) = (rows[0].number("strength_MPa")?, rows[0].number("crack_mm")?);
    let is_film = rows[0].number("length_mm")? * NM_PER_MM == FILM.length;
    let (strip, work) = if is_film { (FILM, FILM_WORK) } else { (ARM, HALF_OF_THE_WORK) };
    let mut model = of_strip(Strip { crack: Some(NM_PER_MM * crack), ..strip }, work, strength);
    (model.adhesion.healing, model.adhesion.line_load) = (false, LineLoad::Full);
    let back = openings.windows(2).map(|pair| Step::Press(NM_PER_MM * (pair[0] - pair[1])));
    model.steps = [Step::Lift(NM_PER_MM * openings[0])].into_iter().chain(back).collect();
    let found = peel(&model, &Accuracy::to(GOOD), &StopCriteria::after_points(2));
    let kind = if is_film { "T-peel" } else { "double cantilever beam" };
    let one = |(index, row): (usize, &Row)| {
        let force = found.steps.get(index).map(|grip| grip.forces.vertical / NN_PER_N);
        let name = format!(
            "force of a {kind} that does not heal, {strength} MPa, opened to {} mm, at {} mm (N)",
            openings[0], openings[index]
        );
        let expected = row.number("force_N")?;
        Some(Check::new(name, OF_CRACKS, force.ok_or_else(|| missing(&found.end)), expected, Measure::Relative, GOOD))
    };
    Some(rows.iter().enumerate().filter_map(one).collect())
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
    let stop = StopCriteria { until, ..StopCriteria::default() };
    peel(&of_strip(arm, work, strength), &Accuracy::to(GOOD), &stop)
}

/// An arm under the exponential law, whose load does not depend on its rotation.
fn of_strip(arm: Strip, work: f64, strength: f64) -> PeelModel {
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        line_load: LineLoad::AxisGap,
        work: Some(work),
        strength: Some(GPA_PER_MPA * strength),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap_or(law.equilibrium_distance);
    PeelModel::of(Body::Strip(arm), Adhesion { equilibrium_distance, ..law }, Grip::FREE)
}
