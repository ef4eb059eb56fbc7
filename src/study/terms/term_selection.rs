//! Leaves out of a model what does not change the answer at the accuracy asked for, and says what that was.
//!
//! The path is followed without the terms that take something to compute, and what each would change is estimated on that path for every
//! number that is reported ([`crate::study::terms::effects`]). Bounds are widened by twice that. Where they are within the accuracy then, the path stands;
//! else the term that changes most is put back, and the path followed again.

use super::effects::FirstOrderChange;
use super::section_sampling::SectionSampling;
use super::term_selection;
use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::adhesion::substrate::Substrate;
use crate::adhesion::substrate_response::GroundLaw;
use crate::model::check::error::ModelError;
use crate::model::ground::{Friction, Ground};
use crate::model::peel::{Form, Hold, PeelModel};
use crate::solve::newton::Solution;
use crate::solve::problem::Direction;
use crate::study::asked::accuracy::Accuracy;
use crate::study::asked::error_bounds::{COMPANION_FRACTION, FAR_FACE_SHARE_FACTOR, SHIFT_BOUND_FACTOR};
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::asked::terms::{KeptReason, LeftOut, NotEstimated, Term, TermDecisions, Terms};
use crate::study::peel::budget::Checkpoint;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::peel::solution_history::{LimitPoint, SolutionHistory};
use crate::study::peel::{assembly, run as whole_path};
use std::sync::Arc;

/// Heights of the ground over r0 beyond which it is no small change.
const SHALLOW: f64 = 0.1;

/// Follows the peel with the terms that are asked for.
pub(in crate::study) fn run(
    model: &PeelModel,
    accuracy: &Accuracy,
    stop: &StopCriteria,
    checkpoint: &Checkpoint,
) -> Peel {
    match accuracy.terms {
        Terms::All => whole_path::run(model, accuracy, stop, checkpoint),
        Terms::Auto => TermSelection { model, accuracy, stop, checkpoint }.run(),
    }
}

struct TermSelection<'a> {
    model: &'a PeelModel,
    accuracy: &'a Accuracy,
    stop: &'a StopCriteria,
    checkpoint: &'a Checkpoint<'a>,
}

impl TermSelection<'_> {
    fn run(&self) -> Peel {
        let (mut terms, mut kept) = candidates(self.model, self.accuracy.relative);
        let mut iterations = 0;
        while !terms.is_empty() {
            let mut peel = self.without(&terms);
            iterations += peel.effort.newton_iterations;
            let Some(mut found) = self.found(&peel, &terms) else {
                let why = KeptReason::NotEstimated(NotEstimated::Failed);
                kept.extend(terms.drain(..).map(|term| (term, why)));
                break;
            };
            found.iter().for_each(|found| found.widen(&mut peel));
            peel.tell_bounds();
            if peel.reached_accuracy().is_none_or(|reached| reached <= self.accuracy.relative) {
                let left_out = found.iter().map(|found| found.left_out).collect();
                return self.assembled(peel, left_out, kept, iterations);
            }
            found.sort_by(|a, b| b.left_out.largest.total_cmp(&a.left_out.largest));
            let LeftOut { term, largest, .. } = found[0].left_out;
            terms.retain(|&other| other != term);
            kept.push((term, KeptReason::Matters(largest)));
            if term == Term::Friction {
                // on a path with it a change of the force is no change of an energy
                kept.extend(terms.drain(..).map(|term| (term, KeptReason::NotEstimated(NotEstimated::Friction))));
            }
        }
        let peel = whole_path::run(self.model, self.accuracy, self.stop, self.checkpoint);
        iterations += peel.effort.newton_iterations;
        self.assembled(peel, Vec::new(), kept, iterations)
    }

    /// The path without some terms, of which nothing is kept: it is short beside the one with them.
    fn without(&self, terms: &[Term]) -> Peel {
        let model = terms.iter().fold(self.model.clone(), |model, &term| without(term, model));
        whole_path::run(&model, self.accuracy, self.stop, &Checkpoint::NOTHING)
    }

    /// What each of the terms would change of a path without them; none where that has failed.
    fn found(&self, peel: &Peel, terms: &[Term]) -> Option<Vec<Found>> {
        let trace = peel.trace.as_ref().filter(|_| !matches!(peel.end, PathEnd::Failed(_)))?;
        let found: Vec<Found> = terms.iter().map(|&term| Found::of(peel, trace, self.model, term)).collect();
        found.iter().all(|found| found.left_out.largest.is_finite()).then_some(found)
    }

    /// The result, with what was decided.
    fn assembled(
        &self,
        mut peel: Peel,
        mut left_out: Vec<LeftOut>,
        mut kept: Vec<(Term, KeptReason)>,
        iterations: usize,
    ) -> Peel {
        match peel.model.form(peel.choice.form) {
            Form::TwoField => {
                left_out.push(LeftOut { term: Term::Horizontal, force: 0.0, displacement: 0.0, largest: 0.0 });
            }
            Form::ThreeField => kept.push((Term::Horizontal, KeptReason::NotEstimated(NotEstimated::ActsAlong))),
        }
        let moment = (peel.model.adhesion.line_load == LineLoad::Full).then_some(Term::ContactMoment);
        kept.extend(
            [Term::Shear, Term::Extension].into_iter().chain(moment).map(|term| (term, KeptReason::NothingSaved)),
        );
        peel.effort.newton_iterations = iterations;
        peel.considered = Some(TermDecisions { left_out, kept });
        peel
    }
}

