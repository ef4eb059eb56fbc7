//! The columns of the tables.

use super::key;
use crate::output_key::OutputKey;

/// Of observed.csv.
#[rustfmt::skip]
pub const OBSERVED_COLUMNS: &[OutputKey] = &[
    key("branch", "whether the machine retreats or returns"),
    key("machine_displacement_nm", "U of the machine"),
    key("displacement_nm", "u of the grip"),
    key("force_nN", "P"),
    key("work_aJ", "∫ P dU"),
    key("front_nm", "length that adheres, by its energy"),
    key("jump", "whether the beam has jumped to this point"),
    key("adheres", "what adheres: `pad`, `edge`, `end face` or `nothing`"),
];

/// Of states.csv: the columns that are the same at all places of a state. The others are those of [`crate::STATE_FIELDS`].
#[rustfmt::skip]
pub const STATE_COLUMNS: &[OutputKey] = &[
    key("state", "number of the state from 0, in path order; the time of states.pvd"),
    key("limit_point", "`load` or `displacement` where the state is a limit point, else empty"),
    key("path_position", "0 at the beginning of the path, 1 at its end"),
    key("displacement_nm", "u"),
    key("force_nN", "P"),
];
