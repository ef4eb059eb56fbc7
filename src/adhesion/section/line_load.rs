//! The line load of a beam section above a flat half space: what of a law reaches the axis.
//!
//! Heights enter as the gap η = y - h/2 below the untilted section, so that the small number is stored and not recovered from a
//! difference.

use super::barrier::Barrier;
use super::cohesive::opening_rate::OpeningRate;
use super::law::Law;
use super::response::LineResponse;
use super::{body_force, surface_traction};
use crate::adhesion::levels::half_space::HalfSpace;
use crate::number::Real;
use crate::number::root::{Bracket, Look};
use serde::{Deserialize, Serialize};

/// What of the adhesion reaches the axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineLoad {
    /// Line force and line moment.
    #[default]
    Full,
    /// The line force without the moment; it has no potential.
    ForceOnly,
    /// The traction at the gap below the axis, independent of the section's rotation: Ψ = W(η), less W(η + h) where the upper surface is included.
    AxisGap,
}

/// The law of one section: half space, height, adhesion model, which load, which faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineLaw {
    /// Hamaker constant and distances of the ground
    pub half_space: HalfSpace,
    /// nm
    pub height: f64,
    /// The adhesion model
    pub law: Law,
    /// Whether the contact moment acts beside the line force
    pub line_load: LineLoad,
    /// Whether the attraction of the upper surface is included (the r2 terms); a cohesive law has none.
    pub far_face: bool,
}

