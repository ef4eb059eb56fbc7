//! What a beam lies on, and how it comes to lie there.
//!
//! On ground that is not flat a beam has several equilibria without a force: it may follow the ground into a valley, or lie
//! across it. Which one a path starts in depends on how the beam got there, so that is said: from a guess it is relaxed, with
//! no grip, down the gradient of its energy to the stable equilibrium next to it. There the grip takes hold, so that P = 0,
//! u = 0 and no moment, whatever the grip then holds.

use crate::adhesion::Substrate;
use crate::solve::{
    Beginning, Condition, Equilibrium, Focus, Held, MOST_FIELDS, NewtonOptions, Observables, Problem, RelaxOptions,
    Workspace, relax, settle,
};
use std::sync::Arc;

/// The guess from which a beam relaxes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// It follows the ground at the gap of a flat section at rest, as where it has been pressed on: everywhere it can it stays
    /// in contact.
    #[default]
    Conformed,
    /// It lies straight on the crests at that gap, as where it has come near from above: it sinks in as far as adhesion draws
    /// it.
    Crests,
}

/// What a beam lies on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ground {
    pub substrate: Substrate,
    pub start: Start,
}

/// Lengths of the elements on which it relaxes, over the length of the process zone and over the least length in which the
/// ground changes; the equilibrium is then found on twice as many.
const ELEMENT: f64 = 2.0;
const OF_DETAIL: f64 = 0.25;
/// Width of a focus that is the same everywhere, over the length of the beam.
const WIDE: f64 = 10.0;
/// Fewest and most elements on which it relaxes.
const FEWEST: f64 = 12.0;
const MOST: f64 = 400.0;
/// Most steps of relaxation.
const MOST_STEPS: usize = 1000;
/// Most that a step of relaxation moves, relative as in [`Problem::relative_size`].
const RELAXING: f64 = 0.3;

/// Lengths of elements on ground that is not flat relative to each other: where a front may be, everywhere, over the length
/// of the process zone, and over the length in which the ground changes.
const FLOOR: f64 = 2.0;

impl Ground {
    /// A focus so wide that it makes elements short everywhere: on ground that is not flat, fronts may be anywhere.
    pub(super) fn everywhere(&self, length: f64, process_length: f64) -> Option<Focus> {
        let floor = (FLOOR * process_length).min(OF_DETAIL * self.substrate.detail());
        let wide = WIDE * length;
        (!self.substrate.is_flat()).then_some(Focus { center: 0.5 * length, length: wide, weight: wide / floor })
    }

    /// Where a path starts of a problem whose beam begins at rest.
    pub(super) fn beginning(&self, problem: &mut Problem) -> Beginning {
        if self.substrate.is_flat() {
            return Beginning::AtRest;
        }
        // no grip yet
        let held = std::mem::replace(&mut problem.held, [false; MOST_FIELDS + 1]);
        let settled = self.settled(problem);
        problem.held = held;
        match settled {
            Ok(at) => Beginning::Settled(Arc::new(at)),
            Err(why) => Beginning::Nowhere(format!(
                "no equilibrium of the beam without a grip was found on the substrate: {why}. Try another substrate.start, or a \
                 stiffer strip"
            )),
        }
    }

    fn settled(&self, problem: &Problem) -> Result<Equilibrium, String> {
        let (length, detail) = (problem.length, self.substrate.detail());
        let elements = (length / (ELEMENT * problem.process_length).min(OF_DETAIL * detail)).ceil().clamp(FEWEST, MOST);
        let guess = self.guess(problem, elements as usize);
        let (options, mut work) =
            (RelaxOptions { largest_update: RELAXING, most_steps: MOST_STEPS }, Workspace::default());
        let relaxed =
            relax(problem, guess, Held::Force(0.0), &options, &mut work).map_err(|error| error.to_string())?;
        let finer = problem.on_elements(&relaxed.solution.at, 2 * elements as usize);
        let condition = Condition { weights: Observables::FORCE, target: 0.0 };
        let newton = NewtonOptions { tolerance: 1e-11, largest_update: 0.5, most_iterations: 20, exact_slope: false };
        let settled = settle(problem, finer, &condition, &newton, &mut work).map_err(|error| error.to_string())?;
        Ok(settled.at)
    }

    /// Where it relaxes from.
    fn guess(&self, problem: &Problem, elements: usize) -> Equilibrium {
        let ends = problem.ends(0.0, elements);
        let places = problem.places(&ends);
        let half = 0.5 * problem.height;
        let distance = problem.rest_gap + half;
        let line = match self.start {
            Start::Conformed => self.substrate.along(distance, &places),
            Start::Crests => {
                let up = self.substrate.top(0.0, problem.length) + distance;
                places.iter().map(|&place| [place, up, 0.0]).collect()
            }
        };
        let state = line.into_iter().flat_map(|[x, y, rotation]| [x, y - half, rotation]).collect();
        Equilibrium { ends, center: problem.fronts.near(problem.rest_front), state, ..Equilibrium::default() }
    }
}
