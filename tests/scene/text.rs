//! Scenes and questions to them that several tests share.

use peelkit_scene::{Scene, SceneError};

/// The least that a strip needs.
pub use crate::strip::STRIP_SCENE as MINIMAL;

/// The least that a spatula needs.
pub const SPATULA: &str = r#"
[spatula]
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

/// A beam in a table.
pub const PROFILE: &str = r#"
[profile]
table = """
s_nm, width_nm, height_nm, angle_deg
# the pad
0, 20, 5, 0
40, 20, 5, 0
100, 10, 10, 30
"""
youngs_modulus = "2 GPa"
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

/// Every key of a piece, and the least that one needs.
pub const PIECES: &str = r#"
[profile]
youngs_modulus = "2 GPa"
[[profile.pieces]]
length = "0.25 um"
width = ["200 nm", "150 nm"]
height = "5 nm"
[[profile.pieces]]
length = "150 nm"
width = ["150 nm", "50 nm"]
height = ["5 nm", "50 nm"]
roundness = [0, 1]
bend = "30 deg"
course = "smooth"
height_course = "smooth"
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

/// One override.
pub fn set(key: &str, value: &str) -> Vec<(String, String)> {
    vec![(key.to_owned(), value.to_owned())]
}

/// The least scene of a strip with one override, or the message and its remedy.
pub fn with(key: &str, value: &str) -> Result<Scene, String> {
    Scene::parse("a.toml", MINIMAL, &set(key, value)).map_err(|error| format!("{error} / {}", error.remedy()))
}

/// The message about a text, its remedy behind it.
pub fn complaint(text: &str) -> String {
    let error = Scene::parse("dir/a.toml", text, &[]).expect_err(text);
    format!("{error} / {}", error.remedy())
}

pub fn assert_says(complaint: &str, parts: &[&str]) {
    for part in parts {
        assert!(complaint.contains(part), "{part:?} is not in {complaint:?}");
    }
}

/// A scene is refused, and message and remedy together have these parts.
#[track_caller]
pub fn assert_refused(found: Result<Scene, SceneError>, parts: &[&str]) {
    let error = found.unwrap_err();
    let text = format!("{error} {}", error.remedy());
    for part in parts {
        assert!(text.contains(part), "{part:?} is not in\n{text}");
    }
}
