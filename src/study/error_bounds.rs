//! What error bounds are made of: what is multiplied, by how much, and the measurement behind each number.

use crate::solve::{LimitPointKind, Located, Problem};

/// Error bounds are the difference to half as many elements again times this.
pub(super) const SAFETY: f64 = 2.0;
/// Round-off, relative to the largest force of the path or to the displacement itself.
pub(super) const ROUND_OFF: f64 = 5e-12;
/// The same for the force where the grip holds the strip sideways, which strains it from both ends: 3e-11 was found.
pub(super) const ROUND_OFF_HELD: f64 = 5e-11;
/// Round-off of the force of nearly inextensible or unshearable beams, over the largest stiffness and the machine's epsilon: with
/// GA_s × 1e8 a force was found wrong by 0.024 of that.
pub(super) const STRAINED: f64 = 0.05;
/// The same for the displacement of a turn of the force, which is the zero of a difference of forces.
pub(super) const ROUND_OFF_PLACE: f64 = 6e-10;
/// More of it in a stiff beam, over its EI/r0² and the machine's epsilon: the place of the peak of the paper's strip scatters by
/// 4e-13, 6e-11 and 2e-9 of itself with EI times 1, 1e3 and 1e4.
pub(super) const BENT: f64 = 1.0;
/// Two meshes may agree in one number by luck: no bound is below this share of the relative difference in the other number of
/// the same point.
pub(super) const MODESTY: f64 = 0.1;
/// No bound is below this, relative, or below a tenth of the accuracy asked for where that is less.
pub(super) fn least(relative: f64) -> f64 {
    (0.1 * relative).min(2e-10)
}
/// Whether limit points of this kind are wanted as well as was asked.
pub(super) fn counts(problem: &Problem, kind: LimitPointKind) -> bool {
    !problem.system.has_history() || kind == LimitPointKind::Load
}

/// The relative error below which no bound of a located point is.
pub(super) fn modesty(located: &Located, relative: f64) -> f64 {
    let (o, d) = (&located.observables, &located.difference);
    // the place of a flat turn says nothing of its force
    let place = if located.flat { 0.0 } else { (d.displacement / o.displacement).abs() };
    // more than all of it, as of a force that is zero, shows no more than that it is wrong
    MODESTY * place.max((d.force / o.force).abs()).min(1.0) + least(relative)
}
