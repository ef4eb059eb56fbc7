//! The pair potential between two atoms, and Hamaker's identity.

use super::half_space::HalfSpace;
use std::f64::consts::PI;

/// The Lennard-Jones potential φ(r) = ε (r0/r)¹² - 2ε (r0/r)⁶, eq. (1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LennardJones {
    /// Depth ε of the well, nN·nm = aJ
    pub well_depth: f64,
    /// Distance r0 of the bottom of the well, nm
    pub equilibrium_distance: f64,
}

impl LennardJones {
    /// The pair potential behind a half space: ε = A_H/(2π² β1 β2 r0⁶), densities β1 and β2 in atoms/nm³.
    ///
    /// From eq. (1) to eq. (9): a plane of atoms at the distance z attracts by r^-n as 2π z^(2-n)/(n-2), the planes behind r as
    /// 2π r^(3-n)/((n-2)(n-3)). A point at r so has the energy Φ = πβ2ε r0³ [(r0/r)⁹/45 - (r0/r)³/3] and feels b = -Φ',
    /// eq. (9); times β1 its factor πβ1β2ε r0² is the A_H/(2π r0⁴) of [`HalfSpace::body_force`].
    pub fn behind(half_space: &HalfSpace, density: f64, other_density: f64) -> Self {
        let r0 = half_space.equilibrium_distance;
        let well_depth = half_space.hamaker_constant / (2.0 * PI * PI * density * other_density * r0.powi(6));
        Self { well_depth, equilibrium_distance: r0 }
    }

    /// Hamaker's constant A_H = 2π² β1 β2 ε r0⁶, aJ, of two bodies of these densities in atoms/nm³.
    pub fn hamaker_constant(&self, density: f64, other_density: f64) -> f64 {
        2.0 * PI * PI * density * other_density * self.well_depth * self.equilibrium_distance.powi(6)
    }

    /// φ, aJ, by the square of the distance in nm².
    #[inline(always)]
    pub fn energy(&self, distance_squared: f64) -> f64 {
        let q6 = self.sixth_power(distance_squared);
        self.well_depth * q6 * (q6 - 2.0)
    }

    /// -φ'(r)/r, nN/nm, by the square of the distance in nm²: times the vector between the atoms it is the force, positive
    /// where they push one another apart.
    #[inline(always)]
    pub fn force_over_distance(&self, distance_squared: f64) -> f64 {
        let q6 = self.sixth_power(distance_squared);
        12.0 * self.well_depth * q6 * (q6 - 1.0) / distance_squared
    }

    /// (r0/r)⁶
    #[inline(always)]
    fn sixth_power(&self, distance_squared: f64) -> f64 {
        let q2 = self.equilibrium_distance * self.equilibrium_distance / distance_squared;
        q2 * q2 * q2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn well_is_as_deep_as_stated_and_where() {
        let pair = LennardJones { well_depth: 0.3, equilibrium_distance: 0.7 };
        assert_relative_eq!(pair.energy(0.49), -0.3, max_relative = 1e-15);
        assert!(pair.force_over_distance(0.49).abs() < 1e-14);
        assert!(pair.force_over_distance(0.4) > 0.0 && pair.force_over_distance(0.6) < 0.0);
    }

    #[test]
    fn force_is_minus_the_slope_of_the_energy() {
        let pair = LennardJones { well_depth: 0.3, equilibrium_distance: 0.7 };
        for r in [0.5f64, 0.65, 0.9, 3.0] {
            let (d, e) = (1e-3 * r, |r: f64| pair.energy(r * r));
            let slope = (8.0 * (e(r + d) - e(r - d)) - (e(r + 2.0 * d) - e(r - 2.0 * d))) / (12.0 * d);
            assert_relative_eq!(pair.force_over_distance(r * r) * r, -slope, max_relative = 1e-7);
        }
    }

    #[test]
    fn hamaker_there_and_back() {
        let law = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
        let pair = LennardJones::behind(&law, 15.0, 40.0);
        assert_relative_eq!(pair.hamaker_constant(15.0, 40.0), 0.1, max_relative = 1e-15);
        // an atom for every r0³ of both bodies: ε = A_H/(2π²)
        let dense = LennardJones::behind(&law, 0.4f64.powi(-3), 0.4f64.powi(-3));
        assert_relative_eq!(dense.well_depth, 0.1 / (2.0 * PI * PI), max_relative = 1e-14);
    }
}
