//! What follows from the model before anything is solved, as an object of summary.json.

use crate::number::Finite;
use peelkit::model::{DerivedOfSection, DerivedQuantities, DimensionlessGroups, PeelModel};
use serde::Serialize;

/// The object `derived`; `None` where a body has no single value. Units stand in the names, the groups have none.
#[derive(Debug, Serialize)]
pub(super) struct DerivedSummary {
    #[serde(rename = "work_of_adhesion_J_per_m2")]
    work_of_adhesion: Option<Finite>,
    #[serde(rename = "strength_GPa")]
    strength: Option<Finite>,
    equilibrium_gap_nm: Option<Finite>,
    #[serde(rename = "work_of_adhesion_of_section_J_per_m2")]
    work_of_adhesion_of_section: Option<Finite>,
    #[serde(rename = "kendall_force_nN")]
    kendall_force: Option<Finite>,
    #[serde(rename = "sliding_force_nN")]
    sliding_force: Option<Finite>,
    #[serde(rename = "axial_stiffness_EA_nN")]
    axial_stiffness: Option<Finite>,
    #[serde(rename = "shear_stiffness_GAs_nN")]
    shear_stiffness: Option<Finite>,
    #[serde(rename = "bending_stiffness_EI_nN_nm2")]
    bending_stiffness: Option<Finite>,
    process_length_nm: Option<Finite>,
    elasto_adhesive_length_nm: Option<Finite>,
    groups: Groups,
}

#[derive(Debug, Serialize)]
struct Groups {
    length_over_height: Option<Finite>,
    length_over_process_length: Option<Finite>,
    process_length_over_height: Option<Finite>,
    /// EI/(w b ℓ²)
    bending_over_adhesion: Option<Finite>,
    /// EI/(w b L²)
    bending_over_adhesion_of_length: Option<Finite>,
    /// EI/(GA_s ℓ²)
    bending_over_shear: Option<Finite>,
    /// w/(E h)
    adhesion_over_stretching: Option<Finite>,
    /// σ/E
    strength_over_modulus: Option<Finite>,
}

impl DerivedSummary {
    pub fn of(model: &PeelModel) -> Self {
        let DerivedQuantities { work_of_adhesion, strength, equilibrium_gap, section } = model.derived();
        let known = |of: fn(&DerivedOfSection) -> f64| number(section.as_ref().map(of));
        let group = |of: fn(&DimensionlessGroups) -> f64| number(section.as_ref().map(|section| of(&section.groups)));
        Self {
            work_of_adhesion: number(Some(work_of_adhesion)),
            strength: number(strength),
            equilibrium_gap_nm: number(Some(equilibrium_gap)),
            work_of_adhesion_of_section: known(|section| section.work_of_adhesion),
            kendall_force: known(|section| section.kendall_force),
            sliding_force: number(section.as_ref().and_then(|section| section.sliding_force)),
            axial_stiffness: known(|section| section.stiffness.axial),
            shear_stiffness: known(|section| section.stiffness.shear),
            bending_stiffness: known(|section| section.stiffness.bending),
            process_length_nm: known(|section| section.process_length),
            elasto_adhesive_length_nm: known(|section| section.elasto_adhesive_length),
            groups: Groups {
                length_over_height: group(|groups| groups.length_over_height),
                length_over_process_length: group(|groups| groups.length_over_process_length),
                process_length_over_height: group(|groups| groups.process_length_over_height),
                bending_over_adhesion: group(|groups| groups.bending_over_adhesion),
                bending_over_adhesion_of_length: group(|groups| groups.bending_over_adhesion_of_length),
                bending_over_shear: group(|groups| groups.bending_over_shear),
                adhesion_over_stretching: group(|groups| groups.adhesion_over_stretching),
                strength_over_modulus: number(section.and_then(|section| section.groups.strength_over_modulus)),
            },
        }
    }
}

/// A number that there is: an absurd model may overflow one, which is then not there.
fn number(value: Option<f64>) -> Option<Finite> {
    value.filter(|value| value.is_finite()).map(Finite)
}
