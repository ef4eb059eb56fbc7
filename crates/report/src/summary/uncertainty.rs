//! What an uncertain peel gives, as one JSON object.

use super::origin::Origin;
use super::parameters::Parameters;
use super::written::written;
use crate::number::Finite;
use peelkit::study::uncertainty::{
    Analysis, Correlation, DerivativesBy, Estimate, Input, NumberAnalysis, Order, Propagation, SobolIndex, Statistics,
};
use peelkit_scene::{Key, Scene, find_key};
use serde::Serialize;

/// An uncertain peel as one object; `None` where a thing does not occur.
#[derive(Debug, Serialize)]
pub struct UncertaintySummary {
    #[serde(flatten)]
    origin: Origin,
    inputs: Vec<InputSummary>,
    correlations: Vec<CorrelationSummary>,
    sample: SampleSummary,
    cut_short: Vec<CutShortSummary>,
    /// By `sensitivities` or `differences`
    derivatives_by: &'static str,
    results: Vec<ResultSummary>,
    solve_s: Finite,
    parameters: Parameters,
}

#[derive(Debug, Serialize)]
struct InputSummary {
    key: String,
    /// Of its numbers; `None` where they have none
    unit: Option<&'static str>,
    distribution: &'static str,
    mean: Finite,
    deviation: Finite,
}

#[derive(Debug, Serialize)]
struct CorrelationSummary {
    keys: [String; 2],
    coefficient: Finite,
}

#[derive(Debug, Serialize)]
struct SampleSummary {
    asked: usize,
    samples: usize,
    computed: usize,
    cut_short: usize,
    replicates: usize,
    points: usize,
    seed: u64,
}

#[derive(Debug, Serialize)]
struct CutShortSummary {
    reason: String,
    count: usize,
    first_sample: usize,
}

#[derive(Debug, Serialize)]
struct ResultSummary {
    of: &'static str,
    count: usize,
    missing: usize,
    mean: Option<EstimateSummary>,
    deviation: Option<EstimateSummary>,
    smallest: Option<Finite>,
    largest: Option<Finite>,
    quantiles: Vec<QuantileSummary>,
    indices: Vec<IndexSummary>,
    at_means: Option<AtMeans>,
    propagation: Vec<PropagationSummary>,
    one_at_a_time: Vec<AloneSummary>,
}

#[derive(Debug, Serialize)]
struct EstimateSummary {
    value: Finite,
    error: Finite,
}

#[derive(Debug, Serialize)]
struct QuantileSummary {
    probability: Finite,
    value: Finite,
    from: Finite,
    to: Finite,
}

#[derive(Debug, Serialize)]
struct IndexSummary {
    keys: Vec<String>,
    first: Finite,
    first_error: Finite,
    total: Finite,
    total_error: Finite,
}

#[derive(Debug, Serialize)]
struct AtMeans {
    value: Finite,
    derivatives: Vec<DerivativeSummary>,
}

#[derive(Debug, Serialize)]
struct DerivativeSummary {
    key: String,
    /// Times the standard deviation of the input, in the unit of the result
    per_deviation: Finite,
}

#[derive(Debug, Serialize)]
struct PropagationSummary {
    order: u8,
    mean: Finite,
    deviation: Finite,
    mean_difference: EstimateSummary,
    deviation_difference: EstimateSummary,
    fails: bool,
}

#[derive(Debug, Serialize)]
struct AloneSummary {
    key: String,
    from: Finite,
    to: Finite,
    at_from: Option<Finite>,
    at_to: Option<Finite>,
}

