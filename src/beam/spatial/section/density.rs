//! The energy of a beam in space, per length of its axis: stored and of adhesion.
//!
//! Fields are the place (x, y, z) of the axis and the quaternion q of the directors d1 (along the axis), d2 (width) and d3 (height). With
//! R = [d1 d2 d3],
//!
//!   Γ = Rᵀ r' - e1,   K = 2 Im(q̄ ∘ q')/|q|²,   φ = ½ (Γ, K - K0) · C (Γ, K - K0) + Ψ(y, a, c),   a = b d2·e_y,  c = h d3·e_y.
//!
//! Γ, K and R are homogeneous of degree zero in (q, q'), so that interpolated quaternions need not have the length one; and they do not
//! change when the whole beam is turned, which interpolation between the nodes commutes with.
//!
//! Derivatives: with q̂ = q/|q|, changes are written as δq = |q| q̂ ∘ (α, ω), δq' = |q| q̂ ∘ (β, ξ) and δr' = R γ. Then, to second order,
//!
//!   Γ = g + γ + 2 g × ω  - 2 ω × γ + 2α ω × g + 2 ω (ω·g) - 2 |ω|² g,                                g = Rᵀ r'
//!   K = k - αk + 2ξ - 2v ω + k × ω  - 2αξ - 2βω - 2 ω × ξ + α² k + 4αv ω + 2α ω × k - |ω|² k,        v = q·q'/|q|²
//!
//! and Rᵀ e_y as Γ with γ = 0. Source: J. C. Simo, A finite strain beam formulation, Comput. Methods Appl. Mech. Eng. 49 (1985).

use super::held_sections::{HeldSections, LocalHold};
use super::kinematics::SPATIAL_FIELDS;
use super::kinematics::{Kinematics, turned_twice};
use super::local_adhesion::LocalAdhesion;
use super::spatial_profile::{SpatialProfile, Station};
use crate::adhesion::spatial_section::response::SpatialSectionResponse;
use crate::adhesion::spatial_section::section::SpatialSection;
use crate::beam::element::energy_density::{Coupling, MEMORY, Point, PointResponse};
use crate::beam::element::integrand::{Integrand, PointEnergy, PointGradient};
use crate::beam::spatial::rotation::{
    Matrix3, apply, cross, dot, matrix, multiply, multiply_by_transposed, multiply_transposed, normalised, skew,
};
use crate::number::{F64x4, Real};

/// Where the factor of a viscous material stands in [`Point::memory`], behind the six strains.
pub(super) const FACTOR: usize = 6;

/// The density, with sections from place to place.
#[derive(Clone, Debug)]
pub struct SpatialDensity {
    /// What bends
    pub profile: SpatialProfile,
    /// What adheres its sections to the flat ground y = 0; nothing of a beam on its own.
    pub adhesion: Option<SpatialSection>,
    /// What holds them along the ground as well, under a cohesive law; nothing where they slide
    pub held: Option<HeldSections>,
}

/// What the adhesion of a section exerts on the ground.
pub(crate) struct AdhesionLoad {
    /// Ψ, nN
    pub energy: f64,
    /// Per length, along x, y and z, nN/nm
    pub force: [f64; 3],
    /// Per length, about the directors, nN
    pub moment: [f64; 3],
}

/// Section forces and moments C ε, and the energy.
#[inline(always)]
fn forces<T: Real>(stiffness: &[[T; 6]; 6], strains: &[T; 6]) -> ([T; 3], [T; 3], T) {
    let [n0, n1, n2, m0, m1, m2] = apply(stiffness, strains);
    let (n, m) = ([n0, n1, n2], [m0, m1, m2]);
    let [g0, g1, g2, k0, k1, k2] = *strains;
    (n, m, (dot(n, [g0, g1, g2]) + dot(m, [k0, k1, k2])) * 0.5)
}

/// The same of a viscous material with the memory of a point, C ε + f C (ε - ε_k); the stiffness becomes (1 + f) C.
#[inline(always)]
fn viscous_forces<T: Real>(stiffness: &mut [[T; 6]; 6], strains: &[T; 6], memory: &[T; MEMORY]) -> ([T; 3], [T; 3], T) {
    let factor = memory[FACTOR];
    let since: [T; 6] = std::array::from_fn(|k| strains[k] - memory[k]);
    let (n, m, stored) = forces(stiffness, strains);
    let (more_n, more_m, more) = forces(stiffness, &since);
    for row in stiffness.iter_mut() {
        *row = row.map(|entry| entry + entry * factor);
    }
    let sum = |a: [T; 3], b: [T; 3]| std::array::from_fn(|k| a[k] + b[k] * factor);
    (sum(n, more_n), sum(m, more_m), stored + more * factor)
}

