//! What `run` and `sweep` read: a scene and the keys that replace those of its text.

use crate::folder_name::default_folder;
use crate::stop::Stop;
use clap::Args;
use peelkit_scene::{Scene, SceneError};
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct SceneArgs {
    /// The scene: a TOML file; `peel new` writes a template
    #[arg(value_name = "SCENE")]
    pub path: PathBuf,

    /// Sets a key of the scene: strip.length="50 nm"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_override)]
    pub overrides: Vec<(String, String)>,
}

impl SceneArgs {
    /// Reads the scene of a peel: one with a seta is refused.
    pub fn load(&self) -> Result<Scene, Stop> {
        read_scene(&self.path, &self.overrides)
    }

    /// Reads the scene, which may have a seta.
    pub fn load_with_seta(&self) -> Result<Scene, Stop> {
        read(&self.path, |name, text| Scene::parse_with_seta(name, text, &self.overrides))
    }

    /// Reads the scene, which may have a seta or be pulled at a rate.
    pub fn load_any(&self) -> Result<Scene, Stop> {
        read(&self.path, |name, text| Scene::parse_any(name, text, &self.overrides))
    }

    /// Where the outputs go when the user does not say; `parts` are what a command adds to the name.
    pub fn default_folder(&self, parts: &[String]) -> PathBuf {
        default_folder(&self.path, parts, &self.overrides)
    }
}

/// Reads a scene of a peel.
pub fn read_scene(path: &Path, overrides: &[(String, String)]) -> Result<Scene, Stop> {
    read(path, |name, text| Scene::parse(name, text, overrides))
}

fn read(path: &Path, parse: impl FnOnce(&str, &str) -> Result<Scene, SceneError>) -> Result<Scene, Stop> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| {
        Stop::bad_input(
            format!("cannot read the scene {name}: {error}"),
            "Give the path of a scene file; `peel new` writes a template.",
        )
    })?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..valid].iter().filter(|&&byte| byte == b'\n').count();
        Stop::bad_input(
            format!("{name}, line {line}: this is not text in UTF-8"),
            "A scene is a TOML file, saved as UTF-8; `peel new` writes a template.",
        )
    })?;
    Ok(parse(&name, &text)?)
}

pub fn parse_override(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("write KEY=VALUE, for example strip.length=\"50 nm\"")?;
    Ok((key.trim().to_owned(), value.to_owned()))
}
