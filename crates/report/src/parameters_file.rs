//! parameters.toml: the scene as it was computed, to be run again.

use super::error::ReportError;
use super::file::write_whole;
use super::records::summary::VERSION;
use peelkit_scene::Scene;
use std::fs;
use std::path::{Path, PathBuf};

const NAME: &str = "parameters.toml";

/// Writes parameters.toml: the scene with its defaults and with what was set on the command line, which `peel run` computes to the same
/// numbers. `command`, the command line, stands above it as a remark.
///
/// Fails with [`ReportError::Write`] where the file cannot be written.
pub fn write_parameters(dir: &Path, scene: &Scene, command: &str) -> Result<PathBuf, ReportError> {
    let path = dir.join(NAME);
    let command = command.lines().collect::<Vec<_>>().join(" ");
    let text = format!(
        "# The scene with its defaults and with what --set has changed, by peel {VERSION}:\n#   {command}\n{}",
        scene.to_toml()
    );
    write_whole(&path, text.as_bytes())?;
    Ok(path)
}

/// The command line that stands above the scene of parameters.toml in this folder; none where there is no such file.
pub fn command_of_results(dir: &Path) -> Option<String> {
    let text = fs::read_to_string(dir.join(NAME)).ok()?;
    Some(text.lines().nth(1)?.strip_prefix("#   ")?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_is_read_again() {
        let scene = "strip = { length = \"100 nm\", height = \"10 nm\", youngs_modulus = \"2 GPa\" }\n\
                     adhesion = { hamaker_constant = \"1e-19 J\", equilibrium_distance = \"0.4 nm\" }\n";
        let scene = Scene::parse("a.toml", scene, &[]).unwrap();
        let dir = tempfile::tempdir().unwrap();
        assert_eq!(command_of_results(dir.path()), None);
        write_parameters(dir.path(), &scene, "peel run a.toml").unwrap();
        assert_eq!(command_of_results(dir.path()).as_deref(), Some("peel run a.toml"));
    }
}
