//! The keys and columns of `peel optimise`.

use super::{key, like};
use crate::output_key::OutputKey;

/// Of summary.json of `peel optimise`, and of what `--json` prints.
#[rustfmt::skip]
pub const OPTIMISATION_SUMMARY: &[OutputKey] = &[
    key("version", "of the program"),
    key("schema", "number of this set of keys and columns"),
    key("command", "the command line"),
    key("scene", "the scene as it was named on the command line"),
    key("title", "its title"),
    key("of", "the number of the peel that is optimised, by its name in the summary of `peel run`"),
    key("goal", "`maximise` or `minimise`"),
    key("holding_angle_rad", "angle of the pull above the line of a ratio; null where the objective is none"),
    key("release_angle_rad", "angle of the pull below the line"),
    key("before", "the design of the scene"),
    key("before.objective", "the objective, in the unit of `of`; a ratio has none"),
    key("before.error", "bound on its error; null where the number of the peel has none"),
    key("before.volume_nm3", "volume of the body, nm³"),
    like("after", "before", "the best design"),
    key("gain", "objective after over objective before"),
    key("gain_error", "bound on the error of that"),
    key("variables", "what is free: parameters, then widths and heights from the free end on"),
    key("variables[].name", "the key of the scene, or the column of the profile and its place"),
    key("variables[].unit", "of its numbers here; null where it is a plain number"),
    key("variables[].lower", "lower bound"),
    key("variables[].upper", "upper bound"),
    key("variables[].before", "in the design of the scene"),
    key("variables[].after", "in the best design"),
    key("variables[].error", "how far it is from there to where the gradient vanishes, at most; null under constraints and of more than four free variables"),
    key("constraints", "how many constraints there are beside the bounds"),
    key("searches", "an object for each search; the last one is that without gradients where `optimise.check` is true"),
    key("searches[].evaluations", "designs that it evaluated"),
    key("searches[].bad", "how many of them have no such number, or could not be computed"),
    key("searches[].objective", "the best that it found; null where that is none"),
    key("searches[].end", "`converged`, `no-better-step`, `most-evaluations` or `interrupted`"),
    key("best_search", "which of them has found the best design, from 0"),
    key("certificate", "why the best design is an optimum; null after an interruption"),
    key("certificate.gradient", "largest derivative of the logarithm of the objective by a variable, over its range from bound to bound; null without derivatives"),
    key("certificate.projected_gradient", "what active bounds and constraints leave of it: zero at an optimum"),
    key("certificate.active", "bounds and constraints that hold the optimum"),
    key("certificate.active[].name", "which"),
    key("certificate.active[].multiplier", "what the logarithm of the objective would gain if it gave way by 1, or by the range of the variable"),
    key("certificate.neighbours", "random feasible designs beside the optimum"),
    key("certificate.neighbours.computed", "how many have an objective"),
    key("certificate.neighbours.bad", "how many have none"),
    key("certificate.neighbours.better", "how many are better by more than the error of the search"),
    key("certificate.neighbours.largest_gain", "logarithm of the best of them over the optimum: below zero where none is better"),
    key("certificate.check", "what a search without gradients found from the optimum on; null where it was not asked for"),
    key("certificate.check.gain", "logarithm of its best over the optimum"),
    key("certificate.check.evaluations", "designs that it evaluated"),
    key("unfinished", "whether it was interrupted"),
    key("timing", "time"),
    key("timing.solve_s", "of all searches and the certificate"),
    key("parameters", "the scene as it was computed, units in the names"),
];

/// Of history.csv.
#[rustfmt::skip]
pub const HISTORY_COLUMNS: &[OutputKey] = &[
    key("search", "which search, from 0"),
    key("evaluation", "which of its designs, from 0"),
    key("objective", "to the accuracy of the search; empty where the design has none"),
    key("best_objective", "of the best feasible design so far"),
    key("violation", "by how much the worst constraint is violated"),
    key("largest_slope", "largest derivative of the logarithm of the objective by a variable, over its range; empty where none was computed"),
    key("values", "the variables in their order, separated by spaces"),
];
