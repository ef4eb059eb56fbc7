//! What a section counts where the length that adheres is counted, and with it where the peeling front is.
//!
//! A bonded section that shear has tilted by θ is in contact like one that lies flat, so it has to count as much: else
//! the sum over a beam is off by the integral of what is missing, and what looks for the front by it looks beside it. In
//! shear-soft beams the tilt decays over (EI/GA_s)^(1/2), which may be thousands of process zones.
//!
//! At a closed face the body force has Ψ = W/|cos θ|, the surface traction W |cos θ|, and a traction per area of
//! reference W itself, as has any law that is blind to the tilt. Ψ times the power of |cos θ| that is missing is W: its
//! series in sin θ, which is smooth where a section stands upright.
//!
//! |cos θ| itself is taken to the fourth power of θ alone: what is bonded and tilted by 0.3 rad counts a thousandth too little. Where it is a thousand
//! process zones long the mesh then lies beside the front, and [`TiltCount::Fine`] is what finds it.

use super::law::Law;
use super::line_load::{LineLaw, LineLoad};
use super::response::LineResponse;
use crate::number::Real;

/// How a tilted section is counted under the body force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TiltCount {
    /// To the fourth power of its rotation
    #[default]
    Coarse,
    /// As it is, but for a thousandth of a radian where it stands upright
    Fine,
}

/// Over this, in rad, |cos θ| is rounded off where a section stands upright.
const ROUND: f64 = 1e-3;

/// 1/|cos θ| = Σ a_k sin^2k θ: within 1e-4 up to 0.6 rad, and three times a flat section where one stands upright.
const PER_COSINE: [f64; 7] = [1.0, 0.5, 0.375, 0.3125, 0.273_437_5, 0.246_093_75, 0.225_585_937_5];

impl LineLaw {
    /// What a section with this response counts, nN/nm, with its derivatives by the gap (nN/nm²) and by the rotation,
    /// nN/nm. Flat it is Ψ.
    #[inline(always)]
    pub(crate) fn coverage<T: Real>(&self, count: TiltCount, response: &LineResponse<T>, sin: T, cos: T) -> [T; 3] {
        let &LineResponse { energy, by_gap, energy_by_rotation, .. } = response;
        let (share, turned) = match (&self.law, self.line_load) {
            (_, LineLoad::AxisGap) | (Law::Cohesive(_) | Law::Own(_), _) => {
                return [energy, by_gap, energy_by_rotation];
            }
            (Law::BodyForce, _) => match count {
                TiltCount::Coarse => cosine(sin, cos),
                TiltCount::Fine => rounded_cosine(sin, cos),
            },
            (Law::SurfaceTraction, _) => per_cosine(sin, cos),
        };
        [energy * share, by_gap * share, energy_by_rotation * share + energy * turned]
    }
}

/// ¼(1 + 4 cos²θ - cos⁴θ) and its slope: |cos θ| but for a fourth power of θ. Where a section stands upright a quarter is left.
#[inline(always)]
fn cosine<T: Real>(sin: T, cos: T) -> (T, T) {
    let square = cos * cos;
    (square - (square * square - 1.0) * 0.25, -(sin * cos * (-square + 2.0)))
}

/// √(cos²θ + ε²)/√(1 + ε²) and its slope.
#[inline(always)]
fn rounded_cosine<T: Real>(sin: T, cos: T) -> (T, T) {
    let flat = 1.0 + ROUND * ROUND;
    let [value] = cos.each(|cos| [cos.hypot(ROUND) / flat.sqrt()]);
    (value, -(sin * cos * (value * flat).recip()))
}

