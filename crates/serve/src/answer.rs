//! What the page gets of a run.

use crate::controls::{Control, controls};
use crate::poses::Poses;
use crate::refusal::Refusal;
use crate::request::{Part, PeelRequest};
use crate::runs::RunEnd;
use peelkit::study::{self, Peel};
use peelkit_report::{Finite, PeelSummary, timed};
use peelkit_scene::Scene;
use serde::Serialize;

/// About how many points a curve is drawn with.
const DENSE: usize = 600;
/// Most pieces of a step of the path that are drawn.
const MOST_PIECES: usize = 8;

/// A run as the page gets it.
#[derive(Debug, Serialize)]
struct Answer<'a> {
    summary: PeelSummary<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<Curve>,
    #[serde(skip_serializing_if = "Option::is_none")]
    poses: Option<Poses>,
    #[serde(skip_serializing_if = "Option::is_none")]
    controls: Option<Vec<Control>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    toml: Option<String>,
    /// Why there is no displacement-controlled test, where one is wanted
    #[serde(skip_serializing_if = "Option::is_none")]
    no_test: Option<String>,
}

/// The curve, its limit points among its points.
#[derive(Debug, Serialize)]
struct Curve {
    #[serde(rename = "displacement_nm")]
    displacement: Vec<Finite>,
    #[serde(rename = "force_nN")]
    force: Vec<Finite>,
    /// Under displacement control
    unstable: Vec<bool>,
}

impl Curve {
    fn of(peel: &Peel) -> Self {
        let points = peel.dense_curve((DENSE / peel.points.len().max(1)).clamp(1, MOST_PIECES));
        Self {
            displacement: points.iter().map(|point| Finite(point.0)).collect(),
            force: points.iter().map(|point| Finite(point.1)).collect(),
            unstable: points.iter().map(|point| point.2 > 0).collect(),
        }
    }
}

/// The peel of a scene, which ends with its run.
pub(crate) fn peel(scene: &Scene, end: &RunEnd) -> Peel {
    study::peel(&scene.model, &scene.accuracy, &end.ends(scene.bounds.from_now()))
}

/// Reads the scene, runs it, and writes what is wanted as JSON.
pub(crate) fn answer(request: &PeelRequest, end: &RunEnd) -> Result<Vec<u8>, Refusal> {
    let scene = request.scene.read()?;
    let wants = |part: Part| request.parts.contains(&part);
    let (peel, seconds) = timed(|| peel(&scene, end));
    let test = (wants(Part::Test) && !end.is_left())
        .then(|| timed(|| study::observed(&scene.model, &scene.accuracy, &end.ends(scene.bounds.from_now()))));
    let summary = PeelSummary::new(&scene, &peel, seconds);
    let (summary, no_test) = match &test {
        Some((Ok(test), seconds)) => (summary.with_observed(test, *seconds), None),
        Some((Err(none), _)) => (summary, Some(none.to_string())),
        None => (summary, None),
    };
    let answer = Answer {
        summary,
        curve: wants(Part::Curve).then(|| Curve::of(&peel)),
        poses: wants(Part::Poses).then(|| Poses::of(&peel)),
        controls: wants(Part::Controls).then(|| controls(&scene)),
        toml: wants(Part::Toml).then(|| scene.to_toml()),
        no_test,
    };
    serde_json::to_vec(&answer).map_err(|error| Refusal::Broken(error.to_string()))
}
