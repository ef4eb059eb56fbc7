//! How a beam comes to lie on ground that is not flat: relaxed without a grip, from a guess, to the stable equilibrium next to it.

use super::error::SettlingError;
use super::loading_steps::elements;
use crate::beam::planar::planar_beam::{FRONT, PlanarBeam};
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::model::ground::{Ground, Start};
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::{NewtonOptions, settle};
use crate::solve::problem::{EndConditions, InitialState};
use crate::solve::relax::{Held, RelaxOptions, disturbed_anyhow, relax};
use crate::solve::state::{Mesh, Observables, PathConstraint, State};
use crate::solve::system::{INTERFACE, System};
use crate::solve::workspace::{ShouldStop, Workspace};
use std::sync::Arc;

/// Lengths of the elements on which it relaxes, over the length of the process zone and over the least length in which the
/// ground changes; the equilibrium is then found on twice as many, again and again until they do not move the grip any more.
const ELEMENT: f64 = 2.0;
const OF_DETAIL: f64 = 0.25;
/// Fewest and most elements on which it relaxes, and those besides for a piece of the outline behind the first.
const FEWEST: f64 = 12.0;
const MOST: f64 = 400.0;
const A_PIECE: f64 = 2.0;
/// The grip is not moved by what is less than this share of the gap at rest; most elements on which that is looked at.
const MOVED: f64 = 1e-9;
const MOST_SETTLED: usize = 1600;
/// Most steps of relaxation.
const MOST_STEPS: usize = 1000;
/// Most that a step of relaxation moves, relative as in [`System::size`].
const RELAXING: f64 = 0.3;

/// The free equilibrium, found by gradient flow from the stress-free configuration, of a beam that its ground can touch up to S = `contact_extent`. An error says why
/// there is none.
pub(super) fn settled_on_ground(
    problem: &BeamProblem,
    ground: &Ground,
    contact_extent: f64,
    should_stop: &Option<ShouldStop>,
) -> Result<State, SettlingError> {
    // no grip yet
    let problem = &problem.with_grip(EndConditions { held: [false; INTERFACE], ..problem.grip });
    let Some(beam) = problem.beam.planar() else { return Ok(problem.initial(FEWEST as usize)) };
    let detail = ground.substrate.feature_length();
    let elements =
        (contact_extent / (ELEMENT * beam.process_length).min(OF_DETAIL * detail)).ceil().clamp(FEWEST, MOST);
    let elements = elements + A_PIECE * (beam.mesh.pieces.count() - 1) as f64;
    let guess = guess(beam, ground, elements as usize);
    let (options, mut ws) =
        (RelaxOptions { most_steps: MOST_STEPS, ..RelaxOptions::by(RELAXING) }, Workspace::until(should_stop.clone()));
    let mut relaxed = |from| {
        let relaxed = relax(problem, from, Held::Force(0.0), &options, &mut ws);
        relaxed.map(|relaxed| relaxed.solution.at)
    };
    let finer = beam.on_elements(&relaxed(guess)?, 2 * elements as usize);
    let constraint = PathConstraint { weights: Observables::FORCE, target: 0.0 };
    let newton = NewtonOptions { tolerance: 1e-11, largest_update: 0.5, most_iterations: 20, exact_slope: false };
    let settled = |from| settle(problem, from, &constraint, &newton, &mut Workspace::until(should_stop.clone()));
    // on few elements an equilibrium may be one that is none on more
    let mut found = settled(finer.clone()).or_else(|_| {
        let relaxed = relaxed(finer).map_err(SettlingError::from)?;
        settled(relaxed).map_err(SettlingError::from)
    })?;
    // displacements count from here: what a coarse mesh gets wrong no finer path would show
    while 2 * found.at.mesh.elements() <= MOST_SETTLED {
        let Ok(finer) = settled(beam.on_elements(&found.at, 2 * found.at.mesh.elements())) else { break };
        let moved = problem.displacement(&finer.at) - problem.displacement(&found.at);
        found = finer;
        if moved.abs() <= MOVED * beam.rest_gap {
            break;
        }
    }
    // a mesh that moves begins where the front is
    let focus = found.observables.monitors[FRONT];
    Ok(State { mesh: Mesh { focus, ..found.at.mesh.clone() }, ..found.at })
}

