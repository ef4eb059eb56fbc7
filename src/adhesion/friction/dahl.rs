//! Friction of an adhering face: a limit of the tangential traction, and what it carries below it.
//!
//! A face that adheres resists sliding even where nothing presses on it. At the gap d the traction t along it is at most
//!
//!   τ(d) = w(d) [τ0 + μ (q(p) - q(0))],   p = T(d),
//!
//! the shear strength τ0 within the range of contact, which ends about the gap d_max of the largest attraction of the half space, and Coulomb's
//! μ p on top of it where it pushes,
//!
//!   w = (1 + 1/81)/(1 + (d/d_max)²⁴),   q = ½ (p + (p² + p_s²)^½),   p_s = min(σ/10, τ0/μ),
//!
//! with σ the half space's strength: smooth functions, and w = 1 at the gap of no traction.
//!
//! The traction over shear strength, s = t/τ(d), follows Dahl's law (1968):
//!
//!   ds = (1 ∓ s) dx_b/δ,   the upper sign where the place x_b of the face moves towards +x.
//!
//! So it sticks with the stiffness τ/δ at first and slides at the limit after a few δ, backwards likewise, and |s| never
//! exceeds 1. Over a step in which the face does not turn back the law is integrated exactly, whatever the gap does,
//!
//!   s₁ = ±1 - (±1 - s₀) exp(-|Δx_b|/δ),
//!
//! which is the return mapping: s returns to the surface |s| = 1. Its tangent is exact as well. The elastic way of the face is
//! δ s and stores ½ τ δ s²; the rest of the work ∫ t dx_b is dissipated.
//!
//! P. R. Dahl, A solid friction model, Aerospace Corporation, TOR-0158(3107-18)-1, 1968; the limit is that of an adhering contact, as
//! in J. C. Mergel, R. Sahli, J. Scheibert and R. A. Sauer, J. Adhesion 95, 1101 (2019), with smooth ends.

use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;
use serde::{Deserialize, Serialize};

/// Friction between a face and a half space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLaw {
    half_space: HalfSpace,
    /// τ0, nN/nm² = GPa
    pub strength: f64,
    /// μ
    pub coefficient: f64,
    /// δ, nm
    pub presliding: f64,
    /// p_s, GPa
    onset: f64,
}

/// What a material point of a face remembers of its sliding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct FrictionState {
    /// x_b at the end of the last step, nm
    pub place: f64,
    /// s there
    pub mobilisation: f64,
    /// τ there, GPa
    pub limit: f64,
}

/// Traction on the substrate at the end of a step, and its tangent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traction<T> {
    /// t, GPa, in the direction of x
    pub value: T,
    /// ∂t/∂x_b, GPa/nm
    pub by_place: T,
    /// ∂t/∂d, GPa/nm
    pub by_gap: T,
    /// Elastic energy ½ τ δ s², nN/nm
    pub energy: T,
}

/// Most that p_s is over the strength of the half space.
const ONSET: f64 = 0.1;
/// Shortest δ that is not given, over r0: a contact that gives way by less has corners, which no step resolves and no force feels.
const SHORTEST: f64 = 0.0025;
/// A limit below this share of the strength is that of a face out of contact.
const APART: f64 = 1e-9;

impl FrictionLaw {
    /// The law of a shear strength τ0 (GPa), Coulomb's coefficient μ and a way before sliding δ (nm); without one, the stick is as
    /// stiff as the half space across the gap, τ0/δ = -T'(d_eq), or, of weak friction, δ = r0/400.
    pub fn new(half_space: HalfSpace, strength: f64, coefficient: f64, presliding: Option<f64>) -> Self {
        let least = SHORTEST * half_space.equilibrium_distance;
        let as_across = || strength / half_space.body_force(half_space.equilibrium_gap());
        let presliding = presliding.unwrap_or_else(|| as_across().max(least));
        let onset = (ONSET * half_space.strength()).min(strength / coefficient);
        Self { half_space, strength, coefficient, presliding, onset }
    }

