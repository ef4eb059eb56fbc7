//! A cohesive law that holds along the ground as well: one potential of opening and slip.
//!
//! A point of the bonded face that lay at X(S) on the ground has slipped by t = x + (h/2) sin θ - X(S). The traction of an open face, of
//! [`super::cohesive`], loses its hold with the slip, and what repels a pressed one does not:
//!
//!   Ψ(x, y, θ) = Ψ_pull(y, θ) B(t) + Ψ_push(y, θ),   B(t) = exp(-t²/δ_t²).
//!
//! With the work of adhesion w the shear traction on a closed face is 2 w t/δ_t² B(t). Its largest value, at t = δ_t/√2, is the shear strength
//! τ = (2/e)^(1/2) w/δ_t, and its work is w: as much as it takes to open the face. The load is minus the gradient of Ψ, so the tangent is symmetric, and
//! an equilibrium does not depend on how it was reached.
//!
//! With a work w_t of its own the shear traction is w_t/w times as large, and δ_t = (2/e)^(1/2) w_t/τ. Opening and slip take the works
//!
//!   G_n = w ∫ B (-dA),   G_t = w_t ∫ A (-dB),   A = Ψ_pull/Ψ_pull(closed),
//!
//! and both A and B fall from one to zero, or one of them does: so G_n/w + G_t/w_t = 1, the linear criterion of mixed modes, whatever the way. Unless
//! the works are equal there is no potential, and the tangent is not symmetric.
//!
//! With an exponent η both tractions are κ_e times as large,
//!
//!   κ_e = 1 + 2 (κ(m) - 1) (1 - AB),   κ = (1 - m + m w/w_t) (1 + (w_t/w - 1) m^η),   m = w_t q/(w p + w_t q),   p = -ln A,   q = -ln B.
//!
//! On a way on which q/p is constant G_t/(G_n + G_t) is m, and as the integral of 2 (1 - AB) d(AB) is one,
//!
//!   G_n + G_t = w + (w_t - w) m^η,
//!
//! the criterion of Benzeggagh and Kenane. From η = 1 to 8 κ is above a half, whatever the works, and κ_e above zero. Pure opening and pure slip are as they were, and so is the stiffness of a closed face.
//!
//! Where a face that lets go does not heal, both A and B remember how far it has been open and has slipped at most. Nearer than that they are
//! parabolas, whose tractions fall in straight lines to nothing where the face is closed and has not slipped:
//!
//!   A(r) = A(r_max) - ½ A'(r_max) (r_max - r_eq) (1 - (r - r_eq)²/(r_max - r_eq)²),   B(t) = B(t_max) (1 + (t_max² - t²)/δ_t²).
//!
//! Sources: the coupling is that of X.-P. Xu and A. Needleman, Numerical simulations of fast crack growth in brittle solids, J. Mech. Phys. Solids 42
//! (1994), eq. (5) with q = 1 and r = 0, for a normal law of any shape and without its loss of stiffness under pressure; two works are those of
//! M. J. van den Bosch, P. J. G. Schreurs, M. G. D. Geers, An improved description of the exponential Xu and Needleman cohesive zone law for
//! mixed-mode decohesion, Eng. Fract. Mech. 73 (2006). The criterion with an exponent: M. L. Benzeggagh, M. Kenane, Measurement of mixed-mode
//! delamination fracture toughness of unidirectional glass/epoxy composites with mixed-mode bending apparatus, Compos. Sci. Technol. 56 (1996).

use super::calibrated::Cohesive;
use super::response::LineResponse;
use crate::number::Real;
use crate::number::root::Bracket;
use std::f64::consts::{E, FRAC_1_SQRT_2};

/// Works that differ by no more than this share are the same.
const SAME_WORK: f64 = 1e-12;

/// A cohesive law with a shear strength, on level ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShearedLaw {
    /// What opens and presses the face
    pub cohesive: Cohesive,
    /// δ_t, nm
    pub slip_scale: f64,
    /// w_t/w
    pub work_ratio: f64,
    /// η of Benzeggagh and Kenane; none: the linear criterion
    pub exponent: Option<f64>,
}

