//! Sections whose face is held where it was bonded, by local changes of their fields; symbols are those of the energy density.
//!
//! A point of the bonded face at s b d2 from the middle of its width has been displaced by
//!
//!   d = r - r0 + (R - R0) ℓ,   ℓ = s b e2 - (h/2) e3,
//!
//! from the stress-free configuration r0, R0, in which it was bonded; along the ground that is its slip. The load there is -f, and where it has a
//! potential f = ∇ψ. The work against it is f·δr + 2 ω·(ℓ × Rᵀ f), and the change of that is the one of f, and of ℓ·(Rᵀ f) with f as it is.

use super::kinematics::{Kinematics, SPATIAL_FIELDS, turned_twice};
use super::spatial_profile::Station;
use crate::adhesion::section::sheared::ShearedLaw;
use crate::adhesion::spatial_section::held_face::{HeldMeans, means};
use crate::beam::spatial::rest::BranchRest;
use crate::beam::spatial::rotation::{
    Matrix3, apply_transposed, cross, matrix, multiply, multiply_transposed, normalised,
};
use crate::number::Real;

/// What holds the bonded face of sections along the ground, and where they were bonded.
#[derive(Clone, Debug)]
pub struct HeldSections {
    /// The law; that of opening without a slip is that of the sections
    pub(crate) law: ShearedLaw,
    /// Where they are without stress
    pub(crate) rest: BranchRest,
}

/// What pulls at a point: energy, and minus the load by the place and (α, ω), with its changes.
pub(super) struct LocalHold<T> {
    pub energy: T,
    /// How the energy changes with the place, and with (α, ω)
    pub change: ([T; 3], [T; 4]),
    pub by_place: [T; 3],
    pub by_value: [T; 4],
    pub place_place: Matrix3<T>,
    pub place_value: [[T; 4]; 3],
    /// Of what goes with (α, ω), by the place
    pub value_place: [[T; 3]; 4],
    pub value_value: [[T; 4]; 4],
}

impl HeldSections {
    /// What pulls at a section at S with its axis at this place, nm.
    #[inline(always)]
    pub(super) fn pull<T: Real>(
        &self,
        arc: T,
        place: [T; 3],
        at: &Kinematics<T>,
        station: &Station<T>,
    ) -> LocalHold<T> {
        let zero = T::splat(0.0);
        let (b, half) = (station.width, station.height * 0.5);
        let [x0, z0, aside_x, aside_z, up_x, up_z] = self.bonded(arc);
        let r = &at.frame;
        let middle = [
            place[0] - x0 - (r[0][2] - up_x) * half,
            place[1] - r[1][2] * half,
            place[2] - z0 - (r[2][2] - up_z) * half,
        ];
        let across = [(r[0][1] - aside_x) * b, r[1][1] * b, (r[2][1] - aside_z) * b];
        let HeldMeans { energy, change, gradient, hessian } = means(&self.law, middle, across);
        // ℓ is one lever, and s times another one
        let levers = [[zero, zero, -half], [zero, b, zero]];
        let [one, first, second] = hessian.map(|moment| moment.map(|row| row.map(|entry| entry * b)));
        // how the displacement of a point changes with ω: 2 R (ω × ℓ)
        let [fixed, aside] = levers.map(|lever| turned_by(r, lever));
        let place_turn = sum(&multiply(&one, &fixed), &multiply(&first, &aside));
        let aside_turn = sum(&multiply(&first, &fixed), &multiply(&second, &aside));
        let turn_place = sum(&multiply_transposed(&fixed, &one), &multiply_transposed(&aside, &first));
        let turn_turn = sum(&multiply_transposed(&fixed, &place_turn), &multiply_transposed(&aside, &aside_turn));
        let mut out = LocalHold {
            energy: energy * b,
            change: (change[0].map(|force| force * b), [zero; 4]),
            by_place: gradient[0].map(|force| force * b),
            by_value: [zero; 4],
            place_place: one,
            place_value: [[zero; 4]; 3],
            value_place: [[zero; 3]; 4],
            value_value: [[zero; 4]; 4],
        };
        for i in 0..3 {
            for j in 0..3 {
                out.place_value[i][j + 1] = place_turn[i][j];
                out.value_place[i + 1][j] = turn_place[i][j];
                out.value_value[i + 1][j + 1] = turn_turn[i][j];
            }
        }
        for ((force, change), lever) in gradient.into_iter().zip(change).zip(levers) {
            let local = |force: [T; 3]| apply_transposed(r, &force.map(|force| force * b));
            let (moment, changed) = (cross(lever, local(force)), cross(lever, local(change)));
            for i in 0..3 {
                out.by_value[i + 1] = out.by_value[i + 1] + moment[i] * 2.0;
                out.change.1[i + 1] = out.change.1[i + 1] + changed[i] * 2.0;
            }
            turned_twice(lever, local(force), &mut out.value_value);
        }
        out
    }

