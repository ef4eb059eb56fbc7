//! The stability out of the plane at every point of a path, and where it is lost first.

use super::dip::dip;
use super::first_loss::{Known, LocatedLoss, StepSearch};
use super::refusal::NotOutOfPlane;
use super::result::{OutOfPlane, OutOfPlaneError, OutOfPlaneLoss};
use super::roll_elements::RollStability;
use super::roll_reader::RollReader;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::workspace::Workspace;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;

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
