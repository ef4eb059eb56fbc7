//! A compressible neo-Hookean material in space, at finite strain.
//!
//!   W = μ/2 (F:F - 3) - μ ln J + Λ/2 ln² J,   P = ∂W/∂F = μ F + c F⁻ᵀ,   c = Λ ln J - μ,
//!
//! with Lamé's constants μ = E/2(1+ν) and Λ = Eν/((1+ν)(1-2ν)), GPa.

/// A vector or a row of a matrix in space.
pub(super) type Vector = [f64; 3];

/// Lamé's constants, GPa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NeoHookean {
    /// μ
    pub shear: f64,
    /// Λ
    pub first: f64,
}

/// What a material point says at a displacement gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PointResponse {
    /// W, aJ/nm³
    pub energy: f64,
    /// F⁻ᵀ, row by row: it takes gradients by the reference into those by the present place
    pub inverse: [Vector; 3],
    /// c = Λ ln J - μ, GPa
    pub pressure: f64,
}

impl NeoHookean {
    /// Of E (GPa) and ν.
    pub(crate) fn new(youngs_modulus: f64, poissons_ratio: f64) -> Self {
        let shear = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
        Self { shear, first: 2.0 * shear * poissons_ratio / (1.0 - 2.0 * poissons_ratio) }
    }

    /// At the displacement gradient H = F - 1; not a number where J is not above zero.
    pub(crate) fn at(&self, h: &[Vector; 3]) -> PointResponse {
        let f: [Vector; 3] = std::array::from_fn(|i| std::array::from_fn(|j| h[i][j] + f64::from(u8::from(i == j))));
        let cofactor: [Vector; 3] = std::array::from_fn(|i| {
            let (a, b) = (&f[(i + 1) % 3], &f[(i + 2) % 3]);
            std::array::from_fn(|j| a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3])
        });
        // J - 1 without the cancellation of small strains
        let minor = |i: usize, j: usize| h[i][i] * h[j][j] - h[i][j] * h[j][i];
        let determinant = h[0][0] * (h[1][1] * h[2][2] - h[1][2] * h[2][1])
            + h[0][1] * (h[1][2] * h[2][0] - h[1][0] * h[2][2])
            + h[0][2] * (h[1][0] * h[2][1] - h[1][1] * h[2][0]);
        let trace = h[0][0] + h[1][1] + h[2][2];
        let grown = trace + minor(0, 1) + minor(1, 2) + minor(0, 2) + determinant;
        let (volume, log) = (1.0 + grown, grown.ln_1p());
        let square: f64 = h.iter().flatten().map(|value| value * value).sum();
        PointResponse {
            energy: 0.5 * self.shear * (2.0 * trace + square - 2.0 * log) + 0.5 * self.first * log * log,
            inverse: cofactor.map(|row| row.map(|value| value / volume)),
            pressure: self.first * log - self.shear,
        }
    }

    /// P, GPa, of a response at the displacement gradient H.
    pub(crate) fn stress(&self, h: &[Vector; 3], response: &PointResponse) -> [Vector; 3] {
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let own = h[i][j] + f64::from(u8::from(i == j));
                self.shear * own + response.pressure * response.inverse[i][j]
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const STATE: [Vector; 3] = [[0.1, -0.3, 0.05], [0.2, -0.1, 0.07], [0.02, 0.11, 0.15]];

    #[test]
    fn stress_is_the_slope_of_the_energy() {
        let material = NeoHookean::new(2.0, 0.2);
        let stress = material.stress(&STATE, &material.at(&STATE));
        for i in 0..3 {
            for j in 0..3 {
                let moved = |step: f64| {
                    let mut h = STATE;
                    h[i][j] += step;
                    material.at(&h).energy
                };
                let (d, e) = (1e-3, 2e-3);
                let slope = (8.0 * (moved(d) - moved(-d)) - (moved(e) - moved(-e))) / (12.0 * d);
                assert_relative_eq!(slope, stress[i][j], epsilon = 1e-9);
            }
        }
    }

    #[test]
    fn small_strains_are_those_of_hooke_and_rotations_are_free() {
        let material = NeoHookean::new(2.0, 0.2);
        let strain = 1e-7;
        // stretched along x, the sides held: E (1 - ν)/((1 + ν)(1 - 2ν))
        let held = [[strain, 0.0, 0.0], [0.0; 3], [0.0; 3]];
        let stress = material.stress(&held, &material.at(&held));
        assert_relative_eq!(stress[0][0] / strain, 2.0 * 0.8 / (1.2 * 0.6), max_relative = 1e-6);
        let (sin, cos) = 1.1f64.sin_cos();
        let turned = [[cos - 1.0, -sin, 0.0], [sin, cos - 1.0, 0.0], [0.0; 3]];
        assert!(material.at(&turned).energy.abs() < 1e-15);
    }
}
