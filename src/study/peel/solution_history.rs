//! The solutions behind a peel: the curve between its points and the deformed strip.

use crate::beam::planar::chain::NodeState;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::spatial::section_state::{SpatialSectionPlace, SpatialSectionState};
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::problem::beam_problem::{Beam, BeamProblem, SpatialGrip};
use crate::solve::newton::Solution;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::State;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Path points with the problem that they solve.
#[derive(Clone)]
pub(in crate::study) struct SolutionHistory {
    pub problem: Arc<BeamProblem>,
    pub points: Vec<Arc<Solution>>,
    /// The solution next to the initiation peak, if there is one.
    pub peak: Option<Arc<Solution>>,
    /// The solutions next to the limit points, in their order.
    pub limit_points: Vec<Arc<Solution>>,
}

impl std::fmt::Debug for SolutionHistory {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "SolutionHistory({} points)", self.points.len())
    }
}

/// Samples of the axis an element gets.
const SAMPLES: usize = 6;
/// Samples of the axis a whole beam gets at least in a picture.
const SMOOTH: f64 = 240.0;

impl SolutionHistory {
    /// (u, P, negative eigenvalues under displacement control) with `per_step` intervals a step. A displacement limit
    /// point is put where it splits its step into a stable and an unstable part.
    pub(crate) fn dense_curve(&self, limit_points: &[LimitPoint], per_step: usize) -> Vec<(f64, f64, usize)> {
        let mut curve = Vec::new();
        for (index, point) in self.points.iter().enumerate() {
            curve.push((point.observables.displacement, point.observables.force, point.negative));
            let Some(next) = self.points.get(index + 1) else { break };
            let turn = limit_points.iter().find(|p| p.after == index && p.kind == LimitPointKind::Displacement);
            let inner = self.step(index, per_step);
            match turn {
                Some(turn) => curve.extend(split(inner, turn, point.negative, next.negative)),
                None => curve.extend(inner.into_iter().map(|(u, p)| (u, p, point.negative))),
            }
        }
        curve
    }

    /// Displacement and force inside one step.
    fn step(&self, index: usize, per_step: usize) -> Vec<(f64, f64)> {
        let segment = PathSegment::around(&self.problem, &self.points, index);
        let middle = 0.5 * segment.end();
        let displacement = segment.observable(|o| o.displacement, middle);
        let force = segment.observable(|o| o.force, middle);
        let label = |k: usize| segment.end() * k as f64 / per_step as f64;
        (1..per_step).map(|k| (displacement.at(label(k)).0, force.at(label(k)).0)).collect()
    }

    /// Section states at the ends of the elements.
    pub(crate) fn sections(&self, index: usize) -> Vec<NodeState> {
        let (Some(point), Some(beam)) = (self.points.get(index), self.problem.beam.planar()) else { return Vec::new() };
        beam.chain.node_states(beam.configuration(&point.at), 0..point.at.mesh.elements())
    }

    /// The same of a beam in space.
    pub(crate) fn sections_in_space(&self, index: usize) -> Vec<SpatialSectionState> {
        let (Some(point), Some(beam)) = (self.points.get(index), self.problem.beam.spatial()) else {
            return Vec::new();
        };
        beam.end_states(&point.at, 0..point.at.mesh.elements())
    }

    /// Axis and rotation at one point, with x from the section's x' by Simpson's rule between samples.
    pub(crate) fn shape(&self, index: usize) -> DeformedShape {
        self.points.get(index).map(|point| DeformedShape::of(&self.problem.beam, &point.at)).unwrap_or_default()
    }

    /// The same with samples so near to one another that a picture of it has no corners.
    pub(crate) fn smooth_shape(&self, index: usize) -> DeformedShape {
        self.points.get(index).map(|point| DeformedShape::smooth(&self.problem.beam, &point.at)).unwrap_or_default()
    }

    /// Sections at so many places evenly along a beam in space, at one point.
    pub(crate) fn evenly_in_space(&self, index: usize, count: usize) -> Vec<SpatialSectionPlace> {
        self.points.get(index).map(|point| self.sections_evenly(&point.at, count)).unwrap_or_default()
    }