/// First derivatives of the stored energy in local changes: by γ, by (α, ω), by (β, ξ).
#[inline(always)]
fn local_gradient<T: Real>(at: &Kinematics<T>, n: [T; 3], m: [T; 3]) -> ([T; 3], [T; 4], [T; 4]) {
    let (by_stretch, by_turn) = (cross(n, at.stretch), cross(m, at.turn));
    let on_value = [
        -dot(m, at.turn),
        by_stretch[0] * 2.0 + by_turn[0] - at.growth * m[0] * 2.0,
        by_stretch[1] * 2.0 + by_turn[1] - at.growth * m[1] * 2.0,
        by_stretch[2] * 2.0 + by_turn[2] - at.growth * m[2] * 2.0,
    ];
    (n, on_value, [T::splat(0.0), m[0] * 2.0, m[1] * 2.0, m[2] * 2.0])
}

/// Second derivatives of the stored energy in local changes.
struct LocalTangent<T> {
    /// By γ twice
    stretch_stretch: [[T; 3]; 3],
    /// By γ and (α, ω)
    stretch_value: [[T; 4]; 3],
    /// By γ and (β, ξ)
    stretch_slope: [[T; 4]; 3],
    /// By (α, ω) twice
    value_value: [[T; 4]; 4],
    /// By (α, ω) and (β, ξ)
    value_slope: [[T; 4]; 4],
    /// By (β, ξ) twice
    slope_slope: [[T; 4]; 4],
}

impl<T: Real> LocalTangent<T> {
    #[inline(always)]
    fn new(at: &Kinematics<T>, c: &[[T; 6]; 6], n: [T; 3], m: [T; 3]) -> Self {
        let zero = T::splat(0.0);
        let part = |row: usize, column: usize| -> Matrix3<T> {
            let mut out = [[zero; 3]; 3];
            for i in 0..3 {
                for j in 0..3 {
                    out[i][j] = c[row + i][column + j];
                }
            }
            out
        };
        let (gg, gk, kk) = (part(0, 0), part(0, 3), part(3, 3));
        // how Γ and K change with (α, ω); with γ as it is, with (β, ξ) by twice ξ
        let (g, k) = (skew(at.stretch), skew(at.turn));
        let (mut stretch, mut turn) = ([[zero; 4]; 3], [[zero; 4]; 3]);
        for i in 0..3 {
            turn[i][0] = -at.turn[i];
            for j in 0..3 {
                stretch[i][j + 1] = g[i][j] * 2.0;
                turn[i][j + 1] = k[i][j];
            }
            turn[i][i + 1] = turn[i][i + 1] - at.growth * 2.0;
        }
        let add = |a: [[T; 4]; 3], b: [[T; 4]; 3]| {
            let mut sum = a;
            for i in 0..3 {
                for j in 0..4 {
                    sum[i][j] = sum[i][j] + b[i][j];
                }
            }
            sum
        };
        let force = add(multiply(&gg, &stretch), multiply(&gk, &turn));
        let moment = add(multiply_transposed(&gk, &stretch), multiply(&kk, &turn));
        let mut value_value = multiply_transposed(&stretch, &force);
        let by_turn = multiply_transposed(&turn, &moment);
        let (mut stretch_value, mut stretch_slope) = (force, [[zero; 4]; 3]);
        let (mut value_slope, mut slope_slope) = ([[zero; 4]; 4], [[zero; 4]; 4]);
        let (force_skew, moment_skew) = (skew(n), skew(m));
        for i in 0..4 {
            for j in 0..4 {
                value_value[i][j] = value_value[i][j] + by_turn[i][j];
            }
            for j in 0..3 {
                value_slope[i][j + 1] = moment[j][i] * 2.0;
            }
        }
        for i in 0..3 {
            for j in 0..3 {
                stretch_value[i][j + 1] = stretch_value[i][j + 1] - force_skew[i][j] * 2.0;
                stretch_slope[i][j + 1] = gk[i][j] * 2.0;
                value_slope[i + 1][j + 1] = value_slope[i + 1][j + 1] + moment_skew[i][j] * 2.0;
                slope_slope[i + 1][j + 1] = kk[i][j] * 4.0;
            }
        }
        turned_twice(n, at.stretch, &mut value_value);
        let (across, along) = (cross(at.turn, m), dot(m, at.turn) * 2.0);
        value_value[0][0] = value_value[0][0] + along;
        for i in 0..3 {
            let mixed = at.growth * m[i] * 4.0 + across[i] * 2.0;
            value_value[0][i + 1] = value_value[0][i + 1] + mixed;
            value_value[i + 1][0] = value_value[i + 1][0] + mixed;
            value_value[i + 1][i + 1] = value_value[i + 1][i + 1] - along;
            value_slope[0][i + 1] = value_slope[0][i + 1] - m[i] * 2.0;
            value_slope[i + 1][0] = value_slope[i + 1][0] - m[i] * 2.0;
        }
        Self { stretch_stretch: gg, stretch_value, stretch_slope, value_value, value_slope, slope_slope }
    }
}

