//! The keys of the summary of a pull at a rate, and the columns of its curve and of a sweep.

use super::{OutputKey, key};

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
    key("largest_force", "the largest force of the pull"),
    key("largest_force.force_nN", "by a parabola through the three steps next to it"),
    key("largest_force.displacement_nm", "of what moves the grip"),
    key("largest_force.time_s", "since the pull began"),
    key("largest_force.kinetic_aJ", "kinetic energy at the step next to it"),
    key("largest_force.dissipated_aJ", "dissipated by the material up to that step"),
    key("contact_lost_s", "when nothing adheres any more for the first time; else null"),
    key("equilibria_peak", "first peak of the equilibria of the same scene; null where they have none"),
    key("equilibria_peak.force_nN", "its force"),
    key("equilibria_peak.displacement_nm", "its displacement"),
    key("equilibria_peak.error_nN", "bound of the error of its force"),
    key("force_over_equilibria", "largest force of the pull over the peak of the equilibria; null without one"),
    key("balance", "what became of the work, from rest to the end"),
    key("balance.work_aJ", "work of the grip, or of the machine behind its spring"),
    key("balance.stored_aJ", "change of the elastic energy"),
    key("balance.adhesion_aJ", "change of the energy of adhesion"),
    key("balance.spring_aJ", "change of the energy of the machine's spring"),
    key("balance.kinetic_aJ", "kinetic energy"),
    key("balance.dissipated_aJ", "dissipated by the material"),
    key("balance.imbalance", "largest defect of that balance at any step, over the largest work"),
    key("path", "computational cost"),
    key("path.steps", "steps in time"),
    key("path.steps_tried", "the same with those that were refused"),
    key("path.newton_iterations", "Newton iterations"),
    key("path.elements", "elements of the mesh, which stays"),
    key("timing", "wall clock"),
    key("timing.solve_s", "of the pull in time"),
    key("timing.equilibria_s", "of the equilibria"),
    key("parameters", "the scene as it was computed, with its defaults: its tables as objects, units in the names"),
];

/// Of curve.csv of a pull at a rate.
#[rustfmt::skip]
pub const RATE_CURVE_COLUMNS: &[OutputKey] = &[
    key("time_s", "since the pull began"),
    key("displacement_nm", "of what moves the grip: of the machine where the scene has `grip.stiffness`"),
    key("force_nN", "force of the grip along the pull"),
    key("front_nm", "the peeling front: how long the free end's adhesion would have to go on"),
    key("work_aJ", "work since the pull began"),
    key("stored_aJ", "elastic energy, with that of springs in series with dashpots"),
    key("adhesion_aJ", "energy of adhesion, negative"),
    key("spring_aJ", "energy of the machine's spring"),
    key("kinetic_aJ", "kinetic energy"),
    key("dissipated_aJ", "dissipated by the material since the pull began"),
];

/// Of sweep.csv of pulls at a rate, without the columns that repeat the values under the names of their keys.
#[rustfmt::skip]
pub const RATE_SWEEP_COLUMNS: &[OutputKey] = &[
    key("value", "the value of the key that was varied"),
    key("value_2", "of the second key, where two are varied"),
    key("largest_force_nN", "the largest force of the pull, by a parabola through the three steps next to it"),
    key("displacement_nm", "of what moves the grip, there"),
    key("time_s", "since the pull began, there"),
    key("kinetic_aJ", "kinetic energy at the step next to it"),
    key("dissipated_aJ", "dissipated by the material up to that step"),
    key("contact_lost_s", "when nothing adheres any more for the first time; empty where that does not happen"),
    key("work_aJ", "work of the grip, or of the machine behind its spring, to the end"),
    key("imbalance", "largest defect of the balance of energies at any step, over the largest work"),
    key("end", "as in summary.json of a pull at a rate"),
    key("solve_s", "wall clock"),
    key("steps", "steps in time"),
    key("newton_iterations", "Newton iterations"),
    key("elements", "elements of the mesh, which stays"),
];
