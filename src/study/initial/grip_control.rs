//! What the grip moves and what it holds: in a step before the pull, while it lets go of what a step has moved, and in the pull.
//!
//! In space, steps before the pull are along the axes of the strip, whatever the direction of the pull: x along it, y up, z sideways. The grip's own two directions are
//! those of the pull, of azimuth β: along the substrate (cos β, 0, sin β), in which `horizontal` holds it while its height is held as well,
//! and (-sin β, 0, cos β), in which `lateral` does. A step along x or z takes hold of what it moves, and of the other one too where the
//! grip is held in one of its two directions; else a grip that is held in one of them is free in the other.

use crate::beam::grip_state::GripForces;
use crate::beam::spatial::rotation::{Matrix3, apply_transposed, cross};
use crate::model::problem::beam_problem::{ACROSS, ALONG, BeamProblem, ROLL, ROTATION, SIDEWAYS, YAW};
use crate::model::step::Moved;
use crate::solve::problem::{Direction, EndConditions};
use crate::solve::state::State;
use crate::solve::system::INTERFACE;

/// A force below this share of its scale is none; in space that along a strip, of differences of its places along x, is known less well.
pub(super) const NONE: f64 = 1e-9;
const NONE_IN_SPACE: f64 = 1e-7;

/// What the grip moves and what it holds.
#[derive(Clone, Copy)]
pub(super) struct GripControl {
    pub driven: usize,
    pub direction: Direction,
    pub held: [bool; INTERFACE],
    pub gear: f64,
    /// In space: along what the right end moves.
    pub axes: Option<Matrix3>,
}

/// How the grip lets go: what it does meanwhile, and the force that falls to zero.
pub(super) struct LettingGo {
    pub control: GripControl,
    pub force: f64,
}

impl GripControl {
    pub(crate) fn of(problem: &BeamProblem) -> Self {
        let EndConditions { driven, direction, held, gear, .. } = problem.grip;
        let axes = problem.beam.spatial().map(|beam| beam.chain.ends[1].axes);
        Self { driven, direction, held, gear, axes }
    }

    /// Makes the grip do so from where it is: displacements count from there.
    pub(crate) fn set(self, problem: &mut BeamProblem) {
        let Self { driven, direction, held, gear, axes } = self;
        problem.grip = EndConditions { driven, direction, held, gear, ..problem.grip };
        if let Some(axes) = axes {
            problem.move_along(axes);
            if let Some(at) = problem.start.known().cloned() {
                problem.start_at(at);
            }
        }
    }

    /// In the step that moves this; `self` is what the grip does in the pull.
    pub(crate) fn moving(&self, problem: &BeamProblem, azimuth: Option<f64>, moved: Moved) -> Self {
        if let Some(azimuth) = azimuth {
            return moving(self, azimuth, moved);
        }
        let (height, rotation) = (self.driven, problem.beam.slot_of_rotation());
        let mut held = self.held;
        let (driven, direction) = match moved {
            Moved::Place => (height, Direction { along: 1.0, up: 0.0 }),
            Moved::Rotation => (rotation, Direction::UP),
            // what leaves the plane is refused there
            Moved::Height | Moved::Side | Moved::Roll | Moved::Yaw => (height, Direction::UP),
        };
        // where the place is moved, the height is what is held across
        held[height] = moved == Moved::Rotation;
        held[rotation] &= moved != Moved::Rotation;
        if let Some(across) = problem.grip.across {
            held[across] |= moved == Moved::Place;
        }
        Self { driven, direction, held, gear: 0.0, axes: None }
    }

