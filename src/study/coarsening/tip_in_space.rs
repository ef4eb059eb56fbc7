//! A tip in space that follows the table of its spatula.
//!
//! The plane of the spatula is vertical, through its azimuth β: e = (cos β, 0, sin β) points along the substrate from the free end of the pad to
//! the end that is held, y away from the substrate. With r the place of that end from where it is in the stress-free configuration, and Q = R(q) R(q0)ᵀ its
//! rotation since then,
//!
//!   u = r·y,  v = r·e,  θ = atan2(y·Q e, e·Q e).
//!
//! Out of its plane the spatula is a linear spring, or free: ½ k n² + ½ c (ψ² + ρ²) with n = r·(e × y), and ψ = -(e × y)·Q e the yaw and ρ = (e × y)·Q y the roll to first order.
//! That leaves out how the pad peels from its side, and what the spring has to do with u and θ.

use super::columns::TipSheet;
use super::near_end::{Answer, Answers, Asked, NearEnd, Source, Visited, Visits};
use super::options::{TipPlace, TipResponse};
use super::table::TipTable;
use crate::beam::spatial::rotation::{Matrix3, Quaternion, apply, apply_transposed, cross, dot, matrix};
use crate::beam::spatial::tree::branching_beam::EndResponse;
use crate::model::seta::normal_pull::Sideways;
use crate::model::seta::tip_law::{TipBranch, TipLaw};
use std::sync::Arc;

const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// What resists a motion out of the plane of a spatula; zeros: nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OutOfPlane {
    /// k, nN/nm
    pub displacement: f64,
    /// c, nN·nm
    pub rotation: f64,
}

/// A tip in space.
#[derive(Clone, Debug)]
pub struct SpatulaTip {
    /// Its law
    pub table: Arc<TipTable>,
    /// β, rad
    pub azimuth: f64,
    /// q0: its directors in the stress-free configuration, of length one
    pub directors: Quaternion,
    /// What resists it out of its plane
    pub out_of_plane: OutOfPlane,
}

/// A number that depends on the place and on a turn, with its derivatives by δ and φ as in [`EndResponse`].
#[derive(Clone, Copy, Debug, Default)]
struct Measure {
    value: f64,
    gradient: [f64; 6],
    /// By φ alone: places are linear.
    bend: Matrix3,
}

impl SpatulaTip {
    fn axis(&self) -> [f64; 3] {
        let (sin, cos) = self.azimuth.sin_cos();
        [cos, 0.0, sin]
    }

    /// Where its end is in its plane: `place` from where it is in the stress-free configuration, nm.
    pub fn in_plane(&self, place: [f64; 3], directors: Quaternion) -> TipPlace {
        let axis = self.axis();
        let [now, rest] = [directors, self.directors].map(matrix);
        let along = apply_transposed(&rest, &axis);
        let [cos, sin] = [axis, UP].map(|p| dot(apply_transposed(&now, &p), along));
        TipPlace { normal: dot(place, UP), lateral: dot(place, axis), rotation: sin.atan2(cos) }
    }

    /// p·Q d.
    fn component(&self, directors: Quaternion, p: [f64; 3], d: [f64; 3]) -> Measure {
        // in the axes of the directors: p·R exp(φ) R0ᵀ d with exp(φ) d = d + φ × d + ½ φ × (φ × d)
        let [p, d] = [apply_transposed(&matrix(directors), &p), apply_transposed(&matrix(self.directors), &d)];
        let turned = cross(d, p);
        let inner = dot(p, d);
        let bend = |i: usize, j: usize| 0.5 * (p[i] * d[j] + p[j] * d[i]) - if i == j { inner } else { 0.0 };
        Measure {
            value: inner,
            gradient: [0.0, 0.0, 0.0, turned[0], turned[1], turned[2]],
            bend: std::array::from_fn(|i| std::array::from_fn(|j| bend(i, j))),
        }
    }

