//! A cohesive law on the bonded face, averaged over its width.
//!
//! A cohesive law is a nominal traction, per area of reference, and so has no 1/cos θ, as in the plane. At s b d2 from
//! the middle of its width, s from -1/2 to 1/2, the bonded face is at the distance r + s a, r = y - c/2:
//!
//!   Ψ = b ∫ W_c(r + s a) ds.
//!
//! Where the section has turned over, c < 0, that face is attracted and the other one, r = y - |c|/2, may be pressed, as in the plane.

use super::response::SpatialSectionResponse;
use crate::adhesion::section::calibrated::{Cohesive, Part};

/// Ψ of a rectangle of this width, nm, with gradient and Hessian.
#[inline(never)]
pub(super) fn response(law: &Cohesive, width: f64, y: f64, a: f64, c: f64) -> SpatialSectionResponse {
    let face = |part, along: f64| of_part(law, part, [width, y, a], [c, along]);
    if c > 0.0 {
        return face(Part::Whole, -0.5);
    }
    let (pulled, pressed) = (face(Part::Pull, -0.5), face(Part::Push, 0.5));
    SpatialSectionResponse {
        energy: pulled.energy + pressed.energy,
        gradient: std::array::from_fn(|k| pulled.gradient[k] + pressed.gradient[k]),
        hessian: std::array::from_fn(|k| pulled.hessian[k] + pressed.hessian[k]),
    }
}

/// Of what repels alone.
#[inline(never)]
pub(super) fn pressed(law: &Cohesive, width: f64, y: f64, a: f64, c: f64) -> SpatialSectionResponse {
    of_part(law, Part::Push, [width, y, a], [c, if c > 0.0 { -0.5 } else { 0.5 }])
}

/// Of a part of the law on the face whose middle is at the distance y + `along` c.
fn of_part(law: &Cohesive, part: Part, [width, y, a]: [f64; 3], [c, along]: [f64; 2]) -> SpatialSectionResponse {
    let means = law.over_width(part, y + along * c, a.abs());
    let [energy, by_r, by_a, by_rr, by_ra, by_aa] = means.map(|mean| width * mean);
    let across = if a < 0.0 { -1.0 } else { 1.0 };
    SpatialSectionResponse {
        energy,
        gradient: [by_r, across * by_a, along * by_r],
        hessian: [by_rr, across * by_ra, along * by_rr, by_aa, along * across * by_ra, 0.25 * by_rr],
    }
}

// -- The mean over a face that is tilted across its width --
//
// At s of its width from its middle, s from -1/2 to 1/2, the face is at the distance r + s a, open by t + s x in units
// of the range, x = a/δ_r. Where x is above 1/2 the means of ∫ s and of its derivatives follow from what the law is at
// the two edges. Below that they would be differences of nearly equal numbers, and Gauss's rule of six points is taken
// between the corners of the law: it is exact for a law of lines with rounded corners, polynomials of degree 9. Both
// are within 3e-13 of what is averaged, without its sign.

/// Gauss's points above zero on [-1, 1] and their weights.
const POINTS: [f64; 3] = [0.238_619_186_083_196_9, 0.661_209_386_466_264_5, 0.932_469_514_203_152];
const WEIGHTS: [f64; 3] = [0.467_913_934_572_691_04, 0.360_761_573_048_138_6, 0.171_324_492_379_170_34];

/// The places and weights of the six points from `middle` - `half` to `middle` + `half`.
#[inline(always)]
pub(super) fn six_points(middle: f64, half: f64) -> [(f64, f64); 6] {
    std::array::from_fn(|k| {
        let (point, weight) = (POINTS[k / 2], half * WEIGHTS[k / 2]);
        (if k % 2 == 0 { middle - half * point } else { middle + half * point }, weight)
    })
}

impl Cohesive {
    /// The means over s from -1/2 to 1/2 of W_c, W_c', s W_c', W_c'', s W_c'' and s² W_c'' at r + s a, for a ≥ 0, of a part of the law.
    fn over_width(&self, part: Part, r: f64, a: f64) -> [f64; 6] {
        let per_range = 1.0 / self.range;
        let (t, x) = ((r - self.closed) * per_range, a * per_range);
        let means = if x > 0.5 { self.by_edges(part, t, x) } else { self.by_points(part, t, x) };
        // W_c = -σ δ_r ∫ s
        let (w, s, slope) = (-self.strength * self.range, self.strength, self.strength * per_range);
        let factors = [w, s, s, slope, slope, slope];
        std::array::from_fn(|k| factors[k] * means[k])
    }

