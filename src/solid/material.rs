//! What a plane solid is made of: an isotropic elastic energy of the deformation gradient F, in plane strain or plane stress.
//!
//! With μ = E/2(1+ν), Λ = Eν/((1+ν)(1-2ν)), J = det F and the stretch λ3 across the plane:
//!
//! - compressible Neo-Hookean: W = μ/2 (F:F + λ3² - 3) - μ ln(J λ3) + Λ/2 ln²(J λ3),
//!   P = μ F + (c/J) cof F with c = Λ ln(J λ3) - μ;
//! - St Venant-Kirchhoff: W = Λ/2 tr²E + μ E:E of Green's strain E = (FᵀF - 1)/2, P = F (Λ tr E + 2 μ E).
//!
//! In plane strain λ3 = 1, in plane stress it is where ∂W/∂λ3 = 0. Energies are per reference volume, nN/nm² = GPa.

use crate::beam::section::Material;

/// The elastic energy of a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolidMaterial {
    /// Compressible Neo-Hookean
    #[default]
    NeoHookean,
    /// St Venant-Kirchhoff: linear in Green's strain; it softens without limit under compression
    StVenantKirchhoff,
}

/// What holds across the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// No stress: of a strip that is narrow against its length; what a beam is
    #[default]
    Stress,
    /// No strain: of a strip that is wide against its height
    Strain,
}

/// Energy, stress and tangent at one point. Components are in the order 11, 12, 21, 22, the first index that of the force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stress {
    /// W, GPa
    pub energy: f64,
    /// P = ∂W/∂F, GPa
    pub stress: [f64; 4],
    /// ∂P/∂F, GPa
    pub tangent: [[f64; 4]; 4],
}

/// A material with its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Elastic {
    material: SolidMaterial,
    plane: Plane,
    /// μ, GPa
    shear: f64,
    /// Λ, GPa; of St Venant-Kirchhoff in plane stress 2μΛ/(Λ + 2μ)
    lame: f64,
}

/// Most iterations for the stretch across the plane; three to five are usual.
const MOST_ITERATIONS: usize = 50;
/// When they end.
const CONVERGED: f64 = 1e-15;

