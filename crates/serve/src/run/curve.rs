//! The curve of a run as the page draws it.

use peelkit::study::{Peel, SetaPoint, SetaPullOff};
use peelkit_analyses::RunOutcome;
use peelkit_report::{Equilibria, Finite, PulledAtRate};
use serde::Serialize;

/// About how many points a curve is drawn with.
const DENSE: usize = 600;
/// Most pieces of a step of the path that are drawn.
const MOST_PIECES: usize = 8;
/// How far the equilibria are drawn, over the way of a pull at a rate.
const BEHIND: f64 = 1.1;

/// The curve, its limit points among its points.
#[derive(Debug, Serialize)]
pub(crate) struct Curve {
    #[serde(flatten)]
    line: Line,
    /// Under displacement control
    unstable: Vec<bool>,
    /// Of a pull at a rate: without rate
    #[serde(skip_serializing_if = "Option::is_none")]
    equilibria: Option<Line>,
}

#[derive(Debug, Serialize)]
struct Line {
    #[serde(rename = "displacement_nm")]
    displacement: Vec<Finite>,
    #[serde(rename = "force_nN")]
    force: Vec<Finite>,
}

impl FromIterator<(f64, f64)> for Line {
    fn from_iter<I: IntoIterator<Item = (f64, f64)>>(points: I) -> Self {
        let (displacement, force) = points.into_iter().map(|(u, p)| (Finite(u), Finite(p))).unzip();
        Self { displacement, force }
    }
}

/// The points of the last step of the loading, which pulls.
pub(crate) fn pulled(pull_off: &SetaPullOff) -> impl Iterator<Item = &SetaPoint> {
    let last = pull_off.points.last().map(|point| point.step);
    pull_off.points.iter().filter(move |point| Some(point.step) == last)
}

impl Curve {
    pub fn of(outcome: &RunOutcome) -> Self {
        match outcome {
            RunOutcome::Peel(found) => Self::of_peel(&found.peel),
            RunOutcome::Seta(found) => {
                Self::stable(pulled(found.pull_off()).map(|at| (at.displacement, at.force_along)).collect())
            }
            RunOutcome::Array(found) => Self::stable(
                found.pull.events.iter().filter(|at| at.starts_jump).map(|at| (at.lift, at.load)).collect(),
            ),
            RunOutcome::Solid(found) => {
                let points = &found.peel.points;
                let unstable = points.iter().map(|at| at.negative.is_some_and(|count| count > 0)).collect();
                let line = points.iter().map(|at| (at.displacement, at.force)).collect();
                Self { line, unstable, equilibria: None }
            }
            RunOutcome::Rate(found) => Self::at_rate(&found.pulled, &found.equilibria),
        }
    }

    fn of_peel(peel: &Peel) -> Self {
        let points = peel.dense_curve((DENSE / peel.points.len().max(1)).clamp(1, MOST_PIECES));
        Self {
            line: points.iter().map(|point| (point.0, point.1)).collect(),
            unstable: points.iter().map(|point| point.2 > 0).collect(),
            equilibria: None,
        }
    }

    fn at_rate(pulled: &PulledAtRate, equilibria: &Equilibria) -> Self {
        let way = BEHIND * pulled.way();
        let slow = equilibria.points.iter().copied().take_while(|at| at.0 <= way).collect();
        let curve = Self::stable(pulled.points.iter().map(|at| (at.displacement, at.force)).collect());
        Self { equilibria: Some(slow), ..curve }
    }

    /// One that is followed as a test follows it.
    fn stable(line: Line) -> Self {
        Self { unstable: vec![false; line.force.len()], line, equilibria: None }
    }
}
