//! What pulls a face back to where it was bonded, averaged over its width: off the ground and along it, in both directions.
//!
//! At s b d2 from the middle of its width, s from -1/2 to 1/2, the bonded face is at the distance r(s) from the ground and has slipped by x(s) and
//! z(s) along it. All three are linear in s: p(s) = p + s e. As in the plane, of [`crate::adhesion::section::sheared`], with the slip in any direction,
//!
//!   Ψ_pull = b ∫ W_pull(r) B(t) ds,   B(t) = exp(-t²/δ_t²),   t² = x² + z².
//!
//! Its derivatives by p and e are the means of ∇ψ and s ∇ψ, of ∇∇ψ, s ∇∇ψ and s² ∇∇ψ, ψ = W_pull B. Where slip takes a work of its own the load is
//! not -∇ψ but -f, f = κ_e (ψ_x w_t/w, ψ_r, ψ_z w_t/w), and the tangent is made of ∇f. The means are taken by Gauss's rule of six points between the
//! corners of the law, in pieces over which ψ changes little: what is left out is below 1e-9 of each.

use super::cohesive_face::six_points;
use crate::adhesion::section::calibrated::Part;
use crate::adhesion::section::sheared::ShearedLaw;
use crate::number::Real;

/// How far a face opens, in ranges of the law, or slips, in slip scales, over one piece at most.
const PIECE: f64 = 0.5;
/// The same where an exponent mixes the works: the mode changes all at once where a face is closed and has not slipped.
const MIXED_PIECE: f64 = 0.05;
/// A change of less, over [`PIECE`], takes one piece even where a corner of the law is rounded, which is a tenth of a range.
const SMALL: f64 = 0.05;
/// Square of the slip over δ_t beyond which nothing is left of B: e⁻⁴⁰ is 4e-18.
const FAR: f64 = 40.0;
/// Opening, in ranges, beyond which nothing is left of a law that does not end at a corner.
const OPEN: f64 = 50.0;

/// The means over the width of ψ, and of ∇ψ, f and ∇f times powers of s.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HeldMeans<T> {
    /// nN/nm
    pub energy: T,
    /// ∇ψ times 1 and s, by x, r and z, nN/nm²
    pub change: [[T; 3]; 2],
    /// f, likewise; where the load has a potential that is ∇ψ
    pub gradient: [[T; 3]; 2],
    /// ∇f times 1, s and s²: of each number of f by x, r and z, nN/nm³
    pub hessian: [[[T; 3]; 3]; 3],
}

/// Numbers of these means, and of what they are means of.
const MEANS: usize = 40;
const DENSITY: usize = 16;

/// Of a face whose middle is at p = (x, r, z), which changes by e over the width, nm.
#[inline(always)]
pub(crate) fn means<T: Real>(law: &ShearedLaw, middle: [T; 3], across: [T; 3]) -> HeldMeans<T> {
    let [x, r, z] = middle;
    let [dx, dr, dz] = across;
    let all = T::each_of([x, r, z, dx, dr, dz], |[x, r, z, dx, dr, dz]| at_one(law, [x, r, z], [dx, dr, dz]));
    let vector = |from: usize| std::array::from_fn(|k| all[from + k]);
    HeldMeans {
        energy: all[0],
        change: std::array::from_fn(|moment| vector(1 + 3 * moment)),
        gradient: std::array::from_fn(|moment| vector(7 + 3 * moment)),
        hessian: std::array::from_fn(|moment| std::array::from_fn(|row| vector(13 + 9 * moment + 3 * row))),
    }
}

