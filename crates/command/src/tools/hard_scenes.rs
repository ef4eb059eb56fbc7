//! The hard scenes, as they lie in `scenes/hard`, and how each is expected to end.

use crate::terminal::stop::Stop;
use peelkit_checks::suite::hard::{Ending, HardScene};
use peelkit_scene::Scene;

/// Name, text, ending.
macro_rules! scenes {
    ($($name:literal $ending:ident),* $(,)?) => {
        &[$(($name, include_str!(concat!("../../scenes/hard/", $name, ".toml")), Ending::$ending)),*]
    };
}

const SCENES: &[(&str, &str, Ending)] = scenes![
    "bending-1e-6" TurnedBack,
    "bending-1e6" Pivoting,
    "block" Detached,
    "cusp" Pivoting,
    "guided" Detached,
    "hamaker-1e-3" Pivoting,
    "hamaker-1e3" Refused,
    "incompressible" Pivoting,
    "inextensible" Pivoting,
    "long" Pivoting,
    "no-snap" Pivoting,
    "on-edge" Pivoting,
    "one-thickness" Pivoting,
    "r0-large" Pivoting,
    "r0-small" TurnedBack,
    "shear-soft" Pivoting,
    "thin" Pivoting,
    "toe" Bound,
    "touch-again" TurnedBack,
    "unshearable" Pivoting,
];

/// All of them, read.
pub fn hard_scenes() -> Result<Vec<HardScene>, Stop> {
    let read = |&(name, text, expected): &(&'static str, &str, Ending)| {
        let Scene { model, accuracy, bounds, .. } = Scene::parse(&format!("scenes/hard/{name}.toml"), text, &[])?;
        Ok(HardScene { name, model, accuracy, bounds, expected })
    };
    SCENES.iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_folder_is_in_the_list() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/hard");
        let mut files: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|file| file.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned())
            .collect();
        files.sort();
        assert_eq!(files, SCENES.iter().map(|scene| scene.0).collect::<Vec<_>>());
        assert_eq!(hard_scenes().unwrap().len(), SCENES.len());
    }
}
