//! What the grip moves and what it holds: in a step before the pull, while it lets go of what a step has moved, and in the pull.

use super::grip_in_space;
use crate::beam::grip_state::GripForces;
use crate::beam::spatial::rotation::Matrix3;
use crate::model::beam_problem::BeamProblem;
use crate::model::step::Moved;
use crate::solve::end_conditions::{Direction, EndConditions};
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
    pub fn of(problem: &BeamProblem) -> Self {
        let EndConditions { driven, direction, held, gear, .. } = problem.grip;
        let axes = problem.beam.spatial().map(|beam| beam.chain.ends[1].axes);
        Self { driven, direction, held, gear, axes }
    }

    /// Makes the grip do so from where it is: displacements count from there.
    pub fn set(self, problem: &mut BeamProblem) {
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
    pub fn moving(&self, problem: &BeamProblem, azimuth: Option<f64>, moved: Moved) -> Self {
        if let Some(azimuth) = azimuth {
            return grip_in_space::moving(self, azimuth, moved);
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
    pub fn letting_go(&self, problem: &BeamProblem, height: usize, at: &State) -> Option<LettingGo> {
        if let (Some(axes), Some(beam)) = (&self.axes, problem.beam.spatial()) {
            let least = NONE_IN_SPACE * problem.measure.force;
            return grip_in_space::letting_go(self, axes, beam.grip_reactions(at).force, least);
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