#[inline(never)]
fn at_one(law: &ShearedLaw, middle: [f64; 3], across: [f64; 3]) -> [f64; MEANS] {
    // from the side that is nearer to the ground on
    let side = if across[1] < 0.0 { -1.0 } else { 1.0 };
    let across = across.map(|change| side * change);
    let mut means = [0.0; MEANS];
    let Some([low, high]) = held_part(law, middle, across) else { return means };
    let cohesive = &law.cohesive;
    let slips = across[0].hypot(across[2]) / law.slip_scale;
    let knots = Part::Pull.knots(cohesive.shape);
    // without a tilt they are infinite, or no numbers
    let corners = knots.map(|opening| (cohesive.closed + cohesive.range * opening - middle[1]) / across[1]);
    let piece = if law.exponent.is_some() { MIXED_PIECE } else { PIECE };
    let mut from = low;
    for to in corners.filter(|place| *place > low && *place < high).chain([high]) {
        // what pulls a face that is pressed changes with its slip alone
        let is_open = middle[1] + 0.5 * (from + to) * across[1] > cohesive.closed;
        let opens = if is_open { across[1] / cohesive.range } else { 0.0 };
        let change = opens.max(slips) / piece * (to - from);
        let pieces = change.ceil().max(if change > SMALL { 2.0 } else { 1.0 });
        let half = 0.5 * (to - from) / pieces;
        for piece in 0..pieces as usize {
            let center = from + half * (2.0 * piece as f64 + 1.0);
            for (s, weight) in six_points(center, half) {
                let place = std::array::from_fn(|k| middle[k] + s * across[k]);
                add(&mut means, &density(law, place), weight, side * s);
            }
        }
        from = to;
    }
    means
}

/// Between which s anything is left of the law.
fn held_part(law: &ShearedLaw, middle: [f64; 3], across: [f64; 3]) -> Option<[f64; 2]> {
    let (mut low, mut high) = (-0.5f64, 0.5f64);
    let square = across[0] * across[0] + across[2] * across[2];
    let along = middle[0] * across[0] + middle[2] * across[2];
    let beyond = middle[0] * middle[0] + middle[2] * middle[2] - FAR * law.slip_scale * law.slip_scale;
    // it slips by more than that where square s² + 2 along s + beyond is above zero
    if square > 0.0 {
        let root = (along * along - square * beyond).max(0.0).sqrt();
        low = low.max((-along - root) / square);
        high = high.min((-along + root) / square);
    } else if beyond > 0.0 {
        return None;
    }
    let cohesive = &law.cohesive;
    let corner = cohesive.shape.knots().last().copied();
    let open = corner.filter(|&corner| Part::Pull.at(cohesive.shape, corner)[0] == 0.0).unwrap_or(OPEN);
    let last = cohesive.closed + cohesive.range * open;
    if across[1] > 0.0 {
        high = high.min((last - middle[1]) / across[1]);
    } else if middle[1] > last {
        return None;
    }
    (low < high).then_some([low, high])
}

/// ψ, ∇ψ, f and ∇f at a place (x, r, z).
#[inline(always)]
fn density(law: &ShearedLaw, [x, r, z]: [f64; 3]) -> [f64; DENSITY] {
    let [work, traction, slope] = law.cohesive.levels_of(Part::Pull, r);
    let curved = 2.0 / law.slip_scale.powi(2);
    let hold = (-0.5 * curved * (x * x + z * z)).exp();
    let (pull, open) = (work * hold, -traction * hold);
    let (by_x, by_z) = (-(curved * x), -(curved * z));
    let change = [pull * by_x, open, pull * by_z];
    let (open_x, open_z, pull_xz) = (open * by_x, open * by_z, pull * by_x * by_z);
    let (mut force, mut rows) = (
        change,
        [
            [pull * (by_x * by_x - curved), open_x, pull_xz],
            [open_x, slope * hold, open_z],
            [pull_xz, open_z, pull * (by_z * by_z - curved)],
        ],
    );
    if !law.has_potential() {
        for k in [0, 2] {
            force[k] *= law.work_ratio;
            rows[k] = rows[k].map(|entry| entry * law.work_ratio);
        }
        let per_work = -1.0 / law.cohesive.work();
        if let Some([factor, by_open, by_hold]) = law.mixed_at([work * per_work, hold]) {
            let by_place = [by_hold * hold * by_x, -by_open * per_work * traction, by_hold * hold * by_z];
            for k in 0..3 {
                for l in 0..3 {
                    rows[k][l] = rows[k][l] * factor + force[k] * by_place[l];
                }
                force[k] *= factor;
            }
        }
    }
    let mut all = [pull; DENSITY];
    all[1..4].copy_from_slice(&change);
    all[4..7].copy_from_slice(&force);
    all[7..].copy_from_slice(rows.as_flattened());
    all
}

