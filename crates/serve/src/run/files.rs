//! The files of a run, to keep.

use crate::asked::refusal::Refusal;
use crate::asked::request::{File, FileRequest};
use crate::run::answer::run;
use crate::run::runs::RunEnd;
use peelkit_analyses::{Outcome, RunOutcome};
use peelkit_report::{curve_csv, curve_svg};
use peelkit_scene::Scene;

/// A file as it is sent.
#[derive(Debug)]
pub(crate) struct Sent {
    pub media: &'static str,
    pub content: Vec<u8>,
}

/// Runs the scene, where the file needs that, and writes the file.
pub(crate) fn file(request: &FileRequest, end: &RunEnd) -> Result<Sent, Refusal> {
    let scene = request.scene.read()?;
    if let File::Scene = request.file {
        return Ok(Sent { media: "application/toml", content: scene.to_toml().into_bytes() });
    }
    let outcome = run(&scene, false, end)?;
    Ok(match request.file {
        File::Curve => Sent { media: "text/csv; charset=utf-8", content: table(&outcome, &scene)? },
        File::Picture => Sent { media: "image/svg+xml", content: picture(&outcome, &scene)? },
        File::Summary | File::Scene => {
            Sent { media: "application/json", content: outcome.json(&scene, None)?.into_bytes() }
        }
    })
}

fn table(outcome: &RunOutcome, scene: &Scene) -> Result<Vec<u8>, Refusal> {
    match outcome {
        RunOutcome::Peel(found) => Ok(curve_csv(&found.peel)?),
        _ => written(outcome, scene, "curve.csv"),
    }
}

fn picture(outcome: &RunOutcome, scene: &Scene) -> Result<Vec<u8>, Refusal> {
    match outcome {
        RunOutcome::Peel(found) => Ok(curve_svg(&found.peel, scene)?.into_bytes()),
        _ => written(outcome, scene, "curve.svg"),
    }
}

/// One of the files that the command writes of it.
fn written(outcome: &RunOutcome, scene: &Scene, name: &str) -> Result<Vec<u8>, Refusal> {
    let folder = tempfile::tempdir()?;
    outcome.write(scene, folder.path(), "peel serve")?;
    Ok(std::fs::read(folder.path().join(name))?)
}
