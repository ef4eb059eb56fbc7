//! What the grip drives and what it holds: constraints on named unknowns of a system's interface.
//!
//! The grip drives one unknown q_d, or two of them in one direction: with dx and dy for how far they are from where
//! displacements are zero, and the direction (cos α, sin α),
//!
//!   u = dx cos α + dy sin α,   w = dx sin α - dy cos α,
//!
//! and the forces on them are P (cos α, sin α) + Q (sin α, -cos α). Across the drive they are free, Q = 0, or held, w = 0. A geared
//! unknown goes along, q_g = t u. The unknown in its place is how far it is from there: with that held at zero u, P and their slopes
//! along the path come from the same equations as without, P being the force alone, and dΠ = (P + t M) du with the force M on it.

use super::state::State;
use super::system::{INTERFACE, System};
use serde::{Deserialize, Serialize};

/// The direction of a drive, as cosine and sine of its angle α.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Direction {
    /// cos α: along the first unknown
    pub along: f64,
    /// sin α: along the second
    pub up: f64,
}

impl Direction {
    /// Along the second unknown alone.
    pub const UP: Self = Self { along: 0.0, up: 1.0 };

    /// The component along the drive, of those along x and y.
    pub fn ahead(self, x: f64, y: f64) -> f64 {
        self.turned(x, y).1
    }

    /// Components across and along the drive, of those along x and y.
    pub fn turned(self, x: f64, y: f64) -> (f64, f64) {
        (self.up * x - self.along * y, self.along * x + self.up * y)
    }

    /// Components along x and y, of those across and along the drive.
    pub(super) fn back(self, across: f64, ahead: f64) -> (f64, f64) {
        (self.up * across + self.along * ahead, self.up * ahead - self.along * across)
    }
}

/// What the grip moves and holds. Slots are those of the system's interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndConditions {
    /// The unknown that is driven; of a drive in a direction the second one, whose place is along sin α.
    pub driven: usize,
    /// The first one, along cos α, where the structure has one.
    pub across: Option<usize>,
    /// The direction of the drive; [`Direction::UP`] drives one unknown and no mixture of two.
    pub direction: Direction,
    /// What is held where displacements are zero; of a drive in a direction, the displacement across it in place of `across`.
    pub held: [bool; INTERFACE],
    /// The unknown that goes along with the drive where `gear` is not zero.
    pub geared: usize,
    /// t, its change per unit of u
    pub gear: f64,
    /// 1/k of a spring between the grip and what moves it, nm/nN; zero where the grip is moved itself. The displacement of
    /// [`super::Observables`] is that of the far end of the spring, U = u + P/k.
    pub compliance: f64,
    /// Values of the interface where displacements are zero.
    pub origin: [f64; INTERFACE],
    /// Scale of an error of each.
    pub scale: [f64; INTERFACE],
}

impl EndConditions {
    /// Drives one unknown and holds nothing; scales are 1.
    pub fn drive(driven: usize) -> Self {
        Self {
            driven,
            across: None,
            direction: Direction::UP,
            held: [false; INTERFACE],
            geared: driven,
            gear: 0.0,
            compliance: 0.0,
            origin: [0.0; INTERFACE],
            scale: [1.0; INTERFACE],
        }
    }

    /// Scale of an error of the displacement.
    pub fn displacement_scale(&self) -> f64 {
        self.scale[self.driven]
    }

    /// Where a drive mixes two unknowns: the slot of the first, and the direction.
    pub(super) fn mixed(&self) -> Option<(usize, Direction)> {
        self.across.filter(|_| self.direction != Direction::UP).map(|across| (across, self.direction))
    }

    /// How far what is held in a slot is from where it is held.
    pub(super) fn off(&self, slot: usize, values: &[f64; INTERFACE]) -> f64 {
        let own = values[slot] - self.origin[slot];
        match self.mixed() {
            Some((across, direction)) if across == slot => {
                direction.turned(own, values[self.driven] - self.origin[self.driven]).0
            }
            _ if slot == self.geared => own - self.gear * self.grip_displacement(values),
            _ => own,
        }
    }

    /// u: how far the grip is along the drive from where displacements are zero.
    pub(crate) fn grip_displacement(&self, values: &[f64; INTERFACE]) -> f64 {
        let driven = values[self.driven] - self.origin[self.driven];
        match self.mixed() {
            Some((across, direction)) => direction.turned(values[across] - self.origin[across], driven).1,
            None => driven,
        }
    }

    /// A state with the grip moved on along the drive.
    pub(super) fn moved(&self, system: &dyn System, mut at: State, ahead: f64) -> State {
        let mut direction = vec![0.0; system.unknowns(&at)];
        if self.gear != 0.0 {
            direction[system.place_of(self.geared, &at)] = self.gear * ahead;
        }
        direction[system.place_of(self.driven, &at)] = self.direction.up * ahead;
        if let Some((across, drive)) = self.mixed() {
            direction[system.place_of(across, &at)] = drive.along * ahead;
        }
        system.retract(&mut at, &direction, 1.0);
        at
    }

    /// A state under these end conditions that has everything from one under others, and what is held as far from where it is held. `own` and
    /// `system` are the systems of the two. The grip need not be as far along the drive then.
    pub(crate) fn carried(&self, other: &Self, own: &dyn System, system: &dyn System, mut at: State) -> State {
        let (values, now) = (own.interface_values(&at), system.interface_values(&at));
        let mut change = vec![0.0; system.unknowns(&at)];
        for slot in (0..system.interface().len()).filter(|&slot| self.held[slot]) {
            let off = self.off(slot, &now) - other.off(slot, &values);
            // across the drive by the first unknown alone, unless that is along it
            let share = self.mixed().filter(|(across, _)| *across == slot).map_or(1.0, |(_, direction)| direction.up);
            change[system.place_of(slot, &at)] = -off / share;
        }
        system.retract(&mut at, &change, 1.0);
        at
    }

    /// The rows of a residual, or of its multipliers, that belong to the two driven unknowns turned into those across and along the drive.
    pub(crate) fn turn_rows(&self, system: &dyn System, at: &State, rows: &mut [f64]) {
        if let Some((across, direction)) = self.mixed() {
            let (a, d) = (system.place_of(across, at), system.place_of(self.driven, at));
            (rows[a], rows[d]) = direction.turned(rows[a], rows[d]);
        }
    }

    /// ∂u/∂q: how far the grip goes along the drive with each unknown; of the drive itself, not of its spring.
    pub(crate) fn displacement_gradient(&self, system: &dyn System, at: &State) -> Vec<f64> {
        let mut gradient = vec![0.0; system.unknowns(at)];
        gradient[system.place_of(self.driven, at)] = self.direction.up;
        if let Some((across, direction)) = self.mixed() {
            gradient[system.place_of(across, at)] = direction.along;
        }
        gradient
    }
}
