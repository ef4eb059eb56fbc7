//! A piece of strip over a flat half space, held by the same forces at every level of coarse-graining.
//!
//! ```text
//!            _________
//!      l ___/        /     tilted by θ about its centre, which is at x = 0;
//!    ___/           / h    its lowest corner is a gap above the half space
//!   /______________/
//!  ------------------
//! ```

use super::levels::half_space::HalfSpace;
use super::levels::lattice::LatticeHalfSpace;
use super::levels::pair::LennardJones;
use super::levels::volume::body_force_by_volume;
use super::section::law::Law;
use super::section::line_load::{LineLaw, LineLoad};
use crate::number::gauss::Rule;

/// A rectangle l × h, a unit of width of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltedBlock {
    /// What it is in front of
    pub half_space: HalfSpace,
    /// Along the axis, nm
    pub length: f64,
    /// Across it, nm
    pub height: f64,
    /// Angle θ between axis and substrate, rad
    pub tilt: f64,
    /// Height of the lowest corner, nm
    pub gap: f64,
}

/// Force away from the half space (nN/nm) and moment about the centre (nN), per width.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resultant {
    /// Positive away from the half space, nN/nm
    pub force: f64,
    /// About the centre, positive counterclockwise, nN
    pub moment: f64,
}

/// Which faces carry the surface traction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Faces {
    /// Those that look at the substrate, as in eqs. (11) and (12): columns of endless length.
    Near,
    /// All four; those that look away take off what the columns have too much. With b = -∂T/∂y it is exact.
    All,
}

/// How the interaction is computed, from the finest to the coarsest.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // the text of each names its fields
pub enum Level {
    /// Atoms at the given spacing (nm) on both sides, eq. (2), summed one by one up to a cutoff (nm).
    Atoms { spacing: f64, cutoff: f64 },
    /// Eqs. (6) and (7): the rule squared over the piece, `rays` cubed over the half space for each of its points.
    Volumes { rule: Rule, rays: Rule },
    /// Eqs. (6) and (9): the rule squared over the piece.
    BodyForce { rule: Rule },
    /// Eqs. (10) and (11): the rule along each face.
    SurfaceTraction { rule: Rule, faces: Faces },
    /// Eqs. (17)-(22): the rule along the axis.
    LineLoad { rule: Rule, far_face: bool },
}

impl TiltedBlock {
    /// Force and moment at the given level.
    pub fn resultant(&self, level: &Level) -> Resultant {
        match level {
            Level::Atoms { spacing, cutoff } => self.by_atoms(*spacing, *cutoff),
            Level::Volumes { rule, rays } => {
                // the product of the densities cancels
                let pair = LennardJones::behind(&self.half_space, 1.0, 1.0);
                self.by_points(rule, |r| body_force_by_volume(&pair, 1.0, r, rays)[1])
            }
            Level::BodyForce { rule } => self.by_points(rule, |r| self.half_space.body_force(r)),
            Level::SurfaceTraction { rule, faces } => self.by_faces(rule, *faces),
            Level::LineLoad { rule, far_face } => self.by_line(rule, *far_face),
        }
    }

    /// Height of the centre, nm.
    fn centre(&self) -> f64 {
        let (sin, cos) = self.tilt.sin_cos();
        self.gap + 0.5 * (self.length * sin.abs() + self.height * cos.abs())
    }

    fn by_points(&self, rule: &Rule, body_force: impl Fn(f64) -> f64) -> Resultant {
        let ((sin, cos), y) = (self.tilt.sin_cos(), self.centre());
        let mut sum = Resultant::default();
        for (along, w_along) in rule.over(-0.5 * self.length, 0.5 * self.length) {
            for (across, w_across) in rule.over(-0.5 * self.height, 0.5 * self.height) {
                let force = w_along * w_across * body_force(y + along * sin + across * cos);
                sum.add(force, along * cos - across * sin);
            }
        }
        sum
    }

    fn by_faces(&self, rule: &Rule, faces: Faces) -> Resultant {
        let ((sin, cos), y) = (self.tilt.sin_cos(), self.centre());
        let (half_length, half_height) = (0.5 * self.length, 0.5 * self.height);
        let mut sum = Resultant::default();
        // centre of a face, half of the face, cosine of the angle between its normal and the substrate
        for (centre, half, facing) in [
            ([0.0, -half_height], [half_length, 0.0], cos),
            ([-half_length, 0.0], [0.0, half_height], sin),
            ([0.0, half_height], [half_length, 0.0], -cos),
            ([half_length, 0.0], [0.0, half_height], -sin),
        ] {
            if facing == 0.0 || (faces == Faces::Near && facing < 0.0) {
                continue;
            }
            for (part, weight) in rule.over(-1.0, 1.0) {
                let (along, across) = (centre[0] + part * half[0], centre[1] + part * half[1]);
                let area = weight * (half[0] + half[1]) * facing;
                let force = area * self.half_space.traction(y + along * sin + across * cos);
                sum.add(force, along * cos - across * sin);
            }
        }
        sum
    }

