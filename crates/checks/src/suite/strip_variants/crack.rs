//! Double cantilever beams with an initial crack, against a boundary value problem and fracture mechanics.

use crate::suite::check::{Check, Measure, missing};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::{Attraction, CohesiveShape, LineLoad};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Strip};
use peelkit::study::{Accuracy, FollowedUntil, Peel, StopCriteria, peel};
use rayon::prelude::*;

const TABLE: &str = include_str!("../../../verification/double_cantilever.csv");
const SOURCE: &str = "verification/double_cantilever.py: boundary value problem";
/// The table is good to this.
const GOOD: f64 = 1e-7;

/// mm, MPa and N/mm in nm, GPa and J/m²; the shear modulus of 5.2 GPa by the shear correction.
const ARM: Strip = Strip {
    length: 1e8,
    height: 1.5e6,
    width: 2e7,
    material: Material { shear_correction: 5.0 / 6.0 * 5.2 / (135.3 / 2.48), ..Material::of(135.3, 0.24) },
    crack: None,
};
const HALF_OF_THE_WORK: f64 = 140.0;
const NM_PER_MM: f64 = 1e6;
const GPA_PER_MPA: f64 = 1e-3;
const NN_PER_N: f64 = 1e9;

/// The largest forces of the table; under ever stronger interfaces that of fracture mechanics.
pub(super) fn checks() -> Vec<Check> {
    read(TABLE).par_iter().filter_map(peak).collect()
}

fn peak(row: &Row) -> Option<Check> {
    let (strength, crack, expected) = (row.number("strength_MPa")?, row.number("crack_mm")?, row.number("peak_N")?);
    let found = of_arm(strength, crack);
    let force = found.peak.as_ref().map(|peak| peak.force / NN_PER_N).ok_or_else(|| missing(&found.end));
    let name = format!("peak of a double cantilever beam, crack of {crack} mm, {strength} MPa (N)");
    Some(Check::new(name, SOURCE, force, expected, Measure::Relative, GOOD))
}

/// The path of an arm up to its first jump.
fn of_arm(strength: f64, crack: f64) -> Peel {
    let law = Adhesion {
        attraction: Attraction::Cohesive(CohesiveShape::Exponential),
        line_load: LineLoad::AxisGap,
        work: Some(HALF_OF_THE_WORK),
        strength: Some(GPA_PER_MPA * strength),
        ..Adhesion::default()
    };
    let equilibrium_distance = law.distance_of_work_and_strength().unwrap_or(law.equilibrium_distance);
    let arm = Strip { crack: Some(NM_PER_MM * crack), ..ARM };
    let model = PeelModel::of(Body::Strip(arm), Adhesion { equilibrium_distance, ..law }, Grip::FREE);
    let stop = StopCriteria { until: FollowedUntil::FirstJump, ..StopCriteria::default() };
    peel(&model, &Accuracy::to(GOOD), &stop)
}
