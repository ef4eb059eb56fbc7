//! Reissner's planar beam with x' minimised out: two unknowns a node, the gap and the rotation.
//!
//! On a flat substrate without friction nothing acts along x, so the horizontal section force H is one number for the
//! whole chain: zero where the grip is free to slide, the multiplier of x(L) - x(0) = L where it is held. Minimising
//! ½EA Γ1² + ½GA_s Γ2² - H x' over x' leaves, with B = cos²θ/EA + sin²θ/GA_s, C = sin²θ/EA + cos²θ/GA_s,
//! D = sin θ cos θ (1/EA - 1/GA_s) and V = (y' - sin θ - H D)/C,
//!
//!   φ(y', θ; H) = ½ C V² - ½ B H² - H cos θ,   ∂φ/∂H = -x' = -(cos θ + H B + V D),
//!
//! to which ½EI θ'² and the adhesion bΨ(y, θ) are added. Nothing is neglected.

use crate::adhesion::section::coverage::TiltCount;
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::element::energy_density::{Coupling, EnergyDensity, MEMORY, Point, PointResponse, SectionState};
use crate::beam::section::SectionAt;
use crate::beam::varying::Profile;
use crate::number::Real;

/// The two-field form of the planar Reissner beam on a flat half space. Fields: gap η = y - h/2 (nm), rotation θ.
/// The border is H where `HELD`, and counts nothing otherwise. What varies along the beam is in its profile; there
/// y' = η' + h'/2 and θ' - κ0 bends it.
#[derive(Clone, Debug)]
pub struct ReducedBeam<const HELD: bool> {
    /// The beam from place to place
    pub profile: Profile,
    /// What adheres it to the flat ground
    pub law: LineLaw,
    /// How its tilted sections are counted
    pub count: TiltCount,
}

/// B, C and D of the module's head at one rotation.
struct Compliance<T> {
    along: T,
    across: T,
    mixed: T,
}

impl<T: Real> Compliance<T> {
    #[inline(always)]
    fn of(station: &SectionAt<T>, sin: T, cos: T) -> Self {
        let [axial, shear] = station.compliance;
        Self {
            along: cos * cos * axial + sin * sin * shear,
            across: sin * sin * axial + cos * cos * shear,
            mixed: sin * cos * (axial - shear),
        }
    }
}

impl<const HELD: bool> ReducedBeam<HELD> {
    fn state(
        station: &SectionAt<f64>,
        rotation: f64,
        vertical_force: f64,
        moment: f64,
        axial_multiplier: f64,
    ) -> SectionState {
        let (sin, cos) = rotation.sin_cos();
        let h = if HELD { axial_multiplier } else { 0.0 };
        let c = Compliance::of(station, sin, cos);
        let bend = moment / station.section.bending;
        let v = vertical_force;
        SectionState {
            horizontal_slope: cos + h * c.along + v * c.mixed,
            vertical_slope: sin + v * c.across + h * c.mixed,
            horizontal_force: h,
            vertical_force: v,
            moment,
            curvature: bend + station.curvature,
            stored: 0.5 * (c.along * h * h + 2.0 * c.mixed * h * v + c.across * v * v) + 0.5 * moment * bend,
        }
    }
}

impl<const HELD: bool> EnergyDensity<2> for ReducedBeam<HELD> {
    const COUPLING: Coupling<2> = Coupling {
        value_value: [[true; 2]; 2],
        value_slope: [[false, false], [true, false]],
        slope_slope: [[true, false], [false, true]],
    };
    const BORDER: bool = HELD;

