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
//! Source: the coupling is that of X.-P. Xu and A. Needleman, Numerical simulations of fast crack growth in brittle solids, J. Mech. Phys. Solids 42
//! (1994), eq. (5) with q = 1 and r = 0, for a normal law of any shape and without its loss of stiffness under pressure.

use super::calibrated::Cohesive;
use crate::number::Real;
use crate::number::root::Bracket;
use std::f64::consts::{E, FRAC_1_SQRT_2};

/// A cohesive law with a shear strength, on level ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearedLaw {
    /// What opens and presses the face
    pub cohesive: Cohesive,
    /// δ_t, nm
    pub slip_scale: f64,
}

/// Potential and load of a section per length and width, with the tangent, by x, y and θ. The load is minus the gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearedResponse<T> {
    /// Ψ, nN/nm
    pub energy: T,
    /// Minus the load: nN/nm², nN/nm², nN/nm
    pub gradient: [T; 3],
    /// The second derivatives of Ψ
    pub tangent: [[T; 3]; 3],
}

impl ShearedLaw {
    /// With this shear strength, nN/nm².
    pub fn new(cohesive: Cohesive, shear_strength: f64) -> Self {
        Self { cohesive, slip_scale: (2.0 / E).sqrt() * cohesive.work() / shear_strength }
    }

    /// The stiffness along the ground of a closed face that has not slipped, 2w/δ_t², nN/nm³.
    pub fn stiffness(&self) -> f64 {
        2.0 * self.cohesive.work() / self.slip_scale.powi(2)
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
        let along = pull.energy * slope;
        let along_along = pull.energy * bend;
        let along_gap = pull.by_gap * slope;
        let along_rotation = pull.by_rotation * slope + along_along * lever;
        let gap_rotation = pull.gap_rotation * hold + along_gap * lever + push.gap_rotation;
        let rotation_rotation = pull.rotation_rotation * hold + (pull.by_rotation * slope + along_rotation) * lever
            - along * arm
            + push.rotation_rotation;
        ShearedResponse {
            energy: pull.energy * hold + push.energy,
            gradient: [
                along,
                pull.by_gap * hold + push.by_gap,
                pull.by_rotation * hold + along * lever + push.by_rotation,
            ],
            tangent: [
                [along_along, along_gap, along_rotation],
                [along_gap, pull.gap_gap * hold + push.gap_gap, gap_rotation],
                [along_rotation, gap_rotation, rotation_rotation],
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
        ShearedLaw::new(cohesive, 0.6 * PAPER.strength())
    }

    fn at(law: &ShearedLaw, [slip, gap, rotation]: [f64; 3]) -> ShearedResponse<f64> {
        let (sin, cos) = rotation.sin_cos();
        law.response(HEIGHT, [slip, gap], [sin, cos])
    }

    /// Sixth order differences of energy and gradient, at open and pressed, turned and turned over sections.
    #[test]
    fn gradient_and_tangent_are_differences() {
        for &shape in CohesiveShape::ALL {
            let law = law(shape);
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
                        here.gradient[f],
                        epsilon = 1e-8 * size + rounding(here.energy),
                        max_relative = 1e-8
                    );
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
}