impl SpatialDensity {
    /// Γ and K - K0, and the energy ½ ε · C ε that is stored with them, nN.
    pub(super) fn strains(&self, point: &Point<f64, SPATIAL_FIELDS>) -> ([f64; 6], f64) {
        let station = self.profile.at(point.place);
        let strains = Kinematics::new(&point.value, &point.slope).strains(&station.rest_curvature);
        (strains, forces(&station.stiffness, &strains).2)
    }

    /// Section forces and moments along and about the directors.
    pub(crate) fn section_forces(
        &self,
        place: f64,
        value: &[f64; SPATIAL_FIELDS],
        slope: &[f64; SPATIAL_FIELDS],
    ) -> [[f64; 3]; 2] {
        let station = self.profile.at(place);
        let at = Kinematics::new(value, slope);
        let (n, m, _) = forces(&station.stiffness, &at.strains(&station.rest_curvature));
        [n, m]
    }

    /// The density and its derivatives by the fields, at one point or at several side by side.
    #[inline(always)]
    pub fn response<T: Real>(
        &self,
        place: T,
        value: &[T; SPATIAL_FIELDS],
        slope: &[T; SPATIAL_FIELDS],
    ) -> PointResponse<T, SPATIAL_FIELDS> {
        let mut out = PointResponse::zero();
        self.respond_into(place, value, slope, None, &mut out);
        out
    }

    /// The same with what a viscous material remembers there.
    #[inline(always)]
    fn remembering<T: Real>(
        &self,
        point: &Point<T, SPATIAL_FIELDS>,
        is_viscous: bool,
    ) -> PointResponse<T, SPATIAL_FIELDS> {
        let mut out = PointResponse::zero();
        let memory = is_viscous.then_some(&point.memory);
        self.respond_into(point.place, &point.value, &point.slope, memory, &mut out);
        out
    }

    /// What the adhesion of a section at S with these fields exerts on the ground.
    pub(crate) fn load(&self, place: f64, value: &[f64; SPATIAL_FIELDS]) -> AdhesionLoad {
        let (response, by_turn) = self.adhesion_at(place, &Kinematics::new(value, &[0.0; SPATIAL_FIELDS]), value);
        let [x, y, z, ..] = response.by_value;
        // turned by exp(φ/2), the quaternion changes with φ/2
        let moment = [1, 2, 3].map(|i| 0.5 * by_turn.gradient[i]);
        AdhesionLoad { energy: response.adhesion, force: [x, y, z], moment }
    }

    /// The adhesion alone: what goes with the place, and derivatives by (α, ω).
    fn adhesion_at(
        &self,
        place: f64,
        at: &Kinematics<f64>,
        value: &[f64; SPATIAL_FIELDS],
    ) -> (PointResponse<f64, SPATIAL_FIELDS>, ByTurn<f64>) {
        let (station, to_field) = (self.profile.at(place), at.basis());
        let lying = LyingHere { arc: place, place: [value[0], value[1], value[2]], at, station: &station, to_field };
        let (mut out, mut by_turn) = (PointResponse::zero(), ByTurn { gradient: [0.0; 4], hessian: [[0.0; 4]; 4] });
        self.adhere(&lying, &mut by_turn, &mut out);
        (out, by_turn)
    }