/// What adheres to a half space is nearer than this many r0.
const ADHERING: f64 = 2.0;

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
            (Law::Cohesive(cohesive), LineLoad::AxisGap, _) => return LineResponse::blind(cohesive.levels(gap), None),
            (Law::Cohesive(cohesive), ..) => cohesive.on_face(height, gap, sin, cos),
            (Law::Own(own), LineLoad::AxisGap, _) => {
                let flat = own.response(height, gap, T::splat(0.0), T::splat(1.0));
                return LineResponse::blind([flat.energy, -flat.by_gap, flat.gap_gap], None);
            }
            (Law::Own(own), ..) => own.response(height, gap, sin, cos),
            (_, LineLoad::AxisGap, far_face) => return self.axis_gap(height, gap, far_face),
            (Law::BodyForce, _, true) => body_force::both_faces(&self.half_space, height, gap, sin, cos),
            (Law::BodyForce, _, false) => body_force::near_face(&self.half_space, height, gap, sin, cos),
            (Law::SurfaceTraction, _, true) => surface_traction::both_faces(&self.half_space, height, gap, sin, cos),
            (Law::SurfaceTraction, _, false) => surface_traction::near_face(&self.half_space, height, gap, sin, cos),
        };
        if self.line_load == LineLoad::ForceOnly { full.without_moment() } else { full }
    }

    /// The openings, in ranges of a cohesive law, at which its pieces join, ascending; none of a law that is smooth.
    pub(crate) fn knots(&self) -> &'static [f64] {
        match &self.law {
            Law::Cohesive(cohesive) => cohesive.shape.knots(),
            Law::BodyForce | Law::SurfaceTraction | Law::Own(_) => &[],
        }
    }

    /// The opening that `Self::knots` speaks of, of a section of this height (nm) at the gap η (nm) and the rotation
    /// θ; zero of other laws.
    pub fn opening(&self, height: f64, gap: f64, rotation: f64) -> f64 {
        let Law::Cohesive(cohesive) = &self.law else { return 0.0 };
        (self.face_distance(height, gap, rotation) - cohesive.closed) / cohesive.range
    }

    /// Distance of the face that is bonded where a section of this height (nm) is not tilted, at the gap η (nm) and the rotation θ, nm.
    pub(crate) fn face_distance(&self, height: f64, gap: f64, rotation: f64) -> f64 {
        let lift = if self.line_load == LineLoad::AxisGap { 0.0 } else { 0.5 * height * (1.0 - rotation.cos()) };
        gap + lift
    }

    /// Whether the load derives from a potential, so that the tangent is symmetric and energy is conserved.
    pub fn has_potential(&self) -> bool {
        match self.line_load {
            LineLoad::Full => self.law.has_potential(),
            LineLoad::ForceOnly => false,
            LineLoad::AxisGap => true,
        }
    }

    /// The distance (nm) from which on hardly anything pulls: 10 r0 from a half space, whose traction has fallen there to 7e-4 of its
    /// strength; where a thousandth is left of that of a cohesive law; a law of the user's own says it.
    pub fn cutoff_distance(&self) -> f64 {
        self.law.cutoff_distance(&self.half_space)
    }

    /// The change of a gap that changes the traction by its own size, nm: r0 of the half space, and of a cohesive law r0 of the half space that
    /// has its work of adhesion and its strength.
    pub(crate) fn gap_scale(&self) -> f64 {
        self.law.gap_scale(&self.half_space)
    }

    /// What keeps the face that looks down out of the substrate.
    pub(crate) fn barrier(&self) -> Barrier {
        self.law.barrier(&self.half_space)
    }

    /// The distance (nm) up to which a face counts as adhering: 2 r0 from a half space, and from a cohesive law as much farther than it is at
    /// rest as from the half space with its work of adhesion and strength.
    pub(crate) fn adhering_distance(&self) -> f64 {
        match self.barrier() {
            Barrier::Pole => ADHERING * self.gap_scale(),
            Barrier::Spring { closed, scale } => {
                let like = HalfSpace { equilibrium_distance: scale, ..self.half_space };
                closed + ADHERING * scale - like.equilibrium_gap()
            }
        }
    }

    /// The gap η at which a flat section is at rest, T_c(η, θ = 0) = 0, nm.
    ///
    /// It lies between the half space's equilibrium gap (no far face) and its strongest gap, because T(r1) = T(r2) < 0.
    pub fn rest_gap(&self) -> f64 {
        if let Law::Own(own) = self.law {
            return own.law().rest_gap(self.height);
        }
        let closed = self.half_space.equilibrium_gap();
        let gaps = Bracket { low: closed * (1.0 - 1e-9), high: self.half_space.strongest_gap() };
        let traction = |gap: f64| {
            let at = self.response(gap, 0.0, 1.0);
            (at.by_gap, at.gap_gap)
        };
        let settles = |look: &Look| ((look.next - look.at).abs() <= 2.0 * f64::EPSILON * look.at).then_some(look.next);
        gaps.newton(closed, traction, settles).unwrap_or_else(|left| left.next)
    }

    /// Ψ of the flat section at rest, nN/nm: minus the work of adhesion of the strip.
    pub fn rest_energy(&self) -> f64 {
        self.response(self.rest_gap(), 0.0, 1.0).energy
    }

    /// The stiffness (nN/nm³) of the flat section by which the length of the process zone is estimated: at rest, of a cohesive law over
    /// its range.
    pub(crate) fn rest_stiffness(&self) -> f64 {
        match &self.law {
            Law::Cohesive(law) => law.strength / law.range,
            Law::BodyForce | Law::SurfaceTraction => self.response(self.rest_gap(), 0.0, 1.0).gap_gap,
            Law::Own(own) => own.law().rest_stiffness(self.height),
        }
    }

    /// Whether the face that looks up makes a difference.
    pub(crate) fn has_far_face(&self) -> bool {
        self.far_face && self.law.has_far_face()
    }

    /// Whether the energy has no lower bound: the near face of the body force alone has W/|cos θ|, with W below zero, which is a pole where
    /// a section stands upright. The far face takes that away.
    pub fn has_pole(&self) -> bool {
        !self.far_face && self.law.has_pole_of_one_face() && self.line_load != LineLoad::AxisGap
    }

    #[inline(always)]
    fn axis_gap<T: Real>(&self, height: T, gap: T, far_face: bool) -> LineResponse<T> {
        LineResponse::blind(self.half_space.levels(gap), far_face.then(|| self.half_space.levels(gap + height)))
    }
}

/// A cohesive law with an adhesive whose traction grows with the rate of opening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RateLaw {
    /// At rest
    pub law: LineLaw,
    /// What the rate makes of it
    pub rate: OpeningRate,
}

impl RateLaw {
    /// What a section carries besides the load at rest, in a step whose known distance is this one (nm) and whose rate is c (1/ns).
    #[inline(always)]
    pub(crate) fn response<T: Real>(
        &self,
        height: T,
        gap: T,
        sin: T,
        cos: T,
        [known, per_time]: [T; 2],
    ) -> LineResponse<T> {
        let Law::Cohesive(cohesive) = &self.law.law else { return LineResponse::zero() };
        let levels = |r: T| {
            let [w, t, b] = cohesive.levels(r);
            T::each_of([w, t, b, r - known, per_time], |[w, t, b, opened, per_time]| {
                self.rate.levels([w, t, b], opened, per_time)
            })
        };
        match self.law.line_load {
            LineLoad::AxisGap => LineResponse::blind(levels(gap), None),
            LineLoad::Full => LineResponse::of_bonded_face(levels, height, gap, sin, cos),
            LineLoad::ForceOnly => LineResponse::of_bonded_face(levels, height, gap, sin, cos).without_moment(),
        }
    }
}
