//! One design evaluated: ln Q and its gradient from one peel a factor of the objective, and one adjoint; or ln Q alone where something else than a
//! peel has the number.

use super::problem::{DesignFound, DesignProblem, Factor, NumberBy};
use crate::model::peel::PeelModel;
use crate::solve::path::options::{PathOptions, Waypoint};
use crate::study::asked::accuracy::{Accuracy, Choice};
use crate::study::asked::stop_criteria::{Stage, StopCriteria, StopReason};
use crate::study::asked::terms::Terms;
use crate::study::parameters::limit_point_continuation::result::Spacing;
use crate::study::parameters::sensitivity::quantity::PeelQuantity;
use crate::study::parameters::sensitivity::quantity::{Derivative, Variation};
use crate::study::parameters::sensitivity::run::sensitivities;
use crate::study::peel::budget::Checkpoint;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::terms::term_selection::{peel, peel_on};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A gradient of ln Q to the accuracy asked for.
#[derive(Clone, Debug)]
pub(super) struct Precise {
    pub gradient: Vec<f64>,
    pub errors: Vec<f64>,
}

/// Evaluates designs.
pub(super) struct Evaluator<'p> {
    problem: &'p DesignProblem<'p>,
    options: &'p OptimisationOptions<'p>,
    /// None where the number is not that of a peel
    paths: Vec<(Factor, SearchPath)>,
}

impl<'p> Evaluator<'p> {
    /// From what was computed of the start.
    pub(crate) fn new(
        problem: &'p DesignProblem<'p>,
        options: &'p OptimisationOptions<'p>,
        start: &DesignFound,
    ) -> Self {
        let path = |(factor, peel): (Factor, &Peel)| (factor, SearchPath::new(factor.of, peel));
        let paths = match start {
            DesignFound::Peels(peels) => problem.objective.factors().into_iter().zip(peels).map(path).collect(),
            DesignFound::Curves(_) => Vec::new(),
        };
        Self { problem, options, paths }
    }

    /// ln Q at coordinates, with its gradient where that is asked for.
    pub(crate) fn evaluate(&self, coordinates: &[f64], with_gradient: bool) -> Evaluation {
        let found = match &self.problem.number {
            NumberBy::Peel => self.by_peels(coordinates, with_gradient),
            NumberBy::Values(number) => {
                let values = self.problem.values(coordinates);
                let log_of = |factor: &Factor| {
                    let found = number(&values, factor.angle, &(self.options.stop)()).ok()?;
                    Some(factor.power * Some(found.value).filter(|&value| value > 0.0)?.ln())
                };
                let sum: Option<f64> = self.problem.objective.factors().iter().map(log_of).sum();
                sum.filter(|sum| sum.is_finite()).map(|sum| (sum, Vec::new()))
            }
        };
        let (log_value, gradient) = found.map_or((None, Vec::new()), |(value, gradient)| (Some(value), gradient));
        Evaluation { coordinates: coordinates.to_vec(), with_gradient, log_value, gradient }
    }

    fn by_peels(&self, coordinates: &[f64], with_gradient: bool) -> Option<(f64, Vec<f64>)> {
        let model = self.problem.model_at(coordinates)?;
        let (mut sum, mut gradient) = (0.0, vec![0.0; if with_gradient { coordinates.len() } else { 0 }]);
        for (factor, path) in &self.paths {
            let peel = path.peel(&factor.model(model.clone()), self.options);
            let value = factor.of.value(&peel).filter(|&value| value > 0.0)?;
            sum += factor.power * value.ln();
            if with_gradient {
                for (slope, total) in
                    derivatives(self.problem, factor, &peel, coordinates).ok()?.iter().zip(&mut gradient)
                {
                    *total += factor.power * slope.value / value;
                }
            }
        }
        (sum.is_finite() && gradient.iter().all(|slope| slope.is_finite())).then_some((sum, gradient))
    }

    /// The gradient of ln Q from peels to the accuracy asked for; none where the number is not that of a peel.
    pub(crate) fn precise(&self, coordinates: &[f64]) -> Option<Precise> {
        if self.paths.is_empty() {
            return None;
        }
        let model = self.problem.model_at(coordinates)?;
        let zero = || vec![0.0; coordinates.len()];
        let mut sum = Precise { gradient: zero(), errors: zero() };
        for (factor, _) in &self.paths {
            let peel = peel(&factor.model(model.clone()), &self.options.accuracy, &(self.options.stop)());
            let value = factor.of.value(&peel).filter(|&value| value > 0.0)?;
            for (k, slope) in derivatives(self.problem, factor, &peel, coordinates).ok()?.iter().enumerate() {
                sum.gradient[k] += factor.power * slope.value / value;
                sum.errors[k] += slope.error / value;
            }
        }
        Some(sum)
    }
}

