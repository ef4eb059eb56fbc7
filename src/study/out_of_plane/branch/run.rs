//! From the first loss of stability out of the plane onto the branch, and along it by the code that follows any path.

use super::result::{BranchStart, OutOfPlaneBranch, OutOfPlaneBranchError};
use super::switching::{FirstPoint, Switch};
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::peel::{Hold, PeelModel, Space};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::solve::error::SolveError;
use crate::solve::newton::on_more_elements;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::InitialState;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::accuracy::{Accuracy, Resolution};
use crate::study::asked::error_bounds::DIFFERENCE_BOUND_FACTOR;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::asked::terms::Terms;
use crate::study::out_of_plane::first_loss::{Beside, Known, LocatedLoss, StepSearch};
use crate::study::out_of_plane::result::{NotOutOfPlane, OutOfPlaneError, OutOfPlaneLoss};
use crate::study::out_of_plane::roll_elements::{RollReader, RollStability};
use crate::study::peel::meshes::KnownStart;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::peel::run::run_from;
use crate::study::peel::solution_history::{LimitPoint, PathPoint};
use std::sync::Arc;

/// The first step along the branch over the way from the branch point to its first point.
const FIRST_STEP: f64 = 0.5;
/// The branch begins where the planar path loses its stability, to this share of u and P: the meshes are different ones.
const SAME_PLACE: f64 = 1e-3;
/// A first point whose roll is less than this share of the one that it was computed with is back in the plane.
const STAYS: f64 = 0.5;

impl Peel {
    /// The branch on which the strip leaves the plane at the first loss of its stability, followed in space to its end;
    /// nothing where the planar path is stable all along. Of its two mirror images it is the one whose grip has a roll
    /// above zero at first. A change of its inertia without a located limit point is a failure, as on any path.
    ///
    /// # Errors
    /// As [`Peel::out_of_plane`]; where the model is none that is computed in space; where the path is unstable from its
    /// beginning; and where the first point of the branch is not found, or is not what bifurcation theory says.
    pub fn branch(&self, stop: &StopCriteria) -> Result<Option<OutOfPlaneBranch>, OutOfPlaneBranchError> {
        let (stabilities, located) = self.stability_out_of_plane()?;
        let Some(LocatedLoss { loss, beside }) = located else { return Ok(None) };
        let beside = beside.ok_or(OutOfPlaneBranchError::FromTheBeginning)?;
        let history = self.trace.as_ref().ok_or(OutOfPlaneError::NoSolutions)?;
        let planar = history.problem.beam.planar().ok_or(NotOutOfPlane::InSpace).map_err(OutOfPlaneError::from)?;
        let accuracy = Accuracy { relative: self.asked, choice: self.choice, terms: Terms::All };
        let model = self.model.left_plane();
        let switching = Switching { model: &model, accuracy: &accuracy, planar, beside: &beside };
        let FirstPoint { at, displacement, start } = switching.first_point()?;
        switching.check_place(&start, [loss.displacement, loss.force])?;
        let mut problem = switching.problem(Space::default())?;
        let first = switching.released(&problem, at, displacement, &start)?;
        let stable = &history.points[loss.after.unwrap_or(0)];
        switching.check_inertia(&first, &start, [stable.negative, stable.negative_load])?;
        problem.start = InitialState::Known { at: Arc::new(first.at.clone()), settling: false };
        let known = KnownStart {
            problem: Arc::new(problem),
            first_displacement: FIRST_STEP * (displacement - start.displacement),
        };
        let mut peel = run_from(&known, &model, &accuracy, stop);
        let work = work_to(&known.problem, &first);
        add_work(&mut peel, work);
        let rejoins = match peel.end {
            PathEnd::BackInPlane => Some(self.regained(&stabilities, &peel)?),
            _ => None,
        };
        Ok(Some(OutOfPlaneBranch { loss, start, peel, rejoins }))
    }

    /// Where the planar path regains the stability that a branch took over: the place that is nearest to the branch's last point.
    fn regained(&self, stabilities: &[RollStability], branch: &Peel) -> Result<OutOfPlaneLoss, OutOfPlaneError> {
        let history = self.trace.as_ref().ok_or(OutOfPlaneError::NoSolutions)?;
        let planar = history.problem.beam.planar().ok_or(NotOutOfPlane::InSpace)?;
        let reader = RollReader::new(&self.model, planar);
        let last = branch.points.last().map_or([0.0; 2], |point| [point.displacement, point.force]);
        let apart = |step: usize| {
            let middle = |of: fn(&PathPoint) -> f64| 0.5 * (of(&self.points[step]) + of(&self.points[step + 1]));
            let [u, p] = [middle(|at| at.displacement) / last[0], middle(|at| at.force) / last[1]];
            (u - 1.0).hypot(p - 1.0)
        };
        let changes = (0..stabilities.len().saturating_sub(1))
            .filter(|&step| stabilities[step].negative.min(stabilities[step + 1].negative) == 0)
            .filter(|&step| stabilities[step].negative.max(stabilities[step + 1].negative) > 0);
        let [u, force] = last;
        let step = changes
            .min_by(|&a, &b| apart(a).total_cmp(&apart(b)))
            .ok_or(OutOfPlaneError::NotRegained { displacement: u, force })?;
        let search = StepSearch::new(&reader, history, step);
        let [first, second] = [(0.0, step), (search.segment.end(), step + 1)]
            .map(|(label, point)| Known { label, margin: stabilities[point].margin() });
        let between = if first.margin > 0.0 { (first, second) } else { (second, first) };
        let [from, to] = [step, step + 1].map(|point| self.points[point].displacement);
        let located = search.located(between, self.asked, &mut Workspace::default());
        located.map(|located| located.loss).map_err(|cause| OutOfPlaneError::NotLocated { from, to, cause })
    }
}

