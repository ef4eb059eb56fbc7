//! An uncertain peel: statistics.csv, indices.csv, samples.csv, and the object summary.json.

use crate::records::summary::{Found, Summary};
use crate::swept::column;
use crate::writing::error::ReportError;
use crate::writing::names::unknown_error;
use crate::writing::record::{Content, Fields, Object, Record, columns, csv};
use crate::writing::record::{write_table, write_text};
use crate::writing::reference::{Output, merged};
use peelkit::study::uncertainty::{
    Analysis, Correlation, CutShort, DerivativesBy, Estimate, Input, NumberAnalysis, Order, Propagation, Quantile,
    SobolIndex,
};
use peelkit_scene::{Key, Scene, find_key};
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// What is known of a result as a row.
struct StatisticsRow<'a>(&'a NumberAnalysis);

impl Record for StatisticsRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("result", "by its name in the summary of `peel run`", |row| row.0.of.name());
        of.field("count", "samples that have it", |row| count(row.0));
        of.field("missing", "samples that do not", |row| missing(row.0));
        of.field("mean", "mean", |row| Some(row.0.statistics.as_ref()?.mean.value));
        of.field("mean_error", "half the width of its confidence interval of 95 %", |row| Some(row.0.statistics.as_ref()?.mean.error));
        of.field("deviation", "standard deviation", |row| Some(row.0.statistics.as_ref()?.deviation.value));
        of.field("deviation_error", "half the width of its confidence interval of 95 %", |row| Some(row.0.statistics.as_ref()?.deviation.error));
        of.field("smallest", "smallest of the samples", |row| Some(row.0.statistics.as_ref()?.smallest));
        of.field("quantile_01", "below this are 1 % of the distribution", |row| row.quantile(0));
        of.field("quantile_05", "5 %", |row| row.quantile(1));
        of.field("quantile_25", "25 %", |row| row.quantile(2));
        of.field("quantile_50", "50 %: the median", |row| row.quantile(3));
        of.field("quantile_75", "75 %", |row| row.quantile(4));
        of.field("quantile_95", "95 %", |row| row.quantile(5));
        of.field("quantile_99", "99 %", |row| row.quantile(6));
        of.field("largest", "largest of the samples", |row| Some(row.0.statistics.as_ref()?.largest));
        of.field("first_order_mean", "mean by linear propagation", |row| Some(row.propagated(0)?.mean));
        of.field("first_order_deviation", "standard deviation by linear propagation", |row| Some(row.propagated(0)?.deviation));
        of.field("second_order_mean", "mean by propagation with second derivatives", |row| Some(row.propagated(1)?.mean));
        of.field("second_order_deviation", "standard deviation likewise", |row| Some(row.propagated(1)?.deviation));
    }
}

impl StatisticsRow<'_> {
    fn quantile(&self, index: usize) -> Option<f64> {
        Some(self.0.statistics.as_ref()?.quantiles.get(index)?.value)
    }

    /// By a polynomial of the first or the second order, where there are statistics to hold it against.
    fn propagated(&self, order: usize) -> Option<&Propagation> {
        self.0.statistics.as_ref().and_then(|_| self.0.propagations.get(order))
    }
}

/// Samples that have a number.
fn count(number: &NumberAnalysis) -> usize {
    number.values.iter().flatten().count()
}

/// Samples that have none.
fn missing(number: &NumberAnalysis) -> usize {
    number.values.iter().filter(|value| value.is_none()).count()
}

/// What of a result comes from one input.
struct IndexRow<'a> {
    analysis: &'a Analysis,
    number: &'a NumberAnalysis,
    index: &'a SobolIndex,
}

impl Record for IndexRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("result", "by its name in the summary of `peel run`", |row| row.number.of.name());
        of.field("keys", "of indices.csv, like the next four: an input, or all that vary together", |row| names(row.analysis, &row.index.inputs).join(" + "));
        of.field("first", "first-order index of Sobol", |row| row.index.first.value);
        of.field("first_error", "half the width of its confidence interval of 95 %", |row| row.index.first.error);
        of.field("total", "total index of Sobol", |row| row.index.total.value);
        of.field("total_error", "half the width of its confidence interval of 95 %", |row| row.index.total.error);
    }
}

/// The keys of these inputs.
fn names<'a>(analysis: &'a Analysis, inputs: &[usize]) -> Vec<&'a str> {
    inputs.iter().map(|&input| name(analysis, input)).collect()
}

