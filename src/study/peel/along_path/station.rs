//! Stations of a path, and events of the user on it: the equilibria at which a quantity has exactly a value that is asked for, on every part of the
//! path that passes it.

use crate::model::problem::beam_problem::SpatialGrip;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::passing::FoundValue;
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{Accuracy, aim};
use crate::study::asked::error_bounds::least;
use crate::study::asked::events::{EventAt, StationAt, StationQuantity};
use crate::study::asked::locator::{Bounds, Locator, StationErrors};
use crate::study::asked::measured::named;
use crate::study::peel::along_path::work::work_at;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::SolutionHistory;
use crate::study::peel::step_dependence::StepCurve;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// An equilibrium of the path at which a quantity has the value that was asked for.
///
/// The bounds hold as those of limit points do. They are none with friction, where a term of the model was left out, and where half as many
/// elements again have no such equilibrium, as next to a limit point of the quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Station {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// θ of the end that is pulled, rad
    pub end_rotation: f64,
    /// S of the peeling front, nm
    pub front: f64,
    /// Distance of the nearer edge of the section at the free end from the ground, nm
    pub free_end_gap: f64,
    /// ∫ P du from where the path begins, aJ; of a grip that turns as it goes ∫ P du + M dθ
    pub work: f64,
    /// Negative eigenvalues of the tangent with the grip held at its displacement: 0 where the equilibrium is stable
    pub negative_eigenvalues: usize,
    /// The same with the force held
    pub negative_eigenvalues_load: usize,
    /// Bounds on the errors of these numbers
    pub errors: Option<StationErrors>,
    /// It lies between `points[after]` and `points[after + 1]` of the path
    pub after: usize,
    /// The grip of a strip in space; none in the plane
    pub in_space: Option<SpatialGrip>,
}

/// What a path has at a value that was asked for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stations {
    /// What was asked for
    pub at: StationAt,
    /// In path order; empty where the path does not pass the value
    pub found: Vec<Station>,
    /// The least and the largest value on the path
    pub range: [f64; 2],
    /// Where the path passes the value, and the equilibrium there could not be computed
    pub missed: Vec<MissedStation>,
}

/// A step of a path on which a station could not be computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[error("between path points {after} and {} (u = {displacement_nm:.6} nm) the station was not located: {cause}", after + 1)]
pub struct MissedStation {
    /// It lies between `points[after]` and `points[after + 1]` of the path
    pub after: usize,
    /// u of the first of these, nm
    pub displacement_nm: f64,
    /// What the solver says
    pub cause: SolveError,
}

/// What a path has where an event of the user lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Events {
    /// What was asked for
    pub at: EventAt,
    /// In path order; empty where the path does not pass the value in the way that counts
    pub found: Vec<Station>,
    /// The least and the largest value on the path
    pub range: [f64; 2],
    /// Where the path passes the value, and the equilibrium there could not be computed
    pub missed: Vec<MissedStation>,
}

impl Peel {
    /// The equilibria of the path at which a quantity has exactly a value: each is solved there, and its errors are bounded by half as many
    /// elements again, more until the bounds are as small as was asked of the path. Empty where its solutions were dropped.
    pub fn stations(&self, at: StationAt) -> Stations {
        let Events { found, range, missed, .. } = self.events(&at.into());
        Stations { at, found, range, missed }
    }

    /// The same of an event of the user: where a quantity, or a number of the fields of the beam, passes a value in the way that counts.
    pub fn events(&self, at: &EventAt) -> Events {
        let mut events = Events { at: at.clone(), found: Vec::new(), range: [f64::NAN; 2], missed: Vec::new() };
        let Some(trace) = self.trace.as_ref().filter(|trace| !trace.points.is_empty()) else { return events };
        let SolutionHistory { problem, points, limit_points, .. } = trace;
        let located = self.limit_points.iter().map(|at| at.after).zip(limit_points.iter().cloned());
        let locator = Locator::new(&self.model, problem, points, located.collect(), at);
        let dropped = self.considered.as_ref().is_some_and(|terms| terms.left_out.iter().any(|t| t.largest > 0.0));
        let bounds = Bounds {
            asked: self.asked,
            share: aim(&self.model, &Accuracy::to(self.asked)).1.unwrap_or(least(self.asked)),
            are_known: !problem.system.step_dependence().exists() && !dropped,
        };
        events.range = locator.sought.range;
        let mut ws = Workspace::default().at(self.effort.pace);
        for after in 0..points.len() - 1 {
            match locator.sought.on_step(after, &mut ws) {
                Ok(found) => events.found.extend(found.iter().map(|FoundValue { solution, segment, .. }| {
                    let (solution, errors) = locator.bounded(solution, segment, &bounds, &mut ws);
                    Station { errors, ..self.station(trace, (after, &solution, segment), &mut ws) }
                })),
                Err(cause) => events.missed.push(MissedStation {
                    after,
                    displacement_nm: points[after].observables.displacement,
                    cause,
                }),
            }
        }
        events
    }

    fn station(
        &self,
        SolutionHistory { problem, points, .. }: &SolutionHistory,
        (after, solution, segment): (usize, &Arc<Solution>, &PathSegment),
        ws: &mut Workspace,
    ) -> Station {
        let o = &solution.observables;
        let work = if problem.system.is_conservative() {
            work_at(problem, &points[0], solution)
        } else {
            let label = segment.label(o);
            self.points[after].work + StepCurve::until(problem, segment, label, solution, ws).work()
        };
        let at = |quantity: StationQuantity| named(&self.model, problem, quantity).at(solution);
        Station {
            displacement: o.displacement,
            force: o.force,
            end_rotation: o.recorded,
            front: at(StationQuantity::Front),
            free_end_gap: at(StationQuantity::FreeEndGap),
            work,
            negative_eigenvalues: solution.negative,
            negative_eigenvalues_load: solution.negative_load,
            errors: None,
            after,
            in_space: problem.spatial_grip(&solution.at),
        }
    }
}