/// Potential and load of a section per length and width, with the tangent, by x, y and θ. The load is minus the gradient, which is that of the
/// potential where the works are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShearedResponse<T> {
    /// Ψ, nN/nm
    pub energy: T,
    /// How Ψ changes with x, y and θ: minus the load, where that has a potential
    pub energy_change: [T; 3],
    /// Minus the load: nN/nm², nN/nm², nN/nm
    pub gradient: [T; 3],
    /// How each of these changes with x, y and θ
    pub tangent: [[T; 3]; 3],
}

/// How far a face has been at most, where what lets go does not heal; zero where it has not been anywhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Farthest<T> {
    /// Distance of the bonded face from the ground, nm
    pub distance: T,
    /// Slip along the ground, either way, nm
    pub slip: T,
}

impl ShearedLaw {
    /// That of a face that slides freely.
    pub(crate) fn sliding(cohesive: Cohesive) -> Self {
        Self { cohesive, slip_scale: f64::INFINITY, work_ratio: 1.0, exponent: None }
    }

    /// Whether nothing holds it along the ground.
    pub(crate) fn is_sliding(&self) -> bool {
        self.slip_scale == f64::INFINITY
    }

    /// With this shear strength, nN/nm², and work in shear, nN/nm; none: that of opening.
    pub(crate) fn new(cohesive: Cohesive, shear_strength: f64, shear_work: Option<f64>) -> Self {
        let work = cohesive.work();
        // a work that is that of opening but for its rounding is that one
        let shear_work = shear_work.filter(|own| (own / work - 1.0).abs() > SAME_WORK).unwrap_or(work);
        let (slip_scale, work_ratio) = ((2.0 / E).sqrt() * shear_work / shear_strength, shear_work / work);
        Self { cohesive, slip_scale, work_ratio, exponent: None }
    }

    /// The same with this exponent of Benzeggagh and Kenane, from 1 to 8; none: the linear criterion. Of equal works both are the same.
    pub(crate) fn with_exponent(self, exponent: Option<f64>) -> Self {
        Self { exponent: exponent.filter(|_| self.work_ratio != 1.0), ..self }
    }

    /// w_t, nN/nm.
    pub(crate) fn shear_work(&self) -> f64 {
        self.work_ratio * self.cohesive.work()
    }

    /// Whether the load has a potential: where slip takes the work that opening does, which leaves no exponent.
    pub(crate) fn has_potential(&self) -> bool {
        self.work_ratio == 1.0
    }

    /// The stiffness along the ground of a closed face that has not slipped, 2 w_t/δ_t², nN/nm³.
    pub(crate) fn stiffness(&self) -> f64 {
        2.0 * self.shear_work() / self.slip_scale.powi(2)
    }

    /// The slip beyond which a thousandth of the shear strength is not reached, nm.
    pub(crate) fn slip_reach(&self) -> f64 {
        let slips = Bracket { low: FRAC_1_SQRT_2, high: 10.0 };
        let holds = |slip: f64| (2.0 * E).sqrt() * slip * (-slip * slip).exp() > 1e-3;
        self.slip_scale * slips.bisected(holds, |left| left.width() <= 1e-12 * left.high).high
    }