    /// What holds along the ground where anything adheres.
    fn holding(&self) -> Option<&HeldSections> {
        self.held.as_ref().filter(|_| self.adhesion.is_some())
    }

    /// What adheres a section whose axis is at the height y, nm: what repels alone where what pulls holds along the ground too.
    #[inline(always)]
    fn section_response<T: Real>(
        &self,
        law: &SpatialSection,
        y: T,
        at: &Kinematics<T>,
        station: &Station<T>,
    ) -> SpatialSectionResponse<T> {
        let (b, h, up) = (station.width, station.height, at.frame[1]);
        let (a, c) = (b * up[1], h * up[2]);
        if self.held.is_some() { law.pressed_of(b, y, a, c) } else { law.response_of([b, h], y, a, c) }
    }

    /// Adds the adhesion to an energy, and to derivatives by (α, ω); what goes with the place is set in the response.
    #[inline(always)]
    fn adhere<T: Real>(
        &self,
        lying: &LyingHere<T>,
        by_turn: &mut ByTurn<T>,
        out: &mut PointResponse<T, SPATIAL_FIELDS>,
    ) {
        let LyingHere { arc, place, at, station, to_field } = lying;
        let adhesion = match &self.adhesion {
            Some(law) => LocalAdhesion::of(&self.section_response(law, place[1], at, station), at, station),
            None => LocalAdhesion::none(),
        };
        out.energy = out.energy + adhesion.energy;
        out.adhesion = adhesion.energy;
        out.coverage = adhesion.coverage;
        out.by_value[1] = adhesion.by_height;
        out.value_value[1][1] = adhesion.height_height;
        out.coverage_by_value[1] = adhesion.coverage_by_height;
        let (mixed, covered) = (apply(to_field, &adhesion.height_value), apply(to_field, &adhesion.coverage_by_value));
        by_turn.add(&adhesion.by_value, &adhesion.value_value);
        for i in 0..4 {
            out.value_value[1][3 + i] = mixed[i];
            out.value_value[3 + i][1] = mixed[i];
            out.coverage_by_value[3 + i] = covered[i];
        }
        // responses may be those of other branches before
        for i in [0, 2] {
            (out.by_value[i], out.coverage_by_value[i]) = (T::splat(0.0), T::splat(0.0));
        }
        if let Some(held) = self.holding() {
            let pull = held.pull(*arc, *place, at, station);
            add_hold(&pull, to_field, out);
            by_turn.add(&pull.by_value, &pull.value_value);
        }
    }

    /// The same into a response that was zero or one of a beam in space: what never couples stays zero.
    #[inline(always)]
    fn respond_into<T: Real>(
        &self,
        place: T,
        value: &[T; SPATIAL_FIELDS],
        slope: &[T; SPATIAL_FIELDS],
        memory: Option<&[T; MEMORY]>,
        out: &mut PointResponse<T, SPATIAL_FIELDS>,
    ) {
        let mut station = self.profile.at(place);
        let at = Kinematics::new(value, slope);
        let strains = at.strains(&station.rest_curvature);
        let (n, m, stored) = match memory {
            None => forces(&station.stiffness, &strains),
            Some(memory) => viscous_forces(&mut station.stiffness, &strains, memory),
        };
        let (on_stretch, on_value, on_slope) = local_gradient(&at, n, m);
        let tangent = LocalTangent::new(&at, &station.stiffness, n, m);
        let mut by_turn = ByTurn { gradient: on_value, hessian: tangent.value_value };
        let to_field = at.basis();
        out.energy = stored;
        let lying =
            LyingHere { arc: place, place: [value[0], value[1], value[2]], at: &at, station: &station, to_field };
        self.adhere(&lying, &mut by_turn, out);
        let (by_quaternion, by_its_slope) = (apply(&to_field, &by_turn.gradient), apply(&to_field, &on_slope));
        let by_place = apply(&at.frame, &on_stretch);
        let place_place = multiply_by_transposed(&multiply(&at.frame, &tangent.stretch_stretch), &at.frame);
        let place_value = multiply_by_transposed(&multiply(&at.frame, &tangent.stretch_value), &to_field);
        let place_slope = multiply_by_transposed(&multiply(&at.frame, &tangent.stretch_slope), &to_field);
        let value_value = multiply_by_transposed(&multiply(&to_field, &by_turn.hessian), &to_field);
        let value_slope = multiply_by_transposed(&multiply(&to_field, &tangent.value_slope), &to_field);
        let slope_slope = multiply_by_transposed(&multiply(&to_field, &tangent.slope_slope), &to_field);
        for i in 0..3 {
            out.by_slope[i] = by_place[i];
            for j in 0..3 {
                out.slope_slope[i][j] = place_place[i][j];
            }
            for j in 0..4 {
                out.slope_value[i][3 + j] = place_value[i][j];
                out.value_slope[3 + j][i] = place_value[i][j];
                out.slope_slope[i][3 + j] = place_slope[i][j];
                out.slope_slope[3 + j][i] = place_slope[i][j];
            }
        }
        for i in 0..4 {
            out.by_value[3 + i] = by_quaternion[i];
            out.by_slope[3 + i] = by_its_slope[i];
            for j in 0..4 {
                out.value_value[3 + i][3 + j] = value_value[i][j];
                out.value_slope[3 + i][3 + j] = value_slope[i][j];
                out.slope_value[3 + j][3 + i] = value_slope[i][j];
                out.slope_slope[3 + i][3 + j] = slope_slope[i][j];
            }
        }
    }
}