/// The terms to try without, and those of the model that are kept untried.
fn candidates(model: &PeelModel, relative: f64) -> (Vec<Term>, Vec<(Term, KeptReason)>) {
    let (mut tried, mut kept) = (Vec::new(), Vec::new());
    if model.space.is_some() {
        return (tried, kept);
    }
    let mut consider = |term: Term, obstacle: Option<KeptReason>| match obstacle {
        None => tried.push(term),
        Some(why) => kept.push((term, why)),
    };
    let law = model.line_law();
    let driven = if !model.has_potential() {
        Some(KeptReason::NotEstimated(NotEstimated::NoPotential))
    } else if model.pull.turn != 0.0 {
        Some(KeptReason::NotEstimated(NotEstimated::Turning))
    } else if !model.steps.is_empty() {
        Some(KeptReason::NotEstimated(NotEstimated::Steps))
    } else {
        None
    };
    let has_friction = model.friction_law().is_some();
    if has_friction {
        let held = model.grip.horizontal == Hold::Fixed || model.pull.direction() != Direction::UP;
        let alone = held.then_some(KeptReason::NotEstimated(NotEstimated::HoldsAlone));
        consider(Term::Friction, driven.or(alone));
    }
    let substrate = &model.ground.substrate;
    if !substrate.is_flat() {
        let deep = depth(substrate, model.length()) > SHALLOW * law.gap_scale();
        let deep = deep.then_some(KeptReason::NotEstimated(NotEstimated::Deep));
        let free = model.grip.rotation == Hold::Free && model.grip.horizontal == Hold::Free;
        let held = (!free).then_some(KeptReason::NotEstimated(NotEstimated::Held));
        let curved = !model.is_uniform();
        let curved = curved.then_some(KeptReason::NotEstimated(NotEstimated::Curved));
        consider(Term::Ground, driven.or(curved).or(deep).or(held));
    }
    if law.has_far_face() {
        // what it takes of the work of adhesion it takes of the force beyond the peak
        let share = 1.0 - law.rest_energy() / LineLaw { far_face: false, ..law }.rest_energy();
        let matters =
            (SHIFT_BOUND_FACTOR * FAR_FACE_SHARE_FACTOR * share > relative).then_some(KeptReason::Matters(share));
        consider(Term::FarFace, driven.or(matters));
    }
    (tried, kept)
}

/// How far ground reaches above and below the height that it has at the free end of a strip, nm.
fn depth(substrate: &Substrate, length: f64) -> f64 {
    const PLACES: usize = 1000;
    let height = |k: usize| -substrate.clearance(length * k as f64 / PLACES as f64, 0.0);
    (0..=PLACES).map(|k| (height(k) - height(0)).abs()).fold(0.0, f64::max)
}

fn without(term: Term, mut model: PeelModel) -> PeelModel {
    match term {
        Term::FarFace => model.adhesion.far_face = false,
        Term::Ground => model.ground = Ground::default(),
        Term::Friction => model.friction = Friction::NONE,
        Term::ContactMoment | Term::Shear | Term::Extension | Term::Horizontal => {}
    }
    model
}

/// What a term would change of a path without it.
struct Found {
    left_out: LeftOut,
    /// Of each limit point
    shifts: Vec<FirstOrderChange>,
}

/// What a term does on a path without it.
enum Work {
    /// The energy of the adhesion changes from that without the upper face to that with it.
    FarFace(GroundLaw, GroundLaw),
    /// Level ground gets a shape.
    Ground(LineLaw, Substrate),
    Friction(FrictionLaw),
}

impl Work {
    /// Per unit of the path's parameter, of a beam that lies higher by `lift` (nm) with the term.
    fn rate(&self, sampling: &SectionSampling, lift: f64) -> f64 {
        match self {
            Self::FarFace(without, with) => {
                sampling.rate(|at| at.adhesion_on(with, lift) - at.adhesion_on(without, 0.0))
            }
            Self::Ground(law, substrate) => sampling.rate(|at| at.adhesion_by_ground(law, substrate, lift)),
            Self::Friction(law) => sampling.dissipation(law),
        }
    }

    /// Of a term that `model` has and the path of `reduced` has not.
    fn of(term: Term, model: &PeelModel, reduced: &PeelModel) -> Option<Self> {
        let law = reduced.line_law();
        let on = |substrate: &Substrate, law: LineLaw| GroundLaw { law, substrate: substrate.clone() };
        match term {
            Term::FarFace => {
                let substrate = &reduced.ground.substrate;
                Some(Self::FarFace(on(substrate, law), on(substrate, LineLaw { far_face: true, ..law })))
            }
            Term::Ground => Some(Self::Ground(law, model.ground.substrate.clone())),
            Term::Friction => model.friction_law().map(Self::Friction),
            Term::ContactMoment | Term::Shear | Term::Extension | Term::Horizontal => None,
        }
    }
}

