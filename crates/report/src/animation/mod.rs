//! A peel as a page that a browser plays: the beam over the substrate beside the curve with a moving point. The page is one file that
//! needs no other, and well-formed XML.

pub(crate) mod frames;
mod page;
pub(crate) mod panel;
pub(crate) mod player;

use crate::pictures::peel::captioned;
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use peelkit::study::Peel;
use std::path::{Path, PathBuf};

use frames::poses;

/// Writes `animation.html` into `dir`.
///
/// Fails where the path has fewer than two points with shapes ([`ReportError::Draw`]) or the file cannot be written
/// ([`ReportError::Write`]).
pub fn write_animation(dir: &Path, peel: &Peel, title: &str) -> Result<PathBuf, ReportError> {
    let path = dir.join("animation.html");
    let frames = poses(peel);
    if frames.len() < 2 {
        let reason = format!("the path has {} points with a shape", frames.len());
        return Err(ReportError::Draw { path, reason });
    }
    write_whole(&path, page::page(peel, &frames, &captioned(peel, title)).as_bytes())?;
    Ok(path)
}
