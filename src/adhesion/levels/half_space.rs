//! Van der Waals attraction and repulsion of a half space: body force, traction, their integrals.

use crate::number::Real;
use std::f64::consts::PI;

/// The Lennard-Jones half space of eqs. (9), (10) and (18), by its two constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// Hamaker constant A_H, nN·nm = aJ
    pub hamaker_constant: f64,
    /// Equilibrium distance r0 of the pair potential, eq. (1), nm
    pub equilibrium_distance: f64,
}

impl HalfSpace {
    /// The half space with this work of adhesion (nN/nm) and this strength (nN/nm²): w/σ is 9 · 15^(1/3)/(16 √5) r0.
    pub(crate) fn of_work_and_strength(work: f64, strength: f64) -> Self {
        let unit = Self { hamaker_constant: 1.0, equilibrium_distance: 1.0 };
        let equilibrium_distance = work / strength * unit.strength() / unit.work_of_adhesion();
        let hamaker_constant = work * equilibrium_distance.powi(2) / unit.work_of_adhesion();
        Self { hamaker_constant, equilibrium_distance }
    }

    /// Body force density b(r) = A_H/(2π r0⁴) [ (r0/r)¹⁰/5 - (r0/r)⁴ ], nN/nm³, positive away from the half space, eq. (9).
    #[inline(always)]
    pub fn body_force<T: Real>(&self, r: T) -> T {
        let q = r.recip() * self.equilibrium_distance;
        let q2 = q * q;
        let q4 = q2 * q2;
        q4 * (q4 * q2 * 0.2 - 1.0) * (self.potential_scale() / self.equilibrium_distance.powi(2))
    }

    /// Traction T(r) = ∫_r^∞ b = A_H/(2π r0³) [ (r0/r)⁹/45 - (r0/r)³/3 ], nN/nm², eqs. (10) and (18).
    #[inline(always)]
    pub fn traction<T: Real>(&self, r: T) -> T {
        let q = r.recip() * self.equilibrium_distance;
        let q3 = q * q * q;
        q3 * (q3 * q3 * (1.0 / 45.0) - 1.0 / 3.0) * (self.potential_scale() / self.equilibrium_distance)
    }

    /// Potential W(r) = ∫_r^∞ T = A_H/(2π r0²) [ (r0/r)⁸/360 - (r0/r)²/6 ], nN/nm; T = -W'.
    #[inline(always)]
    pub fn potential<T: Real>(&self, r: T) -> T {
        let q = r.recip() * self.equilibrium_distance;
        let q2 = q * q;
        q2 * (q2 * q2 * q2 * (1.0 / 360.0) - 1.0 / 6.0) * self.potential_scale()
    }

    /// W, T and b at once.
    #[inline(always)]
    pub(crate) fn levels<T: Real>(&self, r: T) -> [T; 3] {
        [self.potential(r), self.traction(r), self.body_force(r)]
    }

    /// A_H/(2π r0²), nN/nm: the factor of W.
    pub fn potential_scale(&self) -> f64 {
        self.hamaker_constant / (2.0 * PI * self.equilibrium_distance.powi(2))
    }

    /// Work of adhesion of two half spaces, w_adh = -W(r_eq) = 15^(1/3) A_H/(16π r0²), nN/nm = J/m² (footnote 5).
    pub fn work_of_adhesion(&self) -> f64 {
        15f64.cbrt() * self.hamaker_constant / (16.0 * PI * self.equilibrium_distance.powi(2))
    }

    /// The largest attraction, -T at the strongest gap: (2√5/9) A_H/(2π r0³), nN/nm² = GPa.
    pub fn strength(&self) -> f64 {
        2.0 * 5f64.sqrt() / 9.0 * self.potential_scale() / self.equilibrium_distance
    }

    /// The gap without traction, 15^(-1/6) r0, nm.
    pub fn equilibrium_gap(&self) -> f64 {
        self.equilibrium_distance * 15f64.powf(-1.0 / 6.0)
    }

    /// The gap of the largest attraction, 5^(-1/6) r0, nm.
    pub fn strongest_gap(&self) -> f64 {
        self.equilibrium_distance * 5f64.powf(-1.0 / 6.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    #[test]
    fn published_work_of_adhesion() {
        assert_eq!((PAPER.work_of_adhesion() * 1e4).round() / 1e4, 0.0307);
        assert_relative_eq!(PAPER.work_of_adhesion(), -PAPER.potential(PAPER.equilibrium_gap()), max_relative = 1e-14);
    }

    #[test]
    fn work_and_strength_determine_a_half_space() {
        let found = HalfSpace::of_work_and_strength(PAPER.work_of_adhesion(), PAPER.strength());
        assert_relative_eq!(found.hamaker_constant, PAPER.hamaker_constant, max_relative = 1e-14);
        assert_relative_eq!(found.equilibrium_distance, PAPER.equilibrium_distance, max_relative = 1e-14);
        let tape = HalfSpace::of_work_and_strength(0.2, 1e-3);
        assert_relative_eq!(tape.work_of_adhesion(), 0.2, max_relative = 1e-14);
        assert_relative_eq!(tape.strength(), 1e-3, max_relative = 1e-14);
        assert_relative_eq!(
            tape.equilibrium_distance,
            16.0 * 5f64.sqrt() / (9.0 * 15f64.cbrt()) * 200.0,
            max_relative = 1e-14
        );
    }

    #[test]
    fn each_is_minus_the_slope_of_the_next() {
        for r in [0.2, 0.3, 0.5, 2.0, 9.0] {
            // central differences of fourth order
            let d = 1e-3 * r;
            let slope =
                |f: &dyn Fn(f64) -> f64| (8.0 * (f(r + d) - f(r - d)) - (f(r + 2.0 * d) - f(r - 2.0 * d))) / (12.0 * d);
            assert_relative_eq!(-slope(&|r| PAPER.potential(r)), PAPER.traction(r), max_relative = 1e-8);
            assert_relative_eq!(-slope(&|r| PAPER.traction(r)), PAPER.body_force(r), max_relative = 1e-8);
        }
    }

    #[test]
    fn traction_vanishes_and_is_least_where_stated() {
        assert!(PAPER.traction(PAPER.equilibrium_gap()).abs() < 1e-14);
        assert!(PAPER.body_force(PAPER.strongest_gap()).abs() < 1e-14);
        assert_relative_eq!(PAPER.strength(), -PAPER.traction(PAPER.strongest_gap()), max_relative = 1e-14);
    }

    /// The paper's footnote 3 says 5.7 nm for 0.1 %; that is 5.69 r0, hence r0 = 1 nm and not its own 0.4 nm.
    #[test]
    fn body_force_falls_to_a_thousandth_at_5_69_r0() {
        let law = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 1.0 };
        // largest attraction of b: (r0/r)^6 = 2
        let largest = law.body_force(2f64.powf(-1.0 / 6.0)).abs();
        assert!(law.body_force(5.69).abs() > 1e-3 * largest);
        assert!(law.body_force(5.70).abs() < 1e-3 * largest);
    }
}