fn name(analysis: &Analysis, input: usize) -> &str {
    &analysis.design.plan().inputs[input].name
}

/// Writes statistics.csv, and indices.csv where indices were estimated.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_uncertainty(dir: &Path, analysis: &Analysis) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![write_table(dir, "statistics.csv", analysis.numbers.iter().map(StatisticsRow))?];
    let rows: Vec<_> = analysis
        .numbers
        .iter()
        .flat_map(|number| number.indices.iter().map(move |index| IndexRow { analysis, number, index }))
        .collect();
    if !rows.is_empty() {
        files.push(write_table(dir, "indices.csv", rows)?);
    }
    Ok(files)
}

/// Where a sample stands in the design.
struct SamplePlace {
    sample: usize,
    replicate: usize,
    point: usize,
    row: usize,
}

impl Record for SamplePlace {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("sample", "number of the sample from 0", |at| at.sample);
        of.field("replicate", "its scrambled Sobol sequence", |at| at.replicate);
        of.field("point", "its point in that", |at| at.point);
        of.field("row", "0: A, 1: B, 2 and more: A with the inputs of one group from B", |at| at.row);
    }
}

/// How the path of a sample ended.
struct SampleEnd<'a>(Option<&'a str>);

impl Record for SampleEnd<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("cut_short", "why its path was not computed to the end, if it was not", |end| end.0);
    }
}

/// Writes samples.csv: one row a sample that was computed, with its place in the design, its inputs and its results.
///
/// Fails with [`ReportError::Write`] where the file cannot be written.
pub fn write_samples(dir: &Path, analysis: &Analysis) -> Result<PathBuf, ReportError> {
    let design = &analysis.design;
    let inputs = design.plan().inputs.iter();
    let inputs = inputs.map(|of| find_key(&of.name).map_or_else(|_| of.name.clone(), |key| column(key, key.unit())));
    let results = analysis.numbers.iter().map(|number| number.of.name().to_owned());
    let own: Vec<String> = inputs.chain(results).collect();
    let header = [columns::<SamplePlace>(), own.clone(), columns::<SampleEnd>()].concat();
    let rows = analysis.outcomes.iter().enumerate().filter_map(|(sample, outcome)| {
        let outcome = outcome.as_ref()?;
        let at = design.place(sample);
        let Object(mut row) = SamplePlace { sample, replicate: at.replicate, point: at.point, row: at.row }.object();
        let numbers = design.inputs(at).into_iter().map(Some).chain(outcome.values.iter().copied());
        let cell = |number: Option<f64>| number.map(|number| number.to_string()).cell();
        row.extend(own.iter().map(|name| Cow::from(name.clone())).zip(numbers.map(cell)));
        row.extend(SampleEnd(outcome.cut_short.as_deref()).object().0);
        Some(Object(row))
    });
    write_text(dir, "samples.csv", csv(&header, rows))
}

/// The analysis of an uncertain peel.
#[derive(Clone, Copy, Debug)]
pub struct UncertainPeel<'a> {
    analysis: &'a Analysis,
    unknown_error: Option<&'static str>,
    solve_s: f64,
}

/// An uncertain peel as one object.
pub type UncertaintySummary<'a> = Summary<'a, UncertainPeel<'a>>;

impl<'a> UncertaintySummary<'a> {
    /// Of the analysis of a scene, which took so many seconds.
    pub fn new(scene: &'a Scene, analysis: &'a Analysis, solve_s: f64) -> Self {
        Summary::of(scene, UncertainPeel { analysis, unknown_error: unknown_error(scene), solve_s })
    }
}

