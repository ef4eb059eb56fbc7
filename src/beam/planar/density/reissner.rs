//! Reissner's geometrically exact planar beam, three unknowns a node: ξ, gap, rotation.
//!
//! ξ = x - S is the displacement along the ground: where the beam adheres it is small, however long the beam, and so is its rounding.
//! Γ1 = x' cos θ + y' sin θ - 1, Γ2 = -x' sin θ + y' cos θ, κ = θ' - κ0; stored energy ½EA Γ1² + ½GA_s Γ2² + ½EI κ² per
//! length, or w(Γ1) of another [`StretchLaw`] in place of the first, and the adhesion bΨ(y, θ). κ0 is the curvature at rest, zero for a strip.

use crate::adhesion::section::coverage::TiltCount;
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::element::energy_density::{Coupling, EnergyDensity, MEMORY, Point, PointResponse, SectionState};
use crate::beam::material::stretch_law::{StretchLaw, StretchResponse};
use crate::beam::reference_configuration::ReferenceCurve;
use crate::beam::section::{Section, SectionAt};
use crate::beam::varying::Profile;
use crate::number::Real;

/// The three-field form of the planar Reissner beam on a flat half space. Fields: ξ = x - S (nm), gap η = y - h/2 (nm),
/// rotation θ. It has no border.
#[derive(Clone, Debug)]
pub struct ReissnerBeam {
    /// The beam from place to place
    pub profile: Profile,
    /// What adheres it to the flat ground
    pub law: LineLaw,
    /// How its tilted sections are counted
    pub count: TiltCount,
}

/// What couples in a beam whose adhesion looks at gap and rotation.
pub(super) const COUPLING: Coupling<3> = Coupling {
    value_value: [[false, false, false], [false, true, true], [false, true, true]],
    value_slope: [[false; 3], [false; 3], [true, true, false]],
    slope_slope: [[true, true, false], [true, true, false], [false, false, true]],
};

/// The slopes x', y' and θ' where ξ, the height field and θ have these, and the axis rises faster than that field by `rise`.
#[inline(always)]
pub(super) fn of_axis<T: Real>([along, up, turn]: [T; 3], rise: T) -> [T; 3] {
    [along + 1.0, up + rise, turn]
}

/// The stored energy at one point and its derivatives, for a rotation θ and the slopes x', y', θ'.
#[inline(always)]
pub(super) fn stored<T: Real>(
    &SectionAt { ref section, stretch, curvature, .. }: &SectionAt<T>,
    rotation: T,
    slopes: [T; 3],
) -> PointResponse<T, 3> {
    stored_from(section, stretch, rotation, slopes, [T::splat(0.0), T::splat(0.0), curvature])
}

/// The same of strains that count from known ones, Γ1, Γ2 and θ'.
#[inline(always)]
pub(super) fn stored_from<T: Real>(
    &Section { axial, shear, bending }: &Section<T>,
    law: StretchLaw,
    rotation: T,
    [dx, dy, turn]: [T; 3],
    [known_stretch, known_slide, known_turn]: [T; 3],
) -> PointResponse<T, 3> {
    let (sin, cos) = rotation.sin_cos();
    let curvature = turn - known_turn;
    let (whole_stretch, slide_t) = (dx * cos + dy * sin - 1.0, -(dx * cos + dy * sin));
    // ∂Γ1/∂θ = Γ2 and ∂Γ2/∂θ = -(1 + Γ1)
    let stretch_t = dy * cos - dx * sin;
    let (stretch, slide) = (whole_stretch - known_stretch, stretch_t - known_slide);
    let StretchResponse { force: n, stiffness: axial, energy } = law.at(axial, stretch);
    let q = slide * shear;
    let (horizontal, vertical) = (n * cos - q * sin, n * sin + q * cos);
    let horizontal_t = stretch_t * cos * axial - slide_t * sin * shear - vertical;
    let vertical_t = stretch_t * sin * axial + slide_t * cos * shear + horizontal;
    let rotation_rotation = stretch_t * stretch_t * axial + slide_t * slide_t * shear + n * slide_t - q * stretch_t;

    let mut response = PointResponse::zero();
    response.energy = (energy * 2.0 + q * slide + curvature * curvature * bending) * 0.5;
    response.by_value[2] = n * stretch_t + q * slide_t;
    response.by_slope = [horizontal, vertical, curvature * bending];
    response.value_value[2][2] = rotation_rotation;
    response.value_slope[2][0] = horizontal_t;
    response.value_slope[2][1] = vertical_t;
    response.slope_value[0][2] = horizontal_t;
    response.slope_value[1][2] = vertical_t;
    let mixed = sin * cos * (axial - shear);
    response.slope_slope[0][0] = cos * cos * axial + sin * sin * shear;
    response.slope_slope[0][1] = mixed;
    response.slope_slope[1][0] = mixed;
    response.slope_slope[1][1] = sin * sin * axial + cos * cos * shear;
    response.slope_slope[2][2] = bending;
    response
}

