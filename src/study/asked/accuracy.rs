//! What the user asks of the numbers, and what follows from it: order, elements and steps.

use super::error_bounds::{CORNER_AIM_FRACTION, TOLERANCE_FLOOR_FRACTION};
use super::terms::Terms;
use crate::beam::mesh::MeshKind;
use crate::model::check::error::{ModelError, Range};
use crate::model::check::numbers::NumberOf;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::build::Discretisation;
use crate::solve::frontal::nodes::BUNDLE;
use crate::solve::path::options::PathOptions;
use crate::solve::path::predictor::MOST_POINTS;
use crate::solve::workspace::Pace;
use serde::{Deserialize, Serialize};

/// What the user asks of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Accuracy {
    /// Relative error wanted of every reported force and displacement.
    pub relative: f64,
    /// What is fixed; the rest follows from `relative`.
    pub choice: Choice,
    /// Which terms of the model are computed.
    pub terms: Terms,
}

impl Default for Accuracy {
    /// 1e-6 of every reported force and displacement, with nothing fixed and all terms.
    fn default() -> Self {
        Self::to(1e-6)
    }
}

impl Accuracy {
    /// What a relative error may be: less is lost in round-off, more is no accuracy.
    pub(crate) const RELATIVE: Range = Range::From(1e-11, 1e-2);

    /// Whether its numbers have a meaning. The analyses ask this first.
    ///
    /// # Errors
    /// By the keys of a scene: `accuracy.relative`, `order`, `elements`, `step`.
    pub fn check(&self) -> Result<(), ModelError> {
        ACCURACY_NUMBERS.iter().try_for_each(|number| number.check(self))
    }

    /// A relative error, with nothing fixed.
    pub const fn to(relative: f64) -> Self {
        Self { relative, choice: Choice::NOTHING, terms: Terms::All }
    }

    /// The same with what `choice` fixes.
    pub const fn with(self, choice: Choice) -> Self {
        Self { choice, ..self }
    }

    /// The same as far as it can be had: on ground that is not flat with x at every node, and of a film that yields to 1e-3, on a mesh
    /// that stays.
    pub(in crate::study) fn fitted(&self, model: &PeelModel) -> Self {
        let form = model.form(self.choice.form);
        if !model.yields() {
            return self.with(Choice { form, ..self.choice });
        }
        let mesh = MeshKind::Uniform;
        Self { relative: self.relative.max(BEST_YIELDING), ..self.with(Choice { form, mesh, ..self.choice }) }
    }

    /// Order p of the elements of a model.
    pub(in crate::study) fn order(&self, model: &PeelModel) -> usize {
        self.choice.order.unwrap_or(if model.yields() { ORDER_YIELDING } else { ORDER })
    }
}

/// The numbers of an accuracy, as [`crate::model::MODEL_NUMBERS`] has those of a model.
#[rustfmt::skip]
pub static ACCURACY_NUMBERS: &[NumberOf<Accuracy>] = &[
    NumberOf::new("accuracy.relative", "", Accuracy::RELATIVE, |a| Some(a.relative)),
    NumberOf::new("accuracy.order", "", Range::From(1.0, Discretisation::MOST_ORDER as f64), |a| Some(a.choice.order? as f64)),
    NumberOf::new("accuracy.elements", "", Range::From(1.0, 1e9), |a| Some(a.choice.elements? as f64)),
    NumberOf::new("accuracy.step", "", Choice::STEP, |a| a.choice.step),
];

/// What is fixed of a discretisation; nothing unless given. Where the elements are, they stay what they are, whatever the error bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Choice {
    /// Order p of the elements, 1 to 8
    pub order: Option<usize>,
    /// Number of elements
    pub elements: Option<usize>,
    /// Error of a prediction along the path, relative to the gap, that the steps aim at
    pub step: Option<f64>,
    /// How the elements are placed
    pub mesh: MeshKind,
    /// Which unknowns a node has
    pub form: Form,
}

impl Choice {
    /// Nothing is fixed, with a mesh that follows the front and two unknowns a node.
    pub const NOTHING: Self =
        Self { order: None, elements: None, step: None, mesh: MeshKind::Moving, form: Form::TwoField };
    /// What the error of a prediction may be, relative to the gap.
    pub(crate) const STEP: Range = Range::From(1e-6, 0.5);
}

