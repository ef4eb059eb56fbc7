//! What error bounds are made of: every number that something is multiplied by on its way to a bound, or by which a bound is judged,
//! with the measurement behind it.
//!
//! The true errors are those against collocation without finite elements (`verification/README.md`). A measurement with another factor
//! than the one that stands here was made with a build that has it.

use crate::solve::points::locate::Located;
use crate::solve::points::search::LimitPointKind;
use crate::solve::problem::Problem;

// -- what a difference shows --

/// Multiplies the difference to half as many elements again: bounds of located points, of their works, of plateaus, of jumps and of a cusp.
/// Works of 120 strips drawn at random, at 1e-4 and 1e-6 against 1e-10: 1000, none wrong by more than 0.98 of the two bounds, and but for two that
/// are flat by more than 0.48.
///
/// The difference alone is exceeded by the true error in 2.6 % of 1006 numbers of 200 sampled strips, 1.1 times the difference in one of
/// them, where the two meshes agree by luck (`peel verify --only bounds` with 1 and with 1.1 here, and [`COMPANION_FRACTION`] 0). With 2
/// the largest error over its bound is 0.54 (`figures/error-bounds.csv`).
pub(in crate::study) const DIFFERENCE_BOUND_FACTOR: f64 = 2.0;
/// Multiplies the same difference where a point is followed from value to value on few elements.
///
/// Not measured but derived: where the error falls no faster than the elements get shorter, as on a mesh that misses the edge of a stiff
/// strip, it is 1/(1 - 2/3) = 3 times the difference to half as many elements again.
pub(in crate::study) const FOLLOWED_BOUND_FACTOR: f64 = 3.0;
/// Multiplies the largest relative difference, or the largest relative shift, among the numbers beside one: that number is taken to be
/// uncertain by no less, because two meshes may agree in it by luck, or a shift vanish to first order.
///
/// With differences times 1.1, one bound of 1006 is below the true error without this share, and none with it; with differences times 2 all
/// hold without it as well (`peel verify --only bounds`). For shifts it is a margin without a measurement.
pub(in crate::study) const COMPANION_FRACTION: f64 = 0.1;
/// Multiplies the accuracy asked for: no bound is below that, however well two meshes agree.
///
/// A margin without a measurement: it keeps bounds apart from zero, and at a tenth of what is asked for it hides nothing.
pub(in crate::study) const TOLERANCE_FLOOR_FRACTION: f64 = 0.1;
/// No bound is below this, relative, unless a tenth of what is asked for is less: where bounds are about as small, the largest true error is 8e-11
/// (`figures/error-bounds.csv`).
const LEAST_BOUND: f64 = 2e-10;

// -- what steps change, where the material points remember --

/// Multiplies what shorter strides change of a path that remembers. The steps beyond a limit point are what they are, so that the strides
/// shorten not all of them.
///
/// 4.4 times that change was found. With 1 two of 47 bounds of `peel verify --only friction` are exceeded, by up to 1.13; with 8 none is used
/// up by more than 0.46.
pub(in crate::study) const STRIDE_BOUND_FACTOR: f64 = 8.0;
/// Multiplies the accuracy asked for where such a path has been followed again: its bounds may miss that by so much before it has failed,
/// because the strides are shortened and the mesh is not made finer. A margin without a measurement.
pub(in crate::study) const STRIDE_TOLERANCE_FACTOR: f64 = 2.0;

/// Multiplies the steepness of the chord of the least steep step: a place that is less steep than that may be the plateau on a path with other
/// steps.
///
/// Of 120 strips drawn at random, at 1e-4 and 1e-6 against 1e-10, 32 of 138 plateaus have a bound; the force is wrong by at most 0.28 and the place by
/// at most 0.70 of the two bounds. Where steps with a limit point of the force are left out of account, three are wrong by 100 to 400 times.
pub(in crate::study) const LEVEL_FACTOR: f64 = 4.0;

// -- what judges a mesh or a curve --