/// The section at the rotation θ under the forces H, V and the moment M.
pub(super) fn section_from_forces(
    &Section { axial, shear, bending }: &Section,
    law: StretchLaw,
    rotation: f64,
    [horizontal, vertical, moment]: [f64; 3],
    rest_curvature: f64,
) -> SectionState {
    let (sin, cos) = rotation.sin_cos();
    let (n, q) = (horizontal * cos + vertical * sin, vertical * cos - horizontal * sin);
    let (stretch, slide) = (law.strain(n / axial), q / shear);
    SectionState {
        horizontal_slope: (1.0 + stretch) * cos - slide * sin,
        vertical_slope: (1.0 + stretch) * sin + slide * cos,
        horizontal_force: horizontal,
        vertical_force: vertical,
        moment,
        curvature: moment / bending + rest_curvature,
        stored: 0.5 * (2.0 * law.energy(axial, n) + q * slide + moment * moment / bending),
    }
}

impl EnergyDensity<3> for ReissnerBeam {
    const COUPLING: Coupling<3> = COUPLING;

    #[inline(always)]
    fn response<T: Real>(&self, place: T, [_, gap, rotation]: [T; 3], slope: [T; 3], _: f64) -> PointResponse<T, 3> {
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let adhesion = self.law.response_of(station.height, gap, sin, cos);
        let b = station.width;
        let mut response = stored(&station, rotation, of_axis(slope, station.rise));
        response.adhesion = adhesion.energy * b;
        response.energy = response.energy + response.adhesion;
        response.by_value[1] = adhesion.by_gap * b;
        response.by_value[2] = response.by_value[2] + adhesion.by_rotation * b;
        response.value_value[1][1] = adhesion.gap_gap * b;
        response.value_value[1][2] = adhesion.gap_rotation * b;
        response.value_value[2][1] = adhesion.rotation_gap * b;
        response.value_value[2][2] = response.value_value[2][2] + adhesion.rotation_rotation * b;
        response.set_coverage(self.law.coverage(self.count, &adhesion, sin, cos), b);
        response
    }

    fn knots(&self) -> &'static [f64] {
        self.law.knots()
    }

    fn opening(&self, place: f64, [_, gap, rotation]: [f64; 3], _: [f64; MEMORY]) -> f64 {
        self.law.opening(self.profile.at(place).height, gap, rotation)
    }

    fn adhesion_response(&self, place: f64, [_, gap, rotation]: [f64; 3], _: [f64; MEMORY]) -> PointResponse<f64, 3> {
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let adhesion = self.law.response_of(station.height, gap, sin, cos);
        PointResponse::of_adhesion(&adhesion, self.law.coverage(self.count, &adhesion, sin, cos), station.width)
    }

    fn is_symmetric(&self) -> bool {
        self.law.has_potential()
    }

    fn section_state(&self, point: &Point<f64, 3>, _: f64) -> SectionState {
        self.profile.section_state(point.place, point.value[2], point.slope)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        self.profile.section_state_from_forces(place, value[2], forces)
    }
}

/// The section of a response to the slopes x', y' and θ'.
pub(super) fn section_of(response: &PointResponse<f64, 3>, [dx, dy, turn]: [f64; 3]) -> SectionState {
    let [horizontal_force, vertical_force, moment] = response.by_slope;
    SectionState {
        horizontal_slope: dx,
        vertical_slope: dy,
        horizontal_force,
        vertical_force,
        moment,
        curvature: turn,
        stored: response.energy,
    }
}

impl Profile {
    /// The section at S, turned by θ, under the slopes ξ', η' of the gap below it, and θ'.
    pub(super) fn section_state(&self, place: f64, rotation: f64, slope: [f64; 3]) -> SectionState {
        let station = self.at(place);
        let slopes = of_axis(slope, station.rise);
        section_of(&stored(&station, rotation, slopes), slopes)
    }

    /// The same section under the forces H, V and the moment M.
    pub(super) fn section_state_from_forces(&self, place: f64, rotation: f64, forces: [f64; 3]) -> SectionState {
        let station = self.at(place);
        section_from_forces(&station.section, station.stretch, rotation, forces, station.curvature)
    }
}

// -- Reissner's beam on its own: nothing adheres, and it may be curved at rest --

/// A planar Reissner beam that is stress-free along a given curve. Fields: ξ = x - S, y (nm), rotation θ. It has no border.
///
/// Γ1 and Γ2 as in [`crate::beam::ReissnerBeam`], the change of curvature θ' - κ0(S); stored energy per length
/// ½EA Γ1² + ½GA_s Γ2² + ½EI (θ' - κ0)².
#[derive(Clone, Copy, Debug)]
pub struct ReissnerRod {
    /// EA, GA_s and EI, the same everywhere
    pub section: Section,
    /// Its stress-free axis
    pub rest: ReferenceCurve,
}

impl EnergyDensity<3> for ReissnerRod {
    const COUPLING: Coupling<3> = COUPLING;

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], slope: [T; 3], _: f64) -> PointResponse<T, 3> {
        let [k0, k1, k2] = self.rest.curvature;
        let known = [T::splat(0.0), T::splat(0.0), place * (place * k2 + k1) + k0];
        stored_from(&self.section.splat(), StretchLaw::Linear, value[2], of_axis(slope, T::splat(0.0)), known)
    }

    fn section_state(&self, &Point { place, value, slope, .. }: &Point<f64, 3>, _: f64) -> SectionState {
        section_of(&self.response(place, value, slope, 0.0), of_axis(slope, 0.0))
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        let curvature = self.rest.curvature_at(place);
        section_from_forces(&self.section, StretchLaw::Linear, value[2], forces, curvature)
    }
}
