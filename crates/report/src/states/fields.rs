//! What is written of the beam at each place: one list for the table and for the picture files.

use peelkit::study::SectionFields;

/// A field along the beam: a column of states.csv and an array of the files for ParaView. `S` is the beam at one place, in the plane or in
/// space.
pub struct StateField<S = SectionFields> {
    /// With its unit
    pub name: &'static str,
    /// What it is
    pub about: &'static str,
    /// Of a place of the beam, in the unit of the name
    pub value: fn(&S) -> f64,
}

pub(super) const fn field<S>(name: &'static str, about: &'static str, value: fn(&S) -> f64) -> StateField<S> {
    StateField { name, about, value }
}

/// All fields in the plane, in the order of the columns. The loads are those that the beam exerts on the ground.
pub const STATE_FIELDS: &[StateField] = &[
    field("S_nm", "arc length along the stress-free axis, from the free end", |at| at.place),
    field("x_nm", "place of the axis along the ground", |at| at.x),
    field("y_nm", "height of the axis above the ground", |at| at.y),
    field("theta_rad", "rotation θ of the section, anticlockwise", |at| at.rotation),
    field("N_nN", "section force N normal to the section, positive in tension", |at| at.normal_force),
    field("Q_nN", "shear force Q along the section", |at| at.shear_force),
    field("M_nN_nm", "bending moment M = EI κ", |at| at.moment),
    field("kappa_per_nm", "curvature κ = θ', less that of the stress-free axis", |at| at.curvature),
    field("gap_nm", "distance of the nearer edge of the section from the ground", |at| at.gap),
    field(
        "line_force_nN_per_nm",
        "attraction per length b ∂Ψ/∂y, below zero where the ground repels; its integral is P of a pull straight up",
        |at| at.line_force,
    ),
    field("line_force_x_nN_per_nm", "the same along x, b ∂Ψ/∂x; zero on flat ground", |at| at.line_force_along),
    field("line_moment_nN", "moment of the adhesion per length, b ∂Ψ/∂θ", |at| at.line_moment),
    field("friction_traction_GPa", "traction of friction on the ground, positive along x", |at| at.friction_traction),
    field("adhesion_energy_aJ_per_nm", "adhesion energy per length, bΨ", |at| at.adhesion_energy),
    field("stored_energy_aJ_per_nm", "elastic energy per length", |at| at.stored_energy),
    field("width_nm", "adhering width b of the section", |at| at.width),
    field("height_nm", "height h of the section", |at| at.height),
    field(
        "weight_nm",
        "weight of the quadrature along S: the sum of weight times field is the integral of the field; zero where elements end",
        |at| at.weight,
    ),
];
