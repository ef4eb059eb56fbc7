//! What is to be solved: a system, what its grip does, what measures a path, and where that starts.

use super::end_conditions::EndConditions;
use super::observables::{MONITORS, Observables};
use super::state::State;
use super::system::{EndRoll, Evaluation, System};
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
    pub fn settles(&self) -> bool {
        matches!(self, Self::Settling | Self::Known { settling: true, .. })
    }

    /// The equilibrium that is known.
    pub fn known(&self) -> Option<&Arc<State>> {
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
    pub fn start_at(&mut self, at: Arc<State>) {
        self.grip.origin = self.system.interface_values(&at);
        self.start = InitialState::Known { at, settling: self.start.settles() };
    }

    /// U = u + P/k of a state: how far what moves the grip is from where displacements are zero, nm.
    pub fn displacement(&self, at: &State) -> f64 {
        self.grip.grip_displacement(&self.system.interface_values(at)) + self.grip.compliance * at.force
    }

    /// A state with the grip moved on along the drive, nm.
    pub(super) fn moved(&self, at: State, ahead: f64) -> State {
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