    /// The same at the solution next to a limit point, by its number.
    pub(crate) fn evenly_at_limit_point(&self, number: usize, count: usize) -> Option<Vec<SpatialSectionPlace>> {
        self.limit_points.get(number).map(|solution| self.sections_evenly(&solution.at, count))
    }

    fn sections_evenly(&self, at: &State, count: usize) -> Vec<SpatialSectionPlace> {
        let (Some(beam), ends) = (self.problem.beam.spatial(), &at.mesh.boundaries) else { return Vec::new() };
        let one = |k: usize| {
            let place = beam.length * k as f64 / count.saturating_sub(1).max(1) as f64;
            let element = ends.partition_point(|&end| end <= place).clamp(1, ends.len() - 1) - 1;
            beam.section_at(at, element, (place - ends[element]) / (ends[element + 1] - ends[element]))
        };
        (0..count).map(one).collect()
    }

    /// The shape at the solution next to a limit point, by its number.
    pub(crate) fn shape_at_limit_point(&self, number: usize) -> Option<DeformedShape> {
        self.limit_points.get(number).map(|solution| DeformedShape::smooth(&self.problem.beam, &solution.at))
    }
}

impl DeformedShape {
    /// Axis and rotation of an equilibrium.
    pub(super) fn of(beam: &Beam, at: &State) -> Self {
        Self::sampled(beam, at, |_| SAMPLES)
    }

    /// The same with samples so near to one another that a picture of it has no corners.
    fn smooth(beam: &Beam, at: &State) -> Self {
        let nearest = beam.length() / SMOOTH;
        Self::sampled(beam, at, |length| SAMPLES.max((length / nearest).ceil() as usize))
    }

    /// With so many samples to an element of a length, nm.
    fn sampled(beam: &Beam, at: &State, samples: impl Fn(f64) -> usize) -> Self {
        match beam {
            Beam::Planar(beam) => Self::in_the_plane(beam, at, samples),
            Beam::Spatial(beam) => Self::in_space(beam, at, samples),
        }
    }

    /// The height is that of the outline along the section's own rise: the lowest corner is half of it times the cosine below the axis.
    fn in_space(beam: &SpatialBeam, at: &State, samples: impl Fn(f64) -> usize) -> Self {
        let mut shape = Self::default();
        for (e, pair) in at.mesh.boundaries.windows(2).enumerate() {
            let samples = samples(pair[1] - pair[0]);
            let last = usize::from(e + 2 == at.mesh.boundaries.len());
            for k in 0..samples + last {
                let section = beam.section_at(at, e, k as f64 / samples as f64);
                let [rise, across, up] = [0, 1, 2].map(|director| section.directors[director][1]);
                let cos = across.hypot(up);
                let corner = (section.width * across).abs() + (section.height * up).abs();
                let height = if cos > 0.0 { corner / cos } else { section.height };
                shape.push(section.place[0], [section.place[1], rise.atan2(cos), height]);
                shape.z.push(section.place[2]);
            }
        }
        shape
    }

    fn in_the_plane(beam: &PlanarBeam, at: &State, samples: impl Fn(f64) -> usize) -> Self {
        let mut shape = Self::default();
        let sample = |e: usize, fraction: f64| {
            let (values, section) = beam.chain.sample(beam.configuration(at), e, 2.0 * fraction - 1.0);
            let height =
                beam.height_at(at.mesh.boundaries[e] + fraction * (at.mesh.boundaries[e + 1] - at.mesh.boundaries[e]));
            let rotation = values[beam.rotation];
            ([values[beam.rotation - 1] + 0.5 * height, rotation, height], section.horizontal_slope)
        };
        // the free end is held there, unless friction alone holds it
        let mut x = if beam.memory.slip_at_rest().is_some() { at.values[0] } else { 0.0 };
        for e in 0..at.mesh.elements() {
            let length = at.mesh.boundaries[e + 1] - at.mesh.boundaries[e];
            let samples = samples(length);
            let step = length / samples as f64;
            for k in 0..samples {
                let fraction = |part: f64| (k as f64 + part) / samples as f64;
                let (here, slope) = sample(e, fraction(0.0));
                shape.push(x, here);
                x += step * (slope + 4.0 * sample(e, fraction(0.5)).1 + sample(e, fraction(1.0)).1) / 6.0;
            }
        }
        shape.push(x, sample(at.mesh.elements() - 1, 1.0).0);
        shape
    }