    /// The response of a section of this height (nm) whose axis has slipped by `slip` and lies h/2 above the `gap` (nm), with the rotation θ given as
    /// its sine and cosine, and whose face has been so far away and has slipped so far.
    #[inline(never)]
    pub(crate) fn response_after<T: Real>(
        &self,
        height: T,
        [slip, gap]: [T; 2],
        [sin, cos]: [T; 2],
        farthest: Farthest<T>,
    ) -> ShearedResponse<T> {
        let (pull, push) = self.cohesive.pull_and_push(height, gap, [sin, cos], farthest.distance);
        let half = height * 0.5;
        let (lever, arm) = (half * cos, half * sin);
        let t = slip + arm;
        // B, B' and B''
        let [hold, slope, bend] = t.each_pair(farthest.slip, |t, most| self.hold(t, most));
        // the shear traction and its changes; how the normal one changes with the slip has no factor
        let by_slip = pull.energy * slope;
        let along = by_slip * self.work_ratio;
        let along_along = pull.energy * bend * self.work_ratio;
        let (gap_along, turn_along) = (pull.by_gap * slope, pull.by_rotation * slope);
        let along_gap = gap_along * self.work_ratio;
        let along_rotation = turn_along * self.work_ratio + along_along * lever;
        let gap_rotation = |along: T| pull.gap_rotation * hold + along * lever + push.gap_rotation;
        let rotation_rotation = pull.rotation_rotation * hold + (turn_along + along_rotation) * lever - along * arm
            + push.rotation_rotation;
        let (by_gap, by_rotation) = (pull.by_gap * hold + push.by_gap, pull.by_rotation * hold + push.by_rotation);
        let response = ShearedResponse {
            energy: pull.energy * hold + push.energy,
            energy_change: [by_slip, by_gap, by_rotation + by_slip * lever],
            gradient: [along, by_gap, by_rotation + along * lever],
            tangent: [
                [along_along, along_gap, along_rotation],
                [gap_along, pull.gap_gap * hold + push.gap_gap, gap_rotation(gap_along)],
                [turn_along + along_along * lever, gap_rotation(along_gap), rotation_rotation],
            ],
        };
        match self.exponent {
            None => response,
            Some(exponent) => self.mixed(exponent, response, [pull, push], [hold, slope, lever]),
        }
    }

    /// The response with the tractions of what pulls κ_e times as large, B and B' at the slip of the face, whose lever is that of a rotation.
    #[inline(always)]
    fn mixed<T: Real>(
        &self,
        exponent: f64,
        linear: ShearedResponse<T>,
        [pull, push]: [LineResponse<T>; 2],
        [hold, slope, lever]: [T; 3],
    ) -> ShearedResponse<T> {
        let zero = T::splat(0.0);
        let per_work = -1.0 / self.cohesive.work();
        let open = pull.energy * per_work;
        let [factor, by_open, by_hold] =
            open.each_pair(hold, |open, hold| mixing(exponent, self.work_ratio, [open, hold]));
        let (by_slip, by_opening) = (by_hold * slope, by_open * per_work);
        let change = [by_slip, by_opening * pull.by_gap, by_opening * pull.by_rotation + by_slip * lever];
        let pushed = [zero, push.by_gap, push.by_rotation];
        let pushed_twice =
            [[zero; 3], [zero, push.gap_gap, push.gap_rotation], [zero, push.gap_rotation, push.rotation_rotation]];
        let pulled: [T; 3] = std::array::from_fn(|i| linear.gradient[i] - pushed[i]);
        ShearedResponse {
            gradient: std::array::from_fn(|i| pulled[i] * factor + pushed[i]),
            tangent: std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    (linear.tangent[i][j] - pushed_twice[i][j]) * factor + pulled[i] * change[j] + pushed_twice[i][j]
                })
            }),
            ..linear
        }
    }
}

/// Where less than this share of a law is left, its tractions are nothing.
const NOTHING: f64 = 1e-100;

/// κ and dκ/dm.
fn toughening(exponent: f64, ratio: f64, mode: f64) -> [f64; 2] {
    let (linear, power) = (1.0 - mode + mode / ratio, mode.powf(exponent - 1.0));
    let criterion = 1.0 + (ratio - 1.0) * mode * power;
    [linear * criterion, (1.0 / ratio - 1.0) * criterion + linear * (ratio - 1.0) * exponent * power]
}