    /// How far the middle of the face of a section at S, of this height and with these fields, has slipped, nm.
    pub(in crate::beam::spatial) fn slip(&self, place: f64, height: f64, fields: &[f64; SPATIAL_FIELDS]) -> f64 {
        let [x, _, z, turn @ ..] = *fields;
        let [x0, z0, _, _, up_x, up_z] = self.bonded(place);
        let frame = matrix(normalised(turn));
        let half = 0.5 * height;
        (x - x0 - half * (frame[0][2] - up_x)).hypot(z - z0 - half * (frame[2][2] - up_z))
    }

    /// Where the section at S was bonded, along the ground: its axis, d2 and d3, x and z of each.
    #[inline(always)]
    fn bonded<T: Real>(&self, arc: T) -> [T; 6] {
        arc.each(|arc| {
            let ([x, _, z], directors) = self.rest.at(arc);
            let [along, _, aside] = matrix(directors);
            [x, z, along[1], aside[1], along[2], aside[2]]
        })
    }
}

/// The columns 2 R (e_j × ℓ).
#[inline(always)]
fn turned_by<T: Real>(frame: &Matrix3<T>, [x, y, z]: [T; 3]) -> Matrix3<T> {
    let zero = T::splat(0.0);
    // e_j × ℓ = -(ℓ × e_j)
    let turns = [[zero, z, -y], [-z, zero, x], [y, -x, zero]];
    multiply(frame, &turns.map(|row| row.map(|entry| entry * 2.0)))
}

