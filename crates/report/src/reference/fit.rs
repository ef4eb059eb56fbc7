//! The keys and columns of `peel fit`.

use super::key;
use crate::output_key::OutputKey;

/// Of summary.json of `peel fit`, and of what `--json` prints.
#[rustfmt::skip]
pub const FIT_SUMMARY: &[OutputKey] = &[
    key("version", "of the program"),
    key("schema", "number of this set of keys and columns"),
    key("command", "the command line"),
    key("scene", "the scene as it was named on the command line"),
    key("title", "its title"),
    key("end", "`converged`; `stopped`: before the least sum of squares; `interrupted`: by Ctrl-C. The parameters are the best so far"),
    key("reason", "why the search stopped; else null"),
    key("fitted", "the parameters, in the order of the scene"),
    key("fitted[].key", "the key of the scene"),
    key("fitted[].unit", "of its numbers here; null where it is a plain number"),
    key("fitted[].initial", "where the search began: the value of the scene"),
    key("fitted[].value", "where it ended"),
    key("fitted[].standard_error", "standard error of the value; null at a bound"),
    key("fitted[].interval", "95 % confidence interval from the standard error, cut at the bounds of the search; null at a bound"),
    key("fitted[].profile_interval", "95 % interval of the profile likelihood, an end null where it is not bounded; null where there is no profile"),
    key("fitted[].bounds", "between which it was searched for"),
    key("fitted[].at_bound", "whether the search ended at one of them"),
    key("fitted[].poorly_determined", "whether half its interval is more than 10 % of its value"),
    key("correlations", "of the parameters, or of their logarithms where they are above zero: a row a parameter; null at a bound"),
    key("condition", "largest over least singular value of the derivatives of the residuals by the parameters; null where the least is zero"),
    key("combinations", "products of powers of the parameters above zero whose errors are independent, the largest first"),
    key("combinations[].exponents", "of the parameters, in their order; their squares add up to 1"),
    key("combinations[].relative_error", "standard error of the logarithm of the product"),
    key("pairs", "two parameters that the curve hardly tells apart, one of them poorly determined"),
    key("pairs[].keys", "their keys"),
    key("pairs[].correlation", "of the two"),
    key("pairs[].exponent", "e: what is determined is the first times the second to the power e; null where one may be zero"),
    key("pairs[].relative_error", "standard error of the logarithm of that; null likewise"),
    key("data", "what was measured"),
    key("data.file", "the file as it was named on the command line"),
    key("data.points", "points that were fitted"),
    key("data.behind_jump", "points behind the measured jump, which were not"),
    key("data.estimated_error_nN", "standard error of a force, estimated from the residuals; null where it was given"),
    key("data.before_start_of_model", "points before the path of the model begins"),
    key("data.behind_jump_of_model", "points behind the first jump of the model"),
    key("jump", "the first jump; null where none was measured"),
    key("jump.displacement_nm", "measured displacement of the machine there, half-way between the points around it"),
    key("jump.standard_error_nm", "its standard error"),
    key("jump.modelled_nm", "of the fitted model; null where its branch has no end"),
    key("jump.used", "whether it is a datum"),
    key("sum_of_squares", "of the residuals over their standard errors"),
    key("degrees_of_freedom", "data less parameters"),
    key("displacement_zero_nm", "the measured displacement at which the displacement of the model is zero"),
    key("warnings", "what is not to be trusted"),
    key("warnings[].code", "a word that stays the same, for programs"),
    key("warnings[].text", "what it says, with numbers and what to try"),
    key("paths", "how many paths were computed"),
    key("weightings", "how often residuals were weighted anew"),
    key("solve_s", "time of the fit"),
    key("parameters", "the scene with the parameters that were found"),
];

/// Of fit.csv.
#[rustfmt::skip]
pub const FIT_COLUMNS: &[OutputKey] = &[
    key("displacement_nm", "as measured"),
    key("force_nN", "as measured"),
    key("modelled_nN", "force of the fitted model"),
    key("standard_error_nN", "of the measured force, with what that of its displacement adds"),
    key("residual", "modelled less measured force, over that"),
    key("weight", "how much the point counts: 1 with `loss = \"squares\"`, less for one far from the curve with another"),
    key("place", "`branch`; `before start`: before the path of the model begins; `behind jump`: behind its first jump"),
];

/// Of profiles.csv.
#[rustfmt::skip]
pub const PROFILE_COLUMNS: &[OutputKey] = &[
    key("key", "the parameter that is held"),
    key("value", "at which it is held"),
    key("excess", "by how much the least sum of squares with it held is larger than the least of all"),
];
