//! Garbled scenes and runs of absurd ones.

mod generator;
mod runs;
mod scenes;

/// What broke once: the scenes of `tests/garbled/`, each with its name. Their first lines say what was wrong.
fn corpus() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/garbled");
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap())).collect()
}
