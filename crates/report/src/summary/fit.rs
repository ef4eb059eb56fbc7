//! What a fit found, as one JSON object: summary.json of `peel fit`, and what `--json` prints.

use super::origin::Origin;
use super::parameters::Parameters;
use super::written::written;
use crate::fit_report::FitReport;
use crate::number::Finite;
use peelkit::study::{FitEnd, PairDetermined, PointPlace};

/// A fit as one object. Parameters in the units of their keys, forces in nN, lengths in nm; `None` where a thing does not occur.
#[derive(Debug, serde::Serialize)]
pub struct FitSummary {
    #[serde(flatten)]
    origin: Origin,
    end: &'static str,
    /// Of the end `stopped`.
    reason: Option<String>,
    fitted: Vec<Fitted>,
    correlations: Vec<Vec<Option<Finite>>>,
    condition: Option<Finite>,
    combinations: Vec<Combined>,
    pairs: Vec<Pair>,
    data: Data,
    jump: Option<Jump>,
    sum_of_squares: Finite,
    degrees_of_freedom: usize,
    displacement_zero_nm: Finite,
    warnings: Vec<Warning>,
    paths: usize,
    weightings: usize,
    solve_s: Finite,
    /// The scene with the parameters that were found.
    parameters: Parameters,
}

#[derive(Debug, serde::Serialize)]
struct Fitted {
    key: String,
    unit: Option<&'static str>,
    initial: Finite,
    value: Finite,
    standard_error: Option<Finite>,
    interval: Option<[Finite; 2]>,
    profile_interval: Option<[Option<Finite>; 2]>,
    bounds: [Finite; 2],
    at_bound: bool,
    poorly_determined: bool,
}

#[derive(Debug, serde::Serialize)]
struct Combined {
    exponents: Vec<Finite>,
    relative_error: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Pair {
    keys: [String; 2],
    correlation: Finite,
    exponent: Option<Finite>,
    relative_error: Option<Finite>,
}

#[derive(Debug, serde::Serialize)]
struct Data {
    file: String,
    points: usize,
    behind_jump: usize,
    #[serde(rename = "estimated_error_nN")]
    estimated_error: Option<Finite>,
    before_start_of_model: usize,
    behind_jump_of_model: usize,
}

#[derive(Debug, serde::Serialize)]
struct Jump {
    displacement_nm: Finite,
    standard_error_nm: Finite,
    modelled_nm: Option<Finite>,
    used: bool,
}

#[derive(Debug, serde::Serialize)]
struct Warning {
    code: &'static str,
    text: String,
}

impl FitSummary {
    /// The summary of a fit.
    pub fn new(report: &FitReport) -> Self {
        let FitReport { scene, file, measured, fit, solve_s } = *report;
        let (end, reason) = match &fit.end {
            FitEnd::Converged => ("converged", None),
            FitEnd::Stopped(why) => ("stopped", Some(why.clone())),
            FitEnd::Interrupted => ("interrupted", None),
        };
        let fitted = |(index, parameter): (usize, &peelkit::study::FittedParameter)| Fitted {
            key: parameter.key.clone(),
            unit: Some(report.unit(index)).filter(|unit| !unit.is_empty()),
            initial: Finite(parameter.initial),
            value: Finite(parameter.value),
            standard_error: parameter.standard_error.map(Finite),
            interval: parameter.interval.map(|ends| ends.map(Finite)),
            profile_interval: parameter.profile.as_ref().map(|profile| profile.interval.map(|end| end.map(Finite))),
            bounds: parameter.bounds.map(Finite),
            at_bound: parameter.at_bound.is_some(),
            poorly_determined: parameter.poorly_determined,
        };
        let pair = |pair: &PairDetermined| Pair {
            keys: pair.parameters.map(|index| fit.parameters[index].key.clone()),
            correlation: Finite(pair.correlation),
            exponent: pair.exponent.map(Finite),
            relative_error: pair.relative_error.map(Finite),
        };
        let row = |row: &Vec<Option<f64>>| row.iter().map(|number| number.map(Finite)).collect();
        let combined = |found: &peelkit::study::Combination| Combined {
            exponents: found.exponents.iter().copied().map(Finite).collect(),
            relative_error: Finite(found.relative_error),
        };
        let jump = fit.jump.map(|jump| Jump {
            displacement_nm: Finite(jump.displacement),
            standard_error_nm: Finite(jump.error),
            modelled_nm: jump.modelled.map(Finite),
            used: jump.used,
        });
        let warnings = fit.warnings();
        Self {
            origin: Origin::of(scene),
            end,
            reason,
            fitted: fit.parameters.iter().enumerate().map(fitted).collect(),
            correlations: fit.correlations.iter().map(row).collect(),
            condition: fit.condition.map(Finite),
            combinations: fit.combinations.iter().map(combined).collect(),
            pairs: fit.pairs.iter().map(pair).collect(),
            data: Data {
                file: file.to_owned(),
                points: fit.points.len(),
                behind_jump: measured.behind_jump.len(),
                estimated_error: fit.estimated_error.map(Finite),
                before_start_of_model: fit.count(PointPlace::BeforeStart),
                behind_jump_of_model: fit.count(PointPlace::BehindJump),
            },
            jump,
            sum_of_squares: Finite(fit.sum_of_squares),
            degrees_of_freedom: fit.degrees_of_freedom,
            displacement_zero_nm: Finite(fit.displacement_zero),
            warnings: warnings.iter().map(|w| Warning { code: w.code(), text: w.to_string() }).collect(),
            paths: fit.paths,
            weightings: fit.weightings,
            solve_s: Finite(solve_s),
            parameters: Parameters(report.fitted_scene()),
        }
    }
}

written!(FitSummary);
