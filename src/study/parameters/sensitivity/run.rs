//! The sensitivities of a peel: its limit points solved for once more, each with its multipliers, on its own mesh and on half as many elements again.

use super::along_path::{AtPoint, Turn};
use super::differences::{Beside, Estimate, Stencil};
use super::point::Held;
use super::quantity::{Derivative, Variation};
use super::quantity::{NoSensitivities, PeelQuantity};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::error::SolveError;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::State;
use crate::solve::workspace::Workspace;
use crate::study::asked::error_bounds::DIFFERENCE_BOUND_FACTOR;
use crate::study::peel::along_path::work::power;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use rayon::prelude::*;
use std::sync::Arc;

/// dQ/dx of numbers of a peel by parameters of its model, with error bounds: one row a number and a variation, in that order, without numbers that
/// the path does not have. A variation that cannot be differentiated has its reason in place of its rows.
///
/// # Errors
/// With friction, where terms were left out, and where the solutions behind the path are not known.
pub fn sensitivities(
    peel: &Peel,
    of: &[PeelQuantity],
    variations: &[Variation],
) -> Result<Sensitivities, NoSensitivities> {
    let history = solutions(peel)?;
    let how = discretisation(peel);
    let base = Base::new(peel, Beside::base(&history.problem, &peel.model), history, of)?;
    let one = |variation: &Variation| {
        let beside = Stencil::beside(variation, &base.model, how)?;
        let stencil = Stencil::new(&base.model, &beside);
        if stencil.has_unknowns_of(&base.start.0) {
            return base.derivatives(&stencil, variation);
        }
        // an angle of the pull leaves the right one: the beam gets a horizontal force
        let model = Beside::varied(&variation.key, ASIDE, &(variation.model)(ASIDE), &history.problem, how)?;
        let base = Base::new(peel, model, history, of)?;
        let stencil = Stencil::new(&base.model, &beside);
        if stencil.has_unknowns_of(&base.start.0) {
            return base.derivatives(&stencil, variation);
        }
        Err(NoSensitivities::AnotherKind { key: variation.key.clone() })
    };
    let by_variation: Vec<_> = variations.par_iter().map(one).collect();
    let mut found = Sensitivities::default();
    for &of in of {
        for (variation, rows) in by_variation.iter().enumerate() {
            let row = rows.iter().flatten().find(|(quantity, _)| *quantity == of);
            found.derivatives.extend(row.map(|(_, estimate)| Derivative {
                of,
                variation,
                value: estimate.value,
                error: estimate.error,
            }));
        }
    }
    let refused = by_variation.into_iter().enumerate().filter_map(|(k, rows)| rows.err().map(|why| (k, why)));
    found.refused.extend(refused);
    Ok(found)
}

/// Derivatives, and what has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensitivities {
    /// By numbers, in the order asked for, and by variations
    pub derivatives: Vec<Derivative>,
    /// Variations by which nothing could be differentiated, and why
    pub refused: Vec<(usize, NoSensitivities)>,
}

impl Sensitivities {
    /// The derivative of a number by a variation.
    pub fn of(&self, of: PeelQuantity, variation: usize) -> Option<&Derivative> {
        self.derivatives.iter().find(|derivative| derivative.of == of && derivative.variation == variation)
    }
}

/// The solutions behind a peel that can be differentiated.
pub(super) fn solutions(peel: &Peel) -> Result<&SolutionHistory, NoSensitivities> {
    if let Some(decisions) = peel.considered.as_ref().filter(|decisions| !decisions.left_out.is_empty()) {
        let terms: Vec<&str> = decisions.left_out.iter().map(|left_out| left_out.term.word()).collect();
        return Err(NoSensitivities::TermsLeftOut { terms: terms.join(", ") });
    }
    let history =
        peel.trace.as_ref().filter(|history| !history.points.is_empty()).ok_or(NoSensitivities::NoSolutions)?;
    NoSensitivities::of(&peel.model).map_or(Ok(history), Err)
}

/// How a peel was discretised.
pub(super) fn discretisation(peel: &Peel) -> Discretisation {
    Discretisation::moving(peel.choice.form, peel.effort.order).on(peel.choice.mesh)
}

/// How far beside the model a parameter is taken where the model itself has other unknowns than all beside it; what that changes is as small.
const ASIDE: f64 = 1e-9;

