//! The keys of the summary of a pull-off of a seta, and the columns of its tables.

use super::{key, like};
use crate::output_key::OutputKey;

/// Of `peel run` of a scene with a seta.
#[rustfmt::skip]
pub const SETA_SUMMARY: &[OutputKey] = &[
    key("version", "of the program"),
    key("schema", "number of this set of keys and columns, as of a peel"),
    key("command", "the command line; null where a program of another kind has written the summary"),
    key("scene", "the scene as it was named on the command line"),
    key("title", "its title"),
    key("end", "`detached`; `still-attached` where tips adhere when the root has moved as far as the seta is high; `bound`: a limit of `[bounds]` was reached; `failed`: the computation stopped short"),
    key("reason", "why, with numbers; null where the end says it"),
    key("tips", "number of tips"),
    key("peak", "the equilibrium of the pull with the largest force along the pull: a maximum, or just before an event or behind it; on the finest mesh that `mesh_error` names; null where the pull was not begun"),
    key("peak.force_nN", "force on the root along the pull"),
    key("peak.displacement_nm", "how far the root has moved in the pull"),
    key("peak.location_error_nN", "how far the force of the maximum, or of the event, that was looked for may lie from `force_nN`, with mesh and law of the tips as they are; null where nothing was located, so that the peak is the largest force of the equilibria that were computed"),
    key("peak.location_error_nm", "the same of `displacement_nm`"),
    key("peak.tips_attached", "number of tips that adhere"),
    key("peak.largest_tip_load_nN", "of all tips the largest force away from the ground"),
    key("peak.largest_tip_push_nN", "of all tips the largest force towards the ground; 0 where none is pressed"),
    key("peak.tip_loads_sum_nN", "sum of the forces of the tips away from the ground: the force on the root along the normal"),
    key("mesh_error", "of the peak, which is computed again with elements of rising order until its force changes by no more than `accuracy.relative`; null where no finer mesh came to it: it is then that of the curve, and its error is not known"),
    key("mesh_error.force_nN", "by how much the force differs from that with elements one order lower"),
    key("mesh_error.displacement_nm", "the same of the displacement"),
    key("mesh_error.order", "order of the elements of the peak"),
    key("mesh_error.curve_nN", "by how much the largest force of curve.csv, whose elements have order `accuracy.order`, differs from that of the peak"),
    like("first_detachment", "peak", "just before the first detachment of a tip in the pull, else null"),
    like("last_detachment", "peak", "just before the last one, else null"),
    key("events", "where tips detach or adhere again, or beams buckle, the root held"),
    key("events.count", "how many"),
    key("events.tips_detached", "tips that detached in all of them"),
    key("events.tips_adhered", "tips that adhered again in all of them"),
    key("events.most_tips_at_once", "changes of tips in the largest event"),
    key("events.buckled", "events that begin with beams that buckle: a loss of stability in which no tip takes part"),
    key("balance", "what became of the work of the root, over all steps"),
    key("balance.work_aJ", "the work"),
    key("balance.released_aJ", "energy released in events"),
    key("balance.energy_change_aJ", "change of the stored energy and of that of adhesion"),
    key("balance.imbalance", "the difference, over the largest of the three"),
    key("tip", "the law of each tip"),
    key("tip.law", "what the tips follow: `curve`, the normal pull of their spatula; `table`, see `tip_table`"),
    key("tip.peak_force_nN", "largest force of the curve of its normal pull"),
    key("tip.snap_off_displacement_nm", "displacement at which the tip alone snaps off"),
    key("tip.energy_at_rest_aJ", "energy of the adhering tip at rest against a detached one"),
    key("tip_table", "the table that the tips follow, as it is in the last pull-off; null where they follow the curve of their normal pull"),
    key("tip_table.rows", "its nodes: equilibria of the spatula on both branches"),
    key("tip_table.press_nm", "how far below the height without a normal force it begins"),
    key("tip_table.rotation_rad", "its range of θ"),
    key("tip_table.relative_error", "bound of its error, over the largest force and the largest moment; `seta.tip_tolerance` is what was asked"),
    key("tip_table.normal_force_error_nN", "bound of the error of the normal force of one tip"),
    key("tip_table.moment_error_nN_nm", "the same for the moment"),
    key("tip_table.pull_offs", "how often the seta was pulled off: once, and once more each time the table has grown"),
    key("tip_table.rows_added", "rows of the last table more than of the first"),
    key("tip_table.tips_outside_first", "tips that were in equilibrium outside of the first table"),
    key("tip_table.tips_outside", "tips that were so outside of the last one: above 0 their forces are extrapolated"),
    key("tip_table.first_peak_force_nN", "peak force by the first table, null where there was none"),
    key("tip_table.peak_force_change_nN", "by how much the peak force by the last table differs from it"),
    key("tip_table.resolve_within_nm", "how near to where they snap off tips were solved as spatulae; null where all followed the table"),
    key("tip_table.tips_resolved", "tips that were solved so in the last pull-off"),
    key("tip_table.tips_unresolved", "tips of which no spatula was found in an equilibrium of the seta: they followed the table there"),
    key("tip_table.resolved_force_change_nN", "largest change of the normal force of a tip against the table, in equilibria of the seta"),
    key("tip_table.resolved_moment_change_nN_nm", "the same for the moment"),
    key("tip_table.resolved_peak_force_change_nN", "by how much the spatulae change the peak force of the curve against that by the table alone"),
    key("warnings", "what is not to be trusted"),
    key("warnings[].code", "a word that stays the same, for programs: `outside-table`, tips were outside of their table before or behind the peak; `peak-outside-table`, at the peak or next to it"),
    key("warnings[].text", "what it says, with numbers"),
    key("path", "computational cost"),
    key("path.points", "equilibria of the pull-off"),
    key("path.newton_iterations", "Newton iterations"),
    key("path.elements", "elements of the tree"),
    key("timing", "wall clock"),
    key("timing.tip_s", "of the law of the tips"),
    key("timing.solve_s", "of the pull-off"),
    key("timing.mesh_error_s", "of the peak on finer meshes"),
    key("parameters", "the scene as it was computed, with its defaults: its tables as objects, units in the names"),
];

