//! The models of the scenes that come with the program, as JSON.
//!
//! Expected: each is one that can be computed, and is read as it was written, to the last bit.

use peelkit::model::PeelModel;
use peelkit_scene::Scene;
use std::fs;
use std::path::{Path, PathBuf};

fn scenes(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.filter(|path| path.extension().is_some_and(|extension| extension == "toml")).collect()
}

#[test]
fn the_model_of_every_scene_is_read_as_it_was_written() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let paths = [scenes(&folder), scenes(&folder.join("hard"))].concat();
    assert!(paths.len() > 20, "{paths:?}");
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        let scene = Scene::parse_any(path.to_str().unwrap(), &text, &[]).unwrap();
        let model = if scene.seta.is_some() { scene.tip_model() } else { scene.model };
        let written = serde_json::to_string(&model).unwrap();
        let read: PeelModel = serde_json::from_str(&written).unwrap();
        assert_eq!((read.clone(), read.check()), (model.clone(), Ok(())), "{}", path.display());
        assert_eq!(format!("{read:?}"), format!("{model:?}"), "{}", path.display());
    }
}
