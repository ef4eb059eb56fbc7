//! What is written of the beam at each place: one list for the table and for the picture files.

use peelkit::study::{SectionFields, SpatialSectionFields};

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

const fn field<S>(name: &'static str, about: &'static str, value: fn(&S) -> f64) -> StateField<S> {
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

// -- What is written of a beam in space at each place --

/// All fields in space, in the order of the columns. The loads are those that the beam exerts on the ground.
#[rustfmt::skip]
pub const SPATIAL_STATE_FIELDS: &[StateField<SpatialSectionFields>] = &[
    field("S_nm", "arc length along the stress-free axis, from the free end", |at| at.state.section.arc_length),
    field("x_nm", "place of the axis along the strip at rest", |at| at.state.section.place[0]),
    field("y_nm", "height of the axis above the ground", |at| at.state.section.place[1]),
    field("z_nm", "place of the axis sideways", |at| at.state.section.place[2]),
    field("d1_x", "director d1, normal to the section, along x", |at| at.state.section.directors[0][0]),
    field("d1_y", "the same along y", |at| at.state.section.directors[0][1]),
    field("d1_z", "the same along z", |at| at.state.section.directors[0][2]),
    field("d2_x", "director d2, along the width, along x; at rest it is -z", |at| at.state.section.directors[1][0]),
    field("d2_y", "the same along y", |at| at.state.section.directors[1][1]),
    field("d2_z", "the same along z", |at| at.state.section.directors[1][2]),
    field("d3_x", "director d3, along the height, along x; at rest it is y", |at| at.state.section.directors[2][0]),
    field("d3_y", "the same along y", |at| at.state.section.directors[2][1]),
    field("d3_z", "the same along z", |at| at.state.section.directors[2][2]),
    field("N_nN", "section force along d1, positive in tension", |at| at.state.section.force[0]),
    field("Q2_nN", "shear force along d2, the width", |at| at.state.section.force[1]),
    field("Q3_nN", "shear force along d3, the height", |at| at.state.section.force[2]),
    field("T_nN_nm", "torsional moment about d1", |at| at.state.section.moment[0]),
    field("M2_nN_nm", "bending moment about d2, the width; in the plane it is -M", |at| at.state.section.moment[1]),
    field("M3_nN_nm", "bending moment about d3, the height", |at| at.state.section.moment[2]),
    field("twist_per_nm", "twist, less that of the stress-free beam", |at| at.state.curvature[0]),
    field("kappa2_per_nm", "curvature about d2, less that of the stress-free beam", |at| at.state.curvature[1]),
    field("kappa3_per_nm", "curvature about d3, less that of the stress-free beam", |at| at.state.curvature[2]),
    field("gap_nm", "distance of the lowest point of the section from the ground", |at| at.gap),
    field("line_force_x_nN_per_nm", "attraction per length T_c along x; zero on flat ground", |at| at.state.line_force[0]),
    field("line_force_y_nN_per_nm", "the same along y, ∂Ψ/∂y, below zero where the ground repels; its integral is the vertical force of the grip", |at| at.state.line_force[1]),
    field("line_force_z_nN_per_nm", "the same along z; zero on flat ground", |at| at.state.line_force[2]),
    field("line_moment_x_nN", "moment of the adhesion per length M_c about x, (b Ψ_a d2 + h Ψ_c d3) × y", |at| at.state.line_moment[0]),
    field("line_moment_y_nN", "the same about y; zero on flat ground", |at| at.state.line_moment[1]),
    field("line_moment_z_nN", "the same about z", |at| at.state.line_moment[2]),
    field("line_moment_d1_nN", "the same about d1: what twists", about_axis),
    field("adhesion_energy_aJ_per_nm", "adhesion energy per length, Ψ", |at| at.state.adhesion),
    field("stored_energy_aJ_per_nm", "elastic energy per length", |at| at.state.stored),
    field("width_nm", "width b of the section", |at| at.state.section.width),
    field("height_nm", "height h of the section", |at| at.state.section.height),
    field("weight_nm", "weight of the quadrature along S: the sum of weight times field is the integral of the field; zero where elements end", |at| at.weight),
];

fn about_axis(at: &SpatialSectionFields) -> f64 {
    (0..3).map(|i| at.state.section.directors[0][i] * at.state.line_moment[i]).sum()
}

/// Vectors of the files for ParaView: their names, and those of the fields that are their components.
pub(super) const VECTORS: [(&str, [&str; 3]); 5] = [
    ("d1", ["d1_x", "d1_y", "d1_z"]),
    ("d2", ["d2_x", "d2_y", "d2_z"]),
    ("d3", ["d3_x", "d3_y", "d3_z"]),
    ("line_force_nN_per_nm", ["line_force_x_nN_per_nm", "line_force_y_nN_per_nm", "line_force_z_nN_per_nm"]),
    ("line_moment_nN", ["line_moment_x_nN", "line_moment_y_nN", "line_moment_z_nN"]),
];