impl Record for UncertainPeel<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("inputs", "what is uncertain", |found| found.analysis.design.plan().inputs.as_slice());
        of.field("correlations", "inputs that vary together; empty where all are independent", |found| found.correlations());
        of.group("sample", "how it was sampled", |of| {
            of.field("asked", "`uncertainty.samples`", |found| found.analysis.design.plan().samples);
            of.field("samples", "samples of the design: as many as make whole replicates", |found| found.analysis.design.samples());
            of.field("computed", "how many of them were computed: fewer after Ctrl-C", |found| found.analysis.computed());
            of.field("cut_short", "how many of these were not computed to the end of their path; results that were reached before count", |found| found.analysis.cut_short().iter().map(|cut| cut.count).sum::<usize>());
            of.field("replicates", "independent scrambled Sobol sequences, whose spread gives every error here", |found| found.analysis.design.replicates());
            of.field("points", "points of each sequence", |found| found.analysis.design.points());
            of.field("seed", "`uncertainty.seed`", |found| found.analysis.design.plan().seed);
        });
        of.field("cut_short", "why samples were cut short, the most frequent reason first", |found| found.analysis.cut_short());
        of.field("derivatives_by", "where the derivatives at the means come from: `sensitivities` or, with friction for example, `differences`", |found| derivatives_word(found.analysis.derivatives_by));
        of.field("results", "an object for each result that was asked for", |found| found.results());
        of.field("unknown_error", "of a seta and of a pull at a rate: which part of the errors of the results has no bound; else null", |found| found.unknown_error);
        of.field("solve_s", "time of all peels of this command", |found| found.solve_s);
    }
}

impl Found for UncertainPeel<'_> {
    const PARAMETERS: &'static str = "the scene, as in the summary of `peel run`";
}

fn derivatives_word(by: DerivativesBy) -> &'static str {
    match by {
        DerivativesBy::Sensitivities => "sensitivities",
        DerivativesBy::Differences => "differences",
    }
}

impl<'a> UncertainPeel<'a> {
    fn correlations(&self) -> Vec<Correlated<'a>> {
        let Self { analysis, .. } = *self;
        analysis.design.plan().correlations.iter().map(|of| Correlated { analysis, of }).collect()
    }

    fn results(&self) -> Vec<ResultFound<'a>> {
        let Self { analysis, .. } = *self;
        analysis.numbers.iter().map(|number| ResultFound { analysis, number }).collect()
    }
}

impl Record for Input {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("key", "the key of the scene", |input| input.name.as_str());
        of.field("unit", "of its numbers here; null where it is a plain number", |input| Some(find_key(&input.name).map_or("", Key::unit)).filter(|unit| !unit.is_empty()));
        of.field("distribution", "`normal`, `lognormal`, `uniform` or `triangular`", |input| input.distribution.name());
        of.field("mean", "mean of the distribution", |input| input.distribution.mean());
        of.field("deviation", "its standard deviation", |input| input.distribution.deviation());
    }
}

/// Two inputs that vary together.
struct Correlated<'a> {
    analysis: &'a Analysis,
    of: &'a Correlation,
}

impl Record for Correlated<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("keys", "the two keys", |pair| pair.of.inputs.map(|input| name(pair.analysis, input)));
        of.field("coefficient", "correlation of the normal numbers behind them", |pair| pair.of.coefficient);
    }
}

impl Record for CutShort {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("reason", "of the first such sample; others may have other numbers in it", |found| found.reason.as_str());
        of.field("count", "how many", |found| found.count);
        of.field("first_sample", "the first of them, a row of samples.csv", |found| found.first);
    }
}

/// One result.
struct ResultFound<'a> {
    analysis: &'a Analysis,
    number: &'a NumberAnalysis,
}

impl Record for ResultFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("of", "the result, by its name in the summary of `peel run`; its unit ends the name", |found| found.number.of.name());
        of.field("count", "samples that have it", |found| count(found.number));
        of.field("missing", "samples that do not; all that follows is of the others", |found| missing(found.number));
        of.field("mean", "its mean; null where fewer than two replicates have it", |found| Some(found.number.statistics.as_ref()?.mean));
        of.field("deviation", "its standard deviation", |found| Some(found.number.statistics.as_ref()?.deviation));
        of.field("smallest", "smallest of the samples", |found| Some(found.number.statistics.as_ref()?.smallest));
        of.field("largest", "largest of the samples", |found| Some(found.number.statistics.as_ref()?.largest));
        of.field("quantiles", "its quantiles", |found| found.number.statistics.as_ref().map_or(&[][..], |all| &all.quantiles));
        of.field("indices", "Sobol's sensitivity indices; empty with `indices` = false", |found| found.indices());
        of.field("at_means", "the result with all inputs at their means; null where it does not occur there", |found| found.at_means());
        of.field("propagation", "what derivatives at the means give, beside the sample", |found| found.number.propagations.as_slice());
        of.field("one_at_a_time", "the result where one input is at a quantile and all others at their means", |found| found.one_at_a_time());
    }
}

