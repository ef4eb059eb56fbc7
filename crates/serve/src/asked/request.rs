//! What the page asks: a scene, keys that replace those of it, and what of its run is wanted.

use crate::asked::refusal::Refusal;
use axum::body::Bytes;
use peelkit_scene::Scene;
use serde::Deserialize;
use serde::de::DeserializeOwned;

/// A scene as the page holds it.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct SceneText {
    /// In messages
    name: String,
    /// TOML
    scene: String,
    /// Keys with values that replace those of the text, as `--set`
    #[serde(default)]
    set: Vec<(String, String)>,
}

/// What of a run is wanted.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Part {
    /// The curve between the points of the path as well
    Curve,
    /// The outline of the beam along the path
    Poses,
    /// The keys of the scene with their values and ranges
    Controls,
    /// The displacement-controlled test
    Test,
    /// The scene as it was computed, in TOML
    Toml,
}

/// A run.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct PeelRequest {
    #[serde(flatten)]
    pub scene: SceneText,
    #[serde(default)]
    pub parts: Vec<Part>,
}

/// A file to keep.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(crate) enum File {
    #[serde(rename = "curve.csv")]
    Curve,
    #[serde(rename = "curve.svg")]
    Picture,
    #[serde(rename = "summary.json")]
    Summary,
    #[serde(rename = "parameters.toml")]
    Scene,
}

/// One of the files of a run.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct FileRequest {
    #[serde(flatten)]
    pub scene: SceneText,
    pub file: File,
}

/// Longest name of a scene, characters.
const LONGEST_NAME: usize = 60;

impl SceneText {
    /// The scene. No file is read, whatever it names.
    pub fn read(&self) -> Result<Scene, Refusal> {
        let plain = self.name.chars().filter(|letter| !letter.is_control());
        let name: String = plain.take(LONGEST_NAME).collect();
        Ok(Scene::parse_without_files(&name, &self.scene, &self.set)?)
    }
}

/// Reads a request.
pub(crate) fn parse<T: DeserializeOwned>(body: &Bytes) -> Result<T, Refusal> {
    serde_json::from_slice(body).map_err(|error| Refusal::Request(error.to_string()))
}
