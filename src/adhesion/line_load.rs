//! The line load of a beam section above a flat half space, and the laws that it may follow.
//!
//! Heights enter as the gap η = y - h/2 below the untilted section, so that the small number is stored and not recovered from a
//! difference.

use super::{Cohesive, HalfSpace, body_force, surface_traction};
use crate::number::Real;

/// What of the adhesion reaches the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineLoad {
    /// Line force and line moment.
    Full,
    /// The line force without the moment; it has no potential.
    ForceOnly,
    /// The traction at the gap below the axis, blind to tilt: Ψ = W(η), less W(η + h) where the far face counts.
    AxisGap,
}

/// What pulls a tilted section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// The body force of eq. (9) over its height, eqs. (17)-(22). It has a potential.
    BodyForce,
    /// The traction of eq. (10) on its faces, eqs. (11) and (12). It has none.
    SurfaceTraction,
    /// A cohesive law between the face that looks down and the substrate, in place of the half space's traction. It has a potential.
    Cohesive(Cohesive),
}

/// The law of one section: half space, height, what pulls, which load, which faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineLaw {
    pub half_space: HalfSpace,
    /// nm
    pub height: f64,
    pub law: Law,
    pub line_load: LineLoad,
    /// Whether the top face counts (the r2 terms); a cohesive law knows none.
    pub far_face: bool,
}

/// Potential and load of a section per length and width, with the tangent. The load is minus the gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineResponse<T> {
    /// Ψ, nN/nm
    pub energy: T,
    /// -T_c, nN/nm²
    pub by_gap: T,
    /// -M_c, nN/nm
    pub by_rotation: T,
    /// ∂Ψ/∂θ, nN/nm; equal to `by_rotation` where the load has a potential
    pub energy_by_rotation: T,
    /// ∂(-T_c)/∂y, nN/nm³
    pub gap_gap: T,
    /// ∂(-T_c)/∂θ, nN/nm²
    pub gap_rotation: T,
    /// ∂(-M_c)/∂y, nN/nm²; equal to `gap_rotation` where the load has a potential
    pub rotation_gap: T,
    /// ∂(-M_c)/∂θ, nN/nm
    pub rotation_rotation: T,
}

impl LineLaw {
    /// The response at the gap η = y - h/2 (nm) and the rotation θ, given as its sine and cosine.
    #[inline(always)]
    pub fn response<T: Real>(&self, gap: T, sin: T, cos: T) -> LineResponse<T> {
        self.response_of(T::splat(self.height), gap, sin, cos)
    }

    /// The same for a section of another height, nm.
    #[inline(always)]
    pub fn response_of<T: Real>(&self, height: T, gap: T, sin: T, cos: T) -> LineResponse<T> {
        let full = match (&self.law, self.line_load, self.far_face) {
            (Law::Cohesive(cohesive), LineLoad::AxisGap, _) => return blind(cohesive.levels(gap), None),
            (Law::Cohesive(cohesive), ..) => cohesive.on_face(height, gap, sin, cos),
            (_, LineLoad::AxisGap, far_face) => return self.axis_gap(height, gap, far_face),
            (Law::BodyForce, _, true) => body_force::both_faces(&self.half_space, height, gap, sin, cos),
            (Law::BodyForce, _, false) => body_force::near_face(&self.half_space, height, gap, sin, cos),
            (Law::SurfaceTraction, _, true) => surface_traction::both_faces(&self.half_space, height, gap, sin, cos),
            (Law::SurfaceTraction, _, false) => surface_traction::near_face(&self.half_space, height, gap, sin, cos),
        };
        if self.line_load == LineLoad::ForceOnly { without_moment(full) } else { full }
    }

    /// Whether the load derives from a potential, so that the tangent is symmetric and energy is conserved.
    pub fn has_potential(&self) -> bool {
        match self.line_load {
            LineLoad::Full => self.law != Law::SurfaceTraction,
            LineLoad::ForceOnly => false,
            LineLoad::AxisGap => true,
        }
    }

    /// The distance (nm) from which on hardly anything pulls: 10 r0 from a half space, whose traction has fallen there to 7e-4 of its
    /// strength; where a thousandth is left of that of a cohesive law.
    pub fn reach(&self) -> f64 {
        match &self.law {
            Law::BodyForce | Law::SurfaceTraction => 10.0 * self.half_space.equilibrium_distance,
            Law::Cohesive(law) => law.reach(),
        }
    }

    /// The gap η at which a flat section is at rest, T_c(η, θ = 0) = 0, nm.
    ///
    /// It lies between the half space's equilibrium gap (no far face) and its strongest gap, because T(r1) = T(r2) < 0.
    pub fn rest_gap(&self) -> f64 {
        let (mut low, mut high) = (self.half_space.equilibrium_gap() * (1.0 - 1e-9), self.half_space.strongest_gap());
        let mut gap = self.half_space.equilibrium_gap();
        for _ in 0..200 {
            let at = self.response(gap, 0.0, 1.0);
            if at.by_gap < 0.0 {
                low = gap
            } else {
                high = gap
            }
            let newton = gap - at.by_gap / at.gap_gap;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - gap).abs() <= 2.0 * f64::EPSILON * gap {
                return next;
            }
            gap = next;
        }
        gap
    }

    /// Ψ of the flat section at rest, nN/nm: minus the work of adhesion of the strip.
    pub fn rest_energy(&self) -> f64 {
        self.response(self.rest_gap(), 0.0, 1.0).energy
    }

    #[inline(always)]
    fn axis_gap<T: Real>(&self, height: T, gap: T, far_face: bool) -> LineResponse<T> {
        blind(self.half_space.levels(gap), far_face.then(|| self.half_space.levels(gap + height)))
    }
}

/// Blind to tilt: of potential, traction and body force at the near face and, if it counts, at the far one.
#[inline(always)]
fn blind<T: Real>(near: [T; 3], far: Option<[T; 3]>) -> LineResponse<T> {
    let zero = T::splat(0.0);
    let far = far.unwrap_or([zero; 3]);
    LineResponse {
        energy: near[0] - far[0],
        by_gap: far[1] - near[1],
        by_rotation: zero,
        energy_by_rotation: zero,
        gap_gap: near[2] - far[2],
        gap_rotation: zero,
        rotation_gap: zero,
        rotation_rotation: zero,
    }
}

/// 1 - cos θ without cancellation.
#[inline(always)]
pub(super) fn one_minus<T: Real>(sin: T, cos: T) -> T {
    cos.choose(sin * sin / (cos + 1.0), T::splat(1.0) - cos)
}

#[inline(always)]
fn without_moment<T: Real>(full: LineResponse<T>) -> LineResponse<T> {
    let zero = T::splat(0.0);
    LineResponse { by_rotation: zero, rotation_gap: zero, rotation_rotation: zero, ..full }
}