/// The derivatives of the number of a factor by the coordinates, or why there are none.
pub(super) fn derivatives(
    problem: &DesignProblem,
    factor: &Factor,
    peel: &Peel,
    coordinates: &[f64],
) -> Result<Vec<Derivative>, String> {
    let base = &peel.model;
    let ranges: Vec<f64> = problem.variables.iter().map(|variable| variable.range()).collect();
    let variation = |index: usize| {
        // of a logarithmic coordinate x is ln of the value, else a share of the range
        let share = if problem.variables[index].spacing == Spacing::Logarithmic { 1.0 / ranges[index] } else { 1.0 };
        let model = move |x: f64| {
            let mut moved = coordinates.to_vec();
            moved[index] += share * x;
            // the bounds lie inside the range in which there is a model
            problem.model_at(&moved).map_or_else(|| base.clone(), |model| factor.model(model))
        };
        (share, Variation { key: problem.variables[index].name.clone(), model: Box::new(model) })
    };
    let (shares, variations): (Vec<f64>, Vec<Variation>) = (0..coordinates.len()).map(variation).unzip();
    let found = sensitivities(peel, &[factor.of], &variations).map_err(|why| why.to_string())?;
    let one = |(index, share): (usize, &f64)| {
        let slope = found.of(factor.of, index).copied();
        let refused = || found.refused.iter().find(|(variation, _)| *variation == index);
        slope
            .map(|slope| Derivative { value: slope.value / share, error: slope.error / share, ..slope })
            .ok_or_else(|| refused().map_or_else(|| factor.of.name().to_owned(), |(_, why)| why.to_string()))
    };
    shares.iter().enumerate().map(one).collect()
}

// -- How an optimum is looked for --

/// What was found of one design. A design whose peel has no such number, or that cannot be computed, has no value.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Evaluation {
    /// From 0 to 1 between the bounds of each variable
    pub coordinates: Vec<f64>,
    /// Whether its gradient was asked for: where that fails the design has no value
    pub with_gradient: bool,
    /// ln Q; none: a bad point
    pub log_value: Option<f64>,
    /// d ln Q/d coordinate; empty where it was not asked for or there is none
    pub gradient: Vec<f64>,
}

/// How the next design is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchMethod {
    /// L-BFGS with gradients, on coordinates z with c = (1 + sin z)/2, which keeps to the bounds by itself: the choice without constraints.
    /// Nocedal and Wright, Numerical Optimization (2006), algorithm 7.5; crate argmin.
    QuasiNewton,
    /// Sequential quadratic programming with gradients, bounds and constraints as they are: the choice with constraints. Kraft, ACM
    /// Trans. Math. Softw. 20 (1994) 262; crate slsqp.
    SequentialQuadratic,
    /// COBYLA, without gradients, for checks and where there are no sensitivities. Powell (1994), in: Advances in Optimization and Numerical
    /// Analysis, 51; crate cobyla.
    DerivativeFree,
}

impl SearchMethod {
    /// Its name in a scene and in results.
    pub fn word(self) -> &'static str {
        match self {
            Self::QuasiNewton => "quasi-newton",
            Self::SequentialQuadratic => "sequential-quadratic",
            Self::DerivativeFree => "derivative-free",
        }
    }
}

/// What a search asks and tells while it runs.
pub struct OptimisationOptions<'o> {
    /// How designs are chosen; none: by whether there are constraints
    pub method: Option<SearchMethod>,
    /// How many searches, each from its own start: the first from the design that is given, the others from random ones
    pub starts: usize,
    /// Most designs that one search evaluates
    pub evaluations: usize,
    /// A search ends where ln Q changes by less from one step to the next
    pub tolerance: f64,
    /// Accuracy of the peels of the search
    pub search: Accuracy,
    /// Accuracy of the peels of the start and of the optimum
    pub accuracy: Accuracy,
    /// How many random feasible designs beside the optimum it is compared with
    pub neighbours: usize,
    /// What the random designs come from
    pub seed: u64,
    /// Whether a search without gradients goes on from the optimum, to see whether it finds a better one
    pub check: bool,
    /// Where one peel is stopped, anew for each
    pub stop: &'o (dyn Fn() -> StopCriteria + Sync),
    /// Whether to go on; once it says no, what was found is reported
    pub go_on: &'o (dyn Fn() -> bool + Sync),
    /// What an earlier run has found of a design with these coordinates, asked with its gradient or without
    pub known: &'o (dyn Fn(&[f64], bool) -> Option<Evaluation> + Sync),
    /// Is given each design that is evaluated, and by which search, from any thread
    pub keep: &'o (dyn Fn(usize, &Evaluation) + Sync),
}

