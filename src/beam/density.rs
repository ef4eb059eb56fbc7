//! What an element integrates: an energy density along the axis and its first and second derivatives.

/// Response at one point of the axis to F fields, their slopes along S and one number that is the same along the whole
/// chain (the border; the horizontal force of a held grip, say). Per length.
#[derive(Clone, Copy, Debug)]
pub struct PointResponse<const F: usize> {
    /// Energy density φ, nN
    pub energy: f64,
    /// Its share from adhesion, nN
    pub adhesion: f64,
    /// ∂φ/∂field
    pub by_value: [f64; F],
    /// ∂φ/∂field'
    pub by_slope: [f64; F],
    /// ∂²φ/∂field∂field (rows: the equation, columns: the unknown)
    pub value_value: [[f64; F]; F],
    /// ∂²φ/∂field∂field'
    pub value_slope: [[f64; F]; F],
    /// ∂²φ/∂field'∂field
    pub slope_value: [[f64; F]; F],
    /// ∂²φ/∂field'∂field'
    pub slope_slope: [[f64; F]; F],
    /// ∂(adhesion)/∂field: what the path parameter needs
    pub adhesion_by_value: [f64; F],
    /// ∂φ/∂border
    pub by_border: f64,
    /// ∂²φ/∂border²
    pub border_border: f64,
    /// ∂²φ/∂border∂field
    pub border_value: [f64; F],
    /// ∂²φ/∂border∂field'
    pub border_slope: [f64; F],
}

impl<const F: usize> PointResponse<F> {
    /// All zero.
    pub const ZERO: Self = Self {
        energy: 0.0,
        adhesion: 0.0,
        by_value: [0.0; F],
        by_slope: [0.0; F],
        value_value: [[0.0; F]; F],
        value_slope: [[0.0; F]; F],
        slope_value: [[0.0; F]; F],
        slope_slope: [[0.0; F]; F],
        adhesion_by_value: [0.0; F],
        by_border: 0.0,
        border_border: 0.0,
        border_value: [0.0; F],
        border_slope: [0.0; F],
    };
}

/// Section forces and stretch of the axis at one point, from the unknowns alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionState {
    /// x' of the axis
    pub horizontal_slope: f64,
    /// y' of the axis
    pub vertical_slope: f64,
    /// Horizontal section force H, nN
    pub horizontal_force: f64,
    /// Vertical section force V, nN
    pub vertical_force: f64,
    /// Bending moment M, nN·nm
    pub moment: f64,
    /// κ = θ', 1/nm
    pub curvature: f64,
    /// Stored energy, nN
    pub stored: f64,
}

impl SectionState {
    /// H x' + V y' + M θ' - stored, nN. Less the adhesion energy bΨ it is constant along a uniform beam in equilibrium
    /// whose load has a potential: the first integral.
    pub fn eshelby(&self) -> f64 {
        self.horizontal_force * self.horizontal_slope
            + self.vertical_force * self.vertical_slope
            + self.moment * self.curvature
            - self.stored
    }
}

/// A beam with its line load, as an energy density of F fields.
pub trait Density<const F: usize>: Send + Sync {
    /// The density and its derivatives.
    fn response(&self, value: [f64; F], slope: [f64; F], border: f64) -> PointResponse<F>;

    /// Section forces and stretch.
    fn section_state(&self, value: [f64; F], slope: [f64; F], border: f64) -> SectionState;

    /// The same section where its vertical force and moment are known instead of the slopes (at a node between two
    /// elements, where the nodal forces are far more accurate than the slopes).
    fn section_state_from_forces(&self, value: [f64; F], forces: [f64; F], border: f64) -> SectionState;
}