/// What is known when the branch is switched to.
struct Switching<'s> {
    /// In space
    model: &'s PeelModel,
    accuracy: &'s Accuracy,
    planar: &'s PlanarBeam,
    beside: &'s Beside,
}

impl Switching<'_> {
    fn problem(&self, space: Space) -> Result<BeamProblem, OutOfPlaneBranchError> {
        let model = PeelModel { space: Some(space), ..self.model.clone() };
        model.check().map_err(OutOfPlaneBranchError::NotInSpace)?;
        let accuracy = self.accuracy.fitted(&model);
        let how = Discretisation::moving(accuracy.choice.form, accuracy.order(&model)).on(accuracy.choice.mesh);
        let no_order = |_| OutOfPlaneBranchError::NotSwitched(SolveError::SingularGrip);
        model.discretised(how, |_| {}).map_err(no_order)
    }

    fn first_point(&self) -> Result<FirstPoint, OutOfPlaneBranchError> {
        let problem = self.problem(Space { roll: Hold::Fixed, ..Space::default() })?;
        let spatial = spatial(&problem)?;
        let (width, height) = self.model.free_end();
        let switch = Switch {
            planar: self.planar,
            beside: self.beside,
            problem: &problem,
            spatial,
            elements: Resolution::first(self.model, self.accuracy).elements,
            broad: 0.5 * width.max(height) / self.model.adhesion.equilibrium_distance,
        };
        switch.first_point(&mut Workspace::default())
    }

    fn check_place(&self, start: &BranchStart, [displacement, force]: [f64; 2]) -> Result<(), OutOfPlaneBranchError> {
        let apart = |found: f64, expected: f64| (found / expected - 1.0).abs();
        if apart(start.displacement, displacement).max(apart(start.force, force)) <= SAME_PLACE {
            return Ok(());
        }
        Err(OutOfPlaneBranchError::Elsewhere {
            displacement: start.displacement,
            force: start.force,
            expected_displacement: displacement,
            expected_force: force,
        })
    }

    /// The first point in the grip that lets it roll.
    fn released(
        &self,
        problem: &BeamProblem,
        at: State,
        displacement: f64,
        start: &BranchStart,
    ) -> Result<Solution, OutOfPlaneBranchError> {
        let spatial = spatial(problem)?;
        let at = spatial.without_angles_of_grip(at);
        let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: displacement };
        let options = NewtonOptions { tolerance: 1e-10, largest_update: 0.5, most_iterations: 12, exact_slope: true };
        let first = solve(problem, at, &constraint, &options, &mut Workspace::default())
            .map_err(|cause| OutOfPlaneBranchError::NoEquilibrium { displacement, cause })?;
        let [_, _, roll] = spatial.angles_of_grip(&first.at);
        if roll < STAYS * start.roll {
            return Err(OutOfPlaneBranchError::InThePlane { displacement, roll });
        }
        Ok(first)
    }

    /// Of the first point, from those of the planar path where it is stable, with displacement and with force held. Where the
    /// branch goes to the side on which the planar path is unstable, it takes over its stability; where it goes to the
    /// other, it has one negative eigenvalue more.
    fn check_inertia(
        &self,
        first: &Solution,
        start: &BranchStart,
        stable: [usize; 2],
    ) -> Result<(), OutOfPlaneBranchError> {
        let Beside { solution, margin_slope, .. } = self.beside;
        let slope = &solution.slope;
        // d margin/du and d margin/dP along the planar path
        let by = [margin_slope / slope.displacement, margin_slope / slope.force];
        let ways = [start.displacement_by_roll, start.force_by_roll];
        let expected: [usize; 2] = std::array::from_fn(|k| stable[k] + usize::from(by[k] * ways[k] > 0.0));
        let found = [first.negative, first.negative_load];
        if found == expected {
            return Ok(());
        }
        Err(OutOfPlaneBranchError::Inertia { displacement: first.observables.displacement, found, expected })
    }
}

