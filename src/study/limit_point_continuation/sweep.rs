//! A sweep that follows one point of the peel from value to value instead of peeling every value.
//!
//! The point is taken up where the path from rest has it and followed by [`Continuation`]. At some values, the first and
//! the last among them, it is solved for again on half as many elements again, which bounds the error of the values
//! between, and at fewer values it is held against the path from rest: what is followed might still be a limit point, but
//! no longer the first. Where the point is lost, or is another one, a remark says so and the path from rest gives the
//! point of the next value.

use super::continuation::{Continuation, Known, Lost, problem, search};
use super::failure::PointNotFound;
use super::initial_limit_point::initial_limit_point;
use super::result::{FollowedPoint, FollowedRow, FollowedSweep, PointKind, Remark, Spacing};
use crate::beam::FRONT;
use crate::model::{Discretisation, Form, ModelError, PeelModel};
use crate::solve::{BendRule, Located, Mesh, Observables, Path, SolveError, Workspace};
use crate::study::accuracy::{ORDER, Resolution};
use crate::study::error_bounds::{FOLLOWED_BOUND_FACTOR, ROUND_OFF, ROUND_OFF_PLACE, TOLERANCE_FLOOR_FRACTION};
use crate::study::initial::prepared;
use crate::study::refused::failure;
use crate::study::{Accuracy, PathEnd, StopCriteria, Terms, checked, peel};

/// Elements to begin with at the initiation peak, where the free end mostly rests, and the most anywhere.
const FEWEST_ELEMENTS: usize = 10;
const MOST_ELEMENTS: usize = 200;
/// A mesh is chosen with this share of the error allowed, so that it lasts for a while.
const MARGIN: f64 = 0.7;
/// The next value is solved for on more elements when force or displacement have changed by this share since the last.
const CHANGE: f64 = 0.05;
/// Or after this many values.
const MOST_UNCHECKED: usize = 32;
/// A value's error bound is the largest difference at this many checks on either side of it.
const NEIGHBOURS: usize = 3;
/// Parts of the sweep at whose ends the point is held against the path from rest.
const PARTS: usize = 4;
/// Two results for one point may differ by this much relative to the displacement besides their bounds.
const SAME: f64 = 1e-6;

/// Relative differences of displacement and force to more elements.
#[derive(Clone, Copy)]
struct Difference {
    displacement: f64,
    force: f64,
}

impl Difference {
    fn of(known: &Known, finer: &Observables) -> Self {
        let (o, n) = (&known.observables, &known.neglected);
        let relative = |fine: f64, here: f64, neglected: f64| ((fine - here).abs() + neglected) / here.abs();
        Self {
            displacement: relative(finer.displacement, o.displacement, n.displacement),
            force: relative(finer.force, o.force, n.force),
        }
    }

    fn max(self, other: Self) -> Self {
        Self { displacement: self.displacement.max(other.displacement), force: self.force.max(other.force) }
    }

    /// The difference of what is reported of the point.
    fn reported(self, kind: PointKind) -> f64 {
        match kind {
            PointKind::InitiationPeak => self.force,
            PointKind::SnapOff => self.displacement,
        }
    }
}

/// The point at one value.
struct Found {
    observables: Observables,
    energy: f64,
    elements: usize,
    iterations: usize,
}

impl Found {
    fn new(known: &Known, elements: usize, iterations: usize) -> Self {
        Self { observables: known.observables, energy: known.energy, elements, iterations }
    }
}

/// A point followed without interruption, from its first value on.
struct Strand {
    /// Index of the first value.
    first: usize,
    /// What was found, value by value; never empty.
    found: Vec<Found>,
    /// The point at the newest value, and at the newest that was found good on more elements.
    newest: Known,
    good: Known,
    /// Indices of values that were solved for on more elements; never empty.
    checks: Vec<(usize, Difference)>,
    /// What happened on the way, and why it ended before the last value.
    remarks: Vec<Remark>,
}

impl Strand {
    /// Index of the newest value.
    fn last(&self) -> usize {
        self.first + self.found.len() - 1
    }

    fn at(&self, index: usize) -> &Found {
        &self.found[index - self.first]
    }

    fn elements(&self) -> usize {
        self.found[self.found.len() - 1].elements
    }

