//! What is said of a model and of its terms, as objects of summary.json.

use super::located::finite;
use crate::writing::record::{Fields, Record};
use peelkit::model::{DerivedOfSection, DerivedQuantities, DimensionlessGroups};
use peelkit::study::{
    Contact, KeptReason, LeftOut, SMALLEST_RADIUS, Sliding, Term, TermDecisions, TermEffect, Warning, Yielded,
};

impl Record for DerivedQuantities {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("work_of_adhesion_J_per_m2", "w of the law: that of the half space, or that of a cohesive law", |model| finite(model.work_of_adhesion));
        of.field("strength_GPa", "largest traction σ of the law", |model| model.strength.and_then(finite));
        of.field("equilibrium_gap_nm", "gap of a flat face at rest", |model| finite(model.equilibrium_gap));
        of.field("work_of_adhesion_of_section_J_per_m2", "w of this section: less what the attraction of the upper surface takes off. Kendall's force and the groups are made of this one", |model| of_section(model, |section| section.work_of_adhesion));
        of.field("kendall_force_nN", "steady force of a film that is bonded without slip, P²/(2 E h b²) + (P/b)(1 - cos φ) = w at the angle φ of the pull to the strip, or that of its strip.stretch", |model| of_section(model, |section| section.kendall_force));
        of.field("sliding_force_nN", "steady force of a film that slides along the substrate without friction, P² sin² φ/(2 E h b²) + (P/b)(1 - cos φ) = w; null in space", |model| model.section.as_ref()?.sliding_force.and_then(finite));
        of.field("kendall_force_in_shear_nN", "with `adhesion.shear_work`: kendall_force_nN with that work; a long strip peels between the two", |model| model.section.as_ref()?.kendall_force_in_shear.and_then(finite));
        of.field("axial_stiffness_EA_nN", "EA", |model| of_section(model, |section| section.stiffness.axial));
        of.field("shear_stiffness_GAs_nN", "GA_s", |model| of_section(model, |section| section.stiffness.shear));
        of.field("bending_stiffness_EI_nN_nm2", "EI", |model| of_section(model, |section| section.stiffness.bending));
        of.field("neutral_axis_nm", "height of the axis above the adhering face at rest: half of the height, but of layers", |model| of_section(model, |section| section.neutral_axis));
        of.field("process_length_nm", "length ℓ of the process zone: the lesser of (EI/k)^(1/4) and 3 (GA_s/k)^(1/2), k the stiffness of the adhesion at rest", |model| of_section(model, |section| section.process_length));
        of.field("shear_lag_length_nm", "(EA/(b k))^(1/2), over which a force along the substrate goes over into it, k the stiffness there; null where the strip slides freely", |model| model.section.as_ref()?.shear_lag_length.and_then(finite));
        of.field("elasto_adhesive_length_nm", "(EI/(w b))^(1/2)", |model| of_section(model, |section| section.elasto_adhesive_length));
        of.group("groups", "dimensionless groups", |of| {
            of.field("length_over_height", "L/h", |model| group(model, |groups| groups.length_over_height));
            of.field("length_over_process_length", "L/ℓ", |model| group(model, |groups| groups.length_over_process_length));
            of.field("process_length_over_height", "ℓ/h; below 1 there is the warning short-process-zone", |model| group(model, |groups| groups.process_length_over_height));
            of.field("bending_over_adhesion", "EI/(w b ℓ²)", |model| group(model, |groups| groups.bending_over_adhesion));
            of.field("bending_over_adhesion_of_length", "EI/(w b L²)", |model| group(model, |groups| groups.bending_over_adhesion_of_length));
            of.field("bending_over_shear", "EI/(GA_s ℓ²)", |model| group(model, |groups| groups.bending_over_shear));
            of.field("adhesion_over_stretching", "w/(E h)", |model| group(model, |groups| groups.adhesion_over_stretching));
            of.field("strength_over_modulus", "σ/E", |model| model.section.as_ref()?.groups.strength_over_modulus.and_then(finite));
        });
    }
}

fn of_section(model: &DerivedQuantities, number: fn(&DerivedOfSection) -> f64) -> Option<f64> {
    model.section.as_ref().map(number).and_then(finite)
}

fn group(model: &DerivedQuantities, number: fn(&DimensionlessGroups) -> f64) -> Option<f64> {
    model.section.as_ref().map(|section| number(&section.groups)).and_then(finite)
}

impl Record for Warning {
    fn fields(of: &mut Fields<Self>) {
        of.field("code", "a word that stays the same, for programs", |warning| warning.kind.code());
        of.field("value", "the number that is beyond the limit", |warning| warning.value);
        of.field("limit", "the limit", |warning| warning.limit);
        of.field("meaning", "both in a sentence", |warning| warning.to_string());
    }
}

