//! The best design: numbers of a model, and its width and height along the body, under bounds and constraints.
mod certificate;
mod check;
mod derivative_free;
mod evaluation;
mod failure;
mod options;
mod problem;
mod profile;
mod projected_gradient;
mod quasi_newton;
mod refine;
mod result;
mod run;
mod search;
mod search_path;
mod sequential_quadratic;
mod starts;
pub use certificate::{Certificate, DerivativeFreeCheck, Neighbours};
pub use failure::NoOptimum;
pub use options::{Evaluation, OptimisationOptions, SearchMethod};
pub use problem::{
    ConstraintKind, DesignConstraint, DesignFound, DesignFunction, DesignModel, DesignNumber, DesignProblem,
    DesignVariable, Goal, NumberBy, NumberOf, Objective, ProfileColumn,
};
pub use profile::{ProfileDesign, volume};
pub use projected_gradient::ActiveConstraint;
pub use result::{Design, Optimum};
pub use run::optimise;
pub use search::{SearchEnd, SearchResult};
