//! How an optimum is looked for.

use crate::study::accuracy::Accuracy;
use crate::study::stop_criteria::StopCriteria;

/// What was found of one design. A design whose peel has no such number, or that cannot be computed, has no value.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// From 0 to 1 between the bounds of each variable
    pub coordinates: Vec<f64>,
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
    /// What an earlier run has found of a design with these coordinates
    pub known: &'o (dyn Fn(&[f64]) -> Option<Evaluation> + Sync),
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
            known: &|_| None,
            keep: &|_, _| (),
        }
    }
}
