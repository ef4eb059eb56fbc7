//! The files of a run, to keep.

use crate::answer::peel;
use crate::refusal::Refusal;
use crate::request::{File, FileRequest};
use crate::runs::RunEnd;
use peelkit_report::{PeelSummary, curve_csv, curve_svg, timed};

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
    let (peel, seconds) = timed(|| peel(&scene, end));
    Ok(match request.file {
        File::Curve => Sent { media: "text/csv; charset=utf-8", content: curve_csv(&peel)? },
        File::Picture => Sent { media: "image/svg+xml", content: curve_svg(&peel, &scene.title)?.into_bytes() },
        File::Summary | File::Scene => {
            let summary = PeelSummary::new(&scene, &peel, seconds);
            Sent { media: "application/json", content: summary.to_json()?.into_bytes() }
        }
    })
}
