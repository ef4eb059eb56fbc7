//! Whether what is followed is still good enough, and still the point of the path from rest.

use super::result::{PointNotFound, Remark};
use super::strand::{Difference, Found, MOST_ELEMENTS, NEIGHBOURS, Strand, finer};
use super::values::Sweep;
use crate::study::asked::error_bounds::FOLLOWED_BOUND_FACTOR;

/// The next value is solved for on more elements when force or displacement have changed by this share since the last.
const CHANGE: f64 = 0.05;
/// Or after this many values.
const MOST_UNCHECKED: usize = 32;
/// Two results for one point may differ by this much relative to the displacement besides their bounds.
const SAME: f64 = 1e-6;

impl Sweep<'_> {
    /// Whether the newest value is to be solved for on more elements.
    pub(crate) fn is_check_due(&self, strand: &Strand) -> bool {
        let (newest, checked) = (strand.last(), strand.last_check());
        let (now, then) = (&strand.newest.observables, &strand.good.observables);
        let change = |now: f64, then: f64| (now / then - 1.0).abs() > CHANGE;
        newest - checked >= MOST_UNCHECKED
            || self.is_milestone(newest)
            || change(now.displacement, then.displacement)
            || change(now.force, then.force)
    }

    /// Solves for the newest value on more elements; the error expected, over the accuracy asked for.
    pub(crate) fn check_last(&self, strand: &mut Strand) -> f64 {
        let infinite = Difference { displacement: f64::INFINITY, force: f64::INFINITY };
        let difference = self.difference(strand.last(), &strand.newest, strand.elements()).unwrap_or(infinite);
        strand.checks.push((strand.last(), difference));
        let worst = self.worst(difference);
        if worst <= 1.0 || strand.elements() >= MOST_ELEMENTS {
            strand.good.clone_from(&strand.newest);
        }
        worst
    }

    /// Drops what came after the last check but one, and solves for the point there on more elements.
    pub(crate) fn refine(&self, strand: &mut Strand, worst: f64) -> Result<(), Remark> {
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

    /// Whether the path from rest has another point than the one followed to `index`; then the strand is cut where that
    /// begins, found by bisection.
    pub(crate) fn is_replaced(&self, strand: &mut Strand, index: usize) -> bool {
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
        let Some(located) = self.initial_limit_point_of(index)? else { return Ok(false) };
        let own = self.taken_up(index, &located, found.elements)?;
        let bound = strand.checks.iter().rev().map(|c| c.1).take(NEIGHBOURS).reduce(Difference::max);
        let slack = |share: f64| SAME + FOLLOWED_BOUND_FACTOR * share;
        let (a, b) = (&own.observables, &found.observables);
        Ok(bound.is_some_and(|bound| {
            (a.force / b.force - 1.0).abs() <= slack(bound.force)
                && (a.displacement / b.displacement - 1.0).abs() <= slack(bound.displacement)
        }))
    }
}
