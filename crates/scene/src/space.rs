//! Whether a scene is in space, and which keys only such a scene has.

use super::error::ValueError;
use super::key::Key;
use super::scene::Scene;
use peelkit::model::Space;

/// The keys of a scene in space alone: each of them implies that it is in space.
const KEYS: [(&str, &str); 5] =
    [("strip", "section"), ("grip", "lateral"), ("grip", "roll"), ("grip", "yaw"), ("drive", "azimuth")];

/// Whether only a scene in space has this key.
pub(super) fn has(table: &str, name: &str) -> bool {
    KEYS.contains(&(table, name))
}

/// What the scene has besides one in the plane, which it is from now on not.
pub(super) fn of(scene: &mut Scene) -> &mut Space {
    scene.model.space.get_or_insert_default()
}

/// Makes it one in space or in the plane.
pub(super) fn set(scene: &mut Scene, in_space: bool) {
    scene.model.space = in_space.then(|| scene.model.space.unwrap_or_default());
}

/// That a scene in the plane has no such key.
pub(super) fn foreign() -> ValueError {
    let names: Vec<&str> = KEYS.iter().map(|(_, name)| *name).collect();
    ValueError::new(
        "is a key of a scene in space, and this scene has `space` = false",
        format!("Write `space = true`, or remove the keys of space: {}.", names.join(", ")),
    )
}

impl Key {
    /// Whether only a scene in space has it. Where a scene gives it and says nothing of `space`, it is in space.
    pub fn is_of_space(&self) -> bool {
        has(self.table, self.name)
    }
}
