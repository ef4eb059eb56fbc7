//! The page, as it stands in the binary.

use peelkit_scene::Scene;
use serde::Serialize;

/// A file of the page.
pub(crate) struct PageFile {
    pub path: &'static str,
    pub media: &'static str,
    pub text: &'static str,
}

/// Path, media type.
macro_rules! files {
    ($($path:literal $file:literal $media:literal),* $(,)?) => {
        &[$(PageFile { path: $path, media: $media, text: include_str!(concat!("../page/", $file)) }),*]
    };
}

/// All of them.
pub(crate) const FILES: &[PageFile] = files![
    "/" "index.html" "text/html; charset=utf-8",
    "/style.css" "style.css" "text/css; charset=utf-8",
    "/main.js" "main.js" "text/javascript; charset=utf-8",
    "/server.js" "server.js" "text/javascript; charset=utf-8",
    "/controls.js" "controls.js" "text/javascript; charset=utf-8",
    "/curve.js" "curve.js" "text/javascript; charset=utf-8",
    "/beam.js" "beam.js" "text/javascript; charset=utf-8",
    "/sweep.js" "sweep.js" "text/javascript; charset=utf-8",
    "/units.js" "units.js" "text/javascript; charset=utf-8",
    "/results.js" "results.js" "text/javascript; charset=utf-8",
    "/link.js" "link.js" "text/javascript; charset=utf-8",
    "/chart.js" "chart/chart.umd.min.js" "text/javascript; charset=utf-8",
    "/chart-licence.txt" "chart/LICENSE.md" "text/plain; charset=utf-8",
];

/// A scene that the page offers to start from.
#[derive(Clone, Debug, Serialize)]
pub struct StartScene {
    /// In messages
    pub name: String,
    /// As the page lists it
    pub title: String,
    /// TOML
    pub text: String,
}

impl StartScene {
    /// The scene that a user has read from a file: with its tables in its text and with what was set.
    pub fn of(scene: &Scene) -> Self {
        Self { name: scene.name.clone(), title: scene.title.clone(), text: scene.to_toml() }
    }
}

/// Name, title.
macro_rules! scenes {
    ($($name:literal $title:literal),* $(,)?) => {
        &[$(($name, $title, include_str!(concat!("../scenes/", $name)))),*]
    };
}

/// Name, title and text of the scenes that the page offers by itself.
pub const READY: &[(&str, &str, &str)] = scenes![
    "strip-100nm.toml" "Strip of 100 nm",
    "strip-soft.toml" "Very flexible strip",
    "strip-rough.toml" "Strip on wavy ground",
    "spatula.toml" "Spatula",
    "spatula-rough.toml" "Spatula on wavy ground",
    "tape.toml" "Adhesive tape",
    "strip-at-a-rate.toml" "Strip at a rate",
    "seta.toml" "Seta",
];

/// All scenes that the page offers, the user's own first.
pub(crate) fn start_scenes(own: Option<StartScene>) -> Vec<StartScene> {
    let ready = READY.iter().map(|&(name, title, text)| StartScene {
        name: name.into(),
        title: title.into(),
        text: text.into(),
    });
    own.into_iter().chain(ready).collect()
}
