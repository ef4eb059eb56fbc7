//! What an uncertain peel gives, as tables.

use crate::text_summary::number::{in_unit, short, with_error};
use peelkit::study::uncertainty::{Analysis, DerivativesBy, NumberAnalysis, Order, Propagation, Statistics};
use peelkit_report::unknown_error;
use peelkit_scene::{Key, Scene, find_key};
use std::fmt::Write;

/// What is uncertain, how it was sampled and what is to be said of that, and a block for each result.
pub fn uncertainty(scene: &Scene, analysis: &Analysis, remark: Option<&str>) -> String {
    let mut text = format!("{}\n\n{}", scene.title, sampled(analysis));
    if let Some(remark) = remark {
        let _ = writeln!(text, "{remark}");
    }
    for number in &analysis.numbers {
        text += &block(analysis, number);
    }
    let by = match analysis.derivatives_by {
        DerivativesBy::Sensitivities => {
            "Propagation: derivatives at the means of the inputs; second ones are differences of exact first ones."
        }
        DerivativesBy::Differences => {
            "Propagation: derivatives at the means of the inputs, by differences of whole computations."
        }
    };
    let _ = writeln!(text, "\nErrors are those of the sample, with a confidence of 95 %.\n{by}");
    if let Some(unknown) = unknown_error(scene) {
        let _ = writeln!(text, "{unknown}");
    }
    text
}

/// The inputs, and the design.
fn sampled(analysis: &Analysis) -> String {
    let design = &analysis.design;
    let plan = design.plan();
    let mut text = format!("{:<40} {:<12} {:>12} {:>12}\n", "uncertain", "distribution", "mean", "deviation");
    for input in &plan.inputs {
        let unit = find_key(&input.name).map_or("", Key::unit);
        let (mean, deviation) = (short(input.distribution.mean()), short(input.distribution.deviation()));
        let named = format!("{}{}", input.name, in_unit(unit));
        let _ = writeln!(text, "{named:<40} {:<12} {mean:>12} {deviation:>12}", input.distribution.name());
    }
    for of in &plan.correlations {
        let [first, second] = of.inputs.map(|input| plan.inputs[input].name.as_str());
        let _ = writeln!(text, "correlation of {first} and {second}: {}", of.coefficient);
    }
    let computed = analysis.computed();
    let missing =
        if computed < design.samples() { format!(", of which {computed} were computed") } else { String::new() };
    let _ = writeln!(
        text,
        "\n{} samples{missing}: {} replicates of {} points, {} samples to a point",
        design.samples(),
        design.replicates(),
        design.points(),
        design.rows()
    );
    for of in analysis.cut_short() {
        let _ = writeln!(text, "{} cut short, first sample {}: {}", of.count, of.first, of.reason);
    }
    text
}

fn block(analysis: &Analysis, number: &NumberAnalysis) -> String {
    let mut text = format!("\n{}\n", number.of.name());
    let missing = number.values.iter().filter(|value| value.is_none()).count();
    let Some(statistics) = &number.statistics else {
        return text + "  does not occur in enough samples\n";
    };
    if missing > 0 {
        let count = statistics.count;
        let _ = writeln!(text, "  does not occur in {missing} samples; what follows is of the other {count}");
    }
    let estimate = |name: &str, value: f64, error: f64| format!("  {name:<20} {}\n", with_error(value, error));
    text += &estimate("mean", statistics.mean.value, statistics.mean.error);
    text += &estimate("standard deviation", statistics.deviation.value, statistics.deviation.error);
    for of in &statistics.quantiles {
        let name = format!("quantile {:>2.0} %", 100.0 * of.probability);
        let _ = writeln!(text, "  {name:<20} {} ({} to {})", short(of.value), short(of.from), short(of.to));
    }
    for of in &number.propagations {
        text += &propagation(of, statistics);
    }
    text + &indices(analysis, number)
}

fn propagation(of: &Propagation, statistics: &Statistics) -> String {
    let name = match of.order {
        Order::First => "first-order",
        Order::Second => "second-order",
    };
    let differences = [("mean", of.mean_difference), ("deviation", of.deviation_difference)];
    let told: Vec<String> = differences
        .iter()
        .filter(|(_, difference)| of.is_failure(difference))
        .map(|(what, of)| {
            let percent = 100.0 * of.value / statistics.deviation.value;
            let error = 100.0 * of.error / statistics.deviation.value;
            format!("the {what} is off by {percent:+.1} % of the deviation (± {error:.1} %)")
        })
        .collect();
    let told = if told.is_empty() { String::new() } else { format!("; not enough here: {}", told.join(", ")) };
    format!("  {name:<20} mean {}, deviation {}{told}\n", short(of.mean), short(of.deviation))
}

/// The inputs, the largest total index first.
fn indices(analysis: &Analysis, number: &NumberAnalysis) -> String {
    if number.indices.is_empty() {
        return String::new();
    }
    let mut indices = number.indices.clone();
    indices.sort_by(|a, b| b.total.value.total_cmp(&a.total.value));
    let mut text = format!("  {:<40} {:>20} {:>20}\n", "share of the variance", "first order", "total");
    let name = |&input: &usize| analysis.design.plan().inputs[input].name.as_str();
    for of in &indices {
        let names = of.inputs.iter().map(name).collect::<Vec<_>>().join(" + ");
        let cell = |value: f64, error: f64| format!("{value:.4} ± {error:.4}");
        let (first, total) = (cell(of.first.value, of.first.error), cell(of.total.value, of.total.error));
        let _ = writeln!(text, "  {names:<40} {first:>20} {total:>20}");
    }
    let impossible = indices.iter().filter(|of| of.is_impossible()).count();
    if impossible > 0 {
        let _ = writeln!(
            text,
            "  the sample is too small for {impossible} of these: a total share is below its first order, or a share is negative, which is\n  \
             possible within the errors alone. Errors halve with four times the samples: uncertainty.samples = {}",
            4 * analysis.design.samples()
        );
    }
    text
}