    /// τ0/δ, GPa/nm
    pub fn stiffness(&self) -> f64 {
        self.strength / self.presliding
    }

    /// τ at a gap (nm) and its derivative, GPa and GPa/nm.
    pub(crate) fn limit(&self, gap: f64) -> [f64; 2] {
        let q = self.half_space.equilibrium_distance / gap;
        // the fourth power of (d/d_max)⁶ = 5/q⁶
        let apart = (0.2 * q.powi(6)).powi(-4);
        let within = (1.0 + 1.0 / 81.0) / (1.0 + apart);
        let within_slope = -24.0 * within * apart / (gap * (1.0 + apart));
        let (pressure, slope) = (self.half_space.traction(gap), -self.half_space.body_force(gap));
        let root = pressure.hypot(self.onset);
        let held = self.strength + 0.5 * self.coefficient * (pressure + root - self.onset);
        let held_slope = 0.5 * self.coefficient * (1.0 + pressure / root) * slope;
        if within == 0.0 { [0.0; 2] } else { [within * held, within_slope * held + within * held_slope] }
    }

    /// s behind a way (nm) without a turn, and ds/dx_b there, 1/nm.
    fn mobilisation(&self, way: f64, mobilisation: f64) -> [f64; 2] {
        let sense = if way < 0.0 { -1.0 } else { 1.0 };
        let left = (sense - mobilisation) * (-way.abs() / self.presliding).exp();
        [sense - left, left * sense / self.presliding]
    }

    /// The traction of a face that has gone so far (nm) since the end of the last step, where it had this `mobilisation`, and is
    /// at `gap` now, nm.
    #[inline(always)]
    pub(crate) fn traction<T: Real>(&self, way: T, gap: T, mobilisation: T) -> Traction<T> {
        let [limit, limit_slope] = gap.each(|gap| self.limit(gap));
        let [mobilisation, mobilisation_slope] =
            way.each_pair(mobilisation, |way, mobilisation| self.mobilisation(way, mobilisation));
        Traction {
            value: limit * mobilisation,
            by_place: limit * mobilisation_slope,
            by_gap: limit_slope * mobilisation,
            energy: limit * mobilisation * mobilisation * (0.5 * self.presliding),
        }
    }

