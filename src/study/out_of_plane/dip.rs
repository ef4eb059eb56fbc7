//! A loss of stability between two stable points of a path: the margin falls below zero and comes back within a step.

use super::first_loss::{Known, StepSearch};
use super::roll_reader::RollReader;
use super::two_steps::{TwoSteps, Valley};
use crate::solve::{SolveError, Workspace};
use crate::study::peel::SolutionHistory;

/// Most looks at the margin around a point at which it is least.
const MOST_LOOKS: usize = 10;
/// Where a parabola through what is known has its least value above this share of the least margin, there is no loss.
const CLEAR: f64 = 0.5;

/// A loss of stability within a step, and the places on it between which that is.
pub(super) type Within<'s> = (StepSearch<'s>, (Known, Known));

/// The step with a loss of stability beside a point at which the margin is no more than at its neighbours, and the places on it between which
/// that is.
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
        let Some((place, _)) = valley.next().filter(|next| next.1 < CLEAR * valley.least.1) else { return Ok(None) };
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