    /// How the force on what is neither driven nor held, across the way or along the substrate, comes to be zero, where it is not:
    /// what is free is moved then, and all else is held. `height` is the slot of the height in the plane.
    pub(crate) fn letting_go(&self, problem: &BeamProblem, height: usize, at: &State) -> Option<LettingGo> {
        if let (Some(axes), Some(beam)) = (&self.axes, problem.beam.spatial()) {
            let least = NONE_IN_SPACE * problem.measure.force;
            return letting_go(self, axes, beam.grip_reactions(at).force, least);
        }
        let across = problem.grip.across.filter(|&across| !self.held[across])?;
        let GripForces { horizontal, vertical, .. } = problem.beam.grip_forces(at);
        let Direction { along, up } = self.direction;
        let (force, _) = self.direction.turned(horizontal, vertical);
        let mut held = self.held;
        // what is about to be moved as well, and the height across the way in which the place is let go
        held[self.driven] = true;
        (held[across], held[height]) = (true, false);
        let direction = Direction { along: up, up: -along };
        let control = Self { driven: height, direction, held, gear: 0.0, axes: None };
        (force.abs() >= NONE * problem.measure.force).then_some(LettingGo { control, force })
    }
}

const X: [f64; 3] = [1.0, 0.0, 0.0];

const Y: [f64; 3] = [0.0, 1.0, 0.0];

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// The slots of the places.
const PLACES: [usize; 3] = [ALONG, ACROSS, SIDEWAYS];

/// With these columns.
fn columns(columns: [[f64; 3]; 3]) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]))
}

fn column(matrix: &Matrix3, k: usize) -> [f64; 3] {
    std::array::from_fn(|i| matrix[i][k])
}

/// In the step that moves this.
pub(super) fn moving(pull: &GripControl, azimuth: f64, moved: Moved) -> GripControl {
    let (sin, cos) = azimuth.sin_cos();
    let mut held = pull.held;
    let either = held[ACROSS] || held[SIDEWAYS];
    let beside = |axes: [[f64; 3]; 3]| (axes, [false, true, either], ALONG);
    let own = [Y, [cos, 0.0, sin], [-sin, 0.0, cos]];
    let turned = |slot: usize| (own, [true, held[ACROSS], held[SIDEWAYS]], slot);
    let (axes, places, driven) = match moved {
        Moved::Height => (own, [false, held[ACROSS], held[SIDEWAYS]], ALONG),
        Moved::Place => beside([X, Y, Z]),
        Moved::Side => beside([Z, Y, X]),
        Moved::Rotation => turned(ROTATION),
        Moved::Yaw => turned(YAW),
        Moved::Roll => turned(ROLL),
    };
    PLACES.into_iter().zip(places).for_each(|(slot, holds)| held[slot] = holds);
    held[driven] = false;
    GripControl { driven, direction: Direction::UP, held, gear: 0.0, axes: Some(columns(axes)) }
}

/// How the force on what is neither driven nor held comes to be zero: the grip moves along it, and holds all else that the control drives or holds.
pub(super) fn letting_go(control: &GripControl, axes: &Matrix3, force: [f64; 3], least: f64) -> Option<LettingGo> {
    let is_free = |slot: usize| !control.held[slot] && slot != control.driven;
    let along = apply_transposed(axes, &force);
    let free: Vec<usize> = PLACES.into_iter().filter(|&slot| is_free(slot)).collect();
    let size = free.iter().map(|&slot| along[slot].powi(2)).sum::<f64>().sqrt();
    if size < least || size == 0.0 {
        return None;
    }
    let mut way = [0.0; 3];
    for &slot in &free {
        let share = along[slot] / size;
        way.iter_mut().zip(column(axes, slot)).for_each(|(way, axis)| *way += share * axis);
    }
    let mut kept = PLACES.into_iter().filter(|&slot| !is_free(slot)).map(|slot| column(axes, slot));
    let (first, second) = (kept.next(), kept.next());
    let first = first.unwrap_or_else(|| if way[1].abs() < 0.5 { cross(way, Y) } else { cross(way, X) });
    let mut held = control.held;
    held[control.driven] = true;
    (held[ALONG], held[ACROSS], held[SIDEWAYS]) = (false, true, second.is_some());
    let axes = columns([way, first, second.unwrap_or_else(|| cross(way, first))]);
    let control = GripControl { driven: ALONG, direction: Direction::UP, held, gear: 0.0, axes: Some(axes) };
    Some(LettingGo { control, force: size })
}
