//! The tables of an uncertain peel: statistics.csv, indices.csv and samples.csv.

use super::table::write_table;
use crate::error::ReportError;
use crate::file::write_whole;
use crate::number::Finite;
use crate::swept_keys::column;
use peelkit::study::uncertainty::{Analysis, NumberAnalysis};
use peelkit_scene::find_key;
use serde::Serialize;
use std::io;
use std::path::{Path, PathBuf};

/// One row of statistics.csv or of indices.csv: what is known of a result, or of a result and what of it comes from one input.
#[derive(Debug, Default, Serialize)]
struct StatisticsLine {
    result: &'static str,
    count: usize,
    missing: usize,
    mean: Option<Finite>,
    mean_error: Option<Finite>,
    deviation: Option<Finite>,
    deviation_error: Option<Finite>,
    smallest: Option<Finite>,
    quantile_01: Option<Finite>,
    quantile_05: Option<Finite>,
    quantile_25: Option<Finite>,
    quantile_50: Option<Finite>,
    quantile_75: Option<Finite>,
    quantile_95: Option<Finite>,
    quantile_99: Option<Finite>,
    largest: Option<Finite>,
    first_order_mean: Option<Finite>,
    first_order_deviation: Option<Finite>,
    second_order_mean: Option<Finite>,
    second_order_deviation: Option<Finite>,
}

#[derive(Debug, Default, Serialize)]
struct IndexLine {
    result: &'static str,
    /// Those that vary together with a plus sign between
    keys: String,
    first: Finite,
    first_error: Finite,
    total: Finite,
    total_error: Finite,
}

/// Writes statistics.csv, and indices.csv where indices were estimated.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_uncertainty(dir: &Path, analysis: &Analysis) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![write_table(dir, "statistics.csv", analysis.numbers.iter().map(StatisticsLine::from))?];
    let lines: Vec<IndexLine> = analysis.numbers.iter().flat_map(|number| index_lines(analysis, number)).collect();
    if !lines.is_empty() {
        files.push(write_table(dir, "indices.csv", lines.into_iter())?);
    }
    Ok(files)
}

impl From<&NumberAnalysis> for StatisticsLine {
    fn from(number: &NumberAnalysis) -> Self {
        let line = Self {
            result: number.of.name(),
            count: number.values.iter().flatten().count(),
            missing: number.values.iter().filter(|value| value.is_none()).count(),
            ..Self::default()
        };
        let Some(of) = &number.statistics else { return line };
        let quantile = |k: usize| of.quantiles.get(k).map(|quantile| Finite(quantile.value));
        let order = |k: usize| number.propagations.get(k);
        Self {
            mean: Some(Finite(of.mean.value)),
            mean_error: Some(Finite(of.mean.error)),
            deviation: Some(Finite(of.deviation.value)),
            deviation_error: Some(Finite(of.deviation.error)),
            smallest: Some(Finite(of.smallest)),
            quantile_01: quantile(0),
            quantile_05: quantile(1),
            quantile_25: quantile(2),
            quantile_50: quantile(3),
            quantile_75: quantile(4),
            quantile_95: quantile(5),
            quantile_99: quantile(6),
            largest: Some(Finite(of.largest)),
            first_order_mean: order(0).map(|of| Finite(of.mean)),
            first_order_deviation: order(0).map(|of| Finite(of.deviation)),
            second_order_mean: order(1).map(|of| Finite(of.mean)),
            second_order_deviation: order(1).map(|of| Finite(of.deviation)),
            ..line
        }
    }
}

fn index_lines(analysis: &Analysis, number: &NumberAnalysis) -> Vec<IndexLine> {
    let name = |&input: &usize| analysis.design.plan().inputs[input].name.as_str();
    let line = |of: &peelkit::study::uncertainty::SobolIndex| IndexLine {
        result: number.of.name(),
        keys: of.inputs.iter().map(name).collect::<Vec<_>>().join(" + "),
        first: Finite(of.first.value),
        first_error: Finite(of.first.error),
        total: Finite(of.total.value),
        total_error: Finite(of.total.error),
    };
    number.indices.iter().map(line).collect()
}

/// Writes samples.csv: one row a sample that was computed, with its place in the design, its inputs and its results.
///
/// Fails with [`ReportError::Write`] where the file cannot be written.
pub fn write_samples(dir: &Path, analysis: &Analysis) -> Result<PathBuf, ReportError> {
    let path = dir.join("samples.csv");
    let text = samples(analysis).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}

fn samples(analysis: &Analysis) -> io::Result<Vec<u8>> {
    let design = &analysis.design;
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = design
        .plan()
        .inputs
        .iter()
        .map(|of| find_key(&of.name).map_or_else(|_| of.name.clone(), |key| column(key, key.unit())));
    let results = analysis.numbers.iter().map(|number| number.of.name().to_owned());
    let fixed = ["sample", "replicate", "point", "row"].map(str::to_owned);
    writer.write_record(fixed.into_iter().chain(names).chain(results).chain(["cut_short".to_owned()]))?;
    for (sample, outcome) in analysis.outcomes.iter().enumerate() {
        let Some(outcome) = outcome else { continue };
        let at = design.place(sample);
        let place = [sample, at.replicate, at.point, at.row].map(|number| number.to_string());
        let inputs = design.inputs(at).into_iter().map(|input| format!("{input}"));
        let values = outcome.values.iter().map(|value| value.map_or_else(String::new, |value| format!("{value}")));
        let cut_short = outcome.cut_short.clone().unwrap_or_default();
        writer.write_record(place.into_iter().chain(inputs).chain(values).chain([cut_short]))?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}
