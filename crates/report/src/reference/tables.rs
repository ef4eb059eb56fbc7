//! The columns of the tables.

use super::key;
use crate::output_key::OutputKey;

/// Of states.csv: the columns that are the same at all places of a state. The others are those of [`crate::STATE_FIELDS`].
#[rustfmt::skip]
pub const STATE_COLUMNS: &[OutputKey] = &[
    key("state", "number of the state from 0, in path order; the time of states.pvd"),
    key("limit_point", "`load` or `displacement` where the state is a limit point, else empty"),
    key("path_position", "0 at the beginning of the path, 1 at its end"),
    key("displacement_nm", "u"),
    key("force_nN", "P"),
];
