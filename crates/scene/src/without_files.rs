//! A scene that somebody else wrote, such as a page: it reads no file.

use super::document::name_of;
use super::error::{Origin, SceneError, ValueError};
use super::keys::KEYS;
use super::not_toml::not_toml;
use super::scene::Scene;
use toml::de::DeTable;

impl Scene {
    /// As [`Scene::parse`], of a text that somebody else wrote: no file is read. A table of such a scene stands in its text; one that
    /// is the name of a file is refused, wherever it stands.
    pub fn parse_without_files(name: &str, text: &str, overrides: &[(String, String)]) -> Result<Self, SceneError> {
        let file = Origin::File { name, text };
        let document = DeTable::parse(text).map_err(|error| not_toml(&file, text, &error))?;
        for key in KEYS.iter().filter(|key| key.reads_a_file()) {
            let table = document.get_ref().iter().find(|(table, _)| name_of(table) == key.table);
            let keys = table.and_then(|(_, table)| table.get_ref().as_table());
            let value = keys.and_then(|keys| keys.iter().find(|(name, _)| name_of(name) == key.name));
            let named = value.filter(|(_, value)| value.get_ref().as_str().is_some_and(|text| !text.contains('\n')));
            if let Some((_, value)) = named {
                return Err(file.error(value.span(), &format!("`{}`", key.path()), names_a_file()));
            }
            if let Some((path, value)) = overrides.iter().find(|(path, _)| path.trim() == key.path()) {
                let text = format!("{path}={value}");
                let origin = Origin::Override { text: &text };
                return Err(origin.error(0..path.len(), &format!("`{}`", key.path()), names_a_file()));
            }
        }
        Self::parse(name, text, overrides)
    }
}

fn names_a_file() -> ValueError {
    ValueError::new(
        "names a file, and this scene is read without files",
        "Put the lines of the table into the scene, between \"\"\" and \"\"\".",
    )
}
