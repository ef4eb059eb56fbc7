//! A number of the equilibria of a beam that is to have a value: at a solution, between solutions, and how fast it changes.

use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::state::{Observables, State};
use crate::study::asked::events::{EventQuantity, StationQuantity};
use crate::study::states::fields::Reader;

/// Step of a difference of the place of a front, over its scale; of any other number, over the step of the path.
const BESIDE: f64 = 1e-6;
const APART: f64 = 1e-4;
/// Points that an interpolation uses.
const USED: usize = 4;

/// A number of the equilibria of a beam.
pub(in crate::study) struct Measure<'p> {
    problem: &'p BeamProblem,
    quantity: EventQuantity,
    /// Reads what no observable is
    reader: Reader<'p>,
    /// The observable that it is, or follows from
    observable: Option<fn(&Observables) -> f64>,
}

impl<'p> Measure<'p> {
    /// Of a quantity on the paths of a problem.
    pub fn new(model: &'p PeelModel, problem: &'p BeamProblem, quantity: EventQuantity) -> Self {
        let observable: Option<fn(&Observables) -> f64> = match quantity.named() {
            // with a spring the displacement of the observables is that of the machine
            Some(StationQuantity::Displacement) if problem.grip.compliance == 0.0 => Some(|o| o.displacement),
            Some(StationQuantity::Force) => Some(|o| o.force),
            Some(StationQuantity::Front) => Some(|o| o.monitors[FRONT]),
            Some(StationQuantity::EndRotation) => Some(|o| o.recorded),
            _ => None,
        };
        Self { problem, quantity, reader: Reader::new(model, &problem.beam), observable }
    }

    /// Of one with a name.
    pub fn named(model: &'p PeelModel, problem: &'p BeamProblem, quantity: StationQuantity) -> Self {
        Self::new(model, problem, EventQuantity::Named(quantity))
    }

    /// Its value at a solution.
    pub fn at(&self, solution: &Solution) -> f64 {
        match self.observable {
            Some(pick) => self.value(pick(&solution.observables)),
            None => self.of_state(&solution.at),
        }
    }

    /// Its value at a label of a step, by what is known around it, and how fast it changes with the label.
    pub fn between(&self, segment: &PathSegment, label: f64) -> (f64, f64) {
        if let Some(pick) = self.observable {
            let (number, rate, _) = segment.observable(pick, label).at(label);
            return (self.value(number), rate * self.per_number(number));
        }
        let at = |label: f64| self.of_state(&segment.start(self.problem, label, USED));
        let apart = APART * segment.end();
        (at(label), (at(label + apart) - at(label - apart)) / (2.0 * apart))
    }

    /// The same without the rate.
    pub fn value_between(&self, segment: &PathSegment, label: f64) -> f64 {
        match self.observable {
            Some(pick) => self.value(segment.observable(pick, label).at(label).0),
            None => self.of_state(&segment.start(self.problem, label, USED)),
        }
    }

    /// How fast it changes with the label of a segment at a solution, by the tangent there.
    pub fn rate(&self, solution: &Solution, segment: &PathSegment) -> f64 {
        let per_label = segment.weights.dot(&solution.slope);
        if let Some(pick) = self.observable {
            return pick(&solution.slope) * self.per_number(pick(&solution.observables)) / per_label;
        }
        let ahead = APART * segment.end() / per_label;
        let at = |ahead: f64| self.of_state(&solution.moved(self.problem, ahead));
        (at(ahead) - at(-ahead)) / (2.0 * ahead * per_label)
    }

    fn of_state(&self, at: &State) -> f64 {
        // u, of U = u + P/k
        let displacement = || self.problem.displacement(at) - self.problem.grip.compliance * at.force;
        match &self.quantity {
            EventQuantity::Named(StationQuantity::Displacement) => displacement(),
            EventQuantity::Named(StationQuantity::FreeEndGap) => self.reader.free_end_gap(at),
            EventQuantity::OfBeam(of) => of(&self.reader.state(at, displacement())),
            EventQuantity::Named(_) | EventQuantity::OfSeta(_) => f64::NAN,
        }
    }

    /// Its value where the observable is `number`.
    fn value(&self, number: f64) -> f64 {
        let is_front = self.quantity.named() == Some(StationQuantity::Front);
        if is_front { self.problem.beam.front_place(number) } else { number }
    }

    /// How fast it changes with the observable.
    fn per_number(&self, number: f64) -> f64 {
        if self.quantity.named() != Some(StationQuantity::Front) {
            return 1.0;
        }
        let step = BESIDE * self.problem.measure.monitors[FRONT];
        (self.value(number + step) - self.value(number - step)) / (2.0 * step)
    }
}
