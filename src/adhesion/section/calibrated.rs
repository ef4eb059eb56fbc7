//! A cohesive law: traction against opening of the bonded face, in place of a half space's.
//!
//! The bonded face is the one that looks down where the beam is flat: it carries the adhesive. At the distance r from the substrate it is
//! open by δ = r - r_eq. With the range δ_r the nominal traction, per area of reference, is -σ s(δ/δ_r): it attracts where the face is open,
//! and repels where it is pressed. A shape has a largest s of 1, so that σ is the strength, and the work of adhesion is w = σ δ_r ∫ s over
//! all openings above zero. Per length and width, with W_c(r) = -σ δ_r ∫ s from the opening on,
//!
//!   Ψ(y, θ) = W_c(r),  r = y - (h/2) cos θ,   T_c = -∂Ψ/∂y,   M_c = -∂Ψ/∂θ = T_c (h/2) sin θ.
//!
//! Where a section has turned over, cos θ < 0, the bonded face looks up. It is still the one that is attracted, but what is pressed on the
//! substrate is the other face, r' = y - (h/2) |cos θ|:
//!
//!   Ψ(y, θ) = W_c(max(r, r_eq)) + W_c(min(r', r_eq)) - W_c(r_eq).
//!
//! So M_c is continuous where the section is upright, unless its edge is pressed.

use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::section::cohesive::CohesiveShape;
use crate::adhesion::section::cohesive::at::At;
use crate::adhesion::section::response::LineResponse;
use crate::number::Real;
use crate::number::root::Bracket;

/// A cohesive law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cohesive {
    /// How its traction goes with the gap
    pub shape: CohesiveShape,
    /// σ, nN/nm² = GPa
    pub strength: f64,
    /// δ_r, nm
    pub range: f64,
    /// r_eq, the distance at which a face is closed, nm
    pub closed: f64,
}

/// What of a law acts on a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::adhesion) enum Part {
    /// All of it
    Whole,
    /// What attracts an open face; ∫ s of a face that is pressed is that of one that is closed
    Pull,
    /// What repels a pressed face
    Push,
}

impl Part {
    /// Of the shape at the opening t.
    #[inline]
    pub(in crate::adhesion) fn at(self, shape: CohesiveShape, t: f64) -> At {
        match (self, t > 0.0) {
            (Self::Whole, _) | (Self::Pull, true) => shape.at(t),
            (Self::Push, true) => [0.0; 3],
            (Self::Pull, false) => [shape.work(), 0.0, 0.0],
            (Self::Push, false) => {
                let [work, s, slope] = shape.at(t);
                [work - shape.work(), s, slope]
            }
        }
    }

    /// The integral from t on of the first number of [`Self::at`].
    #[inline]
    pub(in crate::adhesion) fn primitive(self, shape: CohesiveShape, t: f64) -> f64 {
        match (self, t > 0.0) {
            (Self::Whole, _) | (Self::Pull, true) => shape.primitive(t),
            (Self::Push, true) => 0.0,
            (Self::Pull, false) => shape.primitive(0.0) - t * shape.work(),
            (Self::Push, false) => shape.primitive(t) - shape.primitive(0.0) + t * shape.work(),
        }
    }

    /// Where its pieces join, in the order of the openings.
    pub(in crate::adhesion) fn knots(self, shape: CohesiveShape) -> impl Iterator<Item = f64> {
        let closed = (self != Self::Whole).then_some(0.0);
        closed.into_iter().chain(shape.knots().iter().copied())
    }
}

impl Cohesive {
    /// The law of this strength (nN/nm²) and work of adhesion (nN/nm), closed where the half space has no traction.
    pub fn calibrated(shape: CohesiveShape, strength: f64, work: f64, half_space: &HalfSpace) -> Self {
        Self { shape, strength, range: work / (strength * shape.work()), closed: half_space.equilibrium_gap() }
    }

    /// w, its work of adhesion, nN/nm.
    pub fn work(&self) -> f64 {
        self.strength * self.range * self.shape.work()
    }

    /// The distance beyond which a thousandth of the strength is not reached, nm.
    pub fn cutoff_distance(&self) -> f64 {
        let openings = Bracket { low: self.shape.pulling(), high: 50.0 };
        let pulls = |opening: f64| self.shape.at(opening)[1] > 1e-3;
        self.closed + self.range * openings.bisected(pulls, |left| left.width() <= 1e-12 * left.high).high
    }

    /// W_c (nN/nm), the traction T = -W_c' (nN/nm²) and b = -T' (nN/nm³) of a face at the distance r, nm.
    #[inline(never)]
    pub fn levels<T: Real>(&self, r: T) -> [T; 3] {
        r.each(|r| self.levels_of(Part::Whole, r))
    }

    /// The same of a part of it.
    pub(in crate::adhesion) fn levels_of(&self, part: Part, r: f64) -> [f64; 3] {
        let per_range = 1.0 / self.range;
        let [work, s, slope] = part.at(self.shape, (r - self.closed) * per_range);
        [-self.strength * self.range * work, -self.strength * s, self.strength * per_range * slope]
    }