/// Order of the elements. At an accuracy of 1e-3 order 5 is faster by half, but on so few elements that the difference to
/// half as many again is no bound yet.
pub const ORDER: usize = 7;
/// The same of a film that yields: where its sections begin to yield the curvature has corners, which more elements see better than higher orders.
const ORDER_YIELDING: usize = 4;
/// First step, over the way in which a grip moves a section by its gap.
const FIRST: f64 = 0.02;
/// Elements more for each place where the outline of a beam has a break.
const A_BREAK: usize = 2;
/// Length of the elements besides on ground that is not flat, over that of the process zone, at the accuracy 1e-6, and over the length in which
/// the ground changes. They see where a part of the strip that bridges a valley touches again; the front has elements of its own.
const ON_GROUND: f64 = 8.0;
const OF_DETAIL: f64 = 0.5;
/// The same where material points stick that remember, over the length in which they do.
const STICKING: f64 = 1.0;
/// Elements besides where they are cut at the corners of the law, at the accuracy 1e-6.
const AT_CORNERS: f64 = 32.0;
/// Elements besides for each factor e by which the shear lag length of a strip that its adhesive holds is shorter than its process zone, at 1e-6.
const AT_SHEAR_LAG: f64 = 8.0;
/// Length of the elements of a film that yields, over that of the process zone, at the accuracy 1e-3; its mesh stays where it is. On one that moves with
/// the front, curvatures that have turned are found anew at other places from step to step, and Newton's method does not come to rest on them.
const WHERE_YIELDING: f64 = 0.16;
/// Most elements that are chosen, where the law has corners, and where a film yields.
const MOST_ELEMENTS: usize = 400;
const MOST_CORNERED: usize = 1000;
const MOST_YIELDING: usize = 10_000;
/// Error wanted of a prediction along the path, relative to the gap, at the accuracy 1e-6; steps shorten with its fourth
/// root, so that the curve between the points keeps up with the points.
const STEP_TOLERANCE: f64 = 1.2e-2;
/// The same in space, where branches of the path nearly meet.
const STEP_TOLERANCE_IN_SPACE: f64 = 4e-3;
/// Elements in space, over those in the plane: of a uniform section, and of one that varies, whose pad twists off along its length.
const IN_SPACE: f64 = 1.25;
const VARYING_IN_SPACE: f64 = 1.5;
/// Longest step along the path of a film that yields, in process zones, at the accuracy 1e-3, and the best accuracy that is aimed at: the turns of its
/// curvature lie between points, and what is missed of them falls with the square of the steps.
const LONGEST_YIELDING: f64 = 0.11;
const BEST_YIELDING: f64 = 1e-3;
/// The same at any accuracy: beyond it Newton's method takes more than it saves.
const LONGEST: f64 = 5e-2;
/// The same of a beam that its adhesive holds along the ground: that at 1e-6. Its path has cusps where it hangs by its edge.
const LONGEST_HELD: f64 = STEP_TOLERANCE;

/// Order, elements and steps of one try.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct Resolution {
    pub order: usize,
    pub elements: usize,
    pub step_tolerance: f64,
    pub stride: f64,
}

impl Resolution {
    /// What sufficed on the reference cases: elements grow like the square of the logarithm of the length, and with the
    /// digits asked for.
    pub(in crate::study) fn first(model: &PeelModel, accuracy: &Accuracy) -> Self {
        let relative = accuracy.relative;
        let span = (model.length() / model.process_length()).asinh();
        let digits = -relative.log10();
        // two decay lengths, of bending and of shear, take more than one
        let apart = (5.0 * (0.6 * model.bending_length() / model.shear_length()).ln()).clamp(0.0, 7.0);
        let sharp = 0.32 + 0.052 * digits + 0.0083 * digits * digits + 0.2 * (digits - 8.0).max(0.0);
        let elements =
            (5.1 + 0.434 * span * span + apart) * sharp * cornered(model) + (A_BREAK * model.breaks().len()) as f64;
        let substrate = &model.ground.substrate;
        let elements = if substrate.is_flat() {
            elements
        } else {
            elements
                + model.contact_extent()
                    / (ON_GROUND * model.process_length() / sharp).min(OF_DETAIL * substrate.feature_length())
        };
        let elements = if model.cuts_elements() { elements + AT_CORNERS * sharp } else { elements };
        let lag = model.adhesion.shear_strength.and_then(|_| model.shear_lag_length());
        let shorter = lag.map_or(0.0, |lag| (model.process_length() / lag).ln().max(0.0));
        let elements = elements + AT_SHEAR_LAG * sharp * shorter;
        let shortest = WHERE_YIELDING * model.process_length() * (relative / BEST_YIELDING).powf(0.25);
        let elements = if model.yields() { elements.max(model.length() / shortest) } else { elements };
        let elements = match model.sticking_length() {
            None => elements,
            Some(_) => elements + model.length() / (STICKING * model.feature_length() / sharp),
        };
        let elements = match model.space {
            None => elements,
            Some(_) if model.strip().is_none() => VARYING_IN_SPACE * elements,
            Some(_) => IN_SPACE * elements,
        };
        let chosen = whole_bundles(elements).clamp(6, most_elements(model));
        let aimed = if model.space.is_some() { STEP_TOLERANCE_IN_SPACE } else { STEP_TOLERANCE };
        let longest = if model.is_held() { LONGEST_HELD } else { LONGEST };
        Self {
            order: accuracy.order(model),
            elements: accuracy.choice.elements.unwrap_or(chosen),
            step_tolerance: accuracy.choice.step.unwrap_or((aimed * (1e6 * relative).powf(0.25)).min(longest)),
            stride: 1.0,
        }
    }