impl Found {
    fn of(peel: &Peel, trace: &SolutionHistory, model: &PeelModel, term: Term) -> Self {
        let nothing = LeftOut { term, force: 0.0, displacement: 0.0, largest: 0.0 };
        let Some(work) = Work::of(term, model, &peel.model) else {
            return Self { left_out: nothing, shifts: Vec::new() };
        };
        let rate = |solution: &Solution, lift: f64| {
            let sampling = SectionSampling::new(&peel.model, &trace.problem, solution);
            sampling.map_or(f64::NAN, |sampling| work.rate(&sampling, lift))
        };
        // where the path begins, from where displacements count
        let lift = match term {
            // friction holds nothing yet
            Term::Friction => 0.0,
            Term::FarFace => {
                LineLaw { far_face: true, ..peel.model.line_law() }.rest_gap() - peel.model.line_law().rest_gap()
            }
            _ => trace.points.first().map_or(0.0, |first| -rate(first, 0.0) / first.slope.force),
        };
        let rate = |solution: &Solution| rate(solution, lift);
        let shift = |point: &LimitPoint| {
            let shift = FirstOrderChange::of(trace, point, &rate);
            // where the force is level the place does not matter
            if point.flat { FirstOrderChange { displacement: 0.0, ..shift } } else { shift }
        };
        let shifts: Vec<FirstOrderChange> = peel.limit_points.iter().map(shift).collect();
        let mut found = Self { left_out: nothing, shifts };
        let peak = peel.initiation_peak.map(|peak| peak.displacement);
        // not a number is larger than any
        let larger =
            |largest: f64, share: f64| if largest.is_nan() || share.abs() <= largest { largest } else { share.abs() };
        for (point, shift) in peel.limit_points.iter().zip(&found.shifts) {
            let shares = [shift.force / point.force, shift.displacement / point.displacement];
            found.left_out.largest = shares.into_iter().fold(found.left_out.largest, larger);
            if Some(point.displacement) == peak {
                (found.left_out.force, found.left_out.displacement) = (shift.force, shift.displacement);
            }
        }
        // a largest force that is no limit point counts as well where it is at an end of the path
        if let Some(largest) = peel.largest_computed_force {
            let is_there = |end: &&Arc<Solution>| largest.displacement == end.observables.displacement;
            let end = [trace.points.first(), trace.points.last()].into_iter().flatten().find(is_there);
            let change = end.map_or(FirstOrderChange::default(), |end| FirstOrderChange::at_end(end, &rate));
            found.left_out.largest = larger(found.left_out.largest, change.force / largest.force);
        }
        found
    }

    /// Adds what the term may change to the bounds.
    fn widen(&self, peel: &mut Peel) {
        for (point, shift) in peel.limit_points.iter_mut().zip(&self.shifts) {
            point.force_error += self.wide(shift.force, point.force);
            point.displacement_error += self.wide(shift.displacement, point.displacement);
            // what the term does on the way there is not estimated
            point.work_error = point.work_error.filter(|_| self.left_out.largest == 0.0);
        }
        if let Some(plateau) = peel.plateau.as_mut().filter(|_| self.left_out.largest != 0.0) {
            (plateau.force_error, plateau.displacement_error) = (None, None);
        }
    }

    /// What a number that shifts is to be bounded by besides.
    fn wide(&self, shift: f64, value: f64) -> f64 {
        SHIFT_BOUND_FACTOR * shift.abs().max(COMPANION_FRACTION * self.left_out.largest * value.abs())
    }
}

// -- The whole peel of a model, with the terms that are asked for --

/// Follows the peel from rest to its end. What went wrong on the way stands in [`Peel::end`]: a model or an accuracy that cannot be
/// computed ([`checked`]) ends as failed at once, with what is wrong and what would be right.
pub fn peel<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria) -> Peel
where
    PeelModel: From<&'m M>,
{
    peel_on(model, accuracy, stop, &Checkpoint::NOTHING)
}

/// The same, with the points that an earlier run of the same model and accuracy has kept: bit for bit what [`peel`] finds. The stop
/// criteria may have changed.
pub fn peel_on<'m, M>(model: &'m M, accuracy: &Accuracy, stop: &StopCriteria, checkpoint: &Checkpoint) -> Peel
where
    PeelModel: From<&'m M>,
{
    let model: PeelModel = model.into();
    // what stays in the plane is solved there
    let model = model.in_the_plane().unwrap_or(model);
    match checked(&model, accuracy) {
        Ok(()) => term_selection::run(&model, accuracy, stop, checkpoint),
        Err(error) => assembly::peel(&model, accuracy, &error),
    }
}

/// Whether a model can be computed to an accuracy: what every analysis asks first.
///
/// # Errors
/// As [`PeelModel::check`] and [`Accuracy::check`].
pub fn checked(model: &PeelModel, accuracy: &Accuracy) -> Result<(), ModelError> {
    model.check()?;
    accuracy.check()
}
