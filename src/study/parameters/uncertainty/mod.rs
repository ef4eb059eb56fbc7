//! What is uncertain of a peel where numbers of its model are.
//!
//! Inputs have distributions ([`Distribution`]) and may vary together ([`Correlation`], a Gaussian copula). A [`Design`] samples them by scrambled
//! Sobol sequences, independent replicates of one another; what the replicates differ by is the sampling error of every estimate:
//! [`Statistics`], and Sobol's indices ([`sobol_indices`]). Beside it stands what derivatives at the means of the inputs give ([`Taylor`],
//! [`Propagation`]): linear and quadratic propagation of error, and where they fail. An [`Analysis`] has all of that for each number of a peel.
//!
//! Numbers that are not of a peel are sampled in the same way:
//!
//! ```
//! use peelkit::study::uncertainty::*;
//!
//! // Ishigami's function of three angles
//! let angle = |name: &str| Input { name: name.into(), distribution: Distribution::Uniform { from: -3.14159, to: 3.14159 } };
//! let inputs = ["a", "b", "c"].map(angle).to_vec();
//! let plan = Plan { inputs, correlations: Vec::new(), samples: 10_000, seed: 0, indices: Indices::Estimated };
//! let design = Design::new(plan)?;
//! let f = |x: Vec<f64>| x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin();
//! let values: Vec<Option<f64>> = (0..design.samples()).map(|k| Some(f(design.inputs(design.place(k))))).collect();
//! let statistics = Statistics::of(&design, &values, &[0.5]).ok_or("too few samples")?;
//! assert!((statistics.mean.value - 3.5).abs() < 0.1);
//! let indices = sobol_indices(&design, &values);
//! // of the third input alone nothing comes; together with the first one a quarter of the variance does
//! assert!(indices[2].first.value.abs() < 0.1 && (indices[2].total.value - 0.244).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
mod analysis;
mod derivatives;
mod design;
mod distribution;
mod plan;
mod statistics;
pub use analysis::{ALONE_AT, Analysis, CutShort, NumberAnalysis};
pub use derivatives::{
    DerivativesBy, OneAtATime, Order, Propagation, Sampled, SampledPeel, Taylor, one_at_a_time, sample,
    taylor_by_differences, taylor_polynomials,
};
pub use design::{Design, SamplePlace};
pub use distribution::{Distribution, NoDistribution};
pub use plan::{Correlation, Indices, Input, NoDesign, Outcome, Plan, peel_numbers};
pub use statistics::{Estimate, Quantile, SobolIndex, Statistics, sobol_indices};