impl Record for TermEffect {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("left_out", "the term: far face, contact moment, shear or extension", |effect| effect.term.word());
        of.field("initiation_peak_change_nN", "by how much the initiation peak would change", |effect| effect.force);
    }
}

impl Record for TermDecisions {
    fn fields(of: &mut Fields<Self>) {
        of.field("left_out", "the neglected terms", |considered| considered.left_out.as_slice());
        of.field("kept", "the others", |considered| considered.kept.iter().map(Kept).collect::<Vec<_>>());
    }
}

impl Record for LeftOut {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("term", "its name", |left| left.term.word());
        of.field("initiation_peak_change_nN", "estimate of what it would change the initiation peak by", |left| left.force);
        of.field("initiation_peak_change_nm", "estimate of how far it would move it", |left| left.displacement);
        of.field("largest_relative_change", "the largest relative change of any result", |left| left.largest);
    }
}

/// A term that was not left out, and why.
struct Kept<'a>(&'a (Term, KeptReason));

impl Record for Kept<'_> {
    fn fields(of: &mut Fields<Self>) {
        of.field("term", "its name", |kept| kept.0.0.word());
        of.field("why", "why it was kept", |kept| why_kept(&kept.0.1));
    }
}

/// Why a term was not left out, in words.
pub fn why_kept(why: &KeptReason) -> String {
    match why {
        KeptReason::Matters(share) => format!("neglecting it would change a result by {share:.1e}, relative"),
        KeptReason::NothingSaved => "neglecting it would not reduce the computational cost".into(),
        KeptReason::NotEstimated(why) => format!("its effect was not estimated: {why}"),
    }
}

/// How a beam lies on ground that is not flat where the path begins, and the largest force of the whole path.
pub(super) struct Ground {
    pub contact: Contact,
    pub largest_force: Option<f64>,
}

impl Record for Ground {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("adhered_fraction", "length nearer than 2 r0, over that of the same beam on flat ground", |ground| ground.contact.adhered_fraction);
        of.field("energy_fraction", "adhesion energy, likewise", |ground| ground.contact.energy_fraction);
        of.field("least_gap_nm", "smallest gap", |ground| ground.contact.least_gap);
        of.field("largest_gap_nm", "largest gap of what lies on the ground", |ground| ground.contact.largest_gap);
        of.field("reach", "penetration into the valleys, over their depth", |ground| ground.contact.penetration);
        of.field("crest_radius_nm", "smallest radius of a crest in contact", |ground| ground.contact.crest_radius);
        of.field("valley_radius_nm", "smallest radius of a valley in contact", |ground| ground.contact.valley_radius);
        of.field("crest_traction_error", "relative error of the half space on that crest, at the largest traction", |ground| ground.contact.crest_error);
        of.field("valley_traction_error", "the same in that valley", |ground| ground.contact.valley_error);
        of.field("largest_force_nN", "largest force of the whole path", |ground| ground.largest_force);
        of.field("warning", "that a radius is below 8 nm, else null", |ground| ground_warning(&ground.contact));
    }
}

/// What to be warned of: ground too sharp for the half space of eq. (9).
pub fn ground_warning(contact: &Contact) -> Option<String> {
    contact.sharp().map(|radius| {
        let worst = [contact.crest_error, contact.valley_error].into_iter().flatten().fold(0.0, |worst: f64, error| worst.max(error.abs()));
        format!(
            "the ground has a radius of curvature of {radius:.2} nm where the beam adheres, less than the {SMALLEST_RADIUS} nm down to which \
             the half space is a good approximation; its traction is wrong by about {:.1} % there",
            100.0 * worst
        )
    })
}

impl Record for Yielded {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("plastic_work_aJ", "work that yielding has left in the film since rest", |yielded| yielded.work);
        of.sometimes("plastic_work_J_per_m2", "the same of a unit of area that peels, over the process zone before", |yielded| yielded.work_per_area);
        of.field("yielded_length_nm", "length that has yielded", |yielded| yielded.length);
        of.field("largest_curvature_over_elastic", "largest curvature that a section has had, over that at which its surfaces yield", |yielded| yielded.largest_curvature);
        of.field("axial_force_over_yield", "largest axial force over that at which the whole section yields", |yielded| yielded.axial_share);
        of.field("permanent_stretch", "largest stretch that stays in the film when it is unloaded, as a strain", |yielded| yielded.permanent_stretch);
    }
}

impl Record for Sliding {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("free_end_displacement_nm", "how far the free end has moved", |sliding| sliding.free_end);
        of.field("friction_force_nN", "sum of the friction along the beam", |sliding| sliding.force);
        of.field("largest_friction_force_nN", "the most that it could be", |sliding| sliding.capacity);
        of.field("contact_length_nm", "length in contact", |sliding| sliding.contact);
        of.field("sliding_length_nm", "how much of it slides", |sliding| sliding.sliding);
        of.field("dissipated_aJ", "work that friction has dissipated", |sliding| sliding.dissipated);
    }
}