impl Elastic {
    /// Of Young's modulus and Poisson's ratio.
    pub(crate) fn new(material: SolidMaterial, plane: Plane, of: &Material) -> Self {
        let Material { youngs_modulus, poissons_ratio, .. } = *of;
        let shear = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
        let lame = youngs_modulus * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio));
        let lame = match (material, plane) {
            (SolidMaterial::StVenantKirchhoff, Plane::Stress) => 2.0 * shear * lame / (lame + 2.0 * shear),
            _ => lame,
        };
        Self { material, plane, shear, lame }
    }

    /// At this deformation gradient; not finite where that is not one of a body, det F ≤ 0.
    #[inline]
    pub(crate) fn at(&self, gradient: [f64; 4]) -> Stress {
        match self.material {
            SolidMaterial::NeoHookean => self.neo_hookean(gradient),
            SolidMaterial::StVenantKirchhoff => self.st_venant_kirchhoff(gradient),
        }
    }

    fn neo_hookean(&self, f: [f64; 4]) -> Stress {
        let Self { shear, lame, .. } = *self;
        let volume = f[0] * f[3] - f[1] * f[2];
        let cofactor = [f[3], -f[2], -f[1], f[0]];
        let log = volume.ln();
        let across = match self.plane {
            Plane::Strain => 0.0,
            Plane::Stress => self.log_stretch(log),
        };
        let stretch = (2.0 * across).exp();
        let whole = log + across;
        let c = lame * whole - shear;
        let by_volume = match self.plane {
            Plane::Strain => lame / volume,
            Plane::Stress => lame / volume * 2.0 * shear * stretch / (2.0 * shear * stretch + lame),
        };
        let (k1, k2) = (c / volume, by_volume / volume - c / (volume * volume));
        let squares: f64 = f.iter().map(|x| x * x).sum();
        let mut tangent = [[0.0; 4]; 4];
        for a in 0..4 {
            for b in 0..4 {
                tangent[a][b] = k2 * cofactor[a] * cofactor[b];
            }
            tangent[a][a] += shear;
            tangent[a][3 - a] += if a == 0 || a == 3 { k1 } else { -k1 };
        }
        Stress {
            energy: 0.5 * shear * (squares + stretch - 3.0) - shear * whole + 0.5 * lame * whole * whole,
            stress: std::array::from_fn(|a| shear * f[a] + k1 * cofactor[a]),
            tangent,
        }
    }

    /// ln λ3 in plane stress, of ln J: where μ(λ3² - 1) + Λ ln(J λ3) = 0, which grows with it and is convex.
    fn log_stretch(&self, log: f64) -> f64 {
        let Self { shear, lame, .. } = *self;
        let mut at = -lame * log / (2.0 * shear + lame);
        for _ in 0..MOST_ITERATIONS {
            let value = shear * (2.0 * at).exp_m1() + lame * (log + at);
            let step = value / (2.0 * shear * (2.0 * at).exp() + lame);
            at -= step;
            if step.abs() <= CONVERGED * (1.0 + at.abs()) {
                break;
            }
        }
        at
    }

    fn st_venant_kirchhoff(&self, f: [f64; 4]) -> Stress {
        let Self { shear, lame, .. } = *self;
        let strain = |j: usize, l: usize| 0.5 * (f[j] * f[l] + f[2 + j] * f[2 + l] - f64::from(u8::from(j == l)));
        let trace = strain(0, 0) + strain(1, 1);
        let second: [[f64; 2]; 2] = std::array::from_fn(|j| {
            std::array::from_fn(|l| 2.0 * shear * strain(j, l) + if j == l { lame * trace } else { 0.0 })
        });
        let squares = strain(0, 0).powi(2) + strain(1, 1).powi(2) + 2.0 * strain(0, 1).powi(2);
        let row = |i: usize, k: usize| f[2 * i] * f[2 * k] + f[2 * i + 1] * f[2 * k + 1];
        let mut tangent = [[0.0; 4]; 4];
        for (i, j, k, l) in (0..16).map(|n| (n >> 3, n >> 2 & 1, n >> 1 & 1, n & 1)) {
            let mut own = lame * f[2 * i + j] * f[2 * k + l] + shear * f[2 * i + l] * f[2 * k + j];
            own += if j == l { shear * row(i, k) } else { 0.0 };
            own += if i == k { second[j][l] } else { 0.0 };
            tangent[2 * i + j][2 * k + l] = own;
        }
        let volume = f[0] * f[3] - f[1] * f[2];
        // a body that is turned inside out is none, although this energy does not see it
        let energy = if volume > 0.0 { 0.5 * lame * trace * trace + shear * squares } else { f64::NAN };
        let of = |i: usize, l: usize| f[2 * i] * second[0][l] + f[2 * i + 1] * second[1][l];
        Stress { energy, stress: [of(0, 0), of(0, 1), of(1, 0), of(1, 1)], tangent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    const GRADIENT: [f64; 4] = [1.07, -0.21, 0.16, 0.92];

    fn all() -> impl Iterator<Item = Elastic> {
        [SolidMaterial::NeoHookean, SolidMaterial::StVenantKirchhoff].into_iter().flat_map(|material| {
            let of = Material::of(2.0, 0.2);
            [Plane::Stress, Plane::Strain].map(|plane| Elastic::new(material, plane, &of))
        })
    }

    #[test]
    fn stress_and_tangent_are_derivatives_of_the_energy() {
        for elastic in all() {
            let here = elastic.at(GRADIENT);
            for a in 0..4 {
                let moved = |by: f64| {
                    let mut f = GRADIENT;
                    f[a] += by;
                    elastic.at(f)
                };
                let (before, after) = (moved(-1e-5), moved(1e-5));
                assert_abs_diff_eq!(here.stress[a], (after.energy - before.energy) / 2e-5, epsilon = 1e-9);
                for b in 0..4 {
                    let difference = (after.stress[b] - before.stress[b]) / 2e-5;
                    assert_abs_diff_eq!(here.tangent[b][a], difference, epsilon = 1e-8);
                }
            }
        }
    }

    /// Small strains: E in plane stress, E/(1-ν²) in plane strain, by the same stiffness of both materials.
    #[test]
    fn small_strains_are_hookes() {
        for elastic in all() {
            let here = elastic.at([1.0, 0.0, 0.0, 1.0]);
            assert_abs_diff_eq!(here.energy, 0.0, epsilon = 1e-15);
            here.stress.iter().for_each(|&stress| assert_abs_diff_eq!(stress, 0.0, epsilon = 1e-15));
            let expected = if elastic.plane == Plane::Stress { 2.0 } else { 2.0 / (1.0 - 0.04) };
            let [along, across] = [here.tangent[0][0], here.tangent[0][3]];
            assert_abs_diff_eq!(along - across * across / here.tangent[3][3], expected, epsilon = 1e-14);
        }
    }

    #[test]
    fn a_rotation_costs_nothing_and_a_reflection_is_no_body() {
        let (sin, cos) = 0.7f64.sin_cos();
        for elastic in all() {
            let turned = elastic.at([cos, -sin, sin, cos]);
            turned.stress.iter().for_each(|&stress| assert_abs_diff_eq!(stress, 0.0, epsilon = 1e-14));
            assert_abs_diff_eq!(turned.energy, 0.0, epsilon = 1e-15);
            assert!(elastic.at([-1.0, 0.0, 0.0, 1.0]).energy.is_nan());
        }
    }
}
