//! A scene to run, and the scenes of a folder.

use std::path::{Path, PathBuf};

pub struct Job {
    pub name: String,
    pub text: String,
    pub observed: bool,
    /// Where files are that the scene names.
    pub folder: Option<PathBuf>,
}

impl Job {
    pub fn label(&self) -> String {
        format!("{}{}", self.name, if self.observed { " --observed" } else { "" })
    }
}

/// Of these scenes the test is computed as well.
const TESTED: [&str; 3] = ["strip.toml", "strip-soft.toml", "strip-100nm.toml"];

pub fn scenes_of(folder: &Path) -> std::io::Result<Vec<Job>> {
    let folder = folder.canonicalize()?;
    let mut jobs = Vec::new();
    for entry in std::fs::read_dir(&folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path)?;
        let observed = TESTED.contains(&name.as_str());
        jobs.push(Job { name, text, observed, folder: Some(folder.clone()) });
    }
    jobs.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(jobs)
}