    /// Drops the values behind the last check, where that found no limit point on more elements.
    fn drop_unbounded(&mut self) {
        while self.checks.len() > 1 && self.checks.last().is_some_and(|(_, difference)| !difference.force.is_finite()) {
            self.checks.pop();
            self.found.truncate(self.last_check() - self.first + 1);
        }
    }

    fn last_check(&self) -> usize {
        self.checks[self.checks.len() - 1].0
    }
}

/// Follows the point of `kind`, on flat ground and with no steps before the pull, over `values` of a parameter, which make their way
/// evenly in the sense of `spacing`. `model` gives the model at a value, also at values in between. `stop` gives the stop criteria of
/// one path, anew for each. `solved` is given the place of a value as soon as it is solved for, again where it is solved for anew. A value at which
/// the model cannot be computed ([`checked`]) has a row without the point, and a remark that says why.
pub fn follow_point<M: Into<PeelModel>>(
    kind: PointKind,
    values: &[f64],
    spacing: Spacing,
    model: &dyn Fn(f64) -> M,
    accuracy: &Accuracy,
    stop: &dyn Fn() -> StopCriteria,
    solved: &dyn Fn(usize),
) -> FollowedSweep {
    let model = |value: f64| model(value).into();
    // the point is one equilibrium, from which nothing is left out
    let accuracy = &Accuracy { terms: Terms::All, ..*accuracy };
    let at_coordinate = |s: f64| model(spacing.value(s));
    let sweep = Sweep { kind, values, spacing, model: &model, at_coordinate: &at_coordinate, accuracy, stop, solved };
    let mut followed = FollowedSweep { kind, rows: Vec::with_capacity(values.len()), remarks: Vec::new() };
    while followed.rows.len() < values.len() {
        let next = followed.rows.len();
        if let Err(error) = sweep.check(next) {
            let reason = PointNotFound::Failed(Box::new(failure(&error)));
            followed.remarks.push(Remark::NotFound { kind, value: values[next], reason });
            followed.rows.push(empty(values[next]));
            solved(next);
            continue;
        }
        match sweep.strand(next) {
            Ok(Some(strand)) => {
                followed.rows.extend(sweep.rows(&strand));
                followed.remarks.extend(strand.remarks);
            }
            Ok(None) => {
                sweep.absent(&mut followed, next);
                followed.rows.push(empty(values[next]));
                solved(next);
            }
            Err(reason) => {
                let (point, elements) = sweep.on_full_path(&mut followed.remarks, next, reason);
                followed.rows.push(FollowedRow { point, elements, ..empty(values[next]) });
                solved(next);
            }
        }
    }
    followed
}

/// A row without the point.
fn empty(value: f64) -> FollowedRow {
    FollowedRow { value, point: None, newton_iterations: 0, elements: 0 }
}

struct Sweep<'a> {
    kind: PointKind,
    values: &'a [f64],
    spacing: Spacing,
    model: &'a dyn Fn(f64) -> PeelModel,
    at_coordinate: &'a dyn Fn(f64) -> PeelModel,
    accuracy: &'a Accuracy,
    stop: &'a dyn Fn() -> StopCriteria,
    solved: &'a dyn Fn(usize),
}

