//! Strips under other laws of adhesion against collocation, and their steady force against the work of adhesion.

use super::crack;
use super::turns::Turns;
use crate::suite::check::{Check, Measure, Topic, missing};
use peelkit::adhesion::CohesiveShape;
use peelkit::analytic::kendall_force;
use peelkit::model::{Attraction, PeelModel, StripModel};
use peelkit::study::{Accuracy, StopCriteria, peel};
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "laws",
    about: "other laws of adhesion, with a shear strength too: collocation, steady force of those with a potential, initial cracks",
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
        ("grip_rotation", "rotation ", ""),
        ("grip_across", "normal to the pull ", ""),
        ("bending_stiffness_factor", "EI × ", ""),
        ("pull_angle_deg", "", " degrees"),
        ("length_nm", "L = ", " nm"),
    ],
};
/// Length of the strips that peel steadily, nm.
const LONG: f64 = 1000.0;
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);

fn checks() -> Vec<Check> {
    let mut checks = TABLE.checks();
    checks.extend(SHEARED.checks());
    checks.extend(CohesiveShape::ALL.par_iter().map(|&shape| steady(shape)).collect::<Vec<_>>());
    checks.extend(crack::checks());
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
