//! What was found as one JSON object, summary.json, which is also what `--json` prints: where it comes from, what was found, and of what scene.

use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use crate::writing::record::{Cell, Content, Fields, Object, Record};
use peelkit_scene::{KEYS, Key, Kind, Scene, Value};
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::fs;
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

// -- The scene as it was computed, as an object of summary.json --

/// The scene as it was computed, defaults and overrides in, a table of it an object; units in the names.
pub(crate) fn parameters(scene: &Scene) -> Object {
    // the title has a place of its own
    let alone = |key: &&Key| key.table.is_empty() && !matches!(key.kind, Kind::Text(_)) && key.belongs_to(scene);
    let given = |key: &'static Key| Some((Cow::from(key.name), given(&key.value(scene)?)));
    let mut object: Vec<_> = KEYS.iter().filter(alone).filter_map(given).collect();
    let stands = |key: &Key| !key.table.is_empty() && key.belongs_to(scene);
    let tables = KEYS.chunk_by(|a, b| a.table == b.table).filter(|keys| keys.iter().any(stands));
    object.extend(tables.map(|keys| (Cow::from(keys[0].table), Cell::Object(table(scene, keys)))));
    Object(object)
}

fn table(scene: &Scene, keys: &[Key]) -> Object {
    let entry = |key: &Key| {
        let unit = key.unit().replace('/', "_per_");
        let name = if unit.is_empty() { key.name.to_owned() } else { format!("{}_{unit}", key.name) };
        let cell = match key.value(scene) {
            Some(Value::Number(count)) if key.is_written_whole(count) => Cell::Count(count as u64),
            value => value.as_ref().map_or(Cell::Nothing, given),
        };
        (Cow::from(name), cell)
    };
    Object(keys.iter().filter(|key| key.belongs_to(scene)).map(entry).collect())
}

/// A value as a scene holds it.
fn given(value: &Value) -> Cell {
    match value {
        Value::Number(number) => Cell::Number(*number),
        Value::Text(text) => text.as_str().cell(),
        Value::Flag(flag) => Cell::Flag(*flag),
        Value::List(items) => Cell::List(items.iter().map(given).collect()),
        Value::Table(entries) => {
            Cell::Object(Object(entries.iter().map(|(name, value)| (Cow::from(name.clone()), given(value))).collect()))
        }
        Value::Other(_) => Cell::Nothing,
    }
}

// -- parameters.toml: the scene as it was computed, to be run again --

const PARAMETERS: &str = "parameters.toml";

/// Writes parameters.toml: the scene with its defaults and with what was set on the command line, which `peel run` computes to the same
/// numbers. `command`, the command line, stands above it as a remark.
///
/// Fails with [`ReportError::Write`] where the file cannot be written.
pub fn write_parameters(dir: &Path, scene: &Scene, command: &str) -> Result<PathBuf, ReportError> {
    let path = dir.join(PARAMETERS);
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
    let text = fs::read_to_string(dir.join(PARAMETERS)).ok()?;
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
