//! Where a snap-back vanishes: the cusp at which the two displacement limit points meet.
//!
//! Between them u falls along the path while P falls, so that du/dP > 0; before the first and behind the second du/dP < 0. At the
//! cusp its largest value is zero. That maximum, over P, is a smooth function of any parameter of the model on both
//! sides of the cusp, and its zero a regular one, where the limit points themselves are singular.

use super::result::CuspError;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::points::search::LimitPointKind;
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{Accuracy, ORDER, Resolution};
use crate::study::asked::error_bounds::DIFFERENCE_BOUND_FACTOR;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::asked::terms::Terms;
use crate::study::peel::result::PathEnd;
use crate::study::terms::term_selection::peel;
use std::sync::Arc;

/// A cusp of the path in a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cusp {
    /// The parameter
    pub value: f64,
    /// Bound on its error
    pub error: f64,
    /// u and P there, nm and nN
    pub displacement: f64,
    /// P there, nN
    pub force: f64,
}

/// Error of a solution, relative as in [`Problem::relative_size`].
const FINE: f64 = 1e-12;
/// Step over which slopes are differenced, as a share of the force.
const BESIDE: f64 = 1e-3;
/// The maximum is found where the next parabola would move it by less than this share of the force: its value is good to the
/// square of that.
const CLOSE: f64 = 1e-6;
/// The cusp is found where the next secant would move it by less than this share.
const CERTAIN: f64 = 1e-10;
/// Most of either.
const MOST_TRIES: usize = 40;
/// Largest step of the parameter, as a share of it.
const LONGEST: f64 = 0.03;

/// Finds the cusp next to the value `from`, at which the path has a snap-back; `model` gives the model at a value, and the
/// snap-back vanishes as the value grows. The error says what was not found.
pub fn cusp<M: Into<PeelModel>>(model: &dyn Fn(f64) -> M, from: f64, accuracy: &Accuracy) -> Result<Cusp, CuspError> {
    let accuracy = &Accuracy { terms: Terms::All, ..*accuracy };
    let model = |value: f64| model(value).into();
    let first = Snapback::on_path(&model(from), accuracy)?;
    let elements = Resolution::first(&model(from), accuracy).elements;
    let [coarse, fine] = [elements, elements + elements.div_ceil(2)].map(|elements| {
        let problem = problem(&model(from));
        vanishing(&model, from, first.on_elements(&problem, elements))
    });
    let (coarse, fine) = (coarse?, fine?);
    Ok(Cusp { error: DIFFERENCE_BOUND_FACTOR * (fine.value - coarse.value).abs() + CERTAIN * coarse.value, ..coarse })
}

fn problem(model: &PeelModel) -> BeamProblem {
    model.problem(Form::TwoField, ORDER).expect("the order is one that there is")
}

/// The equilibrium at which du/dP is largest, as far as it is known.
#[derive(Clone)]
struct Snapback {
    at: State,
    /// nN
    force: f64,
    /// nm
    displacement: f64,
    /// du/dP, nm/nN
    compliance: f64,
}

impl Snapback {
    /// A point of the path half-way between its two limit points.
    fn on_path(model: &PeelModel, accuracy: &Accuracy) -> Result<Self, CuspError> {
        let peel = peel(model, accuracy, &StopCriteria::default());
        if let PathEnd::Failed(failure) = &peel.end {
            return Err(CuspError::Path(Box::new(failure.clone())));
        }
        let mut turns = peel.limit_points.iter().filter(|point| point.kind == LimitPointKind::Displacement);
        let (Some(first), Some(second), Some(trace)) = (turns.next(), turns.next(), &peel.trace) else {
            return Err(CuspError::NoSnapBack);
        };
        let middle = 0.5 * (first.force + second.force);
        let away = |point: &Arc<Solution>| (point.observables.force - middle).abs();
        let between = &trace.points[first.after..=(second.after + 1).min(trace.points.len() - 1)];
        let nearest = between.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        let point = nearest.ok_or(CuspError::NoPoint)?;
        let (o, s) = (&point.observables, &point.slope);
        let compliance = s.displacement / s.force;
        Ok(Self { at: point.at.clone(), force: o.force, displacement: o.displacement, compliance })
    }

    /// The same on another number of elements.
    fn on_elements(&self, problem: &Problem, elements: usize) -> Self {
        Self { at: problem.system.on_elements(&self.at, elements), ..*self }
    }

    /// The maximum of du/dP over P next to this one, by parabolas through three forces.
    fn peaked(&self, problem: &Problem, ws: &mut Workspace) -> Result<Self, CuspError> {
        let mut here = self.clone();
        for _ in 0..MOST_TRIES {
            let middle = here.solved(problem, here.force, ws)?;
            let beside = BESIDE * middle.force;
            let [below, above] = [-beside, beside].map(|way| middle.solved(problem, middle.force + way, ws));
            let (below, above) = (below?.compliance, above?.compliance);
            let (slope, bend) = (0.5 * (above - below), above - 2.0 * middle.compliance + below);
            let step = -slope / bend * beside;
            if !step.is_finite() || bend >= 0.0 {
                return Err(CuspError::NoMaximum { force: middle.force });
            }
            if step.abs() <= CLOSE * middle.force {
                let compliance = middle.compliance - 0.5 * slope * slope / bend;
                return Ok(Self { compliance, ..middle });
            }
            let most = 0.1 * middle.force;
            here = Self { force: middle.force + step.clamp(-most, most), ..middle };
        }
        Err(CuspError::MaximumNotFound { force: here.force, tries: MOST_TRIES })
    }

    /// The equilibrium at a force, from this one.
    fn solved(&self, problem: &Problem, force: f64, ws: &mut Workspace) -> Result<Self, CuspError> {
        let weights = Observables::FORCE;
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 20, exact_slope: true };
        let solution = solve(problem, self.at.clone(), &PathConstraint { weights, target: force }, &options, ws)?;
        let Solution { at, observables, slope, .. } = solution;
        Ok(Self { at, force, displacement: observables.displacement, compliance: slope.displacement })
    }
}

/// The value at which the largest du/dP is zero, by the secant rule.
fn vanishing(model: &dyn Fn(f64) -> PeelModel, from: f64, first: Snapback) -> Result<Cusp, CuspError> {
    let mut ws = Workspace::default();
    let mut before = (from, first.peaked(&problem(&model(from)), &mut ws)?);
    let mut value = from * (1.0 + 0.3 * LONGEST);
    for _ in 0..MOST_TRIES {
        let here = before.1.peaked(&problem(&model(value)), &mut ws)?;
        let slope = (here.compliance - before.1.compliance) / (value - before.0);
        let step = -here.compliance / slope;
        if step.abs() <= CERTAIN * value {
            return Ok(Cusp { value: value + step, error: 0.0, displacement: here.displacement, force: here.force });
        }
        if !step.is_finite() {
            break;
        }
        before = (value, here);
        value += step.clamp(-LONGEST * value, LONGEST * value);
    }
    Err(CuspError::NotVanished { value })
}