    /// The same of what attracts a face that has been as far away as `farthest`, nm. Nearer than that its traction falls in a straight line to
    /// nothing where it is closed, T = T(r_max) (r - r_eq)/(r_max - r_eq), and W_c is what is left to be won: what the way out has taken stays spent.
    fn pull_after(&self, farthest: f64, r: f64) -> [f64; 3] {
        if r >= farthest || farthest <= self.closed {
            return self.levels_of(Part::Pull, r);
        }
        let [energy, traction, _] = self.levels_of(Part::Pull, farthest);
        let (reach, opening) = (farthest - self.closed, (r - self.closed).max(0.0));
        let stiffness = -traction / reach;
        let spent = energy + 0.5 * traction * reach;
        [spent + 0.5 * stiffness * opening * opening, -stiffness * opening, if opening > 0.0 { stiffness } else { 0.0 }]
    }

    /// The load on a section whose face is at the distance `gap` where it is not tilted.
    #[inline(never)]
    pub(in crate::adhesion::section) fn on_face<T: Real>(&self, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        if cos.is_positive() {
            return LineResponse::of_bonded_face(|r| self.levels(r), height, gap, sin, cos);
        }
        LineResponse::each_of([height, gap, sin, cos], |[height, gap, sin, cos]| {
            let bonded = |part| LineResponse::of_bonded_face(|r| self.levels_of(part, r), height, gap, sin, cos);
            if cos > 0.0 {
                return bonded(Part::Whole);
            }
            let pressed = LineResponse::of_face(|r| self.levels_of(Part::Push, r), height, gap, sin, cos);
            bonded(Part::Pull).plus(pressed)
        })
    }

