//! What each term of the model adds to the initiation peak, to first order.
//!
//! Along the path, at the displacement u, the energy Π(q(u)) has the slope P. A term that adds Q(q) to it is left out at the cost of
//! -Q, and as q is stationary P changes by -dQ/du: no path without it has to be followed. At a peak dP/du = 0, so that this is the
//! change of the peak as well. A compliance s that adds ½ s N² to the complementary energy is left out by stiffening; there
//! Π changes by +½ ∫ s N² dS. Of a line load that has no potential, δR the change of the residual, it is δR · dq/du: this is so
//! for the contact moment, whose potential is that of the force as well. All of it takes a symmetric tangent.
//!
//! Error: of the order of the square of the relative change of the peak: an effect of a hundredth or more shows that the term matters and
//! not by how much (`tests/mechanics/study/terms.rs`).

use super::section_sampling::{Point, SectionSampling};
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::model::peel::{Hold, PeelModel};
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::search::LimitPointKind;
use crate::study::asked::terms::Term;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::{LimitPoint, SolutionHistory};

/// cos θ of a section from which on the near face alone, W/cos θ, is no small change of the model.
const UPRIGHT: f64 = 0.1;

/// A term, and what leaving it out would change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TermEffect {
    /// Which one
    pub term: Term,
    /// By how much the force of the initiation peak would change, nN
    pub force: f64,
}

/// The effects of the terms that the model has, at its initiation peak; none without one, or of a grip that turns as it goes, with
/// friction or of a law without a potential, where a change of the force is no change of an energy; none in space. The far face has none where a section is
/// nearly upright: without it the energy has a pole there.
fn terms(model: &PeelModel, trace: &SolutionHistory) -> Vec<TermEffect> {
    let Some(peak) = &trace.peak else { return Vec::new() };
    // with a turn dΠ/du is the force with a share of the moment, and has its largest value elsewhere
    if trace.problem.grip.gear != 0.0 || !trace.problem.system.is_conservative() {
        return Vec::new();
    }
    let Some(sampling) = SectionSampling::new(model, &trace.problem, peak) else { return Vec::new() };
    let mut effects = Vec::new();
    let mut add = |term: Term, work: f64| {
        effects.push(TermEffect { term, force: work / peak.slope.displacement });
    };
    let law = model.line_law();
    if model.ground.substrate.is_flat() {
        if law.has_far_face() && sampling.steepest() > UPRIGHT {
            let near = LineLaw { far_face: false, ..law };
            add(Term::FarFace, sampling.rate(|at| at.adhesion(&near) - at.adhesion(&law)));
        }
        if law.line_load == LineLoad::Full {
            let moment = |at: &Point| {
                let (sin, cos) = at.rotation.sin_cos();
                -at.width * law.response_of(at.height, at.gap, sin, cos).by_rotation
            };
            add(Term::ContactMoment, sampling.work_of_moment(moment));
        }
    }
    add(Term::Shear, sampling.rate(Point::shear));
    // constrained normal to the pull, what does not stretch is not lifted: no small change
    if model.grip.horizontal == Hold::Free {
        add(Term::Extension, sampling.rate(Point::extension));
    }
    effects.retain(|effect| effect.force.is_finite());
    effects
}

impl Peel {
    /// What each term of the model adds to the initiation peak, to first order.
    pub fn terms(&self) -> Vec<TermEffect> {
        self.trace.as_ref().map(|trace| terms(&self.model, trace)).unwrap_or_default()
    }
}

// -- How the limit points of a path move when a term is added to the model, to first order --
//
// Along the path, with the parameter t, a term does the work W' dt: that of its energy, Q', or what it dissipates. Adding it moves the
// curve u(t), P(t) by δu and δP with
//
// δP u' - δu P' = W',
//
// which follows from the symmetry of the tangent; what a change along the curve is taken to be makes no difference. A turn of the
// force, P' = 0, is then moved by f = W'/u' in force and, as it lies where P' + f' = 0, by -u' f'/P'' in displacement; one of the
// displacement by g = -W'/P' and by -P' g'/u''. Where displacements count from a place that moves, W is that of a beam that is moved as far.

/// How a limit point moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct FirstOrderChange {
    /// nN
    pub force: f64,
    /// nm
    pub displacement: f64,
}

impl FirstOrderChange {
    /// How the limit point of a path moves by a term that does the work `rate` per unit of the path's parameter.
    pub(crate) fn of(trace: &SolutionHistory, point: &LimitPoint, rate: &dyn Fn(&Solution) -> f64) -> Self {
        let segment = PathSegment::around(&trace.problem, &trace.points, point.after);
        let middle = 0.5 * segment.end();
        let [displacement, force] = [LimitPointKind::Displacement.pick(), LimitPointKind::Load.pick()]
            .map(|pick| segment.observable(pick, middle));
        let turning = if point.kind == LimitPointKind::Load { &force } else { &displacement };
        let at = turning.turning_point(0.0, segment.end());
        let (work, work_slope) = segment.rate(rate, at);
        let (_, u_slope, u_curvature) = displacement.at(at);
        let (_, p_slope, p_curvature) = force.at(at);
        match point.kind {
            LimitPointKind::Load => {
                let slope = (work_slope * u_slope - work * u_curvature) / (u_slope * u_slope);
                Self { force: work / u_slope, displacement: -u_slope * slope / p_curvature }
            }
            LimitPointKind::Displacement => {
                let slope = -(work_slope * p_slope - work * p_curvature) / (p_slope * p_slope);
                Self { displacement: -work / p_slope, force: -p_slope * slope / u_curvature }
            }
        }
    }

    /// The same for an end of the path at a fixed displacement.
    pub(crate) fn at_end(end: &Solution, rate: &dyn Fn(&Solution) -> f64) -> Self {
        Self { force: rate(end) / end.slope.displacement, displacement: 0.0 }
    }
}
