//! No text makes the parser panic.

use crate::text::{MINIMAL, with};
use peelkit_scene::{KEYS, Scene};
use proptest::prelude::*;

proptest! {
    #[test]
    fn no_text_makes_the_parser_panic(text in "\\PC*") {
        let _ = Scene::parse("a.toml", &text, &[]);
    }

    #[test]
    fn no_override_makes_the_parser_panic(key in "\\PC*", value in "\\PC*") {
        let _ = with(&key, &value);
    }

    #[test]
    fn no_value_makes_the_parser_panic(index in 0..KEYS.len(), value in "[-+0-9.eE]{0,8}[ ]?[\\PC\n]{0,6}") {
        let _ = with(&KEYS[index].path(), &value);
    }

    /// A scene with some of its characters put out of place: read or refused with a message, and what is read is whole.
    #[test]
    fn no_garbled_scene_makes_the_parser_panic(edits in prop::collection::vec((0..MINIMAL.len(), any::<char>()), 1..6)) {
        let mut text: Vec<char> = MINIMAL.chars().collect();
        for (at, character) in edits {
            text[at] = character;
        }
        if let Ok(scene) = Scene::parse("a.toml", &text.into_iter().collect::<String>(), &[]) {
            let strip = *scene.model.strip().unwrap();
            prop_assert!(strip.length.is_finite() && strip.height.is_finite() && strip.material.youngs_modulus.is_finite());
        }
    }
}
