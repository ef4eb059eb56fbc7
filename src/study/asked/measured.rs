//! The numbers of the equilibria of a beam that are to have a value at a station, or to pass one in an event.

use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::points::passing::PathNumber;
use crate::solve::state::State;
use crate::study::asked::events::{EventQuantity, StationQuantity};
use crate::study::states::fields::Reader;

/// Step of a difference of the place of a front, over its scale.
const BESIDE: f64 = 1e-6;

/// A quantity with a name on the paths of a problem.
pub(in crate::study) fn named<'p>(
    model: &'p PeelModel,
    problem: &'p BeamProblem,
    quantity: StationQuantity,
) -> PathNumber<'p> {
    number(model, problem, &EventQuantity::Named(quantity))
}

/// A quantity on the paths of a problem; no number where a beam has none.
pub(in crate::study) fn number<'p>(
    model: &'p PeelModel,
    problem: &'p BeamProblem,
    quantity: &EventQuantity,
) -> PathNumber<'p> {
    // u, of U = u + P/k
    let displacement = |at: &State| problem.displacement(at) - problem.grip.compliance * at.force;
    let reader = Reader::new(model, &problem.beam);
    match quantity {
        // with a spring the displacement of the observables is that of the machine
        EventQuantity::Named(StationQuantity::Displacement) if problem.grip.compliance == 0.0 => {
            PathNumber::observable(problem, |o| o.displacement)
        }
        EventQuantity::Named(StationQuantity::Displacement) => PathNumber::of_state(problem, displacement),
        EventQuantity::Named(StationQuantity::Force) => PathNumber::observable(problem, |o| o.force),
        EventQuantity::Named(StationQuantity::EndRotation) => PathNumber::observable(problem, |o| o.recorded),
        EventQuantity::Named(StationQuantity::Front) => {
            let step = BESIDE * problem.measure.monitors[FRONT];
            PathNumber::following(problem, |o| o.monitors[FRONT], |front| problem.beam.front_place(front), step)
        }
        EventQuantity::Named(StationQuantity::FreeEndGap) => {
            PathNumber::of_state(problem, move |at| reader.free_end_gap(at))
        }
        EventQuantity::OfBeam(of) => {
            let of = of.clone();
            PathNumber::of_state(problem, move |at| of(&reader.state(at, displacement(at))))
        }
        EventQuantity::Named(_) | EventQuantity::OfSeta(_) => PathNumber::of_state(problem, |_| f64::NAN),
    }
}