/// Of curve.csv of a seta.
#[rustfmt::skip]
pub const SETA_CURVE_COLUMNS: &[OutputKey] = &[
    key("step", "number of the step of the loading, from 1; the pull is the last one"),
    key("displacement_nm", "how far the root has moved in the step"),
    key("travel_nm", "how far it has moved in all steps"),
    key("force_nN", "force on the root along the direction of the step, positive where it is pulled"),
    key("tips_attached", "number of tips that adhere"),
    key("root_x_nm", "place of the root from where it is when the plane of the tips is the ground"),
    key("root_y_nm", "the same along the normal of the ground"),
    key("root_z_nm", "the same along z"),
    key("force_x_nN", "force on the root along x"),
    key("force_y_nN", "along the normal of the ground"),
    key("force_z_nN", "along z"),
    key("moment_x_nN_nm", "moment on the root about x"),
    key("moment_y_nN_nm", "about the normal of the ground"),
    key("moment_z_nN_nm", "about z"),
    key("energy_aJ", "stored energy and that of adhesion, against a detached stress-free seta"),
    key("work_aJ", "work of the root from the start"),
    key("released_aJ", "energy released in events from the start"),
];

/// Of events.csv of a seta.
#[rustfmt::skip]
pub const SETA_EVENT_COLUMNS: &[OutputKey] = &[
    key("event", "number of the event, from 1: the tips that change while the root is held. One that begins with beams that buckle has a row of its own before those of its tips"),
    key("step", "number of the step of the loading, from 1; not of a pull at a rate"),
    key("time_s", "of a pull at a rate: since it began"),
    key("displacement_nm", "how far the root has moved in the step"),
    key("loss", "of a pull at a rate: `end-of-branch` where tips come to the end of the branch of their law, `unstable` where they soften faster than the seta holds them"),
    key("tip", "number of the tip, from 0; like all columns of a tip empty where beams buckle"),
    key("tip_x_nm", "place of the tip in the stress-free configuration, along x"),
    key("tip_z_nm", "the same along z"),
    key("change", "`detaches` or `adheres`; `buckles` in the row of beams that buckle"),
    key("tip_load_nN", "force of the tip away from the ground before the event"),
    key("force_before_nN", "force on the root along the direction of the step before the event"),
    key("force_after_nN", "the same behind it"),
    key("tips_attached", "number of tips that adhere behind the event"),
    key("released_aJ", "energy released in the event, with all of its tips"),
];

/// Of tips.csv of a seta.
#[rustfmt::skip]
pub const SETA_TIP_COLUMNS: &[OutputKey] = &[
    key("moment", "`first-detachment`, `peak` or `last-detachment` of the pull, or `end`"),
    key("tip", "number of the tip, from 0"),
    key("tip_x_nm", "place of the tip in the stress-free configuration, along x"),
    key("tip_z_nm", "the same along z"),
    key("state", "`attached`: its force grows as it is pulled; `detaching`: it falls; `detached`"),
    key("height_nm", "height of the tip above its place of adhesion"),
    key("load_x_nN", "force that the tip exerts on the ground along x"),
    key("load_y_nN", "along the normal: positive where it pulls the ground upwards"),
    key("load_z_nN", "along z"),
];

/// Of tip.csv of a seta.
#[rustfmt::skip]
pub const SETA_TIP_CURVE_COLUMNS: &[OutputKey] = &[
    key("displacement_nm", "height of the tip above its place of adhesion; below zero where it is pressed"),
    key("force_nN", "force along the normal"),
    key("slope_nN_per_nm", "its derivative by the displacement"),
    key("energy_aJ", "energy of the tip against a detached one"),
];