    /// How a path is stepped at this resolution.
    pub(in crate::study) fn path_options(self, model: &PeelModel, relative: f64) -> PathOptions {
        PathOptions {
            elements: self.elements,
            step_tolerance: self.step_tolerance,
            stride: self.stride,
            longest: model.yields().then(|| LONGEST_YIELDING * (relative / BEST_YIELDING).sqrt()),
            prediction: MOST_POINTS,
            tolerance: (1e-2 * relative).clamp(1e-12, 1e-6),
            first_displacement: self.stride * FIRST * model.first_way(),
            pace: Pace::Quick,
        }
    }

    /// Finer by this factor.
    pub(in crate::study) fn times(self, growth: f64) -> Self {
        self.with_elements(self.elements as f64 * growth)
    }

    /// On so many elements, and what fills the last bundle.
    pub(in crate::study) fn with_elements(self, elements: f64) -> Self {
        Self { elements: whole_bundles(elements), ..self }
    }

    /// Finer, by what it takes to reduce an error of `worst` times the wanted one, which is of order 2p, and a first integral
    /// that spreads by `spread` times as much as it may, which was found to be of order p.
    pub(in crate::study) fn finer(self, worst: f64, spread: f64) -> Self {
        let order = self.order as f64;
        let growth = (2.0 * worst).powf(0.5 / order).max((2.0 * spread).powf(1.0 / order)).clamp(1.15, 2.0);
        self.times(growth)
    }
}

/// The accuracy that is aimed at, and the relative error below which no bound is, if there is one.
pub(in crate::study) fn aim(model: &PeelModel, accuracy: &Accuracy) -> (Accuracy, Option<f64>) {
    if cornered(model) > 1.0 {
        (Accuracy { relative: CORNER_AIM_FRACTION * accuracy.relative, ..*accuracy }, Some(accuracy.relative))
    } else {
        // what attracts and what repels join with a kink, where a difference to a finer mesh may be small by luck
        let least = TOLERANCE_FLOOR_FRACTION * accuracy.relative;
        (*accuracy, model.adhesion.shear_strength.map(|_| least))
    }
}

/// Most elements that are chosen for a model.
pub(in crate::study) fn most_elements(model: &PeelModel) -> usize {
    match cornered(model) {
        _ if model.yields() => MOST_YIELDING,
        corners if corners > 1.0 => MOST_CORNERED,
        _ => MOST_ELEMENTS,
    }
}

/// How many times as many elements the corners of the model's law take, unless elements are cut there: the narrower
/// they are, the more.
fn cornered(model: &PeelModel) -> f64 {
    if model.cuts_elements() { 1.0 } else { model.adhesion.attraction.corners() }
}

/// Elements come in bundles, of which the last costs the same however full it is.
fn whole_bundles(elements: f64) -> usize {
    (elements.ceil() as usize).next_multiple_of(BUNDLE)
}

// -- Finer until the bounds hold: the same computation on one mesh after another --

/// Most meshes tried.
const MOST_MESHES: usize = 8;
/// Meshes in space on which a path may be unusable: what three did not cure more do not, and each takes as long as a peel that succeeds.
pub(in crate::study) const MOST_FAILED_IN_SPACE: usize = 4;

/// The best of the computations on one mesh after another, up to `most_elements`. `compute` is given a resolution and the best so far; beside
/// what it computed it says on which resolution to go on, or that it is enough.
pub(in crate::study) fn refined<A>(
    first: Resolution,
    most_elements: usize,
    is_better: impl Fn(&A, &A) -> bool,
    mut compute: impl FnMut(Resolution, Option<&A>) -> (A, Option<Resolution>),
) -> Option<A> {
    let (mut resolution, mut best) = (first, None);
    for _ in 0..MOST_MESHES {
        let (found, finer) = compute(resolution, best.as_ref());
        if best.as_ref().is_none_or(|best| is_better(&found, best)) {
            best = Some(found);
        }
        match finer {
            Some(finer) if finer.elements <= most_elements => resolution = finer,
            _ => break,
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on(elements: usize) -> Resolution {
        Resolution { order: 7, elements, step_tolerance: 1e-2, stride: 1.0 }
    }

    /// An error that falls with the elements, then is round-off: the best is kept, and none is computed beyond the most elements.
    #[test]
    fn the_best_is_kept() {
        let mut tried = Vec::new();
        let better = |a: &(usize, f64), b: &(usize, f64)| a.1 < b.1;
        let best = refined(on(8), 30, better, |resolution, _| {
            let elements = resolution.elements;
            tried.push(elements);
            ((elements, if elements > 20 { 0.5 } else { 1.0 / elements as f64 }), Some(on(elements + 6)))
        });
        assert_eq!((best.map(|best| best.0), tried), (Some(20), vec![8, 14, 20, 26]));
        let once = refined(on(8), 30, better, |_, _| ((8, 0.1), None));
        assert_eq!(once, Some((8, 0.1)));
    }
}