/// What is differentiated, of one model.
struct Base {
    model: Beside,
    places: Vec<Place>,
    /// Where the path begins, with dΠ/du there, nN
    start: (State, f64),
}

impl Base {
    /// Of the model that was peeled, or of one so near to it that it has the same path but other unknowns.
    fn new(
        peel: &Peel,
        model: Beside,
        history: &SolutionHistory,
        of: &[PeelQuantity],
    ) -> Result<Self, NoSensitivities> {
        let places = Place::all(peel, model.problem(), history, of)?;
        let first = history.points.first().ok_or(NoSensitivities::NoSolutions)?;
        let start = (adopted(model.problem(), &first.at), power(&history.problem, first));
        Ok(Self { model, places, start })
    }

    fn derivatives(
        &self,
        stencil: &Stencil,
        variation: &Variation,
    ) -> Result<Vec<(PeelQuantity, Estimate)>, NoSensitivities> {
        let mut found = Vec::new();
        for place in &self.places {
            for &of in &place.of {
                let estimate = place.derivative(of, stencil, &self.start);
                if !(estimate.value.is_finite() && estimate.error.is_finite()) {
                    return Err(NoSensitivities::NotFinite { key: variation.key.clone(), of: of.name() });
                }
                found.push((of, estimate));
            }
        }
        Ok(found)
    }
}

/// A state of the path as one of this problem.
fn adopted(problem: &BeamProblem, at: &State) -> State {
    State { values: problem.beam.adopted(at).into_owned(), ..at.clone() }
}

/// A limit point, or the plateau, on two meshes.
struct Place {
    of: Vec<PeelQuantity>,
    /// None: the plateau
    kind: Option<LimitPointKind>,
    /// On the mesh of the path, and on half as many elements again
    on: [AtPoint; 2],
}

impl Place {
    /// Those that have one of the numbers.
    fn all(
        peel: &Peel,
        problem: &BeamProblem,
        history: &SolutionHistory,
        of: &[PeelQuantity],
    ) -> Result<Vec<Self>, NoSensitivities> {
        let mut asked: Vec<(Option<usize>, Vec<PeelQuantity>)> = Vec::new();
        for &quantity in of.iter().filter(|quantity| quantity.value(peel).is_some()) {
            let number = quantity.limit_point(peel);
            // without a potential a work is no difference of energies
            if is_work(quantity) && !problem.system.is_conservative() {
                continue;
            }
            // a plateau without a bound may be another one with other parameters
            let plateau = quantity == PeelQuantity::PlateauForce && quantity.error(peel).is_some();
            if number.is_none() && !plateau {
                continue;
            }
            match asked.iter_mut().find(|(known, _)| *known == number) {
                Some((_, list)) => list.push(quantity),
                None => asked.push((number, vec![quantity])),
            }
        }
        let place = |(number, of): (Option<usize>, Vec<PeelQuantity>)| {
            let name = of[0].name();
            Self::new(peel, problem, history, number, of)
                .map_err(|cause| NoSensitivities::NotSolved { of: name, cause })
        };
        asked.into_par_iter().map(place).collect()
    }

    fn new(
        peel: &Peel,
        problem: &BeamProblem,
        history: &SolutionHistory,
        number: Option<usize>,
        of: Vec<PeelQuantity>,
    ) -> Result<Self, SolveError> {
        let (kind, held, target, near) = match number {
            Some(number) => {
                let point = &peel.limit_points[number];
                let (held, target) = match point.kind {
                    LimitPointKind::Displacement => (Held::Force, point.force),
                    LimitPointKind::Load => (Held::Displacement, point.displacement),
                };
                (Some(point.kind), held, target, history.limit_points[number].at.clone())
            }
            None => {
                let (displacement, after) = peel.plateau.map_or((f64::NAN, 0), |at| (at.displacement, at.after));
                (None, Held::Displacement, displacement, nearest(history, displacement, after))
            }
        };
        let beside = of.iter().any(|&of| moves(of, kind)).then(|| smooth(peel, number, held, target));
        let turn = if kind.is_some() { Turn::Limit } else { Turn::None };
        let finer = near.mesh.elements() + near.mesh.elements().div_ceil(2);
        let near = adopted(problem, &near);
        let start = |at: &State, elements| problem.system.on_elements(at, elements);
        let one = |at: State| AtPoint::new(problem, at, (held, target, turn), beside, &mut Workspace::default());
        let on = [one(near.clone())?, one(start(&near, finer))?];
        Ok(Self { of, kind, on })
    }