fn spatial(problem: &BeamProblem) -> Result<&SpatialBeam, OutOfPlaneBranchError> {
    problem.beam.spatial().map(Arc::as_ref).ok_or(OutOfPlaneBranchError::NotSwitched(SolveError::SingularGrip))
}

/// Work from rest to the first point, aJ, with a bound: the energy there less that at rest.
fn work_to(problem: &BeamProblem, first: &Solution) -> [f64; 2] {
    let system = &*problem.system;
    let rest = system.stress_free(first.at.mesh.elements());
    let (at_rest, _) = system.evaluate(&rest, &vec![0.0; system.unknowns(&rest)]);
    let finer = on_more_elements(problem, first, Observables::DISPLACEMENT, &mut Workspace::default());
    let error = finer.map_or(f64::INFINITY, |finer| DIFFERENCE_BOUND_FACTOR * (finer.energy - first.energy).abs());
    [first.energy - at_rest.energy, error]
}

/// Lets the works of a path that begins at its first point count from rest.
fn add_work(peel: &mut Peel, [work, error]: [f64; 2]) {
    peel.points.iter_mut().for_each(|point| point.work += work);
    let Peel { limit_points, snap_off, pad_detachment, detachment, .. } = peel;
    let add = |point: &mut LimitPoint| {
        point.work += work;
        point.work_error = point.work_error.map(|own| own + error).filter(|error| error.is_finite());
    };
    limit_points.iter_mut().chain(snap_off).chain(pad_detachment).chain(detachment).for_each(add);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::StripModel;

    fn peeled(width: f64) -> Peel {
        let mut model = StripModel::of_the_paper(100.0, 1.0);
        model.strip.width = width;
        crate::study::peel(&model, &Accuracy::to(1e-8), &StopCriteria::default())
    }

    /// With m(u) the moment that rolls the grip about x by one, Π = Π₀(u) + ½ m(u) φ² + O(φ⁴) makes P = P₀(u) + ½ m' φ²
    /// of the branch. The roll about the axis, a, and the yaw ψ are φ = a cos θ - ψ sin θ. So it leaves with the slope
    /// P₀' + m' (φ/a)²/2u₂. P₀' and m' are those of the planar path and of its scalar problem, the others those of the
    /// beam in space.
    #[test]
    fn the_branch_leaves_with_the_slope_of_bifurcation_theory() {
        for width in [1.0, 2.0, 4.0, 26.0, 40.0, 100.0] {
            let peel = peeled(width);
            let stop = StopCriteria { displacement: Some(1e-3), ..StopCriteria::default() };
            let start = peel.branch(&stop).unwrap().unwrap().start;
            let beside = peel.stability_out_of_plane().unwrap().1.unwrap().beside.unwrap();
            let slope = &beside.solution.slope;
            let (planar, margin) = (slope.force / slope.displacement, beside.margin_slope / slope.displacement);
            let (sin, cos) = beside.solution.observables.recorded.sin_cos();
            let about_x = cos - start.yaw_by_roll * sin;
            let expected = planar + margin * about_x.powi(2) / (2.0 * start.displacement_by_roll);
            let scale = planar.abs().max(expected.abs());
            assert!((start.slope() - expected).abs() < 5e-3 * scale, "b = {width}: {} {expected}", start.slope());
        }
    }

    #[test]
    fn a_first_point_with_another_inertia_is_refused() {
        let peel = peeled(40.0);
        let (_, located) = peel.stability_out_of_plane().unwrap();
        let beside = located.unwrap().beside.unwrap();
        let (model, accuracy) = (peel.model.left_plane(), Accuracy::to(1e-6));
        let planar = peel.trace.as_ref().unwrap().problem.beam.planar().unwrap();
        let switching = Switching { model: &model, accuracy: &accuracy, planar, beside: &beside };
        let FirstPoint { at, displacement, start } = switching.first_point().unwrap();
        let problem = switching.problem(Space::default()).unwrap();
        let first = switching.released(&problem, at.clone(), displacement, &start).unwrap();
        assert_eq!(switching.check_inertia(&first, &start, [0, 0]), Ok(()));
        let other = BranchStart { displacement_by_roll: -start.displacement_by_roll, ..start };
        let refused = switching.check_inertia(&first, &other, [0, 0]).unwrap_err();
        let (found, expected) = ([0, 0], [1, 0]);
        assert_eq!(
            refused,
            OutOfPlaneBranchError::Inertia { displacement: first.observables.displacement, found, expected }
        );
        let farther = BranchStart { roll: 3.0 * start.roll, ..start };
        let refused = switching.released(&problem, at, displacement, &farther).unwrap_err();
        assert!(matches!(refused, OutOfPlaneBranchError::InThePlane { .. }), "{refused}");
        let elsewhere = switching.check_place(&start, [0.2, 13.0]).unwrap_err();
        assert!(matches!(elsewhere, OutOfPlaneBranchError::Elsewhere { .. }), "{elsewhere}");
    }
}
