//! The density of the energy out of the plane at one place of the beam.
//!
//! Out of its plane a section may shift along the width by ζ and turn by the vector (ω_x, ω_y, 0). The second
//! variation of the energy is (with c = cos θ, s = sin θ, H and V the horizontal and vertical section force, M the moment)
//!
//!   ½ GA γ² + ½ GJ τ² + ½ EI3 χ² + γ (H ω_y - V ω_x) + ½ V y' ω_x² + ½ H x' ω_y² - H y' ω_x ω_y - M ω_x ω_y'
//!     + ½ (b²Ψ_aa - hΨ_c c) ω_x²,
//!   γ = ω_x y' - ω_y x' - ζ',  τ = c ω_x' + s ω_y',  χ = c ω_y' - s ω_x',
//!
//! where the ends carry no moment. With exp(ω) on the left of the directors, Γ gives the terms with H and V, K gives
//! -½ M (ω_x ω_y' - ω_y ω_x'), of which an integration by parts with M' = H y' - V x' - hΨ_c s takes ω_x' away.
//! ζ is in γ alone where no end holds it: minimising over γ leaves -½ (H ω_y - V ω_x)²/GA of it, and two fields, of
//! which ω_y is held at the left end ([`RollSection::coupled`]).
//!
//! Without H, ω_y is in ω_y' alone. Minimising over that too leaves, exactly, the roll φ = ω_x,
//!
//!   (φ' - βφ)²/2α + ½ κφ²,  α = c²/GJ + s²/EI3,  β = M s c (1/GJ - 1/EI3),
//!   κ = V (y' - V/GA) + b²Ψ_aa - hΨ_c c - M² (s²/GJ + c²/EI3),
//!
//! with natural ends. Ψ (of the width b) is the planar density averaged over the heights y + t a/b, |t| < b/2, of the
//! strips that make up a rolled section, a = b φ: so b²Ψ_aa = (b²/12) Ψ_yy. Ψ_c is its derivative by c_h = h cos θ:
//! -hΨ_c sin θ = Ψ_θ.

use crate::adhesion::section::response::LineResponse;
use crate::beam::element::energy_density::SectionState;
use crate::beam::section::Material;
use crate::beam::torsion::LateralStiffness;
use crate::beam::varying::SectionGeometry;

/// Below this |sin θ| the quotient Ψ_θ/sin θ is taken for its limit Ψ_θθ: products with a smaller number lose digits.
const LEVEL: f64 = 1e-140;

/// A place of the beam in a planar equilibrium, as its roll sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct RollSection {
    width: f64,
    sin: f64,
    cos: f64,
    /// H and V, nN
    horizontal_force: f64,
    vertical_force: f64,
    /// M, nN nm
    moment: f64,
    /// x' and y'
    horizontal_slope: f64,
    vertical_slope: f64,
    /// GA of shear along the width, nN: that of the height
    shear: f64,
    /// b²Ψ_aa, nN
    rolled: f64,
    /// hΨ_c, nN
    lever: f64,
    lateral: LateralStiffness,
}

/// 1/α, β and κ of the module's head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RollDensity {
    /// 1/α, nN nm²
    pub stiffness: f64,
    /// β, 1/nm
    pub drift: f64,
    /// κ, nN
    pub support: f64,
}

/// Of [`RollSection::coupled`].
pub(super) type CoupledDensity = [[f64; 4]; 4];

impl RollSection {
    /// Of the section's outline, its forces, its rotation and the adhesion per width.
    pub(crate) fn new(
        material: &Material,
        outline: &SectionGeometry,
        state: &SectionState,
        [sin, cos]: [f64; 2],
        adhesion: &LineResponse<f64>,
    ) -> Self {
        let (width, height) = (outline.width, outline.height[0]);
        let by_cosine = if sin.abs() > LEVEL { adhesion.by_rotation / sin } else { adhesion.rotation_rotation / cos };
        Self {
            width,
            sin,
            cos,
            horizontal_force: state.horizontal_force,
            vertical_force: state.vertical_force,
            moment: state.moment,
            horizontal_slope: state.horizontal_slope,
            vertical_slope: state.vertical_slope,
            shear: material.section(width, height, outline.roundness).shear,
            rolled: width.powi(3) / 12.0 * adhesion.gap_gap,
            lever: -width * by_cosine,
            lateral: LateralStiffness::of(material, width, height, outline.roundness),
        }
    }

    /// The same section of a straight beam of one section that is `width` wide (nm): its planar equilibrium per width
    /// is the same.
    pub(crate) fn widened(&self, width: f64, lateral: LateralStiffness) -> Self {
        let factor = width / self.width;
        Self {
            width,
            horizontal_force: factor * self.horizontal_force,
            vertical_force: factor * self.vertical_force,
            moment: factor * self.moment,
            shear: factor * self.shear,
            rolled: factor.powi(3) * self.rolled,
            lever: factor * self.lever,
            lateral,
            ..*self
        }
    }

    /// The matrix of twice the density in (ω_x, ω_x', ω_y, ω_y'), with a horizontal force.
    pub(crate) fn coupled(&self) -> CoupledDensity {
        let (s, c, m) = (self.sin, self.cos, self.moment);
        let (horizontal, vertical) = (self.horizontal_force, self.vertical_force);
        let stiff = [
            (self.lateral.torsion, [0.0, c, 0.0, s]),
            (self.lateral.bending, [0.0, -s, 0.0, c]),
            (-1.0 / self.shear, [-vertical, 0.0, horizontal, 0.0]),
        ];
        let mut matrix = [[0.0; 4]; 4];
        for (factor, form) in stiff {
            for i in 0..4 {
                for j in 0..4 {
                    matrix[i][j] += factor * form[i] * form[j];
                }
            }
        }
        matrix[0][0] += vertical * self.vertical_slope + self.rolled - self.lever * c;
        matrix[2][2] += horizontal * self.horizontal_slope;
        for (i, j, mixed) in [(0, 2, -horizontal * self.vertical_slope), (0, 3, -m)] {
            matrix[i][j] += mixed;
            matrix[j][i] += mixed;
        }
        matrix
    }

    /// The density of the roll's energy.
    pub(crate) fn density(&self) -> RollDensity {
        let (s, c, v, m) = (self.sin, self.cos, self.vertical_force, self.moment);
        let (twist, bend) = (1.0 / self.lateral.torsion, 1.0 / self.lateral.bending);
        RollDensity {
            stiffness: 1.0 / (c * c * twist + s * s * bend),
            drift: m * s * c * (twist - bend),
            support: v * (self.vertical_slope - v / self.shear) + self.rolled
                - self.lever * c
                - m * m * (s * s * twist + c * c * bend),
        }
    }
}