    /// Of ∫ s, s and the slope of s, in the same order. With f' for any of them ∫ f'(t + s x) ds = [f]/x, and by parts
    /// for the rest.
    fn by_edges(&self, part: Part, t: f64, x: f64) -> [f64; 6] {
        let edges = [t - 0.5 * x, t + 0.5 * x];
        let [low, high] = edges.map(|t| part.at(self.shape, t));
        let [below, above] = edges.map(|t| part.primitive(self.shape, t));
        let inverse = 1.0 / x;
        let w = (below - above) * inverse;
        let s = (low[0] - high[0]) * inverse;
        let s_moment = (w - 0.5 * (low[0] + high[0])) * inverse;
        let slope = (high[1] - low[1]) * inverse;
        let slope_moment = (0.5 * (high[1] + low[1]) - s) * inverse;
        [w, s, s_moment, slope, slope_moment, 0.25 * slope - 2.0 * inverse * s_moment]
    }

    fn by_points(&self, part: Part, t: f64, x: f64) -> [f64; 6] {
        let mut sums = [0.0; 6];
        let mut from = -0.5;
        let knots = part.knots(self.shape).map(|opening| (opening - t) / x);
        // without a tilt they are infinite, or no numbers
        for to in knots.filter(|place| place.abs() < 0.5).chain([0.5]) {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            for (place, weight) in six_points(middle, half) {
                let [work, s, slope] = part.at(self.shape, t + place * x);
                let terms = [work, s, place * s, slope, place * slope, place * place * slope];
                for k in 0..6 {
                    sums[k] += weight * terms[k];
                }
            }
            from = to;
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::{CohesiveShape, HalfSpace, Rule};
    use std::num::NonZeroUsize;

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    /// At many widths and openings, by a rule far finer than it need be between the corners.
    #[test]
    fn means_are_those_of_a_fine_rule() {
        let rule = Rule::new(NonZeroUsize::new(10).unwrap());
        for &shape in CohesiveShape::ALL {
            let law = Cohesive::calibrated(shape, PAPER.strength(), PAPER.work_of_adhesion(), &PAPER);
            for x in [0.0, 1e-9, 1e-4, 0.03, 0.3, 0.499, 0.501, 1.0, 2.5, 30.0] {
                for lowest in [-0.3, 0.0, 0.04, 0.1, 0.3, 0.72, 1.2, 1.4] {
                    let (r, a) = (law.closed + law.range * (lowest + 0.5 * x), law.range * x);
                    let (mut sums, mut sizes) = ([0.0; 6], [0.0; 6]);
                    let inside = |opening: &&f64| x > 0.0 && **opening > lowest && **opening < lowest + x;
                    let corners = shape.knots().iter().filter(inside).map(|opening| (opening - lowest) / x - 0.5);
                    let ends: Vec<f64> = [-0.5].into_iter().chain(corners).chain([0.5]).collect();
                    for part in ends.windows(2) {
                        let pieces = 30;
                        let end = |k: i32| part[0] + (part[1] - part[0]) * f64::from(k) / f64::from(pieces);
                        for (s, weight) in (0..pieces).flat_map(|k| rule.over(end(k), end(k + 1))) {
                            let [w, t, b] = law.levels(r + s * a);
                            let terms = [w, -t, -s * t, b, s * b, s * s * b];
                            for i in 0..6 {
                                sums[i] += weight * terms[i];
                                sizes[i] += weight * terms[i].abs();
                            }
                        }
                    }
                    let computed = law.over_width(Part::Whole, r, a);
                    // where little is left of a law its own round-off is that of its lines
                    let (work, slope) = (law.strength * law.range, law.strength / law.range);
                    let scales = [work, law.strength, law.strength, slope, slope, slope];
                    for i in 0..6 {
                        let allowed = 1e-12 * sizes[i] + 1e-14 * scales[i];
                        let off = (computed[i] - sums[i]).abs();
                        assert!(off <= allowed, "mean {i} of {shape:?} at {lowest}, {x}: {off:e}, {allowed:e}");
                    }
                }
            }
        }
    }
}
