//! parameters.toml: the scene as it was computed, to be run again.

use super::error::ReportError;
use super::file::write_whole;
use super::records::summary::VERSION;
use peelkit_scene::Scene;
use std::path::{Path, PathBuf};

/// Writes parameters.toml: the scene with its defaults and with what was set on the command line, which `peel run` computes to the same
/// numbers. `command`, the command line, stands above it as a remark.
///
/// Fails with [`ReportError::Write`] where the file cannot be written.
pub fn write_parameters(dir: &Path, scene: &Scene, command: &str) -> Result<PathBuf, ReportError> {
    let path = dir.join("parameters.toml");
    let command = command.lines().collect::<Vec<_>>().join(" ");
    let text = format!(
        "# The scene with its defaults and with what --set has changed, by peel {VERSION}:\n#   {command}\n{}",
        scene.to_toml()
    );
    write_whole(&path, text.as_bytes())?;
    Ok(path)
}
