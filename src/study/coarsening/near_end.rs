//! The spatula itself in place of its table, where a tip is near the end of its attached branch.
//!
//! With d = U_end(θ) - u, how far a tip is before the place where it snaps off, and D the distance from which tips are resolved,
//!
//!   E(u, θ) = E_table(u, θ) + w(d) w((u - U_begin(θ))/b) ΔE(u*, θ),  ΔE = E_spatula - E_table,  u* = U_end(θ) - g(d),
//!
//! with w one for d ≤ D, zero for d ≥ 1.25 D and twice differentiable between, and g(d) = d but in the last 0.04 nm, where g goes over to 0.02 nm: the
//! branch ends where its table does, whose limit points are located ones. So E has one gradient and one tangent everywhere, those of the spatula where w = 1.
//!
//! A spatula is solved from an equilibrium that depends on its place alone, in the middle of a cell of θ and d: what comes out does not
//! depend on what was solved before.

use super::columns::{BranchStart, Column, TipSheet};
use super::held_spatula::HeldState;
use super::options::{CoarseningError, CoarseningOptions, HeldError, PadEnd, TipPlace, TipRange, TipResponse};
use super::run::Coarsening;
use super::spline::Jet;
use super::table::TipTable;
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::tree::branching_beam::EndResponse;
use crate::model::peel::PeelModel;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Tips go over from table to spatula between D and this many times D.
const FADES: f64 = 1.25;
/// b, nm: above the begin of the branch they do so on this way.
const BEGINS: f64 = 5.0;
/// How near the end g comes, nm; g = d from twice that on.
const NEAREST: f64 = 0.02;
/// The error of the mesh of the spatula is that of a table with this tolerance.
const TOLERANCE: f64 = 1e-4;
/// Cells of θ, rad, and of d, nm: even from `EVEN` on, shorter by √2 each below.
const TURN: f64 = 0.01;
const DEPTH: f64 = 2.0;
const EVEN: f64 = 4.0;

type Known<K, V> = Mutex<BTreeMap<K, Result<Arc<V>, HeldError>>>;

/// A spatula that is solved where its tip is near the end of its attached branch.
pub struct NearEnd {
    /// D, nm
    within: f64,
    start: BranchStart,
    /// Ranges of θ, rad
    rotation: [f64; 2],
    columns: Known<i64, Column>,
    states: Known<(i64, i64), HeldState>,
}

impl fmt::Debug for NearEnd {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("NearEnd").field("within", &self.within).finish_non_exhaustive()
    }
}

/// What a tip's response in its plane comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Source {
    Table,
    /// The spatula, which changed normal force (nN) and moment (nN·nm) of the table by so much
    Spatula([f64; 2]),
    /// The table, since the spatula was not solved
    Unsolved,
}

impl NearEnd {
    /// Of a spatula with a table, from so far before the end of its attached branch on, nm. Nothing stops it on its way: a seta whose tips are
    /// solved is stopped between its own equilibria.
    ///
    /// # Errors
    /// A spatula that does not come to rest; a pad that is held along the substrate.
    pub fn new(spatula: &PeelModel, table: &TipTable, within: f64) -> Result<Self, CoarseningError> {
        if table.options.pad_end == PadEnd::Held {
            return Err(CoarseningError::Refused {
                what: "tips whose pads are held along the substrate follow their table alone",
                remedy: "Leave seta.resolve_within out, or take the table of a pad that slides.",
            });
        }
        let options = CoarseningOptions { tolerance: TOLERANCE, ..table.options };
        let start = Coarsening::new(spatula, &options)?.into_attached();
        let rotation = table.options.range.rotation;
        Ok(Self { within, start, rotation, columns: Mutex::default(), states: Mutex::default() })
    }

    /// D, nm
    pub(crate) fn within(&self) -> f64 {
        self.within
    }

    /// The response of an attached tip.
    pub(super) fn response(&self, table: &TipTable, place: TipPlace) -> (TipResponse, Source) {
        let (sheet, by_table) = (&table.attached, table.response(TipSheet::Attached, place));
        let [begin, end] = sheet.ends(place);
        if place.normal <= begin || end - place.normal >= FADES * self.within || !sheet.spans(place) {
            return (by_table, Source::Table);
        }
        let [begin, end] = [0.0, 1.0].map(|s| sheet.end_jet(s, place));
        let u = Jet::coordinate(place.normal, 0);
        let depth = end - u;
        let ramp = |way: Jet| way.through(rise(way.value));
        let far = (depth * (1.0 / self.within) - Jet::constant(1.0)) * (1.0 / (FADES - 1.0));
        let weight = (Jet::constant(1.0) - ramp(far)) * ramp((u - begin) * (1.0 / BEGINS));
        let at = end - depth.through(held_off(depth.value));
        let there = TipPlace { normal: at.value, ..place };
        let Ok(solved) = self.solved(there, end.value - at.value) else { return (by_table, Source::Unsolved) };
        let known = table.response(TipSheet::Attached, there);
        let changed = [0, 2].map(|i| solved.force[i] - known.force[i]);
        let miss = (Jet::from(solved) - Jet::from(known)).at_first(at);
        (TipResponse::from(Jet::from(by_table) + weight * miss), Source::Spatula(changed))
    }

