//! What is uncertain, and how it is sampled.

use super::distribution::{Distribution, NoDistribution};

/// A number that is uncertain.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// What it is called: a key of a scene, say
    pub name: String,
    /// How it is distributed
    pub distribution: Distribution,
}

/// Two inputs that vary together: the numbers Φ⁻¹(Fᵢ(xᵢ)), which are normal whatever the distributions Fᵢ are, have this correlation. Of normal
/// inputs it is their own, of lognormal ones that of their logarithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// Which inputs, by their number
    pub inputs: [usize; 2],
    /// Between -1 and 1, both excluded
    pub coefficient: f64,
}

/// What is uncertain, and how often it is sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// What is uncertain
    pub inputs: Vec<Input>,
    /// Which of them vary together; all others are independent
    pub correlations: Vec<Correlation>,
    /// Most samples; [`super::Design`] takes as many as make whole replicates.
    pub samples: usize,
    /// Of the scrambling: another seed gives another sample
    pub seed: u64,
    /// Whether sensitivity indices are estimated as well. That takes samples away from the statistics, where both have as many.
    pub indices: Indices,
}

/// Whether Sobol's sensitivity indices are estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indices {
    /// Samples are taken in groups in which one input changes.
    Estimated,
    /// Samples are taken for the statistics alone.
    Omitted,
}

/// A plan by which nothing can be sampled.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoDesign {
    #[error("nothing is uncertain: the list of inputs is empty")]
    NoInputs,
    #[error("{found} inputs are uncertain, more than {most}")]
    TooManyInputs { found: usize, most: usize },
    #[error("{name} is given twice")]
    Twice { name: String },
    #[error("{name} has no distribution: {cause}")]
    Distribution { name: String, cause: NoDistribution },
    #[error("the correlation of {first} and {second} is {coefficient}, which is not between -1 and 1")]
    Coefficient { first: String, second: String, coefficient: f64 },
    #[error("a correlation names input {input}, and the inputs are 0 to {last}")]
    NoSuchInput { input: usize, last: usize },
    #[error("{name} is correlated with itself")]
    WithItself { name: String },
    #[error("the correlation of {first} and {second} is given twice")]
    CorrelatedTwice { first: String, second: String },
    #[error("the correlations contradict one another: the matrix that they make is not positive definite")]
    Contradiction,
    #[error("{samples} samples are too few: {inputs} independent inputs or groups of inputs need at least {least}")]
    TooFew { samples: usize, inputs: usize, least: usize },
}

/// Most inputs: the sequence has twice as many dimensions.
const MOST_INPUTS: usize = 128;

impl Plan {
    /// Whether inputs and correlations are each right by itself.
    pub(super) fn check(&self) -> Result<(), NoDesign> {
        let count = self.inputs.len();
        if count == 0 {
            return Err(NoDesign::NoInputs);
        }
        if count > MOST_INPUTS {
            return Err(NoDesign::TooManyInputs { found: count, most: MOST_INPUTS });
        }
        for (index, Input { name, distribution }) in self.inputs.iter().enumerate() {
            if self.inputs[..index].iter().any(|before| before.name == *name) {
                return Err(NoDesign::Twice { name: name.clone() });
            }
            distribution.check().map_err(|cause| NoDesign::Distribution { name: name.clone(), cause })?;
        }
        if let Some(&input) = self.correlations.iter().flat_map(|of| &of.inputs).find(|input| **input >= count) {
            return Err(NoDesign::NoSuchInput { input, last: count - 1 });
        }
        let name = |input: usize| self.inputs[input].name.clone();
        for (index, Correlation { inputs: [first, second], coefficient }) in self.correlations.iter().enumerate() {
            let both = |other: &Correlation| [[*first, *second], [*second, *first]].contains(&other.inputs);
            let (first, second) = (name(*first), name(*second));
            if first == second {
                return Err(NoDesign::WithItself { name: first });
            }
            if coefficient.is_nan() || coefficient.abs() >= 1.0 {
                return Err(NoDesign::Coefficient { first, second, coefficient: *coefficient });
            }
            if self.correlations[..index].iter().any(both) {
                return Err(NoDesign::CorrelatedTwice { first, second });
            }
        }
        Ok(())
    }
}