/// Where it relaxes from.
fn guess(beam: &PlanarBeam, ground: &Ground, elements: usize) -> State {
    let boundaries = beam.ends(0.0, elements);
    let places = beam.places(&boundaries);
    let half = |place: f64| 0.5 * beam.height_at(place);
    let axis = |&place: &f64| {
        let [x, gap, rotation] = beam.rest.at(place);
        [x, gap + half(place), rotation]
    };
    let flat: Vec<[f64; 3]> = places.iter().map(axis).collect();
    // the last node may be behind the end by round-off
    let all = beam.rest_front >= beam.length;
    let lying = places.iter().take_while(|&&place| all || place <= beam.rest_front).count().max(1);
    let mut axes = match ground.start {
        Start::Conformed => conformed(ground, &flat, lying),
        Start::Crests => {
            let up = ground.substrate.top(0.0, flat[lying - 1][0]);
            flat.iter().map(|&[x, y, rotation]| [x, y + up, rotation]).collect()
        }
    };
    if matches!(beam.rest, ReferenceConfiguration::Varying(_)) {
        for (axis, &place) in axes.iter_mut().zip(&places) {
            *axis = kept_off(ground, *axis, half(place), beam.rest_gap);
        }
    }
    let values = axes
        .iter()
        .zip(&places)
        .flat_map(|(&[x, y, rotation], &place)| [x - place, y - half(place), rotation])
        .collect();
    let focus = beam.fronts.near(beam.rest_front);
    State { mesh: Mesh { boundaries, focus, ..Mesh::default() }, values, ..State::default() }
}

/// The axis of a beam on flat ground, bent over to this: what lies keeps its place along the ground and its distance from it, and
/// behind it the beam is carried on as it is, turned by the slope of the ground at the last node that lies.
fn conformed(ground: &Ground, flat: &[[f64; 3]], lying: usize) -> Vec<[f64; 3]> {
    let distance = flat[0][1];
    let along: Vec<f64> = flat[..lying].iter().map(|axis| axis[0]).collect();
    let line = ground.substrate.along(distance, &along);
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
fn kept_off(ground: &Ground, [x, y, rotation]: [f64; 3], half: f64, gap: f64) -> [f64; 3] {
    let foot = ground.substrate.project(x, y);
    let tilt = rotation - foot.sin.atan2(foot.cos);
    let short = (gap + half * tilt.cos().abs() - foot.distance).max(0.0);
    [x - short * foot.sin, y + short * foot.cos, rotation]
}

// -- How a beam of varying outline comes to lie on flat ground in space --
//
// Where its section is wide at the peeling front, the equilibrium in its vertical plane may be unstable: it leans to one side. So it is
// relaxed without a force on the grip, from the stress-free configuration turned a little to the side to which it is pulled: a
// mirror image of the pull leads to the mirror image of the peel.

/// Elements of the steps before the pull, over those on which it comes to rest: the path, or the first step, begins with Newton's method on its own.
const COARSER: usize = 2;

/// Lets a path in space that would have to settle start in the stable equilibrium to which the beam relaxes; displacements count from
/// there. Where it does not come to rest the path settles by Newton's method, and says what is wrong if that fails too.
pub(super) fn settle_in_space(model: &PeelModel, problem: &mut BeamProblem, should_stop: &Option<ShouldStop>) {
    if problem.beam.spatial().is_none() || !matches!(problem.start, InitialState::Settling) {
        return;
    }
    let options = RelaxOptions { most_steps: MOST_STEPS, ..RelaxOptions::by(RELAXING) };
    let mut ws = Workspace::until(should_stop.clone());
    let elements = elements(model, problem);
    // on half as many elements first: on the others it is then next to where it comes to rest
    let leaning = |coarser: usize| disturbed_anyhow(problem, &problem.initial(elements / coarser));
    let mut relaxed = |from: State| relax(problem, from, Held::Force(0.0), &options, &mut ws);
    let roughly =
        relaxed(leaning(2 * COARSER)).map(|rest| problem.system.on_elements(&rest.solution.at, elements / COARSER));
    let at_rest = roughly.and_then(&mut relaxed).or_else(|_| relaxed(leaning(COARSER)));
    if let Ok(relaxed) = at_rest {
        let at = problem.system.on_elements(&relaxed.solution.at, elements);
        problem.start_at(Arc::new(at));
    }
}