#[inline(always)]
fn sum<T: Real>(one: &Matrix3<T>, other: &Matrix3<T>) -> Matrix3<T> {
    std::array::from_fn(|i| std::array::from_fn(|j| one[i][j] + other[i][j]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::section::calibrated::Cohesive;
    use crate::adhesion::section::law::Law;
    use crate::adhesion::section::line_load::{LineLaw, LineLoad};
    use crate::adhesion::section::sheared::Farthest;
    use crate::adhesion::spatial_section::section::{SectionShape, SpatialSection};
    use crate::adhesion::{CohesiveShape, HalfSpace, Rule};
    use crate::beam::element::integrand::Integrand;
    use crate::beam::spatial::rest::{ALONG_X, PlacedRest, SpatialRestCurve};
    use crate::beam::spatial::rotation::{exponential, product};
    use crate::beam::spatial::section::density::SpatialDensity;
    use crate::beam::spatial::section::spatial_profile::{SpatialProfile, SpatialStiffness};
    use nalgebra::SVector;
    use num_dual::{Dual2SVec64, DualNum, hessian};
    use std::num::NonZeroUsize;
    use std::sync::Arc;

    const HALF_SPACE: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
    const WIDTH: f64 = 6.0;
    const HEIGHT: f64 = 4.0;
    const STRENGTH: f64 = 0.01;
    const WORK: f64 = 0.03;

    type Dual = Dual2SVec64<7>;

    /// Bonded where it was moved and turned to about the normal.
    fn density() -> SpatialDensity {
        let law = Cohesive::calibrated(CohesiveShape::Exponential, STRENGTH, WORK, &HALF_SPACE);
        let line = LineLaw {
            half_space: HALF_SPACE,
            height: HEIGHT,
            law: Law::Cohesive(law),
            line_load: LineLoad::Full,
            far_face: true,
        };
        let along_x = SpatialRestCurve::along_x(0.5 * HEIGHT + law.closed).into();
        let placed = PlacedRest { rest: Arc::new(along_x), turn: turned_aside(), origin: [7.0, 0.0, -3.0] };
        let rest = BranchRest::Placed(placed);
        SpatialDensity {
            profile: SpatialProfile::uniform(SpatialStiffness([[0.0; 6]; 6]), WIDTH, HEIGHT),
            adhesion: SpatialSection::new(SectionShape::Rectangle, WIDTH, line).ok(),
            held: Some(HeldSections { law: ShearedLaw::new(law, 0.6 * STRENGTH, None), rest }),
        }
    }

    fn turned_aside() -> [f64; 4] {
        exponential([0.0, 0.4, 0.0])
    }

    /// Slip along x, height, and slip along z of a point of the face, of the fields at S = 2 nm.
    fn place<D: DualNum<f64> + Copy>(v: [D; 7], s: f64) -> [D; 3] {
        let length = (v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]).sqrt();
        let [w, x, y, z]: [D; 4] = std::array::from_fn(|k| v[3 + k] / length);
        let two = |value: D| value * 2.0;
        let d2 = [two(x * y - w * z), -(two(x * x + z * z) - 1.0), two(y * z + w * x)];
        let d3 = [two(x * z + w * y), two(y * z - w * x), -(two(x * x + y * y) - 1.0)];
        let turn = matrix(turned_aside());
        let bonded: [f64; 3] = std::array::from_fn(|i| [7.0, 0.0, -3.0][i] + 2.0 * turn[i][0]);
        let of = |i: usize| v[i] + d2[i] * (s * WIDTH) - d3[i] * (0.5 * HEIGHT);
        // d2 and d3 were -e_z and e_y, turned
        let slip = |i: usize| of(i) - bonded[i] + turn[i][2] * (s * WIDTH) + turn[i][1] * (0.5 * HEIGHT);
        [slip(0), of(1), slip(2)]
    }

    /// The energy as it is defined, open all across.
    fn definition(v: &SVector<Dual, 7>) -> Dual {
        let (range, scale) =
            (WORK / (STRENGTH * std::f64::consts::E), (2.0 / std::f64::consts::E).sqrt() * WORK / (0.6 * STRENGTH));
        let rule = Rule::new(NonZeroUsize::new(24).unwrap());
        let mut energy = Dual::from_re(0.0);
        for (s, weight) in rule.over(-0.5, 0.5) {
            let [x, y, z] = place(std::array::from_fn(|k| v[k]), s);
            let open = (y - HALF_SPACE.equilibrium_gap()) / range;
            let pull = -(open + 1.0) * (-(open - 1.0)).exp() * (STRENGTH * range);
            let hold = (-(x * x + z * z) / (scale * scale)).exp();
            energy += pull * hold * (WIDTH * weight);
        }
        energy
    }

    /// Fields of sections that are open all across.
    fn states() -> Vec<[f64; 7]> {
        let mut seed = 1u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let mut state = || {
            let directors =
                product(product(turned_aside(), ALONG_X), exponential([0.1 * next(), 0.3 * next(), 0.3 * next()]));
            let length = 1.0 + 0.3 * next();
            let axis = [9.0 + 3.0 * next(), 4.5 + next(), -4.0 + 3.0 * next()];
            std::array::from_fn(|k| if k < 3 { axis[k] } else { length * directors[k - 3] })
        };
        (0..100).map(|_| state()).collect()
    }

    /// The derivative of `of` at zero, by a difference of sixth order.
    fn difference(of: impl Fn(f64) -> f64) -> f64 {
        let step = 1e-3;
        let pair = |k: f64| of(k * step) - of(-k * step);
        (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * step)
    }

    fn moved(v: [f64; 7], k: usize, by: f64) -> [f64; 7] {
        std::array::from_fn(|f| if f == k { v[f] + by } else { v[f] })
    }

    /// Where slip takes a work of its own: the work of what the law in the plane says of a face, on what its points move; the tangent by differences.
    #[test]
    fn loads_without_a_potential_work_on_the_places_of_the_face() {
        let law = density().held.unwrap().law;
        let tough = ShearedLaw::new(law.cohesive, 0.6 * STRENGTH, Some(2.5 * WORK));
        let rule = Rule::new(NonZeroUsize::new(24).unwrap());
        for law in [tough, tough.with_exponent(Some(2.3))] {
            let mut density = density();
            density.held.as_mut().unwrap().law = law;
            assert!(!density.is_symmetric());
            for (case, v) in states().into_iter().enumerate() {
                let found = density.response(2.0, &v, &[0.0; 7]);
                let mut wanted = [0.0; 7];
                for (s, weight) in rule.over(-0.5, 0.5) {
                    let [x, y, z] = place(v, s);
                    let slip = x.hypot(z);
                    let [along, open, _] = law.response_after(0.0, [slip, y], [0.0, 1.0], Farthest::default()).gradient;
                    let force = [along * x / slip, open, along * z / slip];
                    for (k, sum) in wanted.iter_mut().enumerate() {
                        let moves = |i: usize| difference(|by| place(moved(v, k, by), s)[i]);
                        *sum += WIDTH * weight * (0..3).map(|i| force[i] * moves(i)).sum::<f64>();
                    }
                }
                let most = 1e-9 * wanted.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
                for i in 0..7 {
                    let off = (found.by_value[i] - wanted[i]).abs();
                    assert!(off <= most, "case {case}: {} and {}", found.by_value[i], wanted[i]);
                    let changes = difference(|by| density.response(2.0, &moved(v, i, by), &[0.0; 7]).energy);
                    let off = (found.coverage_by_value[i] - changes).abs();
                    assert!(off <= most, "case {case}, coverage: {} and {changes}", found.coverage_by_value[i]);
                    for j in 0..7 {
                        let changes = difference(|by| density.response(2.0, &moved(v, j, by), &[0.0; 7]).by_value[i]);
                        let off = (found.value_value[i][j] - changes).abs();
                        assert!(off <= 10.0 * most, "case {case}: {} and {changes}", found.value_value[i][j]);
                    }
                }
            }
        }
    }

    #[test]
    fn energy_and_derivatives_are_those_of_the_definition() {
        let density = density();
        for (case, v) in states().into_iter().enumerate() {
            let (energy, gradient, tangent) = hessian(|v| definition(&v), &v.into());
            let found = density.response(2.0, &v, &[0.0; 7]);
            let most = 1e-11 * tangent.amax().max(gradient.amax()).max(energy.abs());
            let close = |found: f64, wanted: f64, what: &str| {
                assert!((found - wanted).abs() <= most, "case {case}, {what}: {found} and {wanted}, {most:e}");
            };
            close(found.energy, energy, "energy");
            close(found.coverage, energy, "coverage");
            for i in 0..7 {
                close(found.by_value[i], gradient[i], "by a value");
                close(found.coverage_by_value[i], gradient[i], "coverage by a value");
                for j in 0..7 {
                    close(found.value_value[i][j], tangent[(i, j)], "by two values");
                }
            }
        }
    }
}