impl Sweep<'_> {
    fn coordinate(&self, index: usize) -> f64 {
        self.spacing.coordinate(self.values[index])
    }

    /// Whether the model at a value can be computed.
    fn check(&self, index: usize) -> Result<(), ModelError> {
        checked(&(self.model)(self.values[index]), self.accuracy)
    }

    fn anchor(&self, index: usize) -> Result<Option<Located>, PointNotFound> {
        initial_limit_point(&(self.model)(self.values[index]), self.kind, self.accuracy, &(self.stop)())
    }

    /// Says that the path has no such point at this value: in one remark with the values before, where it has none either.
    fn absent(&self, followed: &mut FollowedSweep, index: usize) {
        let value = self.values[index];
        match followed.remarks.last_mut() {
            Some(Remark::Absent { to, .. }) if index > 0 && *to == self.values[index - 1] => *to = value,
            _ => followed.remarks.push(Remark::Absent { kind: self.kind, from: value, to: value }),
        }
    }

    /// The point that could not be solved for by itself, from a whole peel, and its elements.
    fn on_full_path(
        &self,
        remarks: &mut Vec<Remark>,
        index: usize,
        reason: PointNotFound,
    ) -> (Option<FollowedPoint>, usize) {
        let (kind, value) = (self.kind, self.values[index]);
        let peel = peel(&(self.model)(value), self.accuracy, &(self.stop)());
        let point = match kind {
            PointKind::InitiationPeak => peel.initiation_peak.map(FollowedPoint::from),
            PointKind::SnapOff => peel.snap_off.map(FollowedPoint::from),
        };
        remarks.push(match (&point, peel.end) {
            (Some(_), _) => Remark::Peeled { kind, value, reason },
            (None, PathEnd::Failed(failure)) => {
                Remark::NotFound { kind, value, reason: PointNotFound::Failed(Box::new(failure)) }
            }
            (None, PathEnd::Bound(bound)) => Remark::NotFound { kind, value, reason: PointNotFound::Bound(bound) },
            (
                None,
                PathEnd::Detached | PathEnd::Pivoting | PathEnd::TurnedBack | PathEnd::Sliding | PathEnd::Snapped,
            ) => Remark::Absent { kind, from: value, to: value },
        });
        (point, peel.effort.elements)
    }

    /// Elements to begin with.
    fn fewest(&self, index: usize) -> usize {
        match self.kind {
            PointKind::InitiationPeak => FEWEST_ELEMENTS,
            PointKind::SnapOff => Resolution::first(&(self.model)(self.values[index]), self.accuracy).elements,
        }
    }

    /// Whether the point is held against the path from rest at this value.
    fn is_milestone(&self, index: usize) -> bool {
        let last = self.values.len() - 1;
        index == last || index.is_multiple_of(last.div_ceil(PARTS).max(1))
    }

    /// Takes the point up at a value and follows it as far as it goes.
    fn strand(&self, first: usize) -> Result<Option<Strand>, PointNotFound> {
        let Some(located) = self.anchor(first)? else { return Ok(None) };
        let on_mesh = |elements| self.taken_up(first, &located, elements);
        let (known, elements, difference) = self.on_fitting_mesh(first, self.fewest(first), &on_mesh)?;
        (self.solved)(first);
        let mut continuation = Continuation::new(self.kind, self.at_coordinate, known.clone());
        let mut strand = Strand {
            first,
            found: vec![Found::new(&known, elements, 0)],
            newest: known.clone(),
            good: known,
            checks: vec![(first, difference)],
            remarks: Vec::new(),
        };
        while strand.last() + 1 < self.values.len() {
            let (index, before) = (strand.last() + 1, continuation.iterations());
            if self.check(index).is_err() {
                self.check_last(&mut strand);
                break;
            }
            match continuation.reach(self.coordinate(index)) {
                Ok(known) => strand.newest.clone_from(known),
                Err(lost) => {
                    self.check_last(&mut strand);
                    strand.remarks.push(self.parted(lost));
                    break;
                }
            }
            let iterations = continuation.iterations() - before;
            strand.found.push(Found::new(&strand.newest, strand.elements(), iterations));
            (self.solved)(index);
            let worst = if self.is_check_due(&strand) { self.check_last(&mut strand) } else { 0.0 };
            if worst.is_infinite() && strand.elements() >= MOST_ELEMENTS {
                let (value, cause) = (self.values[index], SolveError::LimitPointNotConfirmed);
                strand.remarks.push(Remark::Lost { kind: self.kind, between: (value, value), cause });
                break;
            }
            if worst > 1.0 && strand.elements() < MOST_ELEMENTS {
                // back to the last value that was good, and on from there on more elements
                if let Err(remark) = self.refine(&mut strand, worst) {
                    strand.remarks.push(remark);
                    break;
                }
                continuation = Continuation::new(self.kind, self.at_coordinate, strand.newest.clone());
                continue;
            }
            if self.is_milestone(index) && self.is_replaced(&mut strand, index) {
                break;
            }
        }
        strand.drop_unbounded();
        Ok(Some(strand))
    }

    fn parted(&self, lost: Lost) -> Remark {
        let between = (self.spacing.value(lost.last), self.spacing.value(lost.next));
        if lost.meets {
            Remark::Vanished { kind: self.kind, between }
        } else {
            Remark::Lost { kind: self.kind, between, cause: lost.cause }
        }
    }

    /// Drops what came after the last check but one, and solves for the point there on more elements.
    fn refine(&self, strand: &mut Strand, worst: f64) -> Result<(), Remark> {
        strand.checks.pop();
        let (good, more) = (strand.last_check(), finer(strand.elements(), worst));
        strand.found.truncate(good - strand.first + 1);
        let on_mesh = |elements| self.known_on(good, &strand.good, elements);
        let (known, elements, difference) = self.on_fitting_mesh(good, more, &on_mesh).map_err(|cause| {
            let value = self.values[good];
            Remark::Lost { kind: self.kind, between: (value, value), cause }
        })?;
        strand.checks.push((good, difference));
        let place = good - strand.first;
        strand.found[place] = Found::new(&known, elements, strand.found[place].iterations);
        (strand.newest, strand.good) = (known.clone(), known);
        Ok(())
    }

    /// The located point on a mesh of its own.
    fn taken_up(&self, index: usize, located: &Located, elements: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(self.values[index]), self.kind);
        let (beam, known) = (&problem.beam, &located.solution.at);
        let mesh = Mesh { focus: known.mesh.focus, ..beam.mesh_at(located.observables.monitors[FRONT], elements) };
        let at = beam.resampled(known, mesh);
        let probe = search(&problem, self.kind, 1.0);
        let target = probe.weights.dot(&located.observables);
        let fold = search(&problem, self.kind, target).run(
            at,
            target,
            BendRule::Difference { neighbour: None },
            &mut Workspace::default(),
        )?;
        Ok(Known::new(&problem, self.kind, self.coordinate(index), &fold))
    }

    /// A known point on another number of elements.
    fn known_on(&self, index: usize, known: &Known, elements: usize) -> Result<Known, SolveError> {
        let problem = problem(&(self.model)(self.values[index]), self.kind);
        let fold = known.on_elements(&problem, self.kind, elements, &mut Workspace::default())?;
        Ok(Known::new(&problem, self.kind, known.at, &fold))
    }

    /// A known point against half as many elements again.
    fn difference(&self, index: usize, known: &Known, elements: usize) -> Result<Difference, SolveError> {
        let finer = self.known_on(index, known, elements + elements.div_ceil(2))?;
        Ok(Difference::of(known, &finer.observables))
    }

    /// The error expected, over the accuracy asked for.
    fn worst(&self, difference: Difference) -> f64 {
        FOLLOWED_BOUND_FACTOR * difference.reported(self.kind) / self.accuracy.relative
    }

    /// The point on the coarsest mesh that is good enough, from `elements` on.
    fn on_fitting_mesh(
        &self,
        index: usize,
        mut elements: usize,
        on_mesh: &dyn Fn(usize) -> Result<Known, SolveError>,
    ) -> Result<(Known, usize, Difference), SolveError> {
        loop {
            let known = on_mesh(elements);
            let tried = known.and_then(|known| Ok((self.difference(index, &known, elements)?, known)));
            let worst = tried.as_ref().map_or(f64::INFINITY, |(difference, _)| self.worst(*difference));
            match tried {
                Ok((difference, known)) if worst <= MARGIN || elements >= MOST_ELEMENTS => {
                    return Ok((known, elements, difference));
                }
                Err(error) if elements >= MOST_ELEMENTS => return Err(error),
                _ => elements = finer(elements, worst / MARGIN),
            }
        }
    }

    fn is_check_due(&self, strand: &Strand) -> bool {
        let (newest, checked) = (strand.last(), strand.last_check());
        let (now, then) = (&strand.newest.observables, &strand.good.observables);
        let change = |now: f64, then: f64| (now / then - 1.0).abs() > CHANGE;
        newest - checked >= MOST_UNCHECKED
            || self.is_milestone(newest)
            || change(now.displacement, then.displacement)
            || change(now.force, then.force)
    }

    /// Solves for the newest value on more elements; the error expected, over the accuracy asked for.
    fn check_last(&self, strand: &mut Strand) -> f64 {
        let infinite = Difference { displacement: f64::INFINITY, force: f64::INFINITY };
        let difference = self.difference(strand.last(), &strand.newest, strand.elements()).unwrap_or(infinite);
        strand.checks.push((strand.last(), difference));
        let worst = self.worst(difference);
        if worst <= 1.0 || strand.elements() >= MOST_ELEMENTS {
            strand.good.clone_from(&strand.newest);
        }
        worst
    }

    /// Whether the path from rest has another point than the one followed to `index`; then the strand is cut where that
    /// begins, found by bisection.
    fn is_replaced(&self, strand: &mut Strand, index: usize) -> bool {
        match self.is_same(strand, index) {
            Ok(true) => return false,
            Ok(false) => {}
            Err(reason) => {
                strand.remarks.push(Remark::Unconfirmed { kind: self.kind, value: self.values[index], reason });
                return false;
            }
        }
        let before = (strand.first..index).rev().find(|&i| self.is_milestone(i));
        let (mut same, mut other) = (before.unwrap_or(strand.first), index);
        while other - same > 1 {
            let middle = same + (other - same) / 2;
            if self.is_same(strand, middle) == Ok(false) { other = middle } else { same = middle }
        }
        strand.found.truncate(other - strand.first);
        strand.remarks.push(Remark::Replaced { kind: self.kind, between: (self.values[same], self.values[other]) });
        true
    }

    /// Whether the path from rest has the point that was followed to this value.
    fn is_same(&self, strand: &Strand, index: usize) -> Result<bool, PointNotFound> {
        let found = strand.at(index);
        let Some(located) = self.anchor(index)? else { return Ok(false) };
        let own = self.taken_up(index, &located, found.elements)?;
        let bound = strand.checks.iter().rev().map(|c| c.1).take(NEIGHBOURS).reduce(Difference::max);
        let slack = |share: f64| SAME + FOLLOWED_BOUND_FACTOR * share;
        let (a, b) = (&own.observables, &found.observables);
        Ok(bound.is_some_and(|bound| {
            (a.force / b.force - 1.0).abs() <= slack(bound.force)
                && (a.displacement / b.displacement - 1.0).abs() <= slack(bound.displacement)
        }))
    }

    /// The rows of a strand, each bounded by the checks around it.
    fn rows(&self, strand: &Strand) -> Vec<FollowedRow> {
        let row = |(i, found): (usize, &Found)| {
            let index = strand.first + i;
            let place = strand.checks.partition_point(|c| c.0 < index);
            let around = place.saturating_sub(NEIGHBOURS)..(place + NEIGHBOURS).min(strand.checks.len());
            let worst = strand.checks[around].iter().map(|c| c.1).reduce(Difference::max);
            FollowedRow {
                value: self.values[index],
                point: worst.map(|difference| self.point(index, found, difference)),
                newton_iterations: found.iterations,
                elements: found.elements,
            }
        };
        strand.found.iter().enumerate().map(row).collect()
    }

    fn point(&self, index: usize, found: &Found, difference: Difference) -> FollowedPoint {
        let model = (self.model)(self.values[index]);
        let law = model.line_law();
        let o = &found.observables;
        let place = if self.kind == PointKind::InitiationPeak { ROUND_OFF_PLACE } else { ROUND_OFF };
        let floor = TOLERANCE_FLOOR_FRACTION * self.accuracy.relative;
        FollowedPoint {
            displacement: o.displacement,
            force: o.force,
            end_rotation: o.recorded,
            work: law.has_potential().then(|| Some(found.energy - energy_at_rest(&model)?)).flatten(),
            displacement_error: (FOLLOWED_BOUND_FACTOR * difference.displacement + place + floor)
                * o.displacement.abs(),
            force_error: (FOLLOWED_BOUND_FACTOR * difference.force + ROUND_OFF + floor) * o.force.abs(),
        }
    }
}

/// Stored and adhesion energy where the path begins, aJ.
fn energy_at_rest(model: &PeelModel) -> Option<f64> {
    if let Some(strip) = model.strip() {
        return Some(strip.width * model.line_law().rest_energy() * strip.length);
    }
    let how = Discretisation::moving(Form::TwoField, ORDER);
    let problem = prepared(model, how, None).ok()?.problem;
    let accuracy = Accuracy::to(1e-8);
    let options = Resolution::first(model, &accuracy).path_options(model, accuracy.relative);
    let first = Path::new(&problem, options).advance().ok()?;
    Some(problem.energy(&first.at, first.energy))
}

/// More elements, by what the theory of order 2p asks for to reduce an error of `worst` times the wanted one.
fn finer(elements: usize, worst: f64) -> usize {
    let growth = (2.0 * worst).powf(0.5 / ORDER as f64).clamp(1.08, 1.6);
    ((elements as f64 * growth).ceil() as usize).min(MOST_ELEMENTS)
}
