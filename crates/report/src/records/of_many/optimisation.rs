//! An optimisation: history.csv, its designs in the order in which they were evaluated, and the object summary.json.

use crate::records::summary::{Found, Summary};
use crate::writing::error::ReportError;
use crate::writing::names::unknown_error;
use crate::writing::record::write_table;
use crate::writing::record::{Fields, Record};
use crate::writing::reference::Output;
use peelkit::study::optimisation::{
    ActiveConstraint, Certificate, DerivativeFreeCheck, Design, DesignProblem, DesignVariable, Evaluation, Goal,
    Objective, Optimum, SearchResult, volume,
};
use peelkit_scene::{Key, Scene, find_key};
use std::path::{Path, PathBuf};

/// A design of a search.
struct HistoryRow<'a> {
    search: usize,
    evaluation: usize,
    design: &'a Evaluation,
    best: Option<f64>,
    violation: f64,
    problem: &'a DesignProblem<'a>,
}

impl Record for HistoryRow<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("search", "which search, from 0", |row| row.search);
        of.field("evaluation", "which of its designs, from 0", |row| row.evaluation);
        of.field("objective", "to the accuracy of the search; empty where the design has none", |row| row.design.log_value.map(f64::exp));
        of.field("best_objective", "of the best feasible design so far", |row| row.best.map(f64::exp));
        of.field("violation", "by how much the worst constraint is violated", |row| row.violation);
        of.field("largest_slope", "largest derivative of the logarithm of the objective by a variable, over its range; empty where none was computed", |row| row.design.gradient.iter().map(|slope| slope.abs()).reduce(f64::max));
        of.field("values", "the variables in their order, separated by spaces", |row| numbers(&row.problem.values(&row.design.coordinates)));
    }
}

/// The values in one cell.
fn numbers(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}

/// As the searches have it.
const FEASIBLE: f64 = 1e-7;

/// Writes `dir/history.csv`: every design of every search.
///
/// Fails with [`ReportError::Write`].
pub fn write_history(dir: &Path, problem: &DesignProblem, optimum: &Optimum) -> Result<PathBuf, ReportError> {
    let sign = if problem.goal == Goal::Maximise { -1.0 } else { 1.0 };
    let mut rows = Vec::new();
    for (search, result) in optimum.searches.iter().enumerate() {
        let mut best: Option<f64> = None;
        for (evaluation, design) in result.evaluations.iter().enumerate() {
            let violation = problem.violation(&design.coordinates);
            let better = |value: &f64| best.is_none_or(|best| sign * value < sign * best);
            if violation <= FEASIBLE {
                best = design.log_value.filter(better).or(best);
            }
            rows.push(HistoryRow { search, evaluation, design, best, violation, problem });
        }
    }
    write_table(dir, "history.csv", rows)
}

/// What was found of a problem.
#[derive(Clone, Copy)]
pub struct Optimised<'a> {
    problem: &'a DesignProblem<'a>,
    optimum: &'a Optimum,
    unknown_error: Option<&'static str>,
    solve_s: f64,
}

/// An optimisation as one object.
pub type OptimisationSummary<'a> = Summary<'a, Optimised<'a>>;

impl<'a> OptimisationSummary<'a> {
    /// Of what was found of this problem of the scene, in so many seconds.
    pub fn new(scene: &'a Scene, problem: &'a DesignProblem, optimum: &'a Optimum, solve_s: f64) -> Self {
        Summary::of(scene, Optimised { problem, optimum, unknown_error: unknown_error(scene), solve_s })
    }
}

impl Record for Optimised<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("of", "the number that is optimised, by its name in the summary of `peel run`", |found| found.problem.objective.quantity().name());
        of.field("goal", "`maximise` or `minimise`", |found| goal_word(found.problem.goal));
        of.field("holding_angle_rad", "angle of the pull above the line of a ratio; null where the objective is none", |found| found.angles().map(|[holding, _]| holding));
        of.field("release_angle_rad", "angle of the pull below the line", |found| found.angles().map(|[_, release]| release));
        of.field("before", "the design of the scene", |found| DesignFound { problem: found.problem, design: &found.optimum.before });
        of.field("after", "the best design", |found| DesignFound { problem: found.problem, design: &found.optimum.after });
        of.field("gain", "objective after over objective before", |found| found.optimum.gain);
        of.field("gain_error", "bound on the error of that", |found| found.optimum.gain_error);
        of.field("variables", "what is free: parameters, then widths and heights from the free end on", |found| found.variables());
        of.field("constraints", "how many constraints there are beside the bounds", |found| found.problem.constraints.len());
        of.field("searches", "an object for each search; the last one is that without gradients where `optimise.check` is true", |found| found.optimum.searches.as_slice());
        of.field("best_search", "which of them has found the best design, from 0", |found| found.optimum.best_search);
        of.field("certificate", "why the best design is an optimum; null after an interruption", |found| found.optimum.certificate.as_ref());
        of.field("unfinished", "whether it was interrupted", |found| found.optimum.unfinished);
        of.field("unknown_error", "of a seta and of a pull at a rate: which part of the errors of the objective has no bound; else null", |found| found.unknown_error);
        of.group("timing", "time", |of| of.field("solve_s", "of all searches and the certificate", |found| found.solve_s));
    }
}

