//! What was found as one JSON object, summary.json, which is also what `--json` prints: where it comes from, what was found, and of what scene.

use super::parameters::parameters;
use crate::error::ReportError;
use crate::file::write_whole;
use crate::record::{Fields, Object, Record};
use peelkit_scene::Scene;
use serde::{Serialize, Serializer};
use std::io;
use std::path::{Path, PathBuf};

/// The version of the program that writes these outputs.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The number of the set of keys and columns that outputs have. Keys and columns may be added to a set; where one is renamed, removed or
/// means something else, the number grows by one.
pub const SCHEMA: u32 = 1;

/// What was found of a scene.
pub trait Found: Record {
    /// What `schema` is
    const SCHEMA: &'static str = "number of this set of keys and columns";
    /// What `command` is
    const COMMAND: &'static str = "the command line";
    /// What `parameters` are
    const PARAMETERS: &'static str;

    /// The scene as it was computed, defaults and overrides in
    fn parameters(&self, scene: &Scene) -> Object {
        parameters(scene)
    }
}

/// What was found of a scene, as one object.
#[derive(Clone, Debug)]
pub struct Summary<'a, F> {
    scene: &'a Scene,
    /// `None` where a program of another kind writes this
    command: Option<String>,
    pub(crate) found: F,
}

impl<F: Found> Record for Summary<'_, F> {
    fn fields(of: &mut Fields<Self>) {
        of.field("version", "of the program", |_| VERSION);
        of.field("schema", F::SCHEMA, |_| SCHEMA);
        of.field("command", F::COMMAND, |summary| summary.command.as_deref());
        of.field("scene", "the scene as it was named on the command line", |summary| summary.scene.name.as_str());
        of.field("title", "its title", |summary| summary.scene.title.as_str());
        of.part(|summary| &summary.found);
        of.field("parameters", F::PARAMETERS, |summary| summary.found.parameters(summary.scene));
    }
}

impl<'a, F: Found> Summary<'a, F> {
    pub(crate) fn of(scene: &'a Scene, found: F) -> Self {
        Self { scene, command: None, found }
    }

    /// The same with the command line that it comes from.
    pub fn with_command(self, command: &str) -> Self {
        Self { command: Some(command.to_owned()), ..self }
    }

    /// The object as text; a number that is not finite is an error that names its key.
    pub fn to_json(&self) -> io::Result<String> {
        Record::to_json(self)
    }

    /// Writes summary.json.
    ///
    /// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
    pub fn write(&self, dir: &Path) -> Result<PathBuf, ReportError> {
        let path = dir.join("summary.json");
        let text = self.to_json().map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, text.as_bytes())?;
        Ok(path)
    }
}

impl<F: Found> Serialize for Summary<'_, F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.object().serialize(serializer)
    }
}