    fn push(&mut self, x: f64, [y, rotation, height]: [f64; 3]) {
        self.x.push(x);
        self.y.push(y);
        self.rotation.push(rotation);
        self.height.push(height);
    }
}

/// The inner points of a step with the one nearest to the turn replaced by it; before it the count of the step's first
/// point holds, behind it that of its last, and the turn itself belongs to the stable side.
fn split(inner: Vec<(f64, f64)>, turn: &LimitPoint, before: usize, after: usize) -> Vec<(f64, f64, usize)> {
    let away = |&(u, p): &(f64, f64)| (u / turn.displacement - 1.0).hypot(p / turn.force - 1.0);
    let nearest = (0..inner.len()).min_by(|&a, &b| away(&inner[a]).total_cmp(&away(&inner[b])));
    let count = |k: usize| match nearest {
        Some(n) if k == n => before.min(after),
        Some(n) if k > n => after,
        _ => before,
    };
    let place = |k: usize, (u, p)| if Some(k) == nearest { (turn.displacement, turn.force) } else { (u, p) };
    inner
        .into_iter()
        .enumerate()
        .map(|(k, point)| {
            let (u, p) = place(k, point);
            (u, p, count(k))
        })
        .collect()
}

// -- Points of a path: those of its curve, limit points, branch points and peaks, and the shape of the beam there --

/// One equilibrium of the path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from where the path begins, aJ; of a grip that turns as it goes ∫ P du + M dθ
    pub work: f64,
    /// Negative eigenvalues of the tangent with the grip held at its displacement.
    pub negative_eigenvalues: usize,
    /// The same with the force held.
    pub negative_eigenvalues_load: usize,
    /// S of the peeling front, nm: the adhesion energy that is left over that of a unit length at rest.
    pub front: f64,
    /// Newton iterations it took.
    pub iterations: usize,
    /// The grip of a strip in space; none in the plane
    #[serde(default)]
    pub in_space: Option<SpatialGrip>,
}

/// A limit point of the path, located and not sampled.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LimitPoint {
    /// Of the displacement or of the force
    pub kind: LimitPointKind,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from where the path begins, aJ; of a grip that turns as it goes ∫ P du + M dθ
    pub work: f64,
    /// Bound on the error of `displacement`, nm
    pub displacement_error: f64,
    /// Bound on the error of `force`, nN
    pub force_error: f64,
    /// Bound on the error of `work`, aJ; none where the load has no potential or there is friction, where the work is an integral over the
    /// path, where a term of the model was left out, and where half as many elements again have no solution beside this one
    pub work_error: Option<f64>,
    /// Whether the force is so flat around it that its displacement cannot be determined any better and does not matter.
    pub flat: bool,
    /// It lies between `points[after]` and `points[after + 1]` of the path.
    pub after: usize,
    /// The grip of a strip in space, at the solution next to the point; none in the plane
    #[serde(default)]
    pub in_space: Option<SpatialGrip>,
}

/// Where another branch of equilibria meets the path although the displacement does not turn, located: an eigenvalue passes through zero there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BranchPoint {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Bound on the error of `displacement`, nm
    pub displacement_error: f64,
    /// Bound on the error of `force`, nN
    pub force_error: f64,
    /// Negative eigenvalues with the displacement held, before it and behind it
    pub negative_eigenvalues: [usize; 2],
    /// It lies between `points[after]` and `points[after + 1]` of the path.
    pub after: usize,
}

/// A largest force: a limit point of the path, located.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// θ(L), rad
    pub end_rotation: f64,
    /// Bound on the error of the force, nN
    pub force_error: f64,
    /// Bound on the error of the displacement, nm
    pub displacement_error: f64,
}

/// The axis of the beam at one equilibrium, sampled: x, y and in space z in nm, the rotation in rad, and the height of the section in nm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeformedShape {
    /// Of the axis, nm
    pub x: Vec<f64>,
    /// Of the axis, nm
    pub y: Vec<f64>,
    /// Of the axis sideways, nm; empty in the plane
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub z: Vec<f64>,
    /// θ, rad; in space the elevation of the axis
    pub rotation: Vec<f64>,
    /// h, nm
    pub height: Vec<f64>,
}
