//! What is uncertain, and how it is sampled.

use super::distribution::{Distribution, NoDistribution};
use crate::model::peel::PeelModel;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::parameters::limit_point_continuation::result::{FollowedPoint, PointKind, Remark, Spacing};
use crate::study::parameters::limit_point_continuation::sweep::follow_point;
use crate::study::parameters::sensitivity::quantity::PeelQuantity;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::terms::term_selection::peel;
use nalgebra::{Cholesky, DMatrix};
use serde::{Deserialize, Serialize};

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
    /// Most samples; [`crate::study::parameters::uncertainty::Design`] takes as many as make whole replicates.
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

// -- Which inputs vary together, and how: a Gaussian copula --

/// The dependence of inputs: z = L w makes of independent standard normal numbers w correlated ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Dependence {
    /// L, lower triangular, L Lᵀ the matrix of the correlations; none where all inputs are independent
    factor: Option<DMatrix<f64>>,
    /// The inputs that vary together, each in one group; the groups are independent of one another
    pub groups: Vec<Vec<usize>>,
}

impl Dependence {
    /// Fails where the correlations contradict one another.
    pub(crate) fn of(plan: &Plan) -> Result<Self, NoDesign> {
        let count = plan.inputs.len();
        let groups = groups(plan);
        if plan.correlations.is_empty() {
            return Ok(Self { factor: None, groups });
        }
        let mut matrix = DMatrix::identity(count, count);
        for correlation in &plan.correlations {
            let [i, j] = correlation.inputs;
            matrix[(i, j)] = correlation.coefficient;
            matrix[(j, i)] = correlation.coefficient;
        }
        let factor = Cholesky::new(matrix).ok_or(NoDesign::Contradiction)?.l();
        Ok(Self { factor: Some(factor), groups })
    }

    /// Whether no inputs vary together.
    pub(crate) fn is_independent(&self) -> bool {
        self.factor.is_none()
    }

    /// z = L w
    pub(crate) fn correlated(&self, independent: &[f64]) -> Vec<f64> {
        match &self.factor {
            None => independent.to_vec(),
            Some(factor) => {
                let row = |i: usize| (0..=i).map(|j| factor[(i, j)] * independent[j]).sum();
                (0..independent.len()).map(row).collect()
            }
        }
    }
}

/// The connected parts of the graph of correlations, each ascending, by their first inputs.
fn groups(plan: &Plan) -> Vec<Vec<usize>> {
    let mut group: Vec<usize> = (0..plan.inputs.len()).collect();
    for correlation in &plan.correlations {
        let [a, b] = correlation.inputs.map(|input| group[input]);
        group.iter_mut().filter(|of| **of == a.max(b)).for_each(|of| *of = a.min(b));
    }
    let members = |of: usize| -> Vec<usize> { (0..group.len()).filter(|&input| group[input] == of).collect() };
    (0..group.len()).map(members).filter(|members| !members.is_empty()).collect()
}

// -- The numbers of one sample's peel --

/// What one sample gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// The numbers that were asked for; none where the path does not have one, or was not computed as far
    pub values: Vec<Option<f64>>,
    /// Why its path was not computed to its end, if it was not
    pub cut_short: Option<String>,
}

impl Outcome {
    /// Of a model that there is not, and why.
    pub fn refused(numbers: usize, why: String) -> Self {
        Self { values: vec![None; numbers], cut_short: Some(why) }
    }
}

/// These numbers of a model's peel. Where they are of the initiation peak alone, no more of the path is followed than leads there. `stop` gives the
/// stop criteria of one path, anew for each.
pub fn peel_numbers(
    model: &PeelModel,
    of: &[PeelQuantity],
    accuracy: &Accuracy,
    stop: &dyn Fn() -> StopCriteria,
) -> Outcome {
    let of_initiation =
        |quantity| matches!(quantity, PeelQuantity::InitiationPeakForce | PeelQuantity::InitiationPeakDisplacement);
    if of.iter().all(|&quantity| of_initiation(quantity)) && can_be_followed(model) {
        initiation_peak(model, of, accuracy, stop)
    } else {
        whole(&peel(model, accuracy, &stop()), of)
    }
}

/// Whether the initiation peak can be had without the path behind it.
fn can_be_followed(model: &PeelModel) -> bool {
    model.friction_law().is_none()
        && model.adhesion.healing
        && !model.yields()
        && model.ground.substrate.is_flat()
        && model.steps.is_empty()
}

fn whole(peel: &Peel, of: &[PeelQuantity]) -> Outcome {
    let cut_short = match &peel.end {
        PathEnd::Failed(failure) => Some(failure.to_string()),
        PathEnd::Bound(bound) => Some(bound.to_string()),
        _ => None,
    };
    Outcome { values: of.iter().map(|quantity| quantity.value(peel)).collect(), cut_short }
}

fn initiation_peak(
    model: &PeelModel,
    of: &[PeelQuantity],
    accuracy: &Accuracy,
    stop: &dyn Fn() -> StopCriteria,
) -> Outcome {
    let here = |_| model.clone();
    let found = follow_point(PointKind::InitiationPeak, &[0.0], Spacing::Linear, &here, accuracy, stop, &|_| {});
    let point = found.rows.first().and_then(|row| row.point);
    let cut_short = found.remarks.iter().find_map(|remark| match remark {
        Remark::NotFound { reason, .. } => Some(reason.to_string()),
        _ => None,
    });
    let value = |quantity: &PeelQuantity| {
        point.map(|FollowedPoint { force, displacement, .. }| match quantity {
            PeelQuantity::InitiationPeakForce => force,
            _ => displacement,
        })
    };
    Outcome { values: of.iter().map(value).collect(), cut_short }
}
