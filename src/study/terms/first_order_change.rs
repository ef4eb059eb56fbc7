//! How the limit points of a path move when a term is added to the model, to first order.
//!
//! Along the path, with the parameter t, a term does the work W' dt: that of its energy, Q', or what it dissipates. Adding it moves the
//! curve u(t), P(t) by δu and δP with
//!
//!   δP u' - δu P' = W',
//!
//! which follows from the symmetry of the tangent; what a change along the curve is taken to be makes no difference. A turn of the
//! force, P' = 0, is then moved by f = W'/u' in force and, as it lies where P' + f' = 0, by -u' f'/P'' in displacement; one of the
//! displacement by g = -W'/P' and by -P' g'/u''. Where displacements count from a place that moves, W is that of a beam that is moved as far.

use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::kind::LimitPointKind;
use crate::study::peel::points::LimitPoint;
use crate::study::peel::solution_history::SolutionHistory;

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
    pub fn of(trace: &SolutionHistory, point: &LimitPoint, rate: &dyn Fn(&Solution) -> f64) -> Self {
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
    pub fn at_end(end: &Solution, rate: &dyn Fn(&Solution) -> f64) -> Self {
        Self { force: rate(end) / end.slope.displacement, displacement: 0.0 }
    }
}