    /// θ
    fn angle(&self, directors: Quaternion) -> Measure {
        let axis = self.axis();
        let [cos, sin] = [axis, UP].map(|p| self.component(directors, p, axis));
        let square = cos.value * cos.value + sin.value * sin.value;
        // θ_c = -s/r², θ_s = c/r²
        let by = [-sin.value / square, cos.value / square];
        let quartic = square * square;
        let mixed = (sin.value * sin.value - cos.value * cos.value) / quartic;
        let bends = [2.0 * sin.value * cos.value / quartic, mixed, -2.0 * sin.value * cos.value / quartic];
        let turn = |i: usize, j: usize| {
            let [c, s] = [&cos, &sin].map(|part| [part.gradient[3 + i], part.gradient[3 + j]]);
            by[0] * cos.bend[i][j]
                + by[1] * sin.bend[i][j]
                + bends[0] * c[0] * c[1]
                + bends[1] * (c[0] * s[1] + s[0] * c[1])
                + bends[2] * s[0] * s[1]
        };
        Measure {
            value: sin.value.atan2(cos.value),
            gradient: std::array::from_fn(|i| by[0] * cos.gradient[i] + by[1] * sin.gradient[i]),
            bend: std::array::from_fn(|i| std::array::from_fn(|j| turn(i, j))),
        }
    }

    /// Energy and derivatives on a branch: `place` from where its end is in the stress-free configuration, nm.
    pub fn response(&self, on: TipSheet, place: [f64; 3], directors: Quaternion) -> EndResponse {
        self.in_space(on, &self.table.response(on, self.in_plane(place, directors)), place, directors)
    }

    /// The same from the response in its plane.
    pub(super) fn in_space(
        &self,
        on: TipSheet,
        table: &TipResponse,
        place: [f64; 3],
        directors: Quaternion,
    ) -> EndResponse {
        let axis = self.axis();
        let across = cross(axis, UP);
        let along = |d: [f64; 3]| Measure {
            value: dot(place, d),
            gradient: [d[0], d[1], d[2], 0.0, 0.0, 0.0],
            bend: Matrix3::default(),
        };
        let measures = [along(UP), along(axis), self.angle(directors)];
        let mut out = EndResponse { energy: table.energy, ..EndResponse::default() };
        for i in 0..3 {
            add(&mut out, &measures[i], table.force[i], 0.0);
            let stiffness = &table.stiffness[i];
            let gradient = |k: usize| (0..3).map(|j| stiffness[j] * measures[j].gradient[k]).sum();
            product(&mut out, &measures[i].gradient, &std::array::from_fn(gradient), 1.0);
        }
        let OutOfPlane { displacement, rotation } = self.out_of_plane;
        if on == TipSheet::Attached && self.out_of_plane != OutOfPlane::default() {
            let springs = [
                (along(across), displacement),
                (self.component(directors, across, axis), rotation),
                (self.component(directors, across, UP), rotation),
            ];
            for (measure, stiffness) in springs {
                add(&mut out, &measure, stiffness * measure.value, 0.5 * stiffness * measure.value * measure.value);
                product(&mut out, &measure.gradient, &measure.gradient, stiffness);
            }
        }
        out
    }

    /// The branch on which it is behind one on which it has been.
    pub fn branch(&self, before: TipSheet, place: [f64; 3], directors: Quaternion) -> TipSheet {
        self.table.branch(before, self.in_plane(place, directors))
    }

    /// The unit vectors e, y and e × y of its plane, turned with its end.
    pub fn turned_axes(&self, directors: Quaternion) -> [[f64; 3]; 3] {
        let axis = self.axis();
        [axis, UP, cross(axis, UP)].map(|d| apply(&matrix(directors), &apply_transposed(&matrix(self.directors), &d)))
    }
}

/// Adds an energy whose derivative by a measure is `force`.
fn add(out: &mut EndResponse, measure: &Measure, force: f64, energy: f64) {
    out.energy += energy;
    (0..6).for_each(|i| out.gradient[i] += force * measure.gradient[i]);
    for i in 0..3 {
        (0..3).for_each(|j| out.hessian[3 + i][3 + j] += force * measure.bend[i][j]);
    }
}

/// Adds a second derivative by two measures with these gradients.
fn product(out: &mut EndResponse, one: &[f64; 6], other: &[f64; 6], stiffness: f64) {
    for i in 0..6 {
        (0..6).for_each(|j| out.hessian[i][j] += stiffness * one[i] * other[j]);
    }
}

// -- The tips of a seta by the table of their spatula: force and moment follow from height and rotation of a tip --
//
// Each tip has an orientation of its own. Its rotation θ counts from its directors in the stress-free configuration of the seta, its height u
// from the ground, as those of the table do; its pad points away from its azimuth.
//
// E = E_table(u, v, θ) + ½ k (x² + z²) while it adheres;   E = E_table on the detached branch otherwise