/// The series of 1/|cos θ| and its slope.
#[inline(always)]
fn per_cosine<T: Real>(sin: T, cos: T) -> (T, T) {
    let square = sin * sin;
    let (mut value, mut slope) = (T::splat(0.0), T::splat(0.0));
    for coefficient in PER_COSINE.into_iter().rev() {
        slope = slope * square + value;
        value = value * square + coefficient;
    }
    (value, sin * cos * slope * 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::{Attraction, HalfSpace};
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    fn laws() -> impl Iterator<Item = LineLaw> {
        let loads = [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap];
        let law = |attraction: Attraction, line_load| LineLaw {
            half_space: PAPER,
            height: 10.0,
            law: attraction.law(&PAPER, None, None),
            line_load,
            far_face: false,
        };
        Attraction::all().flat_map(move |attraction| loads.map(|load| law(attraction, load)))
    }

    fn coverage(count: TiltCount, law: &LineLaw, gap: f64, rotation: f64) -> [f64; 3] {
        let (sin, cos) = rotation.sin_cos();
        law.coverage(count, &law.response(gap, sin, cos), sin, cos)
    }

    const COUNTS: [TiltCount; 2] = [TiltCount::Coarse, TiltCount::Fine];

    /// A tilted section whose face is closed counts what a flat one does.
    #[test]
    fn a_tilted_section_in_contact_counts_as_a_flat_one() {
        for (law, count) in laws().flat_map(|law| COUNTS.map(|count| (law, count))) {
            let blind = law.line_load == LineLoad::AxisGap;
            for rotation in [0.02, 0.1, 0.2] {
                let lift = if blind { 0.0 } else { 0.5 * law.height * (1.0 - f64::cos(rotation)) };
                let counted = coverage(count, &law, law.rest_gap() - lift, rotation)[0];
                let off = (counted / law.rest_energy() - 1.0).abs();
                assert!(
                    off <= 0.2 * rotation.powi(4),
                    "{:?} {:?} {count:?} at {rotation}: {off:e}",
                    law.law,
                    law.line_load
                );
            }
        }
    }

    /// Where a coarse count misses a thousandth of a tilted section, a fine one misses nothing.
    #[test]
    fn a_fine_count_misses_nothing_of_a_section_that_is_tilted_far() {
        let law = LineLaw {
            half_space: PAPER,
            height: 10.0,
            law: Law::BodyForce,
            line_load: LineLoad::Full,
            far_face: false,
        };
        let missed = |count, rotation: f64| {
            let lift = 0.5 * law.height * (1.0 - rotation.cos());
            1.0 - coverage(count, &law, law.rest_gap() - lift, rotation)[0] / law.rest_energy()
        };
        assert!(missed(TiltCount::Coarse, 0.3) > 9e-4 && missed(TiltCount::Fine, 0.3).abs() < 1e-6);
        assert!(missed(TiltCount::Coarse, 0.5) > 6e-3 && missed(TiltCount::Fine, 0.5).abs() < 1e-6);
        assert!(missed(TiltCount::Fine, 1.35).abs() < 1e-4);
    }

    #[test]
    fn its_derivatives_are_those_of_its_value() {
        for (law, count) in laws().flat_map(|law| COUNTS.map(|count| (law, count))) {
            for (gap, rotation) in [(0.3, 0.1), (0.5, -0.7), (0.28, 1.2)] {
                let d = 1e-5;
                let [value, by_gap, by_rotation] = coverage(count, &law, gap, rotation);
                let gaps = [d, -d].map(|d| coverage(count, &law, gap + d, rotation)[0]);
                let turns = [d, -d].map(|d| coverage(count, &law, gap, rotation + d)[0]);
                assert_abs_diff_eq!((gaps[0] - gaps[1]) / (2.0 * d), by_gap, epsilon = 1e-6);
                assert_abs_diff_eq!((turns[0] - turns[1]) / (2.0 * d), by_rotation, epsilon = 1e-6);
                assert!(value.is_finite());
            }
        }
    }

    #[test]
    fn the_counts_are_the_cosine_and_one_over_it() {
        for rotation in [0.1f64, 0.3, 0.6] {
            let (sin, cos) = rotation.sin_cos();
            assert_relative_eq!(per_cosine(sin, cos).0, 1.0 / cos, max_relative = 1e-4);
            assert_relative_eq!(rounded_cosine(sin, cos).0, cos, max_relative = 1e-6);
        }
        // upright: the sum of its coefficients
        assert_relative_eq!(per_cosine(1.0, 0.0).0, 2.932_617_187_5, max_relative = 1e-12);
    }
}
