//! The stability out of the plane at every point of a path, and where it is lost first.

use super::first_loss::{Known, LocatedLoss, StepSearch};
use super::result::{NotOutOfPlane, OutOfPlane, OutOfPlaneError, OutOfPlaneLoss};
use super::roll_elements::{RollReader, RollStability};
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::workspace::Workspace;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use std::sync::Arc;

impl Peel {
    /// The stability of the path against leaving its plane, of a beam whose grip is free to roll, to turn about the
    /// normal and to move along the width: at every point, and where it is lost first, with error bounds.
    ///
    /// # Errors
    /// Where the model is not pulled straight up by its axis alone ([`NotOutOfPlane`]), where the peel was read or its
    /// solutions were dropped, and where the loss is not located.
    pub fn out_of_plane(&self) -> Result<OutOfPlane, OutOfPlaneError> {
        let (stabilities, located) = self.stability_out_of_plane()?;
        let negative_eigenvalues = stabilities.iter().map(|at| at.negative).collect();
        Ok(OutOfPlane { negative_eigenvalues, first_loss: located.map(|located| located.loss) })
    }

    /// The same, with what is known beside the first loss.
    pub(super) fn stability_out_of_plane(&self) -> Result<(Vec<RollStability>, Option<LocatedLoss>), OutOfPlaneError> {
        if let Some(refusal) = NotOutOfPlane::of(&self.model) {
            return Err(refusal.into());
        }
        let history =
            self.trace.as_ref().filter(|trace| !trace.points.is_empty()).ok_or(OutOfPlaneError::NoSolutions)?;
        let beam = history.problem.beam.planar().ok_or(NotOutOfPlane::InSpace)?;
        let reader = RollReader::new(&self.model, beam);
        let stabilities = stabilities(&reader, history)?;
        let located = first_loss(&reader, history, &stabilities, self.asked)?;
        Ok((stabilities, located))
    }
}

/// Of every point of a path.
fn stabilities(reader: &RollReader, history: &SolutionHistory) -> Result<Vec<RollStability>, OutOfPlaneError> {
    let of = |point: &std::sync::Arc<Solution>| {
        let displacement = point.observables.displacement;
        reader.stability(&point.at).ok_or(OutOfPlaneError::NotFinite { displacement })
    };
    history.points.iter().map(of).collect()
}

fn first_loss(
    reader: &RollReader,
    history: &SolutionHistory,
    stabilities: &[RollStability],
    relative: f64,
) -> Result<Option<LocatedLoss>, OutOfPlaneError> {
    let margins: Vec<f64> = stabilities.iter().map(RollStability::margin).collect();
    let first = stabilities.iter().position(|at| at.negative > 0);
    if first == Some(0) {
        let o = &history.points[0].observables;
        let (displacement, force) = (o.displacement, o.force);
        let (displacement_error, force_error) = (0.0, 0.0);
        let loss = OutOfPlaneLoss { displacement, force, displacement_error, force_error, after: None };
        return Ok(Some(LocatedLoss { loss, beside: None }));
    }
    let mut ws = Workspace::default();
    let stable = first.unwrap_or(margins.len());
    let not_located = |step: usize| {
        let u = |point: usize| history.points[point].observables.displacement;
        move |cause: SolveError| OutOfPlaneError::NotLocated { from: u(step), to: u(step + 1), cause }
    };
    for point in 1..stable.saturating_sub(1) {
        if margins[point] > margins[point - 1] || margins[point] > margins[point + 1] {
            continue;
        }
        if let Some((search, between)) = dip(reader, history, &margins, point, &mut ws).map_err(not_located(point))? {
            let step = search.step;
            return search.located(between, relative, &mut ws).map(Some).map_err(not_located(step));
        }
    }
    let Some(step) = first.map(|first| first - 1) else { return Ok(None) };
    let search = StepSearch::new(reader, history, step);
    let between =
        (Known { label: 0.0, margin: margins[step] }, Known { label: search.segment.end(), margin: margins[step + 1] });
    search.located(between, relative, &mut ws).map(Some).map_err(not_located(step))
}

// -- The two steps around a point of a path as one stretch of it, on which something is least --

/// A place of the stretch, by the length of the path from the point, and a number there.
pub(super) type Look = (f64, f64);

/// Looks no nearer to a known place than this share of the shorter side: nearer ones show nothing.
const APART: f64 = 0.02;

/// The two steps around a point of a path.
pub(super) struct TwoSteps<'s> {
    pub steps: [StepSearch<'s>; 2],
    lengths: [f64; 2],
}

impl<'s> TwoSteps<'s> {
    /// Around a point that has neighbours.
    pub(crate) fn around(reader: &'s RollReader<'s>, history: &'s SolutionHistory, point: usize) -> Self {
        let steps = [point - 1, point].map(|step| StepSearch::new(reader, history, step));
        Self { steps, lengths: [point - 1, point].map(|step| length(history, step)) }
    }

    /// The places of the three points.
    pub(crate) fn ends(&self) -> [f64; 3] {
        [-self.lengths[0], 0.0, self.lengths[1]]
    }

    /// On which of the steps a place lies, and its label there.
    pub(crate) fn label(&self, place: f64) -> (usize, f64) {
        let k = usize::from(place > 0.0);
        let share = if k == 1 { place / self.lengths[1] } else { 1.0 + place / self.lengths[0] };
        (k, share * self.steps[k].segment.end())
    }

