//! The best design: numbers of a model, and its width and height along the body, under bounds and constraints.
mod evaluation;
mod methods;
mod optimum;
mod problem;
mod profile;
mod refine;
mod run;
mod search;
pub use evaluation::{Evaluation, OptimisationOptions, SearchMethod};
pub use optimum::{Certificate, DerivativeFreeCheck, Design, Neighbours, NoOptimum, Optimum};
pub use problem::{
    ConstraintKind, DesignConstraint, DesignFound, DesignNumber, DesignProblem, DesignVariable, Goal, NumberBy,
    NumberOf, Objective, ProfileColumn,
};
pub use profile::{ProfileDesign, volume};
pub use refine::ActiveConstraint;
pub use run::optimise;
pub use search::{SearchEnd, SearchResult};
