//! The designs of an optimisation in the order in which they were evaluated.

use super::table::write_table;
use crate::error::ReportError;
use crate::number::Finite;
use peelkit::study::optimisation::{DesignProblem, Evaluation, Goal, Optimum};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// A row of history.csv.
#[derive(Default, Serialize)]
struct HistoryLine {
    search: usize,
    evaluation: usize,
    objective: Option<Finite>,
    best_objective: Option<Finite>,
    violation: Finite,
    largest_slope: Option<Finite>,
    values: String,
}

/// Writes `dir/history.csv`: every design of every search.
///
/// Fails with [`ReportError::Write`].
pub fn write_history(dir: &Path, problem: &DesignProblem, optimum: &Optimum) -> Result<PathBuf, ReportError> {
    let sign = if problem.goal == Goal::Maximise { -1.0 } else { 1.0 };
    let mut lines = Vec::new();
    for (search, result) in optimum.searches.iter().enumerate() {
        let mut best: Option<f64> = None;
        for (evaluation, design) in result.evaluations.iter().enumerate() {
            let violation = problem.violation(&design.coordinates);
            let better = |value: &f64| best.is_none_or(|best| sign * value < sign * best);
            if violation <= FEASIBLE {
                best = design.log_value.filter(better).or(best);
            }
            lines.push(HistoryLine {
                search,
                evaluation,
                objective: design.log_value.map(|value| Finite(value.exp())),
                best_objective: best.map(|value| Finite(value.exp())),
                violation: Finite(violation),
                largest_slope: largest_slope(design),
                values: numbers(&problem.values(&design.coordinates)),
            });
        }
    }
    write_table(dir, "history.csv", lines.into_iter())
}

/// As the searches have it.
const FEASIBLE: f64 = 1e-7;

fn largest_slope(design: &Evaluation) -> Option<Finite> {
    design.gradient.iter().map(|slope| slope.abs()).reduce(f64::max).map(Finite)
}

/// The values in one cell.
fn numbers(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}