/// Multiplies the error bound of the best mesh so far: of two that are near round-off, the finer one is taken where its bound is no more
/// than that.
///
/// The strip of the paper pulled at 10 degrees, at 1e-9: 28, 36 and 44 elements miss that by 2.5, 1.003 and 7.4, the last by round-off. With 0.1 the
/// first was taken, whose second displacement limit point is wrong by 1.2e-9 (`peel verify --only pull`).
pub(in crate::study) const PLAIN_IMPROVEMENT: f64 = 0.5;
/// Multiplies the accuracy asked for where a law has corners: that is aimed at. Between two meshes corners fall elsewhere between the points
/// of the quadrature, so that a difference to a finer mesh may be small by luck.
///
/// With 1 an error is 2.3 times its bound (Dugdale's law), with 0.5 and 0.25 none of 200 is above 0.48 of it (`peel verify --only laws`).
pub(in crate::study) const CORNER_AIM_FRACTION: f64 = 0.25;
/// Multiplies what one point less shows of the error of an interpolant, before that is compared with the error wanted of the curve between the
/// points of a path.
///
/// With 1 the curve of the strip of 100 nm is wrong by 0.9 of what is wanted at 1e-6 and by 0.5 of it at 1e-7, with 2 by 0.07 and 0.3; at
/// 1e-9 by 1.05 either way (`peel accuracy`).
pub(in crate::study) const INTERPOLATION_ERROR_FACTOR: f64 = 2.0;

// -- what leaving out a term changes --

/// Multiplies the change of a number that is estimated to first order for a term that is left out.
///
/// Computed over estimated: 0.98 (friction), 1.00 (waves), 1.00 (upper surface) in the table of docs/notes/accuracy.md.
pub(in crate::study) const SHIFT_BOUND_FACTOR: f64 = 2.0;
/// Multiplies the share that the upper surface has of the work of adhesion: where that, times [`SHIFT_BOUND_FACTOR`], is above the accuracy asked
/// for, the path without it is not tried. It saves time and bounds nothing: what is tried is estimated on its path.
///
/// Strips 2 to 40 nm high: peaks change by up to 0.2 of that share and first displacement limit points by up to 1, later ones mostly by up to 7
/// and, where a number is nearly zero, by any factor (`peel run scenes/strip-100nm.toml --json`, with `--set adhesion.far_face=false`
/// and without).
pub(in crate::study) const FAR_FACE_SHARE_FACTOR: f64 = 8.0;

// -- round-off --

/// Round-off, relative to the largest force of the path or to the displacement itself.
pub(in crate::study) const ROUND_OFF: f64 = 5e-12;
/// The same for the force, an element, where the grip holds the strip sideways, which strains it from both ends: 2e-10 was found on 156 elements
/// (EI × 100, 1e-9), 1.3e-12 an element.
pub(in crate::study) const ROUND_OFF_HELD: f64 = 2.5e-12;
/// The same for the displacement of a turn of the force, which is the zero of a difference of forces.
pub(in crate::study) const ROUND_OFF_PLACE: f64 = 6e-10;
/// Multiplies the largest stiffness times the machine's epsilon, nN: round-off of the force of nearly inextensible or unshearable beams. With
/// GA_s × 1e8 a force was found wrong by 0.024 of that.
pub(in crate::study) const STRAIN_ROUND_OFF: f64 = 0.05;
/// Multiplies EI/r0² times the machine's epsilon, nN: what it adds to the place of a turn of the force in a stiff beam. The place of the
/// peak of the paper's strip scatters by 4e-13, 6e-11 and 2e-9 of itself with EI times 1, 1e3 and 1e4.
pub(in crate::study) const BENDING_ROUND_OFF: f64 = 1.0;

/// No bound is below this, relative.
pub(in crate::study) fn least(relative: f64) -> f64 {
    (TOLERANCE_FLOOR_FRACTION * relative).min(LEAST_BOUND)
}

/// The relative error below which no bound of a located point is.
pub(in crate::study) fn bound_floor(located: &Located, relative: f64) -> f64 {
    let (o, d) = (&located.observables, &located.difference);
    // the place of a flat turn says nothing of its force
    let place = if located.flat { 0.0 } else { (d.displacement / o.displacement).abs() };
    // more than all of it, as of a force that is zero, shows no more than that it is wrong
    COMPANION_FRACTION * place.max((d.force / o.force).abs()).min(1.0) + least(relative)
}

/// Whether limit points of this kind are wanted as well as was asked.
pub(in crate::study) fn counts(problem: &Problem, kind: LimitPointKind) -> bool {
    !problem.system.step_dependence().exists() || kind == LimitPointKind::Load
}