    /// What a face at `place` and `gap`, nm, remembers behind a step, and what was dissipated on it, nN/nm: the work done on the
    /// contact, its limit taken as the mean of those at both ends of the step, less what is stored there.
    pub(crate) fn remembered(&self, place: f64, gap: f64, before: FrictionState) -> (FrictionState, f64) {
        let (way, delta) = (place - before.place, self.presliding);
        let [mobilisation, _] = self.mobilisation(way, before.mobilisation);
        let [limit, _] = self.limit(gap);
        // ± s dx_b = dx_b - δ ds
        let work = 0.5 * (limit + before.limit) * (way - delta * (mobilisation - before.mobilisation)) * way.signum();
        let stored = 0.5
            * delta
            * (limit * mobilisation * mobilisation - before.limit * before.mobilisation * before.mobilisation);
        // a face out of contact comes back with nothing to carry
        let mobilisation = if limit > APART * self.strength { mobilisation } else { 0.0 };
        (FrictionState { place, mobilisation, limit }, work - stored)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    fn law() -> FrictionLaw {
        FrictionLaw::new(PAPER, 0.05, 0.3, None)
    }

    /// Tangents against central differences.
    #[test]
    fn tangents() {
        let law = law();
        let (closed, farthest) = (PAPER.equilibrium_gap(), PAPER.strongest_gap());
        for gap in [0.9 * closed, closed, 0.5 * (closed + farthest), farthest, 0.4, 2.0] {
            for (way, mobilisation) in [(1e-3, 0.0), (-4e-3, 0.3), (2e-2, -0.8), (-1e-4, -0.99)] {
                let d = 1e-7;
                let at = |way: f64, gap: f64| law.traction(way, gap, mobilisation).value;
                let found = law.traction(way, gap, mobilisation);
                let by_place = (at(way + d, gap) - at(way - d, gap)) / (2.0 * d);
                let by_gap = (at(way, gap + d) - at(way, gap - d)) / (2.0 * d);
                assert_relative_eq!(found.by_place, by_place, epsilon = 1e-6, max_relative = 1e-5);
                assert_relative_eq!(found.by_gap, by_gap, epsilon = 1e-6, max_relative = 1e-5);
            }
        }
    }

    /// Two steps one way are one step; the mobilisation never exceeds 1; backwards it is the same law mirrored.
    #[test]
    fn steps_add_up_and_sides_are_alike() {
        let (law, gap) = (law(), 0.26);
        let start = FrictionState { place: 5.0, mobilisation: -0.4, limit: law.limit(gap)[0] };
        for way in [1e-4, 3e-3, 0.5, -2e-3, -0.5] {
            let (half, first) = law.remembered(5.0 + 0.3 * way, gap, start);
            let (two, second) = law.remembered(5.0 + way, gap, half);
            let (one, whole) = law.remembered(5.0 + way, gap, start);
            assert_relative_eq!(two.mobilisation, one.mobilisation, max_relative = 1e-12);
            assert_relative_eq!(first + second, whole, max_relative = 1e-10);
            assert!(one.mobilisation.abs() <= 1.0 && whole >= 0.0, "{one:?} {whole}");
            let mirrored = law.traction(-way, gap, 0.4).value;
            assert_relative_eq!(law.traction(way, gap, -0.4).value, -mirrored, max_relative = 1e-14);
        }
    }

    /// There and back in a closed contact, all work is dissipated or stored: ∮ t dx_b, by Simpson's rule.
    #[test]
    fn a_loop_dissipates_its_area() {
        let (law, gap) = (law(), PAPER.equilibrium_gap());
        let mut slip = FrictionState { place: 0.0, mobilisation: 0.0, limit: law.limit(gap)[0] };
        let (mut dissipated, mut work) = (0.0, 0.0);
        let steps = 200;
        for k in 0..2 * steps {
            let step = if k < steps { 1e-4 } else { -1e-4 };
            let at = |part: f64| law.traction(part * step, gap, slip.mobilisation).value;
            work += step / 6.0 * (at(0.0) + 4.0 * at(0.5) + at(1.0));
            let (next, lost) = law.remembered(slip.place + step, gap, slip);
            dissipated += lost;
            slip = next;
        }
        let stored = law.traction(0.0, gap, slip.mobilisation).energy;
        assert_relative_eq!(work, dissipated + stored, max_relative = 1e-9);
        assert!(slip.place.abs() < 1e-15 && slip.mobilisation < -0.8 && dissipated > 0.0);
    }

    /// At rest the tangential stiffness equals the normal one; the strength is τ0 where nothing presses, half of it where the half space
    /// pulls most, and nothing farther away.
    #[test]
    fn values_at_the_ends() {
        let (law, closed) = (law(), PAPER.equilibrium_gap());
        assert_relative_eq!(law.traction(0.0, closed, 0.0).by_place, PAPER.body_force(closed), max_relative = 1e-12);
        assert_relative_eq!(law.limit(closed)[0], 0.05, max_relative = 1e-12);
        let half = law.limit(PAPER.strongest_gap())[0] / 0.05;
        assert!((0.45..0.51).contains(&half), "{half}");
        assert!(law.limit(0.5)[0] < 1e-6 && law.limit(1e3)[0] < 1e-80 && law.limit(f64::INFINITY)[0] == 0.0);
        // far pressed in, Coulomb's
        let deep = 0.7 * closed;
        assert_relative_eq!(law.limit(deep)[0], 0.05 + 0.3 * PAPER.traction(deep), max_relative = 2e-2);
    }
}