    /// The spatula so far before the end of its branch.
    fn solved(&self, place: TipPlace, depth: f64) -> Result<TipResponse, HeldError> {
        let (turn, (cell, middle)) = ((place.rotation / TURN).floor(), cell(depth));
        let column = known(&self.columns, turn as i64, || {
            let [from, to] = self.rotation;
            self.start.column(0.0, ((turn + 0.5) * TURN).clamp(from, to))
        })?;
        let mut ws = self.start.spatula().workspace();
        let near = known(&self.states, (turn as i64, cell), || {
            let normal = (column.limit() - middle).max(column.start.normal);
            column.state(self.start.spatula(), normal, &mut ws)
        })?;
        let place = TipPlace { lateral: 0.0, ..place };
        let state = self.start.spatula().moved(&near, place, &mut ws)?;
        let response = self.start.spatula().response(&state.solution.at, &mut ws);
        response.map_err(|cause| HeldError::NotReached { from: near.place, to: place, reached: place, cause })
    }
}

/// What is known, or is made now.
fn known<K: Ord, V>(
    all: &Known<K, V>,
    key: K,
    make: impl FnOnce() -> Result<V, HeldError>,
) -> Result<Arc<V>, HeldError> {
    let lock = || -> MutexGuard<_> { all.lock().unwrap_or_else(PoisonError::into_inner) };
    if let Some(known) = lock().get(&key) {
        return known.clone();
    }
    let made = make().map(Arc::new);
    lock().insert(key, made.clone());
    made
}

/// The cell of a depth, and its middle, nm.
fn cell(depth: f64) -> (i64, f64) {
    if depth >= EVEN {
        let cell = ((depth - EVEN) / DEPTH).floor();
        (cell as i64, EVEN + (cell + 0.5) * DEPTH)
    } else {
        let cell = (2.0 * (EVEN / depth).log2()).floor();
        (-1 - cell as i64, EVEN * (-0.5 * (cell + 0.5)).exp2())
    }
}

/// From 0 to 1 on [0, 1], with the first and the second derivative: t³ (10 - 15 t + 6 t²).
fn rise(t: f64) -> [f64; 3] {
    let t = t.clamp(0.0, 1.0);
    let left = 1.0 - t;
    [t * t * t * (10.0 + t * (6.0 * t - 15.0)), 30.0 * t * t * left * left, 60.0 * t * left * (1.0 - 2.0 * t)]
}

/// g(d) with its derivatives: d from 2 m on, m below zero, and its slope [`rise`] between.
fn held_off(depth: f64) -> [f64; 3] {
    let whole = 2.0 * NEAREST;
    if depth >= whole {
        return [depth, 1.0, 0.0];
    }
    let t = (depth / whole).max(0.0);
    let [slope, bend, _] = rise(t);
    [NEAREST + whole * t.powi(4) * (2.5 + t * (t - 3.0)), slope, bend / whole]
}

// -- Where outside of a table the tips of a seta have been in equilibrium: it says how far the table has to grow --

/// How far a table grows, over what was asked of it.
const ROOM: f64 = 1.1;

/// Where outside of a table tips have been in equilibrium.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Visited {
    /// The tips that were outside of it, by number
    pub outside: BTreeSet<usize>,
    /// By how much a tip was pressed farther than where the attached branch begins, at most, nm
    pub pressed: f64,
    /// The smallest and the largest v outside of the table, nm; zeros where the pad slides
    pub lateral: [f64; 2],
    /// The smallest and the largest θ outside of the table, rad
    pub rotation: [f64; 2],
    /// The tips that were solved as spatulae
    pub resolved: Resolved,
}

/// Tips that were solved as spatulae near the end of their branch, and what that changed in equilibria of the seta.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Resolved {
    /// The tips, by number
    pub tips: BTreeSet<usize>,
    /// The largest change of the normal force of a tip against its table, nN
    pub force: f64,
    /// The same of the moment, nN·nm
    pub moment: f64,
    /// The tips of which no spatula was found in an equilibrium of the seta: they followed the table there
    pub unsolved: BTreeSet<usize>,
}

impl Visited {
    /// A range that holds what another one does and, with some room, where tips have been.
    pub(crate) fn widened(&self, range: &TipRange) -> TipRange {
        let wider = |[from, to]: [f64; 2], [low, high]: [f64; 2]| [from.min(ROOM * low), to.max(ROOM * high)];
        TipRange {
            press: range.press + ROOM * self.pressed,
            lateral: wider(range.lateral, self.lateral),
            rotation: wider(range.rotation, self.rotation),
        }
    }
}