    /// The equilibrium at a place.
    pub(crate) fn solution(&mut self, place: f64, ws: &mut Workspace) -> Result<Arc<Solution>, SolveError> {
        let (k, label) = self.label(place);
        self.steps[k].solution_at(label, ws)
    }
}

/// Three looks of which the middle one is least.
#[derive(Clone, Copy, Debug)]
pub(super) struct Valley {
    pub before: Look,
    pub least: Look,
    pub behind: Look,
}

impl Valley {
    /// Where to look next, with the least value of the parabola through the three: at its vertex, or beside the least
    /// one where that is as near. Nothing where the parabola has no least value between.
    pub(crate) fn next(&self) -> Option<Look> {
        let (place, value) = self.vertex()?;
        let apart = APART * (self.least.0 - self.before.0).min(self.behind.0 - self.least.0);
        let longer = self.behind.0 + self.before.0 - 2.0 * self.least.0;
        let is_near = (place - self.least.0).abs() < apart;
        Some((if is_near { self.least.0 + apart.copysign(longer) } else { place }, value))
    }

    fn vertex(&self) -> Option<Look> {
        let ((a, fa), (b, fb), (c, fc)) = (self.before, self.least, self.behind);
        let (left, right) = ((fb - fa) / (b - a), (fc - fb) / (c - b));
        let bend = (right - left) / (c - a);
        let slope = left + bend * (b - a);
        let place = b - slope / (2.0 * bend);
        (bend > 0.0 && place > a && place < c).then(|| (place, fb - slope * slope / (4.0 * bend)))
    }

    /// With a further look between the outer two.
    pub(crate) fn with(self, look: Look) -> Self {
        let Self { before, least, behind } = self;
        match (look.1 < least.1, look.0 < least.0) {
            (true, true) => Self { before, least: look, behind: least },
            (true, false) => Self { before: least, least: look, behind },
            (false, true) => Self { before: look, least, behind },
            (false, false) => Self { before, least, behind: look },
        }
    }
}

/// Length of the step behind a point, in units of the scales of what measures the path.
fn length(history: &SolutionHistory, step: usize) -> f64 {
    let change = history.points[step + 1].observables.since(&history.points[step].observables);
    let measure = &history.problem.measure;
    let monitors = change.monitors.iter().zip(measure.monitors).map(|(change, scale)| change / scale);
    monitors.chain([change.force / measure.force]).map(|part| part * part).sum::<f64>().sqrt().max(f64::MIN_POSITIVE)
}

// -- A loss of stability between two stable points of a path: the margin falls below zero and comes back within a step --

/// Most looks at the margin around a point at which it is least.
const MOST_LOOKS: usize = 10;
/// What a parabola through three looks may be wrong by at its least value, over how much lower that is than the least
/// look, and over how much lower that is than the higher of the other two. Without the latter the loss of a strip 1e-4
/// nm narrower than the limit, 4.9292 nm, was missed on the points of a path at 1e-6.
const PARABOLA: [f64; 2] = [2.0, 0.25];

/// A loss of stability within a step, and the places on it between which that is.
pub(super) type Within<'s> = (StepSearch<'s>, (Known, Known));

/// The step with a loss of stability beside a point at which the margin is no more than at its neighbours, and the
/// places on it between which that is.
pub(super) fn dip<'s>(
    reader: &'s RollReader<'s>,
    history: &'s SolutionHistory,
    margins: &[f64],
    point: usize,
    ws: &mut Workspace,
) -> Result<Option<Within<'s>>, SolveError> {
    let mut around = TwoSteps::around(reader, history, point);
    let [before, least, behind] = around.ends();
    let mut valley = Valley {
        before: (before, margins[point - 1]),
        least: (least, margins[point]),
        behind: (behind, margins[point + 1]),
    };
    for _ in 0..MOST_LOOKS {
        let Some((place, _)) = valley.next().filter(|next| !is_clear(&valley, next.1)) else { return Ok(None) };
        let (k, label) = around.label(place);
        let (_, known) = around.steps[k].margin_at(label, ws)?;
        if known.margin <= 0.0 {
            // the loss is between there and the beginning of the same step
            let stable = Known { label: 0.0, margin: margins[point - 1 + k] };
            let [first, second] = around.steps;
            return Ok(Some((if k == 1 { second } else { first }, (stable, known))));
        }
        valley = valley.with((place, known.margin));
    }
    Ok(None)
}

/// Whether the margin stays above zero, whatever it does between the looks of a valley with this least value of the
/// parabola.
fn is_clear(valley: &Valley, lowest: f64) -> bool {
    let depth = valley.before.1.max(valley.behind.1) - valley.least.1;
    PARABOLA[0] * (valley.least.1 - lowest) + PARABOLA[1] * depth < valley.least.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_has_its_vertex_where_it_is() {
        let look = |x: f64| (x, 2.0 * (x - 0.3).powi(2) - 0.1);
        let valley = Valley { before: look(-1.0), least: look(0.0), behind: look(2.0) };
        let (place, value) = valley.next().unwrap();
        assert!((place - 0.3).abs() < 1e-15 && (value + 0.1).abs() < 1e-15);
        let closer = valley.with(look(0.3));
        assert_eq!((closer.before.0, closer.least.0, closer.behind.0), (0.0, 0.3, 2.0));
        assert_eq!(closer.next().unwrap().0, 0.3 + 0.02 * 0.3, "to the longer side of what is known");
        assert_eq!(Valley { least: (0.0, 50.0), ..valley }.next(), None);
    }
}
