//! What a beam lies on, and how it comes to lie there.
//!
//! On ground that is not flat a beam has several equilibria without a force: it may follow the ground into a valley, or lie
//! across it. Which one a path starts in depends on how the beam got there, so that is said: from a guess it is relaxed, with
//! no grip, down the gradient of its energy to the stable equilibrium next to it. There the grip takes hold, so that P = 0,
//! u = 0 and no moment, whatever the grip then holds.

use crate::adhesion::Substrate;
use crate::beam::Rest;
use crate::solve::{
    Beginning, Condition, Equilibrium, Held, MOST_FIELDS, NewtonOptions, Observables, Problem, RelaxOptions, Workspace,
    relax, settle,
};
use std::sync::Arc;

/// The guess from which a beam relaxes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// It follows the ground at the gap of a flat section at rest, as where it has been pressed on: everywhere it can it stays
    /// in contact. What of it rises when free of stress goes on from there as it then would.
    #[default]
    Conformed,
    /// It lies free of stress on the crests at that gap, as where it has come near from above: it sinks in as far as adhesion
    /// draws it.
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
/// Fewest and most elements on which it relaxes, and those besides for a piece of the outline behind the first.
const FEWEST: f64 = 12.0;
const MOST: f64 = 400.0;
const A_PIECE: f64 = 2.0;
/// Most steps of relaxation.
const MOST_STEPS: usize = 1000;
/// Most that a step of relaxation moves, relative as in [`Problem::relative_size`].
const RELAXING: f64 = 0.3;

/// Lengths of elements on ground that is not flat relative to each other: where a front may be, everywhere, over the length
/// of the process zone, and over the length in which the ground changes.
const FLOOR: f64 = 2.0;

impl Ground {
    /// The length that elements have everywhere relative to those at a front, nm: on ground that is not flat, fronts may be anywhere.
    pub(super) fn floor(&self, process_length: f64) -> Option<f64> {
        let floor = (FLOOR * process_length).min(OF_DETAIL * self.substrate.detail());
        (!self.substrate.is_flat()).then_some(floor)
    }

    /// Where a path starts of a problem whose beam begins at rest, and which the ground can touch up to S = `reach`.
    pub(super) fn beginning(&self, problem: &mut Problem, reach: f64) -> Beginning {
        if self.substrate.is_flat() {
            return Beginning::AtRest;
        }
        // no grip yet
        let held = std::mem::replace(&mut problem.held, [false; MOST_FIELDS + 1]);
        let settled = self.settled(problem, reach);
        problem.held = held;
        match settled {
            Ok(at) => Beginning::Settled(Arc::new(at)),
            Err(why) => Beginning::Nowhere(format!(
                "no equilibrium of the beam without a grip was found on the substrate: {why}. Try another substrate.start, or a \
                 stiffer beam"
            )),
        }
    }

    fn settled(&self, problem: &Problem, reach: f64) -> Result<Equilibrium, String> {
        let detail = self.substrate.detail();
        let elements = (reach / (ELEMENT * problem.process_length).min(OF_DETAIL * detail)).ceil().clamp(FEWEST, MOST);
        let elements = elements + A_PIECE * (problem.pieces.count() - 1) as f64;
        let guess = self.guess(problem, elements as usize);
        let (options, mut work) =
            (RelaxOptions { largest_update: RELAXING, most_steps: MOST_STEPS }, Workspace::default());
        let mut relaxed = |from| {
            let relaxed = relax(problem, from, Held::Force(0.0), &options, &mut work);
            relaxed.map(|relaxed| relaxed.solution.at).map_err(|error| error.to_string())
        };
        let finer = problem.on_elements(&relaxed(guess)?, 2 * elements as usize);
        let condition = Condition { weights: Observables::FORCE, target: 0.0 };
        let newton = NewtonOptions { tolerance: 1e-11, largest_update: 0.5, most_iterations: 20, exact_slope: false };
        let settled = |from| settle(problem, from, &condition, &newton, &mut Workspace::default());
        // on few elements an equilibrium may be one that is none on more
        let settled = settled(finer.clone()).or_else(|_| {
            let relaxed = relaxed(finer)?;
            settled(relaxed).map_err(|error| error.to_string())
        })?;
        Ok(settled.at)
    }

    /// Where it relaxes from.
    fn guess(&self, problem: &Problem, elements: usize) -> Equilibrium {
        let ends = problem.ends(0.0, elements);
        let places = problem.places(&ends);
        let half = |place: f64| 0.5 * problem.height_at(place);
        let axis = |&place: &f64| {
            let [x, gap, rotation] = problem.rest.at(place);
            [x, gap + half(place), rotation]
        };
        let flat: Vec<[f64; 3]> = places.iter().map(axis).collect();
        // the last node may be behind the end by round-off
        let all = problem.rest_front >= problem.length;
        let lying = places.iter().take_while(|&&place| all || place <= problem.rest_front).count().max(1);
        let mut axes = match self.start {
            Start::Conformed => self.conformed(&flat, lying),
            Start::Crests => {
                let up = self.substrate.top(0.0, flat[lying - 1][0]);
                flat.iter().map(|&[x, y, rotation]| [x, y + up, rotation]).collect()
            }
        };
        if matches!(problem.rest, Rest::Varying(_)) {
            for (axis, &place) in axes.iter_mut().zip(&places) {
                *axis = self.kept_off(*axis, half(place), problem.rest_gap);
            }
        }
        let state =
            axes.iter().zip(&places).flat_map(|(&[x, y, rotation], &place)| [x, y - half(place), rotation]).collect();
        Equilibrium { ends, center: problem.fronts.near(problem.rest_front), state, ..Equilibrium::default() }
    }

    /// The axis of a beam on flat ground, bent over to this: what lies keeps its place along the ground and its distance from it, and
    /// behind it the beam is carried on as it is, turned by the slope of the ground at the last node that lies.
    fn conformed(&self, flat: &[[f64; 3]], lying: usize) -> Vec<[f64; 3]> {
        let distance = flat[0][1];
        let along: Vec<f64> = flat[..lying].iter().map(|axis| axis[0]).collect();
        let line = self.substrate.along(distance, &along);
        let bent = |(&[x, y, slope], &[_, height, rotation]): (&[f64; 3], &[f64; 3])| {
            let ((sin, cos), above) = (slope.sin_cos(), height - distance);
            [x - above * sin, y + above * cos, slope + rotation]
        };
        let mut axes: Vec<[f64; 3]> = line.iter().zip(flat).map(bent).collect();
        let ([x, y, _], [x0, y0, _], slope) = (axes[lying - 1], flat[lying - 1], line[lying - 1][2]);
        let (sin, cos) = slope.sin_cos();
        axes.extend(flat[lying..].iter().map(|[to, up, rotation]| {
            let (to, up) = (to - x0, up - y0);
            [x + to * cos - up * sin, y + to * sin + up * cos, slope + rotation]
        }));
        axes
    }

    /// A section of this half height where its lower edge is no nearer to the ground than `gap`, nm.
    fn kept_off(&self, [x, y, rotation]: [f64; 3], half: f64, gap: f64) -> [f64; 3] {
        let foot = self.substrate.foot(x, y);
        let tilt = rotation - foot.sin.atan2(foot.cos);
        let short = (gap + half * tilt.cos().abs() - foot.distance).max(0.0);
        [x - short * foot.sin, y + short * foot.cos, rotation]
    }
}
