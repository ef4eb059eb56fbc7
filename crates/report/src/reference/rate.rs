//! The keys of the summary of a pull at a rate, and the columns of its curve and of a sweep.

use super::key;
use crate::output_key::OutputKey;

/// Of `peel run` of a scene with a rate.
#[rustfmt::skip]
pub const RATE_SUMMARY: &[OutputKey] = &[
    key("version", "of the program"),
    key("schema", "number of this set of keys and columns, as of a peel"),
    key("command", "the command line; null where a program of another kind has written the summary"),
    key("scene", "the scene as it was named on the command line"),
    key("title", "its title"),
    key("end", "`detached`: nothing adheres any more; `still-attached` where the grip came to rest before; `failed`: the computation stopped short"),
    key("reason", "why it stopped short; else null"),
    key("tips", "of a seta: number of tips"),
    key("events", "of a seta: where tips leave the branch of their law"),
    key("events.count", "how many"),
    key("events.tips_detached", "tips that detached in all of them"),
    key("events.tips_adhered", "tips that adhered again in all of them"),
    key("events.most_tips_at_once", "changes of tips in the largest event"),
    key("events.unstable", "events that are losses of stability: the tips soften faster than the seta holds them"),
    key("tip", "of a seta: the law of each tip"),
    key("tip.law", "what the tips follow: `curve`, the normal pull of their spatula"),
    key("tip.peak_force_nN", "largest force of its curve"),
    key("tip.snap_off_displacement_nm", "displacement at which the tip alone snaps off"),
    key("tip.energy_at_rest_aJ", "energy of the adhering tip at rest against a detached one"),
    key("largest_force", "the largest force of the pull"),
    key("largest_force.force_nN", "of a beam by a parabola through the three steps next to it, of a seta that of a step"),
    key("largest_force.displacement_nm", "of what moves the grip, or the root"),
    key("largest_force.time_s", "since the pull began"),
    key("largest_force.kinetic_aJ", "kinetic energy at the step next to it"),
    key("largest_force.dissipated_aJ", "dissipated up to that step"),
    key("largest_force.tips_attached", "of a seta: number of tips that adhere there"),
    key("contact_lost_s", "when nothing adheres any more for the first time; else null"),
    key("equilibria_peak", "first peak of the equilibria of the same scene, of a seta its peak; null where they have none"),
    key("equilibria_peak.force_nN", "its force"),
    key("equilibria_peak.displacement_nm", "its displacement"),
    key("equilibria_peak.error_nN", "bound of the error of its force; of a seta the error with which it is located, null where it is not"),
    key("force_over_equilibria", "largest force of the pull over the peak of the equilibria; null without one"),
    key("balance", "what became of the work, from rest to the end"),
    key("balance.work_aJ", "work of the grip, or of the machine behind its spring"),
    key("balance.stored_aJ", "change of the elastic energy"),
    key("balance.adhesion_aJ", "change of the energy of adhesion"),
    key("balance.spring_aJ", "change of the energy of the machine's spring"),
    key("balance.kinetic_aJ", "kinetic energy"),
    key("balance.dissipated_aJ", "dissipated by the material, and at the events of a seta"),
    key("balance.released_aJ", "of a seta: the part of it that was released at events"),
    key("balance.imbalance", "largest defect of that balance at any step, over the largest work"),
    key("path", "computational cost"),
    key("path.steps", "steps in time, and points behind events"),
    key("path.steps_tried", "the same with those that were refused"),
    key("path.newton_iterations", "Newton iterations"),
    key("path.elements", "elements of the mesh, which stays"),
    key("timing", "wall clock"),
    key("timing.tip_s", "of a seta: of the law of the tips"),
    key("timing.solve_s", "of the pull in time"),
    key("timing.equilibria_s", "of the equilibria"),
    key("parameters", "the scene as it was computed, with its defaults: its tables as objects, units in the names"),
];

/// Of curve.csv of a pull at a rate.
#[rustfmt::skip]
pub const RATE_CURVE_COLUMNS: &[OutputKey] = &[
    key("time_s", "since the pull began"),
    key("displacement_nm", "of what moves the grip, or the root: of the machine where the scene has `grip.stiffness`"),
    key("force_nN", "force of the grip, or on the root, along the pull"),
    key("front_nm", "of a beam the peeling front: how long the free end's adhesion would have to go on"),
    key("tips_attached", "of a seta the number of tips that adhere"),
    key("tip_forces_nN", "of a seta the sum of the forces with which the ground holds the tips, along the pull: the force on the root, but for the error of Newton's method"),
    key("released_aJ", "of a seta energy released at events since the pull began: a part of what is dissipated"),
    key("work_aJ", "work since the pull began"),
    key("stored_aJ", "elastic energy, with that of springs in series with dashpots"),
    key("adhesion_aJ", "energy of adhesion, negative"),
    key("spring_aJ", "energy of the machine's spring"),
    key("kinetic_aJ", "kinetic energy"),
    key("dissipated_aJ", "dissipated by the material, and at events, since the pull began"),
];

/// Of sweep.csv of pulls at a rate, without the columns that repeat the values under the names of their keys.
#[rustfmt::skip]
pub const RATE_SWEEP_COLUMNS: &[OutputKey] = &[
    key("value", "the value of the key that was varied"),
    key("value_2", "of the second key, where two are varied"),
    key("largest_force_nN", "the largest force of the pull, as in summary.json"),
    key("displacement_nm", "of what moves the grip, or the root, there"),
    key("time_s", "since the pull began, there"),
    key("kinetic_aJ", "kinetic energy at the step next to it"),
    key("dissipated_aJ", "dissipated up to that step"),
    key("contact_lost_s", "when nothing adheres any more for the first time; empty where that does not happen"),
    key("work_aJ", "work of the grip, or of the machine behind its spring, to the end"),
    key("imbalance", "largest defect of the balance of energies at any step, over the largest work"),
    key("end", "as in summary.json of a pull at a rate"),
    key("solve_s", "wall clock"),
    key("steps", "steps in time"),
    key("newton_iterations", "Newton iterations"),
    key("elements", "elements of the mesh, which stays"),
];
