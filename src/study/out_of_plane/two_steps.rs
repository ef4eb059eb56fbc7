//! The two steps around a point of a path as one stretch of it, on which something is least.

use super::first_loss::StepSearch;
use super::roll_reader::RollReader;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::workspace::Workspace;
use crate::study::peel::solution_history::SolutionHistory;
use std::sync::Arc;

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
    pub fn around(reader: &'s RollReader<'s>, history: &'s SolutionHistory, point: usize) -> Self {
        let steps = [point - 1, point].map(|step| StepSearch::new(reader, history, step));
        Self { steps, lengths: [point - 1, point].map(|step| length(history, step)) }
    }

    /// The places of the three points.
    pub fn ends(&self) -> [f64; 3] {
        [-self.lengths[0], 0.0, self.lengths[1]]
    }

    /// On which of the steps a place lies, and its label there.
    pub fn label(&self, place: f64) -> (usize, f64) {
        let k = usize::from(place > 0.0);
        let share = if k == 1 { place / self.lengths[1] } else { 1.0 + place / self.lengths[0] };
        (k, share * self.steps[k].segment.end())
    }

    /// The equilibrium at a place.
    pub fn solution(&mut self, place: f64, ws: &mut Workspace) -> Result<Arc<Solution>, SolveError> {
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
    pub fn next(&self) -> Option<Look> {
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
    pub fn with(self, look: Look) -> Self {
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