/// κ_e and its changes with A and B.
fn mixing(exponent: f64, ratio: f64, [open, hold]: [f64; 2]) -> [f64; 3] {
    let left = open * hold;
    let (p, q) = (-open.min(1.0).ln(), -ratio * hold.ln());
    let sum = p + q;
    if !(left > NOTHING && sum > 0.0) {
        return [1.0, 0.0, 0.0];
    }
    let [by_mode, gone] = [1.0 / (sum * sum), 1.0 - left];
    let [toughening, slope] = toughening(exponent, ratio, q / sum);
    let (excess, changing) = (2.0 * (toughening - 1.0), 2.0 * slope * gone * by_mode);
    [1.0 + excess * gone, changing * q / open - excess * hold, -changing * ratio * p / hold - excess * open]
}

impl ShearedLaw {
    /// κ_e and its changes with A and B; none where the criterion is linear.
    pub(in crate::adhesion) fn mixed_at(&self, left: [f64; 2]) -> Option<[f64; 3]> {
        self.exponent.map(|exponent| mixing(exponent, self.work_ratio, left))
    }

    /// B at a slip (nm) and its two derivatives, of a face that has slipped so far at most.
    #[inline(always)]
    fn hold(&self, t: f64, most: f64) -> [f64; 3] {
        let curved = 2.0 / self.slip_scale.powi(2);
        if t.abs() >= most {
            let hold = (-0.5 * curved * t * t).exp();
            return [hold, -(t * hold * curved), (t * t * curved - 1.0) * hold * curved];
        }
        let left = (-0.5 * curved * most * most).exp();
        [left * (1.0 + 0.5 * curved * (most * most - t * t)), -(t * left * curved), -(left * curved)]
    }

