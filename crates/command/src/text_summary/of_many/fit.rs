//! A fit, laid out for a person.

use crate::text_summary::number::in_columns;
use crate::text_summary::number::{short, spaced, with_error};
use peelkit::study::{FitEnd, FittedParameter};
use peelkit_report::{FitReport, unknown_error};
use std::fmt::Write;

/// The parameters with their errors, their correlations, the residuals and what is not to be trusted.
pub fn fit(report: &FitReport) -> String {
    let FitReport { scene, measured, fit, solve_s, against } = report;
    let mut lines: Vec<(&str, String)> = Vec::new();
    let what = against.map_or("points".to_owned(), |key| format!("steady forces against {}", key.path()));
    for (index, (curve, (file, measured))) in fit.curves.iter().zip(*measured).enumerate() {
        let behind = match measured.behind_jump.len() {
            0 => String::new(),
            points => format!("; {points} behind the jump are not fitted"),
        };
        let text = format!("{} {what} of {file}{behind}", curve.points.len());
        lines.push((if index == 0 { "data" } else { "" }, text));
        if let Some(jump) = curve.jump {
            let modelled = jump.modelled.map_or("none".to_owned(), |at| format!("{at:.6} nm"));
            let used = if jump.used { "" } else { ", not a datum" };
            let measured = with_error(jump.displacement, jump.error);
            lines.push(("first jump", format!("measured at {measured} nm, of the model {modelled}{used}")));
        }
    }
    let freedom = fit.degrees_of_freedom;
    let errors = match fit.estimated_error {
        Some(error) => {
            let place =
                fit.estimated_displacement_error.map(|place| format!(" and of a displacement {} nm", short(place)));
            format!("standard error of a force {} nN{}, estimated from them", short(error), place.unwrap_or_default())
        }
        None => {
            let place = fit.estimated_displacement_error.map(short);
            let place =
                place.map(|place| format!(", standard error of a displacement {place} nm, estimated from them"));
            format!("chi² {} of {freedom} degrees of freedom{}", short(fit.sum_of_squares), place.unwrap_or_default())
        }
    };
    lines.push(("residuals", errors));
    for (k, warning) in fit.warnings().iter().enumerate() {
        lines.push((if k == 0 { "warnings" } else { "" }, warning.to_string()));
    }
    lines.push((
        "end",
        match &fit.end {
            FitEnd::Converged => "converged".to_owned(),
            FitEnd::Stopped(why) => format!("stopped: {why}"),
            FitEnd::Interrupted => "interrupted: the best parameters so far".to_owned(),
        },
    ));
    lines.extend(unknown_error(scene).map(|unknown| ("errors", unknown.to_owned())));
    let cost = format!("{} paths, {} weightings, {:.0} ms", fit.paths, fit.weightings, 1e3 * solve_s);
    lines.push(("computational cost", cost));
    in_columns(&scene.title, &lines) + &parameters(report) + &correlations(report)
}

fn parameters(report: &FitReport) -> String {
    let all = &report.fit.parameters;
    let name = |k: usize| format!("{}{}", all[k].key, spaced(report.unit(k)));
    let width = (0..all.len()).map(|k| name(k).chars().count()).max().unwrap_or(0);
    let heading = "parameter";
    let mut text = format!("\n  {heading:<width$}  {:>12}  {:>24}  95 % interval", "began at", "value");
    let profiled = all.iter().any(|parameter| parameter.profile.is_some());
    text += if profiled { "             by profile likelihood\n" } else { "\n" };
    for (k, parameter) in all.iter().enumerate() {
        let found = match parameter.standard_error {
            Some(error) => with_two_digits(parameter.value, error),
            None => format!("{} (bound)", short(parameter.value)),
        };
        let interval = parameter.interval.map_or("-".to_owned(), |[low, high]| {
            let error = parameter.standard_error.unwrap_or(0.0);
            format!("{} to {}", digits(low, error), digits(high, error))
        });
        let began = short(parameter.initial);
        let line = format!("  {:<width$}  {began:>12}  {found:>24}  {interval:<24}  {}", name(k), profile(parameter));
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

/// The interval by the profile, where there is one.
fn profile(parameter: &FittedParameter) -> String {
    let Some(profile) = &parameter.profile else { return String::new() };
    let error = parameter.standard_error.unwrap_or(0.0);
    let end = |end: Option<f64>| end.map_or("not bounded".to_owned(), |value| digits(value, error));
    format!("{} to {}", end(profile.interval[0]), end(profile.interval[1]))
}

/// Correlations as a table, where there are several parameters.
fn correlations(report: &FitReport) -> String {
    let fit = report.fit;
    if fit.parameters.len() < 2 {
        return String::new();
    }
    let width = fit.parameters.iter().map(|parameter| parameter.key.chars().count()).max().unwrap_or(0);
    let mut text = "\n  correlations\n".to_owned();
    for (parameter, row) in fit.parameters.iter().zip(&fit.correlations) {
        let cell = |number: &Option<f64>| number.map_or("     -".to_owned(), |number| format!("{number:6.3}"));
        let cells: Vec<String> = row.iter().map(cell).collect();
        let _ = writeln!(text, "    {:<width$}  {}", parameter.key, cells.join("  "));
    }
    text
}

/// A number to two digits of its error.
fn digits(value: f64, error: f64) -> String {
    if !(error > 0.0 && error.is_finite()) || value.abs() >= 1e6 || (value != 0.0 && value.abs() < 1e-6) {
        return short(value);
    }
    let decimals = (1.0 - error.log10().floor()).clamp(0.0, 12.0) as usize;
    format!("{value:.decimals$}")
}

fn with_two_digits(value: f64, error: f64) -> String {
    format!("{} ± {}", digits(value, error), digits(error, error))
}
