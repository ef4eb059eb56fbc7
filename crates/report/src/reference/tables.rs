//! The columns of the tables.

use super::key;
use crate::output_key::OutputKey;

/// Of curve.csv.
#[rustfmt::skip]
pub const CURVE_COLUMNS: &[OutputKey] = &[
    key("displacement_nm", "u of the grip along the pull"),
    key("force_nN", "P of the grip along the pull"),
    key("end_rotation_rad", "rotation of the grip"),
    key("work_aJ", "∫ P du from the beginning of the path; with the moment of a grip that rotates as it goes"),
    key("negative_eigenvalues", "number of unstable directions under displacement control; 0: stable. For `force-only`, which has no energy, the number of negative pivots, of which only the parity is meaningful"),
    key("negative_eigenvalues_load", "the same under force control; for a grip that rotates as it pulls, under control of P + `turn` · M"),
    key("front_nm", "length that still adheres, by its energy"),
    key("newton_iterations", "that the point took"),
    key("negative_eigenvalues_out_of_plane", "with `--out-of-plane`: number of unstable directions out of the plane, grip free to roll, whether displacement or force is held; else empty"),
    key("torque_nN_nm", "in space, like the next four: moment of the grip on its roll; 0 where that is free"),
    key("roll_deg", "roll of the grip, about its axis"),
    key("yaw_deg", "yaw of the grip, about the normal of the substrate"),
    key("reaction_across_nN", "force of the grip normal to the pull, in its vertical plane; 0 where it is free"),
    key("reaction_lateral_nN", "force of the grip normal to that plane; 0 where it is free"),
];

/// Of limit_points.csv.
#[rustfmt::skip]
pub const LIMIT_POINT_COLUMNS: &[OutputKey] = &[
    key("kind", "`displacement` (du = 0) or `load` (dP = 0)"),
    key("displacement_nm", "u there"),
    key("force_nN", "P there"),
    key("end_rotation_rad", "rotation of the grip there"),
    key("work_aJ", "work of the grip from the beginning of the path to there"),
    key("error_nm", "bound of the error of the displacement"),
    key("error_nN", "bound of the error of the force"),
    key("flat", "whether the force is so level there that the displacement cannot be determined and does not matter"),
    key("after_point", "it lies behind this row of curve.csv, counted from 0"),
    key("error_aJ", "bound of the error of the work; empty with friction and for a load without a potential"),
    key("torque_nN_nm", "in space, like the next four: moment of the grip on its roll there; 0 where that is free"),
    key("roll_deg", "roll of the grip there"),
    key("yaw_deg", "yaw of the grip there"),
    key("reaction_across_nN", "force of the grip there normal to the pull, in its vertical plane; 0 where it is free"),
    key("reaction_lateral_nN", "force of the grip there normal to that plane; 0 where it is free"),
];

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

/// Of sweep.csv, without the columns that repeat the values under the names of their keys. An empty cell: the thing does not occur, or was
/// not computed.
#[rustfmt::skip]
pub const SWEEP_COLUMNS: &[OutputKey] = &[
    key("value", "of the key that is varied, in nm, GPa, aJ, J/m2, N/m, nN, rad, rad/nm or s, or a plain number"),
    key("value_2", "of the second key, where two are varied"),
    key("peak_force_nN", "force of `peak`, the largest up to the first jump"),
    key("peak_error_nN", "its bound"),
    key("peak_displacement_nm", "u at the peak"),
    key("peak_error_nm", "its bound"),
    key("initiation_peak_nN", "the first local maximum of the force"),
    key("initiation_peak_error_nN", "its bound"),
    key("initiation_peak_displacement_nm", "u there"),
    key("initiation_peak_error_nm", "its bound"),
    key("plateau_force_nN", "force of the plateau"),
    key("plateau_error_nN", "its bound"),
    key("plateau_displacement_nm", "u there"),
    key("plateau_error_nm", "how far from there the force changes as little"),
    key("snap_off_displacement_nm", "u at the first jump"),
    key("snap_off_error_nm", "its bound"),
    key("snap_off_force_nN", "P at the first jump"),
    key("snap_off_error_nN", "its bound"),
    key("work_aJ", "work to the first jump, or to the end of a path without one, which is not the work of peeling: see `work_to`"),
    key("work_error_aJ", "its bound"),
    key("work_to", "where `work_aJ` goes to: `first jump` or `end of path`"),
    key("pad_detachment_displacement_nm", "u where the pad comes off"),
    key("pad_detachment_error_nm", "its bound"),
    key("pad_detachment_force_nN", "P there"),
    key("pad_detachment_error_nN", "its bound"),
    key("pad_detachment_work_aJ", "work to there"),
    key("pad_detachment_work_error_aJ", "its bound"),
    key("detachment_displacement_nm", "u where all comes off"),
    key("detachment_error_nm", "its bound"),
    key("detachment_force_nN", "P there"),
    key("detachment_error_nN", "its bound"),
    key("detachment_work_aJ", "work to there"),
    key("detachment_work_error_aJ", "its bound"),
    key("largest_computed_force_nN", "where there is no peak; without a bound"),
    key("end", "how its path ended"),
    key("accuracy_reached", "largest relative bound of this value"),
    key("solve_s", "time of this value"),
    key("points", "points of its path"),
    key("newton_iterations", "on all meshes"),
    key("elements", "of the final mesh"),
    key("order", "of the elements"),
];
