//! The whole peel of one model: path, special points, error bounds, how it ended.

use crate::model::StripModel;
use crate::solve::{Hermite, Stretch, Turn};

/// What the user asks of the numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Relative error wanted of every reported force and displacement.
    pub relative: f64,
}

/// Where a path may be stopped although it goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Most path points.
    pub points: usize,
    /// Most seconds of wall clock; none when absent.
    pub time_s: Option<f64>,
    /// Largest grip displacement, nm; none when absent.
    pub displacement: Option<f64>,
}

/// How a path ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// No point of the beam is nearer than 10 r0.
    Detached,
    /// The force has come back to zero after a snap-off while an edge still holds.
    Pivoting,
    /// The path has returned to u = 0.
    TurnedBack,
    /// A bound that the scene sets was reached; which one, in words.
    Bound(String),
    /// The computation stopped short; why, with numbers and what to try.
    Failed(String),
}

/// One equilibrium of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from rest, aJ
    pub work: f64,
    /// Negative eigenvalues of the tangent with the grip held at its displacement.
    pub negative_eigenvalues: usize,
    /// The same with the force held.
    pub negative_eigenvalues_load: usize,
    /// S of the peeling front, nm: the adhesion energy that is left over that of a unit length at rest.
    pub front: f64,
    /// Newton iterations it took.
    pub iterations: usize,
}

/// A turning point of the path, located and not sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitPoint {
    pub kind: Turn,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// rad
    pub end_rotation: f64,
    /// ∫ P du from rest, aJ
    pub work: f64,
    /// Bound on the error of `displacement`, nm
    pub displacement_error: f64,
    /// Bound on the error of `force`, nN
    pub force_error: f64,
    /// It lies between `points[after]` and `points[after + 1]` of the path.
    pub after: usize,
}

/// A largest force: at a limit point, or at the end of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    pub displacement: f64,
    pub force: f64,
    pub end_rotation: f64,
    pub force_error: f64,
    pub displacement_error: f64,
}

/// Where the force changes least with the displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    pub displacement: f64,
    pub force: f64,
}

/// What it took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    pub points: usize,
    pub newton_iterations: usize,
    pub elements: usize,
    pub order: usize,
}

/// The axis of the strip at one equilibrium, sampled.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub rotation: Vec<f64>,
}

/// The result of one run.
#[derive(Clone, Debug)]
pub struct Peel {
    pub model: StripModel,
    pub points: Vec<PathPoint>,
    /// In path order.
    pub limit_points: Vec<LimitPoint>,
    pub initiation_peak: Option<Peak>,
    pub peak: Option<Peak>,
    pub plateau: Option<Plateau>,
    /// The first displacement limit point at which u turns back.
    pub snap_off: Option<LimitPoint>,
    pub end: End,
    pub effort: Effort,
    pub solve_s: f64,
    /// The curve from each point to the next.
    pub(super) steps: Vec<StepCurve>,
    /// The deformed axis at each point.
    pub(super) shapes: Vec<Shape>,
}

/// Displacement and force between two path points.
#[derive(Clone, Debug)]
pub(super) struct StepCurve {
    end: f64,
    displacement: Hermite,
    force: Hermite,
}

impl StepCurve {
    pub(super) fn new(stretch: &Stretch) -> Self {
        let middle = 0.5 * stretch.end();
        Self {
            end: stretch.end(),
            displacement: stretch.observable(|o| o.displacement, middle),
            force: stretch.observable(|o| o.force, middle),
        }
    }

    fn at(&self, fraction: f64) -> (f64, f64) {
        let label = fraction * self.end;
        (self.displacement.at(label).0, self.force.at(label).0)
    }
}

impl Peel {
    /// The curve between the path points as well, `per_step` intervals a step: (u, P, negative eigenvalues under
    /// displacement control). The located limit points are among its points.
    pub fn dense_curve(&self, per_step: usize) -> Vec<(f64, f64, usize)> {
        let mut curve = Vec::new();
        for (i, point) in self.points.iter().enumerate() {
            curve.push((point.displacement, point.force, point.negative_eigenvalues));
            let Some(step) = self.steps.get(i) else { continue };
            let turns: Vec<_> = self.limit_points.iter().filter(|p| p.after == i).collect();
            curve.extend(step_between(step, point, self.points.get(i + 1), &turns, per_step));
        }
        curve
    }

    /// The deformed axis at `points[index]`; empty where there is none.
    pub fn shape(&self, index: usize) -> Shape {
        self.shapes.get(index).cloned().unwrap_or_default()
    }
}

/// Points of one step between its ends. A displacement limit point splits it: the stable side belongs to one end, the
/// unstable to the other.
fn step_between(
    step: &StepCurve,
    from: &PathPoint,
    to: Option<&PathPoint>,
    turns: &[&LimitPoint],
    per_step: usize,
) -> Vec<(f64, f64, usize)> {
    let after = to.map_or(from.negative_eigenvalues, |p| p.negative_eigenvalues);
    let inner: Vec<(f64, f64)> = (1..per_step).map(|k| step.at(k as f64 / per_step as f64)).collect();
    let Some(turn) = turns.iter().find(|t| t.kind == Turn::Displacement) else {
        return inner.into_iter().map(|(u, p)| (u, p, from.negative_eigenvalues)).collect();
    };
    // the turn is where the inner points are nearest to it in u and P together
    let along = |&(u, p): &(f64, f64)| {
        let (du, dp) = ((u - turn.displacement) / turn.displacement, (p - turn.force) / turn.force);
        du.hypot(dp)
    };
    let nearest = (0..inner.len()).min_by(|&a, &b| along(&inner[a]).total_cmp(&along(&inner[b]))).unwrap_or(0);
    let mut points: Vec<_> = inner.iter().map(|&(u, p)| (u, p)).collect();
    if nearest < points.len() {
        points[nearest] = (turn.displacement, turn.force);
    }
    let unstable_from = nearest + usize::from(after < from.negative_eigenvalues);
    points
        .into_iter()
        .enumerate()
        .map(|(k, (u, p))| (u, p, if k < unstable_from { from.negative_eigenvalues } else { after }))
        .collect()
}

/// Follows the peel from rest to its end. What went wrong on the way stands in [`Peel::end`].
pub fn peel(model: &StripModel, accuracy: &Accuracy, bounds: &Bounds) -> Peel {
    super::peel_run::run(model, accuracy, bounds)
}