    fn by_line(&self, rule: &Rule, far_face: bool) -> Resultant {
        let ((sin, cos), y) = (self.tilt.sin_cos(), self.centre());
        let law = LineLaw {
            half_space: self.half_space,
            height: self.height,
            law: Law::BodyForce,
            line_load: LineLoad::Full,
            far_face,
        };
        let mut sum = Resultant::default();
        for (along, weight) in rule.over(-0.5 * self.length, 0.5 * self.length) {
            let at = law.response(y + along * sin - 0.5 * self.height, sin, cos);
            sum.add(-weight * at.by_gap, along * cos);
            sum.moment -= weight * at.by_rotation;
        }
        sum
    }

    /// One row of atoms to a spacing of width; both lattices have the density that makes A_H what it is.
    fn by_atoms(&self, spacing: f64, cutoff: f64) -> Resultant {
        let ((sin, cos), y) = (self.tilt.sin_cos(), self.centre());
        let density = spacing.powi(-3);
        let pair = LennardJones::behind(&self.half_space, density, density);
        let lattice = LatticeHalfSpace { pair, spacing, cutoff };
        let places = |extent: f64| {
            let count = (extent / spacing).round().max(1.0) as usize;
            (0..count).map(move |k| (k as f64 + 0.5) * spacing - 0.5 * count as f64 * spacing)
        };
        let mut sum = Resultant::default();
        for along in places(self.length) {
            for across in places(self.height) {
                let (x, lift) = (along * cos - across * sin, along * sin + across * cos);
                let force = lattice.force_on([x, y + lift, 0.0]);
                sum.add(force[1] / spacing, x);
                sum.moment -= lift * force[0] / spacing;
            }
        }
        sum
    }
}

impl Resultant {
    #[inline(always)]
    fn add(&mut self, force: f64, lever: f64) {
        self.force += force;
        self.moment += force * lever;
    }
}

/// T_c (nN/nm²) and M_c (nN/nm) of a section by integrating the body force over its height, what eqs. (17)-(22) are in
/// closed form: T_c = ∫ b(y + s cos θ) ds, M_c = -sin θ ∫ s b(y + s cos θ) ds. Axis at `axis` y (nm), `tilt` θ in rad.
///
/// The height is cut into pieces whose ends are four times as far from the half space each. The section lies above it.
pub fn section_by_body_force(half_space: &HalfSpace, height: f64, axis: f64, tilt: f64, rule: &Rule) -> (f64, f64) {
    let (sin, cos) = tilt.sin_cos();
    let lowest = axis - 0.5 * height * cos.abs();
    let first = 3.0 * lowest / cos.abs().max(1e-3);
    let (mut force, mut moment, mut from) = (0.0, 0.0, 0.0);
    while from < height {
        let to = if first > 0.0 { (4.0 * from + first).min(height) } else { height };
        for (up, weight) in rule.over(from, to) {
            let s = (up - 0.5 * height) * cos.signum();
            let b = weight * half_space.body_force(lowest + up * cos.abs());
            force += b;
            moment -= sin * s * b;
        }
        from = to;
    }
    (force, moment)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::num::NonZeroUsize;

    const PIECE: TiltedBlock = TiltedBlock {
        half_space: HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 },
        length: 10.0,
        height: 10.0,
        tilt: 0.35,
        gap: 0.6,
    };

    fn rule(points: usize) -> Rule {
        Rule::new(NonZeroUsize::new(points).unwrap())
    }

    #[test]
    fn four_levels_are_one_number() {
        let truth = PIECE.resultant(&Level::BodyForce { rule: rule(60) });
        for level in [
            Level::Volumes { rule: rule(60), rays: rule(6) },
            Level::SurfaceTraction { rule: rule(60), faces: Faces::All },
            Level::LineLoad { rule: rule(60), far_face: true },
        ] {
            let at = PIECE.resultant(&level);
            assert_relative_eq!(at.force, truth.force, max_relative = 1e-12);
            assert_relative_eq!(at.moment, truth.moment, max_relative = 1e-12);
        }
    }

    /// The force is the second integral of b over the corners: [W(r1) - W(r2) - W(r3) + W(r4)]/(sin θ cos θ).
    #[test]
    fn force_is_that_of_the_corners() {
        let (sin, cos) = PIECE.tilt.sin_cos();
        let corner = |l: f64, h: f64| PIECE.half_space.potential(PIECE.gap + l * sin + h * cos);
        let expected = (corner(0.0, 0.0) - corner(10.0, 0.0) - corner(0.0, 10.0) + corner(10.0, 10.0)) / (sin * cos);
        let at = PIECE.resultant(&Level::BodyForce { rule: rule(60) });
        assert_relative_eq!(at.force, expected, max_relative = 1e-12);
    }

    #[test]
    fn flat_piece_has_no_moment() {
        let flat = TiltedBlock { tilt: 0.0, ..PIECE };
        let expected = 10.0 * (PIECE.half_space.traction(0.6) - PIECE.half_space.traction(10.6));
        for level in [
            Level::BodyForce { rule: rule(60) },
            Level::SurfaceTraction { rule: rule(4), faces: Faces::All },
            Level::LineLoad { rule: rule(4), far_face: true },
        ] {
            let at = flat.resultant(&level);
            assert_relative_eq!(at.force, expected, max_relative = 1e-12);
            assert!(at.moment.abs() < 1e-12 * expected.abs());
        }
    }
}