    /// The derivative of one of its numbers, as on the finer mesh.
    fn derivative(&self, of: PeelQuantity, stencil: &Stencil, start: &(State, f64)) -> Estimate {
        let [own, finer] = [0, 1].map(|mesh| self.on_mesh(mesh, of, stencil));
        let mut found = Estimate {
            value: finer.value,
            error: finer.error + DIFFERENCE_BOUND_FACTOR * (finer.value - own.value).abs(),
        };
        if is_work(of) {
            found = found.plus(stencil.energy_at_start(&start.0, start.1).estimate().times(-1.0));
        }
        found
    }

    fn on_mesh(&self, mesh: usize, of: PeelQuantity, stencil: &Stencil) -> Estimate {
        let point = &self.on[mesh];
        if moves(of, self.kind) {
            return point.moved(stencil);
        }
        if self.kind.is_none() {
            return point.at_plateau(stencil);
        }
        let held = stencil.force(&point.adjoint).estimate();
        if is_work(of) {
            return stencil.energy(&point.adjoint.at, point.power).estimate().plus(held.times(point.power));
        }
        held
    }
}

/// Whether a number is the one that is held at its limit point, and changes only because that moves along the path.
fn moves(of: PeelQuantity, kind: Option<LimitPointKind>) -> bool {
    match kind {
        Some(LimitPointKind::Load) => of.unit() == "nm",
        Some(LimitPointKind::Displacement) => of.unit() == "nN",
        None => false,
    }
}

fn is_work(of: PeelQuantity) -> bool {
    of.unit() == "aJ"
}

/// How far the path is smooth around a limit point, in what is held there: up to zero, or to the next limit point.
fn smooth(peel: &Peel, number: Option<usize>, held: Held, target: f64) -> f64 {
    let value = |k: usize| match held {
        Held::Displacement => peel.limit_points[k].displacement,
        Held::Force => peel.limit_points[k].force,
    };
    let Some(number) = number else { return target.abs() };
    let others = number.checked_sub(1).into_iter().chain((number + 1 < peel.limit_points.len()).then_some(number + 1));
    others.map(|k| (value(k) - target).abs()).fold(target.abs(), f64::min)
}

/// The state at a displacement on the step behind `points[after]`, from the nearer end of that.
fn nearest(history: &SolutionHistory, displacement: f64, after: usize) -> State {
    let points: &[Arc<_>] = &history.points;
    let away = |k: &usize| (points[*k].observables.displacement - displacement).abs();
    let ends = after..(after + 2).min(points.len());
    let best = ends.min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(0);
    let problem: &BeamProblem = &history.problem;
    let point = &points[best];
    let per_displacement = (displacement - point.observables.displacement) / point.slope.displacement;
    point.moved(problem, per_displacement)
}

// -- Sensitivities as exponents: d ln Q/d ln p --

/// By which power of a parameter a number changes: d ln Q/d ln p.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent {
    /// The number
    pub of: PeelQuantity,
    /// Which of the variations, whose coordinate is ln p
    pub variation: usize,
    /// d ln Q/d ln p
    pub value: f64,
    /// Bound on its error
    pub error: f64,
}

impl Sensitivities {
    /// The derivatives by variations in ln p, each over its number: those of one number together, in the order in which the numbers were asked for,
    /// largest first. A number that is zero has none.
    pub fn exponents(&self, peel: &Peel) -> Vec<Exponent> {
        let one = |derivative: &crate::study::parameters::sensitivity::quantity::Derivative| {
            let number = derivative.of.value(peel).filter(|number| *number != 0.0)?;
            let value = derivative.value / number;
            let uncertain = value.abs() * derivative.of.error(peel).unwrap_or(0.0);
            let error = (derivative.error + uncertain) / number.abs();
            Some(Exponent { of: derivative.of, variation: derivative.variation, value, error })
        };
        let mut exponents: Vec<Exponent> = self.derivatives.iter().filter_map(one).collect();
        for group in exponents.chunk_by_mut(|a, b| a.of == b.of) {
            group.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
        }
        exponents
    }
}
