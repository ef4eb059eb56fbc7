//! What the page gets of a run.

use crate::asked::refusal::Refusal;
use crate::asked::request::{Part, PeelRequest};
use crate::run::controls::{Control, controls};
use crate::run::curve::Curve;
use crate::run::poses::{Poses, shown_states};
use crate::run::runs::RunEnd;
use peelkit_analyses::{Analysis, Asked, Outcome, Run, RunOutcome, Session};
use peelkit_scene::{Described, Scene};
use serde::Serialize;

/// What stands beside the summary of a run.
#[derive(Debug, Serialize)]
struct Beside {
    /// What was computed: `peel`, `seta` or `rate`
    kind: &'static str,
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

/// The run of a scene as the command does it, which ends with its end.
pub(crate) fn run(scene: &Scene, observed: bool, end: &RunEnd) -> Result<RunOutcome, Refusal> {
    let asked = Asked { observed, states: shown_states(scene), ..Asked::default() };
    let session = Session { watcher: end, keeping: None, abrupt: true };
    Ok(Run::of(scene, asked)?.run(&session)?)
}

/// Reads the scene, runs it, and writes what is wanted as JSON.
pub(crate) fn answer(request: &PeelRequest, end: &RunEnd) -> Result<Vec<u8>, Refusal> {
    let scene = request.scene.read()?;
    let wants = |part: Part| request.parts.contains(&part);
    let has_test = matches!(scene.describes(), Described::Peel);
    let tested = (wants(Part::Test) && has_test).then(|| run(&scene, true, end));
    let (outcome, no_test) = match tested {
        Some(Ok(outcome)) => (outcome, None),
        Some(Err(why)) => (run(&scene, false, end)?, Some(why.to_string())),
        None => (run(&scene, false, end)?, None),
    };
    let beside = Beside {
        kind: scene.describes().word(),
        curve: wants(Part::Curve).then(|| Curve::of(&outcome)),
        poses: wants(Part::Poses).then(|| Poses::of(&outcome)),
        controls: wants(Part::Controls).then(|| controls(&scene)),
        toml: wants(Part::Toml).then(|| scene.to_toml()),
        no_test,
    };
    let summary = outcome.json(&scene, None)?;
    let beside = serde_json::to_string(&beside).map_err(|error| Refusal::Broken(error.to_string()))?;
    // the summary stands in the answer as the command writes it, digit by digit
    let beside = beside.strip_prefix('{').unwrap_or_default();
    Ok(format!("{{\"summary\":{summary},{beside}").into_bytes())
}
