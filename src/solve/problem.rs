//! What is to be solved: a system, what its grip does, what measures a path, and where that starts.
//!
//! What the grip drives and what it holds are constraints on named unknowns of a system's interface.
//!
//! The grip drives one unknown q_d, or two of them in one direction: with dx and dy for how far they are from where
//! displacements are zero, and the direction (cos α, sin α),
//!
//!   u = dx cos α + dy sin α,   w = dx sin α - dy cos α,
//!
//! and the forces on them are P (cos α, sin α) + Q (sin α, -cos α). Across the drive they are free, Q = 0, or held, w = 0. A geared
//! unknown goes along, q_g = t u. The unknown in its place is how far it is from there: with that held at zero u, P and their slopes
//! along the path come from the same equations as without, P being the force alone, and dΠ = (P + t M) du with the force M on it.

use super::state::{MONITORS, Observables, State};
use super::system::{EndRoll, Evaluation, INTERFACE, System};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A system in a grip, with the start of its path.
#[derive(Clone)]
pub struct Problem {
    /// What is in equilibrium
    pub system: Arc<dyn System>,
    /// Which unknowns of the interface are held, driven or free
    pub grip: EndConditions,
    /// What measures the way along the path
    pub measure: PathMeasure,
    /// Where the path begins
    pub start: InitialState,
}

/// Scales of what measures a path: where it is, and how far it is from point to point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathMeasure {
    /// Scales of the monitors; infinite of one that does not measure this path.
    pub monitors: [f64; MONITORS],
    /// Scale of the force, nN, or nN·nm where the drive is a rotation.
    pub force: f64,
    /// What measures the path beside the monitors and the displacement
    pub beside: MeasuredBeside,
}

/// What measures a path beside the monitors and the displacement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredBeside {
    /// Nothing.
    Nothing,
    /// The force: of a system whose monitors do not go forward along its path.
    Force,
    /// The roll of the driven end, [`System::roll`], in units of the second monitor's scale: where a symmetric plane nearly loses its
    /// stability nothing else moves to first order.
    Roll,
}

impl PathMeasure {
    /// The scale of the force where it measures the path; infinite where it does not.
    pub(super) fn force_scale(&self) -> f64 {
        if self.beside == MeasuredBeside::Force { self.force } else { f64::INFINITY }
    }

    /// The scale of the roll, rad, likewise.
    pub(super) fn roll_scale(&self) -> f64 {
        if self.beside == MeasuredBeside::Roll { self.monitors[1] } else { f64::INFINITY }
    }

    /// How far the monitors of one point are from those of another: the largest of them, each in units of its scale.
    pub(super) fn apart(&self, one: &Observables, other: &Observables) -> f64 {
        let change = other.since(one).monitors;
        self.monitors.iter().zip(change).map(|(scale, change)| (change / scale).abs()).fold(0.0, f64::max)
    }
}

/// Where a path starts.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // the text of each names its fields
pub enum InitialState {
    /// In the stress-free configuration, which is an equilibrium of what is held.
    StressFree,
    /// In the equilibrium next to that configuration, to which the structure has to settle.
    Settling,
    /// In an equilibrium that is known, and with it what displacements count from; `settling` as above, on another mesh.
    Known { at: Arc<State>, settling: bool },
}

impl InitialState {
    /// Whether the structure has to settle to the first point of its path.
    pub(crate) fn settles(&self) -> bool {
        matches!(self, Self::Settling | Self::Known { settling: true, .. })
    }

    /// The equilibrium that is known.
    pub(crate) fn known(&self) -> Option<&Arc<State>> {
        if let Self::Known { at, .. } = self { Some(at) } else { None }
    }
}

impl Problem {
    /// Where the path starts, on `elements` elements.
    pub fn initial(&self, elements: usize) -> State {
        match self.start.known() {
            Some(at) => self.system.on_elements(at, elements),
            None => self.system.stress_free(elements),
        }
    }

    /// Lets the path start in an equilibrium that has been found: displacements count from there.
    pub(crate) fn start_at(&mut self, at: Arc<State>) {
        self.grip.origin = self.system.interface_values(&at);
        self.start = InitialState::Known { at, settling: self.start.settles() };
    }

    /// Lets the structure settle to the equilibrium that is known, which is on another mesh.
    pub(crate) fn settles(&mut self) {
        if let InitialState::Known { settling, .. } = &mut self.start {
            *settling = true;
        }
    }

    /// U = u + P/k of a state: how far what moves the grip is from where displacements are zero, nm.
    pub fn displacement(&self, at: &State) -> f64 {
        self.grip.grip_displacement(&self.system.interface_values(at)) + self.grip.compliance * at.force
    }

    /// A state with the grip moved on along the drive, nm.
    pub(crate) fn moved(&self, at: State, ahead: f64) -> State {
        self.grip.moved(&*self.system, at, ahead)
    }

    /// Π of a state with that of the spring, P²/2k, aJ.
    pub fn energy(&self, at: &State, system: f64) -> f64 {
        system + 0.5 * self.grip.compliance * at.force.powi(2)
    }

    /// How far two points of the path are apart: the largest change of what measures it, each in units of its scale.
    pub(super) fn apart(&self, one: &Observables, other: &Observables) -> f64 {
        let change = other.since(one);
        let force = (change.force / self.measure.force_scale()).abs();
        let roll = (change.roll / self.measure.roll_scale()).abs();
        let displacement = (change.displacement / self.grip.displacement_scale()).abs();
        self.measure.apart(one, other).max(displacement).max(force).max(roll)
    }

    /// Where on the path a state lies.
    pub fn observables(&self, at: &State, evaluation: &Evaluation) -> Observables {
        Observables {
            monitors: evaluation.monitors,
            displacement: self.displacement(at),
            force: at.force,
            recorded: evaluation.recorded,
            roll: self.roll(at).map_or(0.0, |roll| roll.angle),
        }
    }

    /// The roll of the driven end, where it measures the path.
    pub(super) fn roll(&self, at: &State) -> Option<EndRoll> {
        if self.measure.beside == MeasuredBeside::Roll { self.system.roll(at) } else { None }
    }
}

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
    pub(crate) fn turned(self, x: f64, y: f64) -> (f64, f64) {
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
    pub(crate) fn displacement_scale(&self) -> f64 {
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