/// A section as it lies.
struct LyingHere<'a, T> {
    /// S, nm
    arc: T,
    /// Of its axis, nm
    place: [T; 3],
    at: &'a Kinematics<T>,
    station: &'a Station<T>,
    /// [`Kinematics::basis`]
    to_field: [[T; 4]; 4],
}

/// First and second derivatives by (α, ω).
struct ByTurn<T> {
    gradient: [T; 4],
    hessian: [[T; 4]; 4],
}

impl<T: Real> ByTurn<T> {
    #[inline(always)]
    fn add(&mut self, gradient: &[T; 4], hessian: &[[T; 4]; 4]) {
        for i in 0..4 {
            self.gradient[i] = self.gradient[i] + gradient[i];
            for j in 0..4 {
                self.hessian[i][j] = self.hessian[i][j] + hessian[i][j];
            }
        }
    }
}

/// Adds what holds to energy, coverage and what goes with the place. All of the adhesion is counted.
#[inline(always)]
fn add_hold<T: Real>(pull: &LocalHold<T>, to_field: &[[T; 4]; 4], out: &mut PointResponse<T, SPATIAL_FIELDS>) {
    out.energy = out.energy + pull.energy;
    out.adhesion = out.adhesion + pull.energy;
    out.coverage = out.coverage + pull.energy;
    (out.by_value[0], out.by_value[2]) = (pull.by_place[0], pull.by_place[2]);
    out.by_value[1] = out.by_value[1] + pull.by_place[1];
    let (by_place, by_turn) = &pull.change;
    let turned = apply(to_field, by_turn);
    for i in 0..3 {
        let height = if i == 1 { out.coverage_by_value[1] } else { T::splat(0.0) };
        out.coverage_by_value[i] = height + by_place[i];
        let mixed = apply(to_field, &pull.place_value[i]);
        let of_turn: [T; 4] = std::array::from_fn(|k| pull.value_place[k][i]);
        let turned = apply(to_field, &of_turn);
        for j in 0..3 {
            let known = if i == 1 && j == 1 { out.value_value[1][1] } else { T::splat(0.0) };
            out.value_value[i][j] = known + pull.place_place[i][j];
        }
        for k in 0..4 {
            let known = if i == 1 { out.value_value[1][3 + k] } else { T::splat(0.0) };
            out.value_value[i][3 + k] = known + mixed[k];
            out.value_value[3 + k][i] = known + turned[k];
        }
    }
    for k in 0..4 {
        out.coverage_by_value[3 + k] = out.coverage_by_value[3 + k] + turned[k];
    }
}

/// What couples: y and the quaternion by adhesion, the quaternion with all slopes, and all slopes with one another.
const COUPLING: Coupling<SPATIAL_FIELDS> = {
    let (mut value_value, mut value_slope, mut slope_slope) = ([[false; 7]; 7], [[false; 7]; 7], [[true; 7]; 7]);
    let mut i = 0;
    while i < 7 {
        let mut j = 0;
        while j < 7 {
            value_value[i][j] = (i == 1 || i > 2) && (j == 1 || j > 2);
            value_slope[i][j] = i > 2;
            slope_slope[i][j] = true;
            j += 1;
        }
        i += 1;
    }
    Coupling { value_value, value_slope, slope_slope }
};

