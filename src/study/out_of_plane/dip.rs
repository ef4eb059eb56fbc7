//! A loss of stability between two stable points of a path: the margin falls below zero and comes back within a step.

use super::first_loss::{Known, StepSearch};
use super::roll_reader::RollReader;
use super::two_steps::{TwoSteps, Valley};
use crate::solve::error::SolveError;
use crate::solve::workspace::Workspace;
use crate::study::peel::solution_history::SolutionHistory;

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