    /// What a section like that of [`Self::response_after`] has been at most, together with what it was before.
    pub(crate) fn farthest(
        &self,
        height: f64,
        [slip, gap]: [f64; 2],
        rotation: f64,
        before: Farthest<f64>,
    ) -> Farthest<f64> {
        let (sin, cos) = rotation.sin_cos();
        let (distance, slip) = (gap + 0.5 * height * (1.0 - cos), slip + 0.5 * height * sin);
        let slip = if self.is_sliding() { 0.0 } else { slip.abs() };
        Farthest { distance: before.distance.max(distance), slip: before.slip.max(slip) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::HalfSpace;
    use crate::adhesion::section::cohesive::CohesiveShape;
    use approx::assert_relative_eq;

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
    const HEIGHT: f64 = 3.0;

    fn law(shape: CohesiveShape) -> ShearedLaw {
        let cohesive = Cohesive::calibrated(shape, PAPER.strength(), PAPER.work_of_adhesion(), &PAPER);
        ShearedLaw::new(cohesive, 0.6 * PAPER.strength(), None)
    }

    /// The same with 2.5 times the work in shear.
    fn tough(shape: CohesiveShape) -> ShearedLaw {
        ShearedLaw::new(law(shape).cohesive, 0.6 * PAPER.strength(), Some(2.5 * PAPER.work_of_adhesion()))
    }

    /// Of Benzeggagh and Kenane.
    fn mixed(shape: CohesiveShape) -> ShearedLaw {
        tough(shape).with_exponent(Some(2.3))
    }

    fn at(law: &ShearedLaw, [slip, gap, rotation]: [f64; 3]) -> ShearedResponse<f64> {
        let (sin, cos) = rotation.sin_cos();
        law.response_after(HEIGHT, [slip, gap], [sin, cos], Farthest::default())
    }

    /// Sixth order differences of energy and gradient, at open and pressed, turned and turned over sections.
    #[test]
    fn gradient_and_tangent_are_differences() {
        let laws = CohesiveShape::ALL.iter().flat_map(|&shape| [law(shape), tough(shape), mixed(shape)]);
        for law in laws {
            let (closed, range) = (law.cohesive.closed, law.cohesive.range);
            let scales = [law.slip_scale, range, 0.1];
            for (slip, opening, rotation) in
                [(0.0, 0.2, 0.0), (0.3, 0.4, 0.2), (-0.7, 1.3, -0.4), (0.5, -0.2, 0.05), (1.2, 0.45, 2.0)]
            {
                let lift = 0.5 * HEIGHT * (1.0 - f64::cos(rotation));
                let place =
                    [slip * scales[0] - 0.5 * HEIGHT * f64::sin(rotation), closed + opening * range - lift, rotation];
                let here = at(&law, place);
                for f in 0..3 {
                    let step = 1e-3 * scales[f];
                    let moved = |k: f64| {
                        let mut moved = place;
                        moved[f] += k * step;
                        at(&law, moved)
                    };
                    let slope = |of: &dyn Fn(&ShearedResponse<f64>) -> f64| {
                        let pair = |k: f64| of(&moved(k)) - of(&moved(-k));
                        (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * step)
                    };
                    let size = law.cohesive.work() / scales[f];
                    // A section that is turned over is pressed hard, and the difference rounds what is large.
                    let rounding = |value: f64| 8.0 * f64::EPSILON * value.abs() / step;
                    assert_relative_eq!(
                        slope(&|at| at.energy),
                        here.energy_change[f],
                        epsilon = 1e-8 * size + rounding(here.energy),
                        max_relative = 1e-8
                    );
                    if law.has_potential() {
                        assert_eq!(here.energy_change, here.gradient);
                    }
                    for g in 0..3 {
                        let size = size / scales[g];
                        let found = slope(&|at| at.gradient[g]);
                        assert_relative_eq!(
                            found,
                            here.tangent[g][f],
                            epsilon = 1e-7 * size + rounding(here.gradient[g]),
                            max_relative = 1e-7
                        );
                    }
                }
            }
        }
    }

    /// The shear traction of a closed face: its largest value and its work.
    #[test]
    fn strength_and_work_along_the_ground() {
        let law = law(CohesiveShape::Exponential);
        let traction = |t: f64| at(&law, [t, law.cohesive.closed, 0.0]).gradient[0];
        let largest = traction(law.slip_scale / 2.0_f64.sqrt());
        assert_relative_eq!(largest, 0.6 * PAPER.strength(), max_relative = 1e-13);
        assert!([0.7, 0.71].iter().all(|&t| traction(t * law.slip_scale) < largest));
        let reach = law.slip_reach();
        assert_relative_eq!(traction(reach), 1e-3 * largest, max_relative = 1e-9);
        assert!(reach > law.slip_scale);
        let energy = |t: f64| at(&law, [t, law.cohesive.closed, 0.0]).energy;
        assert_relative_eq!(energy(9.0 * law.slip_scale) - energy(0.0), PAPER.work_of_adhesion(), max_relative = 1e-13);
        let stiffness = at(&law, [0.0, law.cohesive.closed, 0.0]).tangent[0][0];
        assert_relative_eq!(stiffness, law.stiffness(), max_relative = 1e-13);
    }

    /// Of a face that has been farther: sixth order differences, tractions that go on where it is as far away as ever, and fall in straight lines
    /// to nothing where it is closed.
    #[test]
    fn what_has_let_go_unloads_to_where_it_was_closed() {
        let laws = CohesiveShape::ALL.iter().flat_map(|&shape| [law(shape), tough(shape)]);
        for law in laws {
            let (closed, range, far) = (law.cohesive.closed, law.cohesive.range, 0.6);
            let before = Farthest { distance: closed + far * range, slip: 0.8 * law.slip_scale };
            let at = |[slip, opening]: [f64; 2]| {
                law.response_after(HEIGHT, [slip * law.slip_scale, closed + opening * range], [0.0, 1.0], before)
            };
            let there = at([0.8, far]);
            let virgin = law.response_after(HEIGHT, [before.slip, before.distance], [0.0, 1.0], Farthest::default());
            assert_eq!(there, virgin);
            let just_before = at([0.8 - 1e-9, far - 1e-9]);
            for f in 0..3 {
                assert_relative_eq!(
                    just_before.gradient[f],
                    virgin.gradient[f],
                    epsilon = 1e-7 * law.cohesive.strength
                );
            }
            assert_relative_eq!(just_before.energy, virgin.energy, max_relative = 1e-7);
            // at the slip that it has had, half of the opening carries half of the traction
            assert_relative_eq!(at([0.8, 0.3]).gradient[1], 0.5 * virgin.gradient[1], max_relative = 1e-12);
            assert_eq!(at([0.8, 0.0]).gradient[1], 0.0);
            let [one, two] = [0.2, 0.4].map(|slip| at([slip, far]).gradient[0]);
            assert_relative_eq!(two, 2.0 * one, max_relative = 1e-12);
            for (slip, opening, rotation) in [(0.3, 0.4, 0.1), (-0.5, 0.1, -0.2), (0.2, 0.7, 0.0), (1.2, 0.3, 0.05)] {
                let lift = 0.5 * HEIGHT * (1.0 - f64::cos(rotation));
                let scales = [law.slip_scale, range, 0.1];
                let place =
                    [slip * scales[0] - 0.5 * HEIGHT * f64::sin(rotation), closed + opening * range - lift, rotation];
                let response = |[slip, gap, rotation]: [f64; 3]| {
                    let (sin, cos) = rotation.sin_cos();
                    law.response_after(HEIGHT, [slip, gap], [sin, cos], before)
                };
                let here = response(place);
                for f in 0..3 {
                    let step = 1e-3 * scales[f];
                    let moved =
                        |k: f64| response(std::array::from_fn(|g| place[g] + if g == f { k * step } else { 0.0 }));
                    let slope = |of: &dyn Fn(&ShearedResponse<f64>) -> f64| {
                        let pair = |k: f64| of(&moved(k)) - of(&moved(-k));
                        (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * step)
                    };
                    let size = law.cohesive.work() / scales[f];
                    assert_relative_eq!(slope(&|at| at.energy), here.energy_change[f], epsilon = 1e-8 * size);
                    for g in 0..3 {
                        let found = slope(&|at| at.gradient[g]);
                        assert_relative_eq!(
                            found,
                            here.tangent[g][f],
                            epsilon = 1e-7 * size / scales[g],
                            max_relative = 1e-7
                        );
                    }
                }
            }
        }
    }

    /// A face that goes out and back again, in one mode or in both, gives back no more than it took, and what it has taken is the work that is spent.
    #[test]
    fn a_way_out_and_back_takes_work() {
        let law = law(CohesiveShape::Bilinear);
        let (closed, range, steps) = (law.cohesive.closed, law.cohesive.range, 4000);
        for [slip, opening] in [[0.0, 0.5], [0.7, 0.0], [0.6, 0.3], [3.0, 2.0]] {
            let (mut before, mut work) = (Farthest::default(), 0.0);
            let place = |s: f64| [s * slip * law.slip_scale, closed + s * opening * range];
            for k in 0..2 * steps {
                let part = |k: f64| 1.0 - (k / f64::from(steps) - 1.0).abs();
                let [from, middle, to] = [0.0, 0.5, 1.0].map(|half| place(part(f64::from(k) + half)));
                let load = law.response_after(HEIGHT, middle, [0.0, 1.0], before).gradient;
                before = law.farthest(HEIGHT, to, 0.0, before);
                work += load[0] * (to[0] - from[0]) + load[1] * (to[1] - from[1]);
            }
            let spent = law.response_after(HEIGHT, place(0.0), [0.0, 1.0], before).energy + law.cohesive.work();
            assert_relative_eq!(work, spent, epsilon = 1e-5 * law.cohesive.work());
            assert!(spent > 0.01 * law.cohesive.work() && spent <= law.cohesive.work() * (1.0 + 1e-12), "{spent}");
        }
    }

    /// Along straight and bent ways from a closed face to one that has let go: the works of both modes, summed up, meet the linear criterion.
    #[test]
    fn works_of_both_modes_meet_the_linear_criterion() {
        let law = tough(CohesiveShape::Exponential);
        let (closed, range) = (law.cohesive.closed, law.cohesive.range);
        let [work, shear_work] = [law.cohesive.work(), law.shear_work()];
        assert_relative_eq!(shear_work, 2.5 * PAPER.work_of_adhesion(), max_relative = 1e-14);
        let ways: [fn(f64) -> [f64; 2]; 4] =
            [|s| [0.0, 40.0 * s], |s| [9.0 * s, 0.0], |s| [9.0 * s, 40.0 * s], |s| [2.0 * s, 40.0 * s * s]];
        let mut shares = Vec::new();
        for way in ways {
            let place = |s: f64| {
                let [slip, opening] = way(s);
                [slip * law.slip_scale, closed + opening * range, 0.0]
            };
            // the middle rule converges with its second order
            let (steps, mut works) = (20_000, [0.0; 2]);
            for k in 0..steps {
                let [from, to] = [k, k + 1].map(|k| place(f64::from(k) / f64::from(steps)));
                let load = at(&law, place((f64::from(k) + 0.5) / f64::from(steps))).gradient;
                works[0] += load[1] * (to[1] - from[1]);
                works[1] += load[0] * (to[0] - from[0]);
            }
            let shear = works[1] / shear_work;
            assert_relative_eq!(works[0] / work + shear, 1.0, epsilon = 2e-5);
            shares.push(shear);
        }
        assert!(shares[0] == 0.0 && (shares[1] - 1.0).abs() < 1e-5, "{shares:?}");
        assert!(shares[2..].iter().all(|share| (0.02..0.98).contains(share)), "{shares:?}");
    }

    /// On ways of constant q/p: the works of both modes have the mode m, and meet the criterion of Benzeggagh and Kenane. Opening and slip alone take
    /// what they take by the linear criterion, to the last bit.
    #[test]
    fn works_on_ways_of_one_mode_meet_the_criterion_of_benzeggagh_and_kenane() {
        let law = mixed(CohesiveShape::Exponential);
        let (closed, range, ratio) = (law.cohesive.closed, law.cohesive.range, law.work_ratio);
        let linear = ShearedLaw { exponent: None, ..law };
        for k in 0..60 {
            let far = f64::from(k) * 0.1;
            let [opened, slipped] = [[0.0, closed + far * range, 0.0], [far * law.slip_scale, closed, 0.0]]
                .map(|place| (at(&law, place), at(&linear, place)));
            assert_eq!(opened.0.gradient, opened.1.gradient);
            assert_eq!(slipped.0.gradient, slipped.1.gradient);
        }
        for share in [0.05, 0.3, 0.6, 1.0, 2.0, 8.0] {
            // p of the exponential law at an opening, and the slip whose q is so many times as large
            let place = |opening: f64| {
                let p = opening - opening.ln_1p();
                [(share * p).sqrt() * law.slip_scale, closed + opening * range, 0.0]
            };
            let (steps, mut works) = (40_000, [0.0; 2]);
            for k in 0..steps {
                let [from, middle, to] =
                    [0.0, 0.5, 1.0].map(|half| place(45.0 * (f64::from(k) + half) / f64::from(steps)));
                let load = at(&law, middle).gradient;
                works[0] += load[1] * (to[1] - from[1]);
                works[1] += load[0] * (to[0] - from[0]);
            }
            let mode = ratio * share / (1.0 + ratio * share);
            let expected = law.cohesive.work() * (1.0 + (ratio - 1.0) * mode.powf(2.3));
            assert_relative_eq!(works[1] / (works[0] + works[1]), mode, epsilon = 1e-5);
            assert_relative_eq!(works[0] + works[1], expected, max_relative = 1e-5);
        }
    }

    /// The largest exponent that is taken: κ stays above a half, so that tractions keep their sign.
    #[test]
    fn tractions_keep_their_sign() {
        let ratios = (-60..=60).map(|k| 10f64.powf(0.05 * f64::from(k)));
        let least = ratios.flat_map(|ratio| (0..=1000).map(move |k| toughening(8.0, ratio, f64::from(k) / 1000.0)[0]));
        let least = least.fold(f64::INFINITY, f64::min);
        assert!((0.52..0.53).contains(&least), "{least}");
    }
}