impl OptimisationOptions<'_> {
    /// Two searches of at most 200 designs, to 1e-8 of the objective, 100 neighbours, nothing kept, never stopped, to this accuracy.
    pub fn to(accuracy: Accuracy) -> Self {
        Self {
            method: None,
            starts: 2,
            evaluations: 200,
            tolerance: 1e-8,
            search: Accuracy { relative: accuracy.relative.max(1e-6), ..accuracy },
            accuracy,
            neighbours: 100,
            seed: 0,
            check: false,
            stop: &StopCriteria::default,
            go_on: &|| true,
            known: &|_, _| None,
            keep: &|_, _| (),
        }
    }
}

// -- How the peels of a search are computed: no further than the number that is asked for, on the mesh of the design at the start --

/// How the peel of one factor of an objective is computed in a search. Every design is computed alike, whatever was computed before.
#[derive(Clone, Copy)]
pub(super) struct SearchPath {
    of: PeelQuantity,
    elements: usize,
    reach: Reach,
}

/// How far a path is followed.
#[derive(Clone, Copy)]
enum Reach {
    /// To this displacement, nm
    Displacement(f64),
    /// Until the displacement has turned back
    FirstJump,
    /// To its end
    End,
}

/// A path is followed this many times as far as the initiation peak of the start is.
const BEYOND_PEAK: f64 = 3.0;
/// Path points behind the first jump that its interpolation may use.
const BEHIND: usize = 6;
/// A mesh is as good as that of the start where its error is not this many times what was asked for.
const WORSE_MESH: f64 = 10.0;

impl SearchPath {
    /// From the peel of the design at the start.
    pub(crate) fn new(of: PeelQuantity, start: &Peel) -> Self {
        use PeelQuantity::*;
        let reach = match of {
            InitiationPeakForce | InitiationPeakDisplacement => {
                start.initiation_peak.map_or(Reach::End, |peak| Reach::Displacement(BEYOND_PEAK * peak.displacement))
            }
            PeakForce | PeakDisplacement | FirstJumpForce | FirstJumpDisplacement | FirstJumpWork
                if start.snap_off.is_some() =>
            {
                Reach::FirstJump
            }
            _ => Reach::End,
        };
        Self { of, elements: start.effort.elements, reach }
    }

    /// The peel of a design: on another mesh or to its end only where the number is not found otherwise.
    pub(crate) fn peel(&self, model: &PeelModel, options: &OptimisationOptions) -> Peel {
        let Accuracy { relative, choice, .. } = options.search;
        let accuracy = Accuracy { relative, choice, terms: Terms::All };
        let fixed = accuracy.with(Choice { elements: Some(self.elements), ..choice });
        let stop = (options.stop)();
        let found = match self.reach {
            Reach::End => peel(model, &fixed, &stop),
            Reach::Displacement(most) => peel(model, &fixed, &StopCriteria { displacement: Some(most), ..stop }),
            Reach::FirstJump => to_first_jump(model, &fixed, stop),
        };
        let good = found.reached_accuracy().is_some_and(|reached| reached <= WORSE_MESH * relative);
        if good && self.of.value(&found).is_some() && !matches!(found.end, PathEnd::Failed(_)) {
            return found;
        }
        peel(model, &accuracy, &(options.stop)())
    }
}

/// The peel as far as a few points behind where the displacement turns back.
fn to_first_jump(model: &PeelModel, accuracy: &Accuracy, stop: StopCriteria) -> Peel {
    let behind = Arc::new(AtomicUsize::new(0));
    let seen = behind.clone();
    let enough = move |stage| {
        let is_over = stage == Stage::Path && seen.load(Ordering::Relaxed) >= BEHIND;
        is_over.then_some(StopReason::Interrupted)
    };
    let keep = |_: &PathOptions, waypoint: Waypoint| {
        let back = waypoint.point.slope.displacement < 0.0;
        behind.store(if back { behind.load(Ordering::Relaxed) + 1 } else { 0 }, Ordering::Relaxed);
    };
    let checkpoint = Checkpoint { taken: &|_| Vec::new(), keep: &keep };
    peel_on(model, accuracy, &stop.or_when(enough), &checkpoint)
}
