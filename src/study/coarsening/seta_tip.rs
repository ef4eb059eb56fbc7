//! The tips of a seta by the table of their spatula: force and moment follow from height and rotation of a tip.
//!
//! Each tip has an orientation of its own. Its rotation θ counts from its directors in the stress-free configuration of the seta, its height u
//! from the ground, as those of the table do; its pad points away from its azimuth.
//!
//!   E = E_table(u, v, θ) + ½ k (x² + z²) while it adheres;   E = E_table on the detached branch otherwise

use super::answers::{Answer, Answers, Asked};
use super::branch::TipSheet;
use super::near_end::{NearEnd, Source};
use super::place::TipPlace;
use super::table::TipTable;
use super::tip_in_space::{OutOfPlane, SpatulaTip};
use super::visited::{Visited, Visits};
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::tree::branching_beam::EndResponse;
use crate::model::seta::normal_pull::Sideways;
use crate::model::seta::tip_law::{TipBranch, TipLaw};
use std::sync::Arc;

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