/// The same while a seta is pulled off.
#[derive(Debug, Default)]
pub(super) struct Visits(Mutex<Visited>);

impl Visits {
    /// What is known already.
    pub(crate) fn new(visited: Visited) -> Self {
        Self(Mutex::new(visited))
    }

    /// A tip is in equilibrium at a place of a table.
    pub(crate) fn note(&self, table: &TipTable, tip: usize, on: TipSheet, place: TipPlace) {
        if table.contains(on, place) {
            return;
        }
        let mut visited = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        visited.outside.insert(tip);
        let widened = |[from, to]: [f64; 2], value: f64| [from.min(value), to.max(value)];
        if table.options.pad_end == PadEnd::Held {
            visited.lateral = widened(visited.lateral, place.lateral);
        }
        visited.rotation = widened(visited.rotation, place.rotation);
        if on == TipSheet::Attached {
            visited.pressed = visited.pressed.max(table.attached.ends(place)[0] - place.normal);
        }
    }

    /// A tip is in equilibrium, and has been solved as a spatula before or not.
    pub(crate) fn note_resolved(&self, tip: usize, source: Source, solved: bool) {
        if !solved && source != Source::Unsolved {
            return;
        }
        let resolved = &mut self.0.lock().unwrap_or_else(PoisonError::into_inner).resolved;
        if solved {
            resolved.tips.insert(tip);
        }
        match source {
            Source::Table => {}
            Source::Spatula([force, moment]) => {
                resolved.force = resolved.force.max(force.abs());
                resolved.moment = resolved.moment.max(moment.abs());
            }
            Source::Unsolved => drop(resolved.unsolved.insert(tip)),
        }
    }

    /// What was noted so far.
    pub(crate) fn get(&self) -> Visited {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

// -- What a tip was asked last: a state of the seta is asked for its forces, its energy and its stiffness one after the other --

/// Where a tip is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Asked {
    pub on: TipSheet,
    /// From its place of adhesion, nm
    pub place: [f64; 3],
    pub directors: Quaternion,
}

/// What its law says there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    pub source: Source,
    /// In its plane
    pub in_plane: TipResponse,
    /// In space
    pub in_space: EndResponse,
}

/// The last two answers of a tip: those at both ends of a step.
#[derive(Debug, Default)]
pub(super) struct Answers {
    last: Mutex<[Option<(Asked, Answer)>; 2]>,
    solved: AtomicBool,
}

impl Answers {
    /// The answer that is known, or the one that is found.
    pub(crate) fn get(&self, asked: Asked, find: impl FnOnce() -> Answer) -> Answer {
        let lock = || self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = lock().iter().flatten().find(|(own, _)| *own == asked) {
            return *known;
        }
        let found = find();
        if matches!(found.source, Source::Spatula(_)) {
            self.solved.store(true, Ordering::Relaxed);
        }
        let mut last = lock();
        last.swap(0, 1);
        last[0] = Some((asked, found));
        found
    }

    /// Whether an answer has come from the spatula.
    pub(crate) fn was_solved(&self) -> bool {
        self.solved.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Reference: differences; both functions go on with two derivatives where their formula changes.
    #[test]
    fn ramps_are_twice_differentiable() {
        let step = 1e-5;
        for (of, places) in [
            (rise as fn(f64) -> [f64; 3], [0.0, 0.3, 0.8, 1.0]),
            (|t| held_off(t * 2.0 * NEAREST), [0.0, 0.3, 0.8, 1.0]),
        ] {
            let scale = if of(2.0)[0] == 1.0 { 1.0 } else { 2.0 * NEAREST };
            for t in places {
                let [_, slope, bend] = of(t);
                let [below, above] = [of(t - step), of(t + step)];
                assert_abs_diff_eq!((above[0] - below[0]) / (2.0 * step * scale), slope, epsilon = 1e-4);
                assert_abs_diff_eq!((above[1] - below[1]) / (2.0 * step), bend * scale, epsilon = 2e-3);
            }
        }
        assert_eq!(held_off(1.0), [1.0, 1.0, 0.0]);
        assert_eq!(held_off(-1.0)[0], NEAREST);
    }

    /// A depth is in its own cell, whose middle is at most 1 nm away: a quarter of the depth at 4 nm, where cells become even, and less elsewhere.
    #[test]
    fn a_cell_holds_its_depths() {
        for depth in [0.02, 0.5, 3.99, 4.0, 5.9, 6.1, 300.0] {
            let (own, middle) = cell(depth);
            assert_eq!(cell(middle).0, own);
            assert!((middle - depth).abs() <= 1.0 && middle <= 1.25 * depth && depth <= 1.25 * middle);
        }
    }
}