    #[inline(always)]
    fn response<T: Real>(
        &self,
        place: T,
        [gap, rotation]: [T; 2],
        [gap_slope, turn]: [T; 2],
        axial_multiplier: f64,
    ) -> PointResponse<T, 2> {
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let adhesion = self.law.response_of(station.height, gap, sin, cos);
        let (rise, curvature) = (gap_slope + station.rise, turn - station.curvature);
        let b = station.width;
        let ei = station.section.bending;
        // g sin 2θ and g cos 2θ with g = 1/GA_s - 1/EA: C' = -g sin 2θ, D' = -g cos 2θ
        let g = station.compliance[1] - station.compliance[0];
        let (g_sin, g_cos) = (sin * cos * (g * 2.0), (cos - sin) * (cos + sin) * g);
        let c = Compliance::of(&station, sin, cos);
        let inverse = c.across.recip();
        let mut response = PointResponse::zero();

        let h = if HELD { axial_multiplier } else { 0.0 };
        let v = if HELD { (rise - sin - c.mixed * h) * inverse } else { (rise - sin) * inverse };
        // what cos θ becomes under the horizontal force
        let lever = if HELD { cos - g_cos * h } else { cos };
        let v_t = (g_sin * v - lever) * inverse;
        let mut by_rotation = g_sin * v * v * 0.5 - v * lever;
        let mut by_rotation2 = g_cos * v * v + v * sin;
        let mut energy = c.across * v * v * 0.5;
        if HELD {
            by_rotation = by_rotation + sin * h - g_sin * (0.5 * h * h);
            by_rotation2 = by_rotation2 + cos * h - g_cos * (h * h) - v * g_sin * (2.0 * h);
            energy = energy - c.along * (0.5 * h * h) - cos * h;
            let v_h = -c.mixed * inverse;
            response.by_border = -(cos + c.along * h + v * c.mixed);
            response.border_border = -(c.along + v_h * c.mixed);
            response.border_slope[0] = v_h;
            response.border_value[1] = sin - g_sin * h - v_t * c.mixed + v * g_cos;
        }
        response.energy = energy + curvature * curvature * (ei * 0.5) + adhesion.energy * b;
        response.adhesion = adhesion.energy * b;
        response.by_value = [adhesion.by_gap * b, by_rotation + adhesion.by_rotation * b];
        response.by_slope = [v, curvature * ei];
        response.value_value = [
            [adhesion.gap_gap * b, adhesion.gap_rotation * b],
            [adhesion.rotation_gap * b, by_rotation2 + v_t * v_t * c.across + adhesion.rotation_rotation * b],
        ];
        response.value_slope[1][0] = v_t;
        response.slope_value[0][1] = v_t;
        response.slope_slope[0][0] = inverse;
        response.slope_slope[1][1] = ei;
        response.set_coverage(self.law.coverage(self.count, &adhesion, sin, cos), b);
        response
    }

    fn knots(&self) -> &'static [f64] {
        self.law.knots()
    }

    fn opening(&self, place: f64, [gap, rotation]: [f64; 2], _: [f64; MEMORY]) -> f64 {
        self.law.opening(self.profile.at(place).height, gap, rotation)
    }

    fn adhesion_response(&self, place: f64, [gap, rotation]: [f64; 2], _: [f64; MEMORY]) -> PointResponse<f64, 2> {
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let adhesion = self.law.response_of(station.height, gap, sin, cos);
        PointResponse::of_adhesion(&adhesion, self.law.coverage(self.count, &adhesion, sin, cos), station.width)
    }

    fn is_symmetric(&self) -> bool {
        self.law.has_potential()
    }

    const FOLLOWS_FORCE: bool = true;

    /// y' at θ + δθ and H + δH under the force V + δV, less y' + δy', with δV = (δy' + (g sin 2θ V - cos θ + g cos 2θ H) δθ - D δH)/C.
    #[inline(always)]
    fn slope_beyond_step<T: Real>(
        &self,
        place: T,
        [[_, rotation], [gap_slope, _]]: [[T; 2]; 2],
        [[_, turned], [steeper, _]]: [[T; 2]; 2],
        [h, more]: [f64; 2],
    ) -> T {
        let station = self.profile.at(place);
        let (sin, cos) = rotation.sin_cos();
        let g = station.compliance[1] - station.compliance[0];
        let (g_sin, g_cos) = (sin * cos * (g * 2.0), (cos - sin) * (cos + sin) * g);
        let c = Compliance::of(&station, sin, cos);
        let inverse = c.across.recip();
        let rise = gap_slope + station.rise;
        let v = if HELD { (rise - sin - c.mixed * h) * inverse } else { (rise - sin) * inverse };
        let lever = if HELD { cos - g_cos * h } else { cos };
        let driven = if HELD { steeper - c.mixed * more } else { steeper };
        let force = v + (driven + (g_sin * v - lever) * turned) * inverse;
        let (sin, cos) = (rotation + turned).sin_cos();
        let c = Compliance::of(&station, sin, cos);
        let along = if HELD { c.mixed * (h + more) } else { T::splat(0.0) };
        sin + c.across * force + along - (rise + steeper)
    }

    fn section_state(&self, point: &Point<f64, 2>, axial_multiplier: f64) -> SectionState {
        let &Point { place, value: [_, rotation], slope: [gap_slope, turn], .. } = point;
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let c = Compliance::of(&station, sin, cos);
        let h = if HELD { axial_multiplier } else { 0.0 };
        let v = (gap_slope + station.rise - sin - h * c.mixed) / c.across;
        Self::state(&station, rotation, v, station.section.bending * (turn - station.curvature), axial_multiplier)
    }

    fn section_state_from_forces(
        &self,
        place: f64,
        [_, rotation]: [f64; 2],
        [v, moment]: [f64; 2],
        axial_multiplier: f64,
    ) -> SectionState {
        Self::state(&self.profile.at(place), rotation, v, moment, axial_multiplier)
    }
}