/// The law of the tips of a seta by a table.
#[derive(Clone, Debug)]
pub struct TableLaw {
    /// Of one tip
    pub tip: SpatulaTip,
    /// What holds it along the ground beside the table
    pub sideways: Sideways,
    /// Where outside of the table tips with this law, in any orientation, have been in equilibrium
    visits: Arc<Visits>,
    /// The spatula itself, near the end of the attached branch
    near_end: Option<Arc<NearEnd>>,
    /// Of one tip
    answers: Arc<Answers>,
}

impl TableLaw {
    /// Of tips whose pads point along -x, and which nothing resists out of their planes.
    pub fn new(table: Arc<TipTable>, sideways: Sideways) -> Self {
        let out_of_plane = OutOfPlane::default();
        Self {
            tip: SpatulaTip { table, azimuth: 0.0, directors: [1.0, 0.0, 0.0, 0.0], out_of_plane },
            sideways,
            visits: Arc::default(),
            near_end: None,
            answers: Arc::default(),
        }
    }

    /// The same where it is known where outside of the table tips have been.
    pub fn with_visited(self, visited: Visited) -> Self {
        Self { visits: Arc::new(Visits::new(visited)), ..self }
    }

    /// The same whose tips are spatulae near the end of their attached branch.
    pub fn resolved(self, near_end: Arc<NearEnd>) -> Self {
        Self { near_end: Some(near_end), ..self }
    }

    /// Where outside of the table its tips have been in equilibrium so far.
    pub fn visited(&self) -> Visited {
        self.visits.get()
    }

    /// Where in the table a tip with these directors in the stress-free seta is: `place` from its place of adhesion, nm.
    pub fn place(&self, rest: Quaternion, place: [f64; 3], directors: Quaternion) -> TipPlace {
        SpatulaTip { directors: rest, ..self.tip.clone() }.in_plane(place, directors)
    }

    fn answer(&self, on: TipSheet, place: [f64; 3], directors: Quaternion) -> Answer {
        self.answers.get(Asked { on, place, directors }, || {
            let at = self.tip.in_plane(place, directors);
            let table = &self.tip.table;
            let (in_plane, source) = match &self.near_end {
                Some(near_end) if on == TipSheet::Attached => near_end.response(table, at),
                _ => (table.response(on, at), Source::Table),
            };
            Answer { source, in_plane, in_space: self.tip.in_space(on, &in_plane, place, directors) }
        })
    }
}

/// Attached and detaching are one branch of the table.
fn sheet(on: TipBranch) -> TipSheet {
    if on.adheres() { TipSheet::Attached } else { TipSheet::Detached }
}

impl TipLaw for TableLaw {
    fn response(&self, on: TipBranch, place: [f64; 3], directors: Quaternion) -> EndResponse {
        let mut out = self.answer(sheet(on), place, directors).in_space;
        if let (true, Sideways::Held(k)) = (on.adheres(), self.sideways) {
            for i in [0, 2] {
                out.energy += 0.5 * k * place[i] * place[i];
                out.gradient[i] += k * place[i];
                out.hessian[i][i] += k;
            }
        }
        out
    }

    fn adheres(&self, before: TipBranch, place: [f64; 3], directors: Quaternion) -> bool {
        self.tip.branch(sheet(before), place, directors) == TipSheet::Attached
    }

    fn branch(&self, before: TipBranch, place: [f64; 3], directors: Quaternion) -> TipBranch {
        let at = self.tip.in_plane(place, directors);
        match self.tip.table.branch(sheet(before), at) {
            TipSheet::Detached => TipBranch::Detached,
            TipSheet::Attached => {
                let softens = self.answer(TipSheet::Attached, place, directors).in_plane.stiffness[0][0] < 0.0;
                if softens && at.normal > 0.0 { TipBranch::Detaching } else { TipBranch::Attached }
            }
        }
    }

    fn note(&self, tip: usize, on: TipBranch, place: [f64; 3], directors: Quaternion) {
        self.visits.note(&self.tip.table, tip, sheet(on), self.tip.in_plane(place, directors));
        if self.near_end.is_some() {
            let source = self.answer(sheet(on), place, directors).source;
            self.visits.note_resolved(tip, source, self.answers.was_solved());
        }
    }

    fn is_known(&self, on: TipBranch, place: [f64; 3], directors: Quaternion) -> bool {
        self.tip.table.contains(sheet(on), self.tip.in_plane(place, directors))
    }

    fn oriented(&self, rest: Quaternion) -> Option<Arc<dyn TipLaw>> {
        let tip = SpatulaTip { directors: rest, ..self.tip.clone() };
        Some(Arc::new(Self { tip, answers: Arc::default(), ..self.clone() }))
    }
}