    /// What attracts a section whose bonded face has been as far away as `farthest` (nm; zero: nowhere yet), and what repels it. A face that is as
    /// far away as ever has the load of [`Self::on_face`] of both together.
    pub(in crate::adhesion::section) fn pull_and_push<T: Real>(
        &self,
        height: T,
        gap: T,
        [sin, cos]: [T; 2],
        farthest: T,
    ) -> (LineResponse<T>, LineResponse<T>) {
        let pull = LineResponse::each_of([height, gap, sin, cos, farthest], |[height, gap, sin, cos, farthest]| {
            LineResponse::of_bonded_face(|r| self.pull_after(farthest, r), height, gap, sin, cos)
        });
        let push = LineResponse::each_of([height, gap, sin, cos], |[height, gap, sin, cos]| {
            let levels = |r| self.levels_of(Part::Push, r);
            if cos > 0.0 {
                return LineResponse::of_bonded_face(levels, height, gap, sin, cos);
            }
            LineResponse::of_face(levels, height, gap, sin, cos)
        });
        (pull, push)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::Rule;
    use crate::adhesion::section::cohesive::tabulated::{Measured, TractionTable};
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use std::num::NonZeroUsize;

    const SHAPES: &[CohesiveShape] = CohesiveShape::ALL;
    const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    #[test]
    fn each_is_minus_the_slope_of_the_one_before() {
        for &shape in SHAPES {
            for k in -40..400 {
                let (t, d) = (0.003_7 * f64::from(k), 1e-4);
                let slope = |i: usize| {
                    let f = |t| shape.at(t)[i];
                    (8.0 * (f(t + d) - f(t - d)) - (f(t + 2.0 * d) - f(t - 2.0 * d))) / (12.0 * d)
                };
                let [_, s, rise] = shape.at(t);
                assert_abs_diff_eq!(-slope(0), s, epsilon = 1e-9);
                assert_abs_diff_eq!(slope(1), rise, epsilon = 1e-6);
            }
        }
    }

    /// By a rule that is fine enough to see the corners, and at many openings.
    #[test]
    fn work_and_strength_are_those_asked_for() {
        let rule = Rule::new(NonZeroUsize::new(12).unwrap());
        for &shape in SHAPES {
            let (strength, work) = (PAPER.strength(), PAPER.work_of_adhesion());
            let law = Cohesive::calibrated(shape, strength, work, &PAPER);
            let traction = |delta: f64| -law.levels(law.closed + delta)[1];
            let far = 40.0 * law.range;
            let pieces = 8000;
            let by_rule: f64 = (0..pieces)
                .map(|k| [k, k + 1].map(|k| far * f64::from(k) / f64::from(pieces)))
                .flat_map(|[from, to]| {
                    rule.over(from, to).map(|(delta, weight)| weight * traction(delta)).collect::<Vec<_>>()
                })
                .sum();
            assert_relative_eq!(by_rule, work, max_relative = 1e-12);
            assert_relative_eq!(law.levels(law.closed)[0], -work, max_relative = 1e-14);
            let largest = (0..200_000).map(|k| traction(2.0 * law.range * f64::from(k) / 2e5)).fold(0.0, f64::max);
            assert_relative_eq!(largest, strength, max_relative = 1e-8);
            assert_abs_diff_eq!(traction(0.0), 0.0, epsilon = 1e-16);
            assert!(traction(-0.1 * law.range) < 0.0);
        }
    }

    /// A section that turns over is attracted by its bonded face alone, which goes up; energy, load and moment go on without a jump.
    #[test]
    fn a_section_turns_over_without_a_jump_unless_it_is_pressed() {
        // so low that the other face is open as well
        let height = 0.02;
        for &shape in SHAPES {
            let law = Cohesive::calibrated(shape, 0.05, 0.03, &PAPER);
            let at = |axis: f64, angle: f64| law.on_face(height, axis - 0.5 * height, angle.sin(), angle.cos());
            let upright = std::f64::consts::FRAC_PI_2;
            for opening in [0.05, 0.2, 0.6, 1.1] {
                let axis = law.closed + opening * law.range;
                let [before, behind] = [-1e-9, 1e-9].map(|off| at(axis, upright + off));
                assert_abs_diff_eq!(before.energy, behind.energy, epsilon = 1e-8);
                assert_abs_diff_eq!(before.by_rotation, behind.by_rotation, epsilon = 1e-8);
                let turned = at(axis, 2.2);
                let open = axis - 0.5 * height * 2.2f64.cos();
                assert_relative_eq!(turned.energy, law.levels(open)[0], max_relative = 1e-14);
            }
            let pressed = law.closed - 0.1 * law.range;
            let [before, behind] = [-1e-9, 1e-9].map(|off| at(pressed, upright + off).by_rotation);
            assert!(before < -5e-5 && behind > 5e-5, "{shape:?}: {before} {behind}");
        }
    }

    /// The load of a turned section, open, pressed or both, is the slope of its energy, and the tangent that of the load.
    #[test]
    fn a_turned_section_has_a_potential() {
        let (height, d) = (0.3, 1e-5);
        let law = Cohesive::calibrated(CohesiveShape::Exponential, 0.05, 0.03, &PAPER);
        let at = |gap: f64, angle: f64| law.on_face(height, gap, angle.sin(), angle.cos());
        for gap in [-0.1, 0.0, 0.1, 0.4] {
            for angle in [1.7, 2.3, 3.0, 4.5, -2.0] {
                let here = at(gap, angle);
                let slope =
                    |of: &dyn Fn(f64) -> f64| (8.0 * (of(d) - of(-d)) - (of(2.0 * d) - of(-2.0 * d))) / (12.0 * d);
                assert_abs_diff_eq!(slope(&|off| at(gap + off, angle).energy), here.by_gap, epsilon = 1e-10);
                assert_abs_diff_eq!(slope(&|off| at(gap, angle + off).energy), here.by_rotation, epsilon = 1e-10);
                assert_abs_diff_eq!(slope(&|off| at(gap + off, angle).by_gap), here.gap_gap, epsilon = 1e-9);
                assert_abs_diff_eq!(slope(&|off| at(gap, angle + off).by_gap), here.gap_rotation, epsilon = 1e-9);
                let turned = slope(&|off| at(gap, angle + off).by_rotation);
                assert_abs_diff_eq!(turned, here.rotation_rotation, epsilon = 1e-9);
            }
        }
    }

    #[test]
    fn reach_is_where_a_thousandth_is_left() {
        for &shape in SHAPES {
            let law = Cohesive::calibrated(shape, 0.2, 0.03, &PAPER);
            assert_relative_eq!(-law.levels(law.cutoff_distance())[1], 2e-4, max_relative = 1e-6);
        }
    }

    #[test]
    fn beyond_its_range_a_rounded_law_is_nothing() {
        for shape in [CohesiveShape::Bilinear, CohesiveShape::Dugdale] {
            for t in [1.31, 2.0, 1e3] {
                assert_eq!(shape.at(t), [0.0; 3], "{shape:?} at {t}");
            }
        }
    }

    #[test]
    fn a_law_of_its_rows_has_their_work_strength_and_range() {
        // two rows are level, and there is a second maximum
        let openings = vec![0.0, 0.7, 1.0, 2.2, 2.5, 4.0, 5.0, 9.0];
        let rows = TractionTable::new(openings, vec![0.0, 0.15, 0.2, 0.2, 0.12, 0.13, 0.05, 0.0]).unwrap();
        let curve = Measured::through(&rows);
        assert_eq!(curve, Measured::through(&rows.clone()));
        let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
        let law = Cohesive::calibrated(CohesiveShape::Measured(curve), rows.strength(), rows.work(), &half_space);
        assert_relative_eq!(law.range, 9.0, max_relative = 1e-14);
        assert_relative_eq!(law.levels(law.closed + 5.0)[1], -0.05, max_relative = 1e-13);
        // behind the last row nothing pulls, and 1/1000 of the strength a little before
        assert!((8.5..9.0).contains(&(law.cutoff_distance() - law.closed)), "{law:?}");
    }
}
