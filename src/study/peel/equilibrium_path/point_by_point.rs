//! A path that is computed as far as it is asked for, up to where a whole peel ends.

use super::path_end::step;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::{PathError, PathOptions};
use crate::study::accuracy::Accuracy;
use crate::study::checkpoint::{Checkpoint, Limits};
use crate::study::peel::result::PathEnd;
use crate::study::stop_criteria::StopCriteria;
use std::sync::Arc;

/// The points of a path, one after the other, on one mesh: nothing is located or bounded on it. It ends by the rules of [`crate::study::peel`]; its
/// last point is the first beyond its end.
pub struct PathPoints<'p> {
    problem: &'p BeamProblem,
    path: Path<'p>,
    options: PathOptions,
    /// What is farther from the ground does not adhere, nm
    far: f64,
    relative: f64,
    stop: StopCriteria,
    end: Option<PathEnd>,
    failed: bool,
}

impl<'p> PathPoints<'p> {
    /// The path of a problem of this model; `stop` ends it before its end.
    pub fn new(
        model: &PeelModel,
        problem: &'p BeamProblem,
        options: PathOptions,
        accuracy: &Accuracy,
        stop: StopCriteria,
    ) -> Self {
        let limits = Limits { stop: &stop, checkpoint: &Checkpoint::NOTHING };
        let path = Path::new(problem, options).until(limits.should_stop());
        let (far, relative) = (model.line_law().cutoff_distance(), accuracy.relative);
        Self { problem, path, options, far, relative, stop, end: None, failed: false }
    }

    /// How it has ended, if it has.
    pub fn end(&self) -> Option<&PathEnd> {
        self.end.as_ref()
    }
}

impl Iterator for PathPoints<'_> {
    type Item = Result<Arc<Solution>, PathError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.end.is_some() || self.failed {
            return None;
        }
        let limits = Limits { stop: &self.stop, checkpoint: &Checkpoint::NOTHING };
        let before = self.path.points().len();
        match step(self.problem, &mut self.path, self.options.pace, self.far, self.relative, &limits) {
            Ok(end) => self.end = end,
            Err(error) => {
                self.failed = true;
                return Some(Err(error));
            }
        }
        self.path.points().get(before).map(|newest| Ok(Arc::clone(newest)))
    }
}
