//! The scenes that documents show are read. A part of a scene is completed by what it lacks.

use super::{blocks, documents, text};
use peelkit_scene::{BODIES, Scene};

const STRIP: &str = "[strip]\nlength = \"100 nm\"\nheight = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n";
const ADHESION: &str = "[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";

/// The scene with a body and adhesion, where a document shows a part of one.
fn completed(part: &str) -> String {
    let has = |table: &str| part.lines().any(|line| line.starts_with(&format!("[{table}]")));
    let mut scene = part.to_owned() + "\n";
    // an array of setae has no body
    if has("setae") {
        return scene;
    }
    if !BODIES.iter().any(|body| has(body)) {
        scene += STRIP;
    }
    if !has("adhesion") {
        scene += ADHESION;
    }
    scene
}

#[test]
fn scenes_of_the_documents_are_read() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("beam.csv"), "s_nm,width_nm,height_nm\n0,20,5\n100,20,10\n").unwrap();
    std::fs::write(folder.path().join("heights.csv"), "x_nm,height_nm\n0,0\n50,-8\n100,0\n").unwrap();
    std::fs::write(folder.path().join("seta.toml"), text("scenes/seta.toml")).unwrap();
    let name = folder.path().join("scene.toml");
    let mut read = 0;
    for path in documents() {
        for block in blocks(&text(&path)).iter().filter(|block| block.kind == "toml") {
            let scene = Scene::parse_any(name.to_str().unwrap(), &completed(&block.text), &[]);
            let error = scene.err().map(|error| format!("{error:?}"));
            assert!(error.is_none(), "{path}, line {}: {}", block.lines.start, error.unwrap_or_default());
            read += 1;
        }
    }
    assert!(read > 5);
}
