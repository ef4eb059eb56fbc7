//! A sweep that follows one point of the peel from value to value instead of peeling every value.
//!
//! The point is taken up where the path from rest has it and followed by [`Continuation`]. At some values, the first and
//! the last among them, it is solved for again on half as many elements again, which bounds the error of the values
//! between, and at fewer values it is held against the path from rest: what is followed might still be a limit point, but
//! no longer the first. Where the point is lost, or is another one, a remark says so and the path from rest gives the
//! point of the next value.

use super::continuation::{Continuation, Lost};
use super::result::{FollowedPoint, FollowedRow, FollowedSweep, PointKind, PointNotFound, Remark, Spacing};
use super::strand::{Difference, Found, MOST_ELEMENTS, NEIGHBOURS, Strand};
use super::values::Sweep;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::build::Discretisation;
use crate::solve::error::SolveError;
use crate::solve::path::equilibrium_path::Path;
use crate::study::asked::accuracy::{Accuracy, ORDER, Resolution};
use crate::study::asked::error_bounds::{FOLLOWED_BOUND_FACTOR, ROUND_OFF, ROUND_OFF_PLACE, TOLERANCE_FLOOR_FRACTION};
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::asked::terms::Terms;
use crate::study::initial::prepared::prepared;
use crate::study::peel::assembly::failure;
use crate::study::terms::term_selection::peel;

/// Follows the point of `kind`, on flat ground and with no steps before the pull, over `values` of a parameter, which make their way
/// evenly in the sense of `spacing`. `model` gives the model at a value, also at values in between. `stop` gives the stop criteria of
/// one path, anew for each. `solved` is given the place of a value as soon as it is solved for, again where it is solved for anew. A value at which
/// the model cannot be computed ([`crate::study::checked`]) has a row without the point, and a remark that says why.
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
    // of a sweep that leaves the plane all points are in space, as of one beam
    let planar = |value: &f64| model(*value).in_the_plane();
    let in_plane = values.iter().all(|value| planar(value).is_some());
    let model = |value: f64| planar(&value).filter(|_| in_plane).unwrap_or_else(|| model(value));
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

impl Sweep<'_> {
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
        remarks.push(match (&point, PointNotFound::unknown_behind(peel.end)) {
            (Some(_), _) => Remark::Peeled { kind, value, reason },
            (None, Some(reason)) => Remark::NotFound { kind, value, reason },
            (None, None) => Remark::Absent { kind, from: value, to: value },
        });
        (point, peel.effort.elements)
    }

    /// Takes the point up at a value and follows it as far as it goes.
    fn strand(&self, first: usize) -> Result<Option<Strand>, PointNotFound> {
        let Some(located) = self.initial_limit_point_of(first)? else { return Ok(None) };
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
            match continuation.advance_to(self.coordinate(index)) {
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
}

// -- What is reported at each value, with its bounds --

impl Sweep<'_> {
    /// The rows of a strand, each bounded by the checks around it.
    pub(crate) fn rows(&self, strand: &Strand) -> Vec<FollowedRow> {
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
        let o = &found.observables;
        let place = if self.kind == PointKind::InitiationPeak { ROUND_OFF_PLACE } else { ROUND_OFF };
        let floor = TOLERANCE_FLOOR_FRACTION * self.accuracy.relative;
        FollowedPoint {
            displacement: o.displacement,
            force: o.force,
            end_rotation: o.recorded,
            work: model.has_potential().then(|| Some(found.energy - energy_at_rest(&model)?)).flatten(),
            displacement_error: (FOLLOWED_BOUND_FACTOR * difference.displacement + place + floor)
                * o.displacement.abs(),
            force_error: (FOLLOWED_BOUND_FACTOR * difference.force + ROUND_OFF + floor) * o.force.abs(),
        }
    }
}

/// Stored and adhesion energy where the path begins, aJ.
fn energy_at_rest(model: &PeelModel) -> Option<f64> {
    if let Some(strip) = model.strip().filter(|_| model.space.is_none()) {
        return Some(strip.width * model.line_law().rest_energy() * strip.length);
    }
    let how = Discretisation::moving(Form::TwoField, ORDER);
    let problem = prepared(model, how, None).ok()?.problem;
    let accuracy = Accuracy::to(1e-8);
    let options = Resolution::first(model, &accuracy).path_options(model, accuracy.relative);
    let first = Path::new(&problem, options).advance().ok()?;
    Some(problem.energy(&first.at, first.energy))
}
