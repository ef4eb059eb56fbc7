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
//! Sources: the coupling is that of X.-P. Xu and A. Needleman, Numerical simulations of fast crack growth in brittle solids, J. Mech. Phys. Solids 42
//! (1994), eq. (5) with q = 1 and r = 0, for a normal law of any shape and without its loss of stiffness under pressure; two works are those of
//! M. J. van den Bosch, P. J. G. Schreurs, M. G. D. Geers, An improved description of the exponential Xu and Needleman cohesive zone law for
//! mixed-mode decohesion, Eng. Fract. Mech. 73 (2006).

use super::calibrated::Cohesive;
use crate::number::Real;
use crate::number::root::Bracket;
use std::f64::consts::{E, FRAC_1_SQRT_2};

/// Works that differ by no more than this share are the same.
const SAME_WORK: f64 = 1e-12;

/// A cohesive law with a shear strength, on level ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearedLaw {
    /// What opens and presses the face
    pub cohesive: Cohesive,
    /// δ_t, nm
    pub slip_scale: f64,
    /// w_t/w
    pub work_ratio: f64,
}

/// Potential and load of a section per length and width, with the tangent, by x, y and θ. The load is minus the gradient, which is that of the
/// potential where the works are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearedResponse<T> {
    /// Ψ, nN/nm
    pub energy: T,
    /// How Ψ changes with x, y and θ: minus the load, where that has a potential
    pub energy_change: [T; 3],
    /// Minus the load: nN/nm², nN/nm², nN/nm
    pub gradient: [T; 3],
    /// How each of these changes with x, y and θ
    pub tangent: [[T; 3]; 3],
}

impl ShearedLaw {
    /// With this shear strength, nN/nm², and work in shear, nN/nm; none: that of opening.
    pub fn new(cohesive: Cohesive, shear_strength: f64, shear_work: Option<f64>) -> Self {
        let work = cohesive.work();
        // a work that is that of opening but for its rounding is that one
        let shear_work = shear_work.filter(|own| (own / work - 1.0).abs() > SAME_WORK).unwrap_or(work);
        Self { cohesive, slip_scale: (2.0 / E).sqrt() * shear_work / shear_strength, work_ratio: shear_work / work }
    }

    /// w_t, nN/nm.
    pub fn shear_work(&self) -> f64 {
        self.work_ratio * self.cohesive.work()
    }

    /// Whether the load has a potential: where slip takes the work that opening does.
    pub fn has_potential(&self) -> bool {
        self.work_ratio == 1.0
    }

    /// The stiffness along the ground of a closed face that has not slipped, 2 w_t/δ_t², nN/nm³.
    pub fn stiffness(&self) -> f64 {
        2.0 * self.shear_work() / self.slip_scale.powi(2)
    }

    /// The slip beyond which a thousandth of the shear strength is not reached, nm.
    pub fn slip_reach(&self) -> f64 {
        let slips = Bracket { low: FRAC_1_SQRT_2, high: 10.0 };
        let holds = |slip: f64| (2.0 * E).sqrt() * slip * (-slip * slip).exp() > 1e-3;
        self.slip_scale * slips.bisected(holds, |left| left.width() <= 1e-12 * left.high).high
    }

    /// The response of a section of this height (nm) whose axis has slipped by `slip` and lies h/2 above the `gap` (nm), with the rotation θ given as
    /// its sine and cosine.
    #[inline(never)]
    pub fn response<T: Real>(&self, height: T, [slip, gap]: [T; 2], [sin, cos]: [T; 2]) -> ShearedResponse<T> {
        let (pull, push) = self.cohesive.pull_and_push(height, gap, sin, cos);
        let half = height * 0.5;
        let (lever, arm) = (half * cos, half * sin);
        let t = slip + arm;
        let curved = 2.0 / self.slip_scale.powi(2);
        let [hold] = t.each(|t| [(-0.5 * curved * t * t).exp()]);
        // B' and B''
        let slope = -(t * hold * curved);
        let bend = (t * t * curved - 1.0) * hold * curved;
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
        ShearedResponse {
            energy: pull.energy * hold + push.energy,
            energy_change: [by_slip, by_gap, by_rotation + by_slip * lever],
            gradient: [along, by_gap, by_rotation + along * lever],
            tangent: [
                [along_along, along_gap, along_rotation],
                [gap_along, pull.gap_gap * hold + push.gap_gap, gap_rotation(gap_along)],
                [turn_along + along_along * lever, gap_rotation(along_gap), rotation_rotation],
            ],
        }
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

    fn at(law: &ShearedLaw, [slip, gap, rotation]: [f64; 3]) -> ShearedResponse<f64> {
        let (sin, cos) = rotation.sin_cos();
        law.response(HEIGHT, [slip, gap], [sin, cos])
    }

    /// Sixth order differences of energy and gradient, at open and pressed, turned and turned over sections.
    #[test]
    fn gradient_and_tangent_are_differences() {
        let laws = CohesiveShape::ALL.iter().flat_map(|&shape| [law(shape), tough(shape)]);
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
}
