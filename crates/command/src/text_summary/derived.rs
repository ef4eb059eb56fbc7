//! What follows from a model before anything is solved, for a person.

use super::number::short;
use super::units::{Units, fitting_text};
use peelkit::model::DerivedQuantities;
use peelkit::units::{BENDING_STIFFNESSES, LENGTHS, PRESSURES};
use peelkit_scene::Scene;
use std::f64::consts::FRAC_PI_2;

/// What a steady peel would take, and what kind of a strip this is; of a body whose section varies the work of adhesion alone.
pub fn derived(scene: &Scene, units: &Units) -> Vec<(&'static str, String)> {
    let DerivedQuantities { work_of_adhesion, section, .. } = scene.model.derived();
    let Some(section) = section else {
        return vec![("adhesion", format!("work of adhesion {} J/m²", short(work_of_adhesion)))];
    };
    let model = &scene.model;
    let angle = model.angle_to_strip().to_degrees();
    let groups = section.groups;
    let (kendall, slides) = (units.force.short(section.kendall_force), section.sliding_force);
    // straight up both films are the same one
    let slides = slides.filter(|_| model.pull.angle != FRAC_PI_2).map(|force| units.force.short(force));
    let bonded = if slides.is_some() { ", for a film bonded without slip" } else { "" };
    let distance = model.adhesion.equilibrium_distance;
    let is_supplied = model.adhesion.distance_of_work_and_strength() == Some(distance);
    let mut lines = vec![(
        "adhesion",
        format!(
            "work of adhesion {} J/m², Kendall's force at {} degrees {kendall}{bonded}",
            short(section.work_of_adhesion),
            short(angle),
        ),
    )];
    let measured = model.adhesion.attraction.table().map(|table| {
        format!(
            "measured law: {} rows, strength {}, up to an opening of {}",
            table.rows(),
            fitting_text(PRESSURES, table.strength()),
            fitting_text(LENGTHS, table.range())
        )
    });
    lines.extend(measured.map(|text| ("", text)));
    lines.extend(slides.map(|force| ("", format!("for a film that slides without friction {force}"))));
    let supplied =
        || format!("equilibrium distance {}, a tenth of work over strength", fitting_text(LENGTHS, distance));
    lines.extend(is_supplied.then(|| ("", supplied())));
    let held = section.shear_lag_length.filter(|_| model.adhesion.shear_strength.is_some());
    let held = held.map(|length| {
        format!("the adhesive holds along the substrate, shear lag length {}", fitting_text(LENGTHS, length))
    });
    let is_free = held.is_none() && model.friction_law().is_none() && model.angle_to_strip() != FRAC_PI_2;
    lines.extend(held.map(|text| ("shear", text)));
    let tough = model.adhesion.shear_work.zip(section.kendall_force_in_shear).map(|(work, force)| {
        format!("slip takes {} J/m²; with that Kendall's force is {}", short(work), units.force.short(force))
    });
    lines.extend(tough.map(|text| ("", text)));
    lines.extend(is_free.then(|| ("friction", "none: what is bonded slides along the substrate".to_owned())));
    lines.extend([(
        "strip",
        format!(
            "process zone {}, ℓ/h = {}, L/ℓ = {}; EI = {}",
            units.length.short(section.process_length),
            short(groups.process_length_over_height),
            short(groups.length_over_process_length),
            fitting_text(BENDING_STIFFNESSES, section.stiffness.bending)
        ),
    )]);
    let layers = model.strip().and_then(|strip| strip.layers).map(|layers| {
        format!(
            "{}, {} thick; neutral axis {} above the adhering face",
            layers.layers().len(),
            fitting_text(LENGTHS, layers.thickness()),
            fitting_text(LENGTHS, layers.axis())
        )
    });
    lines.extend(layers.map(|text| ("layers", text)));
    lines
}