/// Where the adhesion holds along the ground the place couples with it.
const HELD: Coupling<SPATIAL_FIELDS> = Coupling { value_value: [[true; 7]; 7], ..COUPLING };

impl Integrand<SPATIAL_FIELDS> for SpatialDensity {
    fn coupling(&self) -> Coupling<SPATIAL_FIELDS> {
        if self.holding().is_some() { HELD } else { COUPLING }
    }

    fn has_border(&self) -> bool {
        false
    }

    fn is_symmetric(&self) -> bool {
        self.held.as_ref().is_none_or(|held| held.law.has_potential())
    }

    /// What a viscous material remembers says whether there is one.
    fn remembers(&self) -> bool {
        true
    }

    /// Where a face that is held closes the law has a corner as well: what repels does not depend on the slip.
    fn knots(&self) -> &'static [f64] {
        let Some(law) = self.adhesion.as_ref().and_then(SpatialSection::cohesive) else { return &[] };
        if self.held.is_some() { law.shape.knots_of_parts() } else { law.shape.knots() }
    }

    fn edges(&self) -> usize {
        2
    }

    fn opening(&self, place: f64, value: [f64; SPATIAL_FIELDS], _: [f64; MEMORY], edge: usize) -> f64 {
        let Some(law) = self.adhesion.as_ref().and_then(SpatialSection::cohesive) else { return 0.0 };
        let [_, y, _, turn @ ..] = value;
        let [width, height] = self.profile.outline(place);
        let [_, [_, aside, up], _] = matrix(normalised(turn));
        let side = if edge == 0 { -0.5 } else { 0.5 };
        (y - 0.5 * height * up + side * width * aside - law.closed) / law.range
    }

    fn adhesion_response(
        &self,
        place: f64,
        value: [f64; SPATIAL_FIELDS],
        _: [f64; MEMORY],
    ) -> PointResponse<f64, SPATIAL_FIELDS> {
        let at = Kinematics::new(&value, &[0.0; SPATIAL_FIELDS]);
        let (mut out, by_turn) = self.adhesion_at(place, &at, &value);
        let to_field = at.basis();
        let gradient = apply(&to_field, &by_turn.gradient);
        let hessian = multiply_by_transposed(&multiply(&to_field, &by_turn.hessian), &to_field);
        for i in 0..4 {
            out.by_value[3 + i] = gradient[i];
            out.value_value[3 + i][3..].copy_from_slice(&hessian[i]);
        }
        out
    }

    fn respond(
        &self,
        points: &[Point<F64x4, SPATIAL_FIELDS>],
        _: f64,
        responses: &mut [PointResponse<F64x4, SPATIAL_FIELDS>],
    ) {
        respond(self, points, responses);
    }

    fn energy_at(&self, point: &Point<F64x4, SPATIAL_FIELDS>, _: f64) -> PointEnergy<F64x4, SPATIAL_FIELDS> {
        energy_at(self, point)
    }

    fn gradient_at(&self, point: &Point<f64, SPATIAL_FIELDS>, _: f64) -> PointGradient<SPATIAL_FIELDS> {
        let PointResponse { by_value, by_slope, coverage_by_value, by_border, .. } =
            self.remembering(point, point.memory[FACTOR] != 0.0);
        PointGradient { by_value, by_slope, coverage_by_value, by_border }
    }
}

/// Whether points side by side remember strains: they are of one material and of one step.
#[inline(always)]
fn is_viscous(point: &Point<F64x4, SPATIAL_FIELDS>) -> bool {
    point.memory[FACTOR].0[0] != 0.0
}

/// The responses compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn respond(
    density: &SpatialDensity,
    points: &[Point<F64x4, SPATIAL_FIELDS>],
    responses: &mut [PointResponse<F64x4, SPATIAL_FIELDS>],
) {
    for (point, out) in points.iter().zip(responses) {
        let memory = is_viscous(point).then_some(&point.memory);
        density.respond_into(point.place, &point.value, &point.slope, memory, out);
    }
}

/// The energies, likewise.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn energy_at(density: &SpatialDensity, point: &Point<F64x4, SPATIAL_FIELDS>) -> PointEnergy<F64x4, SPATIAL_FIELDS> {
    let PointResponse { energy, coverage, coverage_by_value, .. } = density.remembering(point, is_viscous(point));
    PointEnergy { energy, coverage, coverage_by_value }
}