#[inline(always)]
fn add(means: &mut [f64; MEANS], density: &[f64; DENSITY], weight: f64, s: f64) {
    means[0] += weight * density[0];
    for (moment, factor) in [weight, weight * s, weight * s * s].into_iter().enumerate() {
        if moment < 2 {
            (0..3).for_each(|k| means[1 + 3 * moment + k] += factor * density[1 + k]);
            (0..3).for_each(|k| means[7 + 3 * moment + k] += factor * density[4 + k]);
        }
        (0..9).for_each(|k| means[13 + 9 * moment + k] += factor * density[7 + k]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::section::calibrated::Cohesive;
    use crate::adhesion::{CohesiveShape, HalfSpace, Rule};
    use std::num::NonZeroUsize;

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    /// Where it is tilted and turned, a little or much, and partly closed, by a rule far finer than it need be between the corners.
    #[test]
    fn means_are_those_of_a_fine_rule() {
        let rule = Rule::new(NonZeroUsize::new(10).unwrap());
        for &shape in CohesiveShape::ALL {
            let cohesive = Cohesive::calibrated(shape, PAPER.strength(), PAPER.work_of_adhesion(), &PAPER);
            let tough = ShearedLaw::new(cohesive, 0.6 * PAPER.strength(), Some(2.5 * PAPER.work_of_adhesion()));
            let laws = [ShearedLaw::new(cohesive, 0.6 * PAPER.strength(), None), tough, tough.with_exponent(Some(2.3))];
            for (law, tilt) in
                laws.iter().flat_map(|law| [-20.0, -0.6, -1e-9, 0.0, 0.1, 1.7, 30.0].map(|tilt| (law, tilt)))
            {
                for (turn, lowest) in [(0.0, -0.3), (0.2, 0.04), (3.0, 0.3), (40.0, -0.1)] {
                    let r = cohesive.closed + cohesive.range * (lowest + 0.5 * f64::abs(tilt));
                    let middle = [0.4 * law.slip_scale, r, -0.3 * law.slip_scale];
                    let across = [turn * law.slip_scale, tilt * cohesive.range, -0.5 * turn * law.slip_scale];
                    let place = |s: f64| std::array::from_fn(|k| middle[k] + s * across[k]);
                    let corners =
                        Part::Pull.knots(shape).map(|opening| (opening - lowest) / tilt - 0.5f64.copysign(tilt));
                    let mut ends: Vec<f64> = corners.filter(|corner| corner.abs() < 0.5).chain([-0.5, 0.5]).collect();
                    ends.sort_by(f64::total_cmp);
                    let (mut sums, mut sizes) = ([0.0; MEANS], [0.0; MEANS]);
                    for part in ends.windows(2) {
                        let end = |k: i32| part[0] + (part[1] - part[0]) * f64::from(k) / 200.0;
                        for (s, weight) in (0..200).flat_map(|k| rule.over(end(k), end(k + 1))) {
                            let density = density(law, place(s));
                            add(&mut sums, &density, weight, s);
                            add(&mut sizes, &density.map(f64::abs), weight, s.abs());
                        }
                    }
                    let found = at_one(law, middle, across);
                    for k in 0..MEANS {
                        let (off, most) = ((found[k] - sums[k]).abs(), 1e-9 * sizes[k] + 1e-15);
                        assert!(off <= most, "mean {k} of {shape:?} at {tilt}, {turn}, {lowest}: {off:e}, {most:e}");
                    }
                }
            }
        }
    }
}