impl Found for Optimised<'_> {
    const PARAMETERS: &'static str = "the scene as it was computed, units in the names";
}

fn goal_word(goal: Goal) -> &'static str {
    match goal {
        Goal::Maximise => "maximise",
        Goal::Minimise => "minimise",
    }
}

impl<'a> Optimised<'a> {
    /// Of both peels of a ratio.
    fn angles(&self) -> Option<[f64; 2]> {
        match self.problem.objective {
            Objective::Ratio { holding_angle, release_angle, .. } => Some([holding_angle, release_angle]),
            Objective::Quantity(_) => None,
        }
    }

    fn variables(&self) -> Vec<VariableFound<'a>> {
        let Self { optimum, .. } = *self;
        let variables = self.problem.variables.iter().enumerate();
        variables.map(|(index, variable)| VariableFound { variable, index, optimum }).collect()
    }
}

struct DesignFound<'a> {
    problem: &'a DesignProblem<'a>,
    design: &'a Design,
}

impl Record for DesignFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("objective", "the objective, in the unit of `of`; a ratio has none", |found| found.design.objective);
        of.field("error", "bound on its error; null where the number of the peel has none", |found| found.design.error);
        of.field("volume_nm3", "volume of the body, nm³", |found| (found.problem.model)(&found.design.values).map(|model| volume(&model)));
    }
}

struct VariableFound<'a> {
    variable: &'a DesignVariable,
    index: usize,
    optimum: &'a Optimum,
}

impl Record for VariableFound<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("name", "the key of the scene, or the column of the profile and its place", |found| found.variable.name.as_str());
        of.field("unit", "of its numbers here; null where it is a plain number", |found| unit(found.variable));
        of.field("lower", "lower bound", |found| found.variable.lower);
        of.field("upper", "upper bound", |found| found.variable.upper);
        of.field("before", "in the design of the scene", |found| found.optimum.before.values[found.index]);
        of.field("after", "in the best design", |found| found.optimum.after.values[found.index]);
        of.field("error", "how far it is from there to where the gradient vanishes, at most; null under constraints and of more than four free variables", |found| found.optimum.value_errors.as_ref().map(|errors| errors[found.index]));
    }
}

fn unit(variable: &DesignVariable) -> Option<&'static str> {
    let unit = match variable.along {
        Some(_) => "nm",
        None => find_key(&variable.name).map_or("", Key::unit),
    };
    Some(unit).filter(|unit| !unit.is_empty())
}

impl Record for SearchResult {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("evaluations", "designs that it evaluated", |search| search.evaluations.len());
        of.field("bad", "how many of them have no such number, or could not be computed", |search| search.evaluations.iter().filter(|design| design.log_value.is_none()).count());
        of.field("objective", "the best that it found; null where that is none", |search| search.evaluations[search.best?].log_value.map(f64::exp));
        of.field("end", "`converged`, `no-better-step`, `most-evaluations` or `interrupted`", |search| search.end.word());
    }
}

impl Record for Certificate {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("gradient", "largest derivative of the logarithm of the objective by a variable, over its range from bound to bound; null without derivatives", |found| found.gradient);
        of.field("projected_gradient", "what active bounds and constraints leave of it: zero at an optimum", |found| found.projected_gradient);
        of.field("active", "bounds and constraints that hold the optimum", |found| found.active.as_slice());
        of.group("neighbours", "random feasible designs beside the optimum", |of| {
            of.field("computed", "how many have an objective", |found| found.neighbours.computed);
            of.field("bad", "how many have none", |found| found.neighbours.bad);
            of.field("better", "how many are better by more than the error of the search", |found| found.neighbours.better);
            of.field("largest_gain", "logarithm of the best of them over the optimum: below zero where none is better", |found| (found.neighbours.computed > 0).then_some(found.neighbours.largest_gain));
        });
        of.field("check", "what a search without gradients found from the optimum on; null where it was not asked for", |found| found.check);
    }
}

impl Record for ActiveConstraint {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("name", "which", |active| active.name.as_str());
        of.field("multiplier", "what the logarithm of the objective would gain if it gave way by 1, or by the range of the variable", |active| active.multiplier);
    }
}

impl Record for DerivativeFreeCheck {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("gain", "logarithm of its best over the optimum", |check| check.gain);
        of.field("evaluations", "designs that it evaluated", |check| check.evaluations);
    }
}

/// The table and the object.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::object("peel optimise --json", OptimisationSummary::keys()),
        Output::table("history.csv", HistoryRow::keys()),
    ]
}