impl UncertaintySummary {
    /// Of the analysis of a scene, which took so many seconds.
    pub fn new(scene: &Scene, analysis: &Analysis, solve_s: f64) -> Self {
        let design = &analysis.design;
        let plan = design.plan();
        let cut_short = analysis.cut_short();
        let correlation = |of: &Correlation| CorrelationSummary {
            keys: of.inputs.map(|input| plan.inputs[input].name.clone()),
            coefficient: Finite(of.coefficient),
        };
        Self {
            origin: Origin::of(scene),
            inputs: plan.inputs.iter().map(InputSummary::from).collect(),
            correlations: plan.correlations.iter().map(correlation).collect(),
            sample: SampleSummary {
                asked: plan.samples,
                samples: design.samples(),
                computed: analysis.computed(),
                cut_short: cut_short.iter().map(|of| of.count).sum(),
                replicates: design.replicates(),
                points: design.points(),
                seed: plan.seed,
            },
            cut_short: cut_short
                .into_iter()
                .map(|of| CutShortSummary { reason: of.reason, count: of.count, first_sample: of.first })
                .collect(),
            derivatives_by: match analysis.derivatives_by {
                DerivativesBy::Sensitivities => "sensitivities",
                DerivativesBy::Differences => "differences",
            },
            results: analysis.numbers.iter().map(|number| ResultSummary::of(analysis, number)).collect(),
            solve_s: Finite(solve_s),
            parameters: Parameters(scene.clone()),
        }
    }
}

written!(UncertaintySummary);

impl From<&Input> for InputSummary {
    fn from(Input { name, distribution }: &Input) -> Self {
        let unit = find_key(name).map_or("", Key::unit);
        Self {
            key: name.clone(),
            unit: Some(unit).filter(|unit| !unit.is_empty()),
            distribution: distribution.name(),
            mean: Finite(distribution.mean()),
            deviation: Finite(distribution.deviation()),
        }
    }
}

impl From<Estimate> for EstimateSummary {
    fn from(Estimate { value, error }: Estimate) -> Self {
        Self { value: Finite(value), error: Finite(error) }
    }
}

impl From<&Propagation> for PropagationSummary {
    fn from(of: &Propagation) -> Self {
        Self {
            order: match of.order {
                Order::First => 1,
                Order::Second => 2,
            },
            mean: Finite(of.mean),
            deviation: Finite(of.deviation),
            mean_difference: of.mean_difference.into(),
            deviation_difference: of.deviation_difference.into(),
            fails: of.fails(),
        }
    }
}

impl ResultSummary {
    fn of(analysis: &Analysis, number: &NumberAnalysis) -> Self {
        let plan = analysis.design.plan();
        let statistics = number.statistics.as_ref();
        let name = |input: usize| plan.inputs[input].name.clone();
        let index = |of: &SobolIndex| IndexSummary {
            keys: of.inputs.iter().map(|&input| name(input)).collect(),
            first: Finite(of.first.value),
            first_error: Finite(of.first.error),
            total: Finite(of.total.value),
            total_error: Finite(of.total.error),
        };
        let derivative = |(input, slope): (usize, &f64)| DerivativeSummary {
            key: name(input),
            per_deviation: Finite(slope * plan.inputs[input].distribution.deviation()),
        };
        let alone = |(input, at): (usize, &[Option<f64>; 2])| AloneSummary {
            key: name(input),
            from: Finite(analysis.alone[input].inputs[0]),
            to: Finite(analysis.alone[input].inputs[1]),
            at_from: at[0].map(Finite),
            at_to: at[1].map(Finite),
        };
        Self {
            of: number.of.name(),
            count: number.values.iter().flatten().count(),
            missing: number.values.iter().filter(|value| value.is_none()).count(),
            mean: statistics.map(|of| of.mean.into()),
            deviation: statistics.map(|of| of.deviation.into()),
            smallest: statistics.map(|of| Finite(of.smallest)),
            largest: statistics.map(|of| Finite(of.largest)),
            quantiles: statistics.map(quantiles).unwrap_or_default(),
            indices: number.indices.iter().map(index).collect(),
            at_means: number.taylor.as_ref().map(|taylor| AtMeans {
                value: Finite(taylor.value),
                derivatives: taylor.gradient.iter().enumerate().map(derivative).collect(),
            }),
            propagation: number.propagations.iter().map(PropagationSummary::from).collect(),
            one_at_a_time: number.alone.iter().enumerate().map(alone).collect(),
        }
    }
}

fn quantiles(of: &Statistics) -> Vec<QuantileSummary> {
    let quantile = |of: &peelkit::study::uncertainty::Quantile| QuantileSummary {
        probability: Finite(of.probability),
        value: Finite(of.value),
        from: Finite(of.from),
        to: Finite(of.to),
    };
    of.quantiles.iter().map(quantile).collect()
}