impl<'a> ResultFound<'a> {
    fn indices(&self) -> Vec<Index<'a>> {
        let Self { analysis, number } = *self;
        number.indices.iter().map(|index| Index { analysis, index }).collect()
    }

    fn at_means(&self) -> Option<AtMeans<'a>> {
        let taylor = self.number.taylor.as_ref()?;
        Some(AtMeans { analysis: self.analysis, value: taylor.value, gradient: &taylor.gradient })
    }

    fn one_at_a_time(&self) -> Vec<Alone<'a>> {
        let Self { analysis, number } = *self;
        number.alone.iter().enumerate().map(|(input, &at)| Alone { analysis, input, at }).collect()
    }
}

impl Record for Estimate {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "estimate", |found| found.value);
        of.field("error", "half the width of its confidence interval of 95 %", |found| found.error);
    }
}

impl Record for Quantile {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("probability", "share of the distribution below", |found| found.probability);
        of.field("value", "estimate", |found| found.value);
        of.field("from", "where its confidence interval of 95 % begins", |found| found.from);
        of.field("to", "where that ends", |found| found.to);
    }
}

/// What of the result comes from some inputs.
struct Index<'a> {
    analysis: &'a Analysis,
    index: &'a SobolIndex,
}

impl Record for Index<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("keys", "an input, or all inputs that vary together", |found| names(found.analysis, &found.index.inputs));
        of.field("first", "share of the variance that would go if these inputs were known", |found| found.index.first.value);
        of.field("first_error", "half the width of its confidence interval of 95 %", |found| found.index.first.error);
        of.field("total", "share of the variance that would stay if all other inputs were known", |found| found.index.total.value);
        of.field("total_error", "half the width of its confidence interval of 95 %", |found| found.index.total.error);
    }
}

/// The result where all inputs are at their means.
struct AtMeans<'a> {
    analysis: &'a Analysis,
    value: f64,
    gradient: &'a [f64],
}

impl Record for AtMeans<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("value", "its value", |found| found.value);
        of.field("derivatives", "its first derivatives", |found| found.derivatives());
    }
}

impl<'a> AtMeans<'a> {
    fn derivatives(&self) -> Vec<Derivative<'a>> {
        let input = |(input, &slope)| Derivative { input: &self.analysis.design.plan().inputs[input], slope };
        self.gradient.iter().enumerate().map(input).collect()
    }
}

/// Of the result by an input.
struct Derivative<'a> {
    input: &'a Input,
    slope: f64,
}

impl Record for Derivative<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("key", "by which input", |found| found.input.name.as_str());
        of.field("per_deviation", "the derivative times the standard deviation of the input", |found| found.slope * found.input.distribution.deviation());
    }
}

impl Record for Propagation {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("order", "1: linear; 2: with second derivatives", |found| order_number(found.order));
        of.field("mean", "mean of that polynomial at the samples", |found| found.mean);
        of.field("deviation", "its standard deviation", |found| found.deviation);
        of.field("mean_difference", "mean of the polynomial less that of the result, at the same samples", |found| found.mean_difference);
        of.field("deviation_difference", "the same of the standard deviations", |found| found.deviation_difference);
        of.field("fails", "whether one of the two differences is larger than its error and than 1 % of the standard deviation", |found| found.fails());
    }
}

fn order_number(order: Order) -> u32 {
    match order {
        Order::First => 1,
        Order::Second => 2,
    }
}

/// The result where one input is at a quantile and all others are at their means.
struct Alone<'a> {
    analysis: &'a Analysis,
    input: usize,
    at: [Option<f64>; 2],
}

impl Record for Alone<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("key", "the input", |found| name(found.analysis, found.input));
        of.field("from", "its quantile of 5 %", |found| found.analysis.alone[found.input].inputs[0]);
        of.field("to", "its quantile of 95 %", |found| found.analysis.alone[found.input].inputs[1]);
        of.field("at_from", "the result at the first; null where it does not occur", |found| found.at[0]);
        of.field("at_to", "the result at the second; null likewise", |found| found.at[1]);
    }
}

/// The tables and the object.
pub(crate) fn outputs() -> Vec<Output> {
    let samples = [SamplePlace::keys(), SampleEnd::keys()].concat();
    vec![
        Output::object("summary.json of peel uncertainty", UncertaintySummary::keys()),
        Output::table("statistics.csv and indices.csv", merged(StatisticsRow::keys(), IndexRow::keys())),
        Output::table("samples.csv", samples),
    ]
}
