//! What each term of the model adds to the initiation peak, to first order.
//!
//! Along the path, at the displacement u, the energy Π(q(u)) has the slope P. A term that adds Q(q) to it is left out at the cost of
//! -Q, and as q is stationary P changes by -dQ/du: no path without it has to be followed. At a peak dP/du = 0, so that this is the
//! change of the peak as well. A compliance s that adds ½ s N² to the complementary energy is left out by stiffening; there
//! Π changes by +½ ∫ s N² dS. Of a line load that has no potential, δR the change of the residual, it is δR · dq/du: this is so
//! for the contact moment, whose potential is that of the force as well.
//!
//! Error: of the order of the square of the change, in shares of the peak: an effect of a hundredth or more tells that the term matters and
//! not by how much (`tests/terms.rs`).

use super::trace::Trace;
use crate::adhesion::{Law, LineLaw, LineLoad, Rule};
use crate::model::{Hold, PeelModel};
use crate::solve::{Configuration, Equilibrium, Problem, Solution};
use std::num::NonZeroUsize;

/// A term of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// The r2 terms of the adhesion.
    FarFace,
    /// M_c
    ContactMoment,
    /// 1/GA_s
    Shear,
    /// 1/EA
    Extension,
}

impl Term {
    /// As a user reads it.
    pub fn word(self) -> &'static str {
        match self {
            Self::FarFace => "far face",
            Self::ContactMoment => "contact moment",
            Self::Shear => "shear",
            Self::Extension => "extension",
        }
    }
}

/// A term, and what leaving it out would change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TermEffect {
    pub term: Term,
    /// By how much the force of the initiation peak would change, nN
    pub force: f64,
}

/// Step along the path over which the energies are differenced, relative as in [`Problem::relative_size`].
const STEP: f64 = 1e-4;

/// The effects of the terms that the model has, at its initiation peak; none without one, or of a grip that turns as it goes, or with
/// friction, where a change of the force is no change of an energy.
pub(super) fn terms(model: &PeelModel, trace: &Trace) -> Vec<TermEffect> {
    let Some(peak) = &trace.peak else { return Vec::new() };
    // dΠ/du is then the force with a share of the moment, and has its largest value elsewhere
    if trace.problem.turn != 0.0 || trace.problem.slips.is_some() {
        return Vec::new();
    }
    let along = Along { model, problem: &trace.problem, peak, rule: rule(&trace.problem) };
    let mut effects = Vec::new();
    let law = model.line_law();
    if model.ground.substrate.is_flat() {
        if law.far_face && !matches!(law.law, Law::Cohesive(_)) {
            effects.push(TermEffect { term: Term::FarFace, force: along.slope(|at| at.far_face(&law)) });
        }
        if law.line_load == LineLoad::Full {
            effects.push(TermEffect { term: Term::ContactMoment, force: along.moment(&law) });
        }
    }
    effects.push(TermEffect { term: Term::Shear, force: along.slope(Point::shear) });
    // held across the pull what does not stretch is not lifted: no small change
    if model.grip.horizontal == Hold::Free {
        effects.push(TermEffect { term: Term::Extension, force: along.slope(Point::extension) });
    }
    effects.retain(|effect| effect.force.is_finite());
    effects
}

/// One more point than an element has unknowns along it.
fn rule(problem: &Problem) -> Rule {
    Rule::new(NonZeroUsize::MIN.saturating_add(problem.chain.order()))
}

/// The path at its peak.
struct Along<'a> {
    model: &'a PeelModel,
    problem: &'a Problem,
    peak: &'a Solution,
    rule: Rule,
}

/// What a term sees of the beam at one place.
struct Point {
    section: crate::beam::Section,
    width: f64,
    height: f64,
    gap: f64,
    rotation: f64,
    /// N and Q, nN
    normal: f64,
    shear: f64,
}

impl Along<'_> {
    /// dF/du of F = ∫ density dS.
    fn slope(&self, density: impl Fn(&Point) -> f64) -> f64 {
        let step = STEP / self.problem.relative_size(&self.peak.tangent.state, &self.peak.at.state);
        let total = |at: &Equilibrium| {
            let mut sum = 0.0;
            self.each(at.configuration(), |weight, point| sum += weight * density(&point));
            sum
        };
        let difference = total(&self.peak.moved(step)) - total(&self.peak.moved(-step));
        difference / (2.0 * step * self.peak.slope.displacement)
    }

    /// δR · dq/du without the contact moment: -∫ b (∂Ψ/∂θ) (dθ/du) dS.
    fn moment(&self, law: &LineLaw) -> f64 {
        let at = &self.peak.at;
        let change = Configuration { state: &self.peak.tangent.state, ..at.configuration() };
        let mut turns = Vec::new();
        self.each(change, |_, point| turns.push(point.rotation));
        let (mut sum, mut turns) = (0.0, turns.into_iter());
        self.each(at.configuration(), |weight, point| {
            let (sin, cos) = point.rotation.sin_cos();
            let moment = law.response_of(point.height, point.gap, sin, cos).by_rotation;
            sum -= weight * point.width * moment * turns.next().unwrap_or(0.0);
        });
        sum / self.peak.slope.displacement
    }

    /// Every point of the rule on every element, with its weight.
    fn each(&self, at: Configuration<'_>, mut visit: impl FnMut(f64, Point)) {
        for element in 0..at.ends.len() - 1 {
            let (from, length) = (at.ends[element], at.ends[element + 1] - at.ends[element]);
            for (share, weight) in self.rule.over(0.0, 1.0) {
                let (values, state) = self.problem.chain.sample(at, element, 2.0 * share - 1.0);
                let rotation = values[self.problem.rotation];
                let (sin, cos) = rotation.sin_cos();
                let (section, width, height) = self.model.section_at(from + share * length);
                let (h, v) = (state.horizontal_force, state.vertical_force);
                let (normal, shear) = (h * cos + v * sin, v * cos - h * sin);
                let gap = values[self.problem.rotation - 1];
                visit(weight * length, Point { section, width, height, gap, rotation, normal, shear });
            }
        }
    }
}

impl Point {
    /// What the energy changes by without the far face.
    fn far_face(&self, law: &LineLaw) -> f64 {
        let (sin, cos) = self.rotation.sin_cos();
        let energy = |law: &LineLaw| law.response_of(self.height, self.gap, sin, cos).energy;
        self.width * (energy(&LineLaw { far_face: false, ..*law }) - energy(law))
    }

    /// ½ Q²/GA_s
    fn shear(&self) -> f64 {
        0.5 * self.shear * self.shear / self.section.shear
    }

    /// ½ N²/EA
    fn extension(&self) -> f64 {
        0.5 * self.normal * self.normal / self.section.axial
    }
}
