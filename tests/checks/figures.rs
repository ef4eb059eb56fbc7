//! The figures of `figures/`, as `peel figures` has drawn them: each picture is whole, and its data and its caption stand beside it.
//!
//! `.ci/run` draws all of them anew.

use crate::pictures::check_pictures;
use peelkit_checks::holds_figures;
use std::path::{Path, PathBuf};

#[test]
fn the_figures_come_with_their_data_and_captions() {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures");
    let files: Vec<PathBuf> = std::fs::read_dir(&dir).unwrap().map(|entry| entry.unwrap().path()).collect();
    check_pictures(&files);
    assert!(holds_figures(&dir));
    let readme = std::fs::read_to_string(dir.join("README.md")).unwrap();
    for stem in [
        "fig09-peeling",
        "peel-curve",
        "peel-shapes",
        "fig10-bending-stiffness",
        "fig10-three-ways",
        "peeling-work",
        "cost-against-error",
        "cost",
        "against-others",
        "accuracy",
    ] {
        for ending in ["svg", "png", "csv"] {
            assert!(files.contains(&dir.join(format!("{stem}.{ending}"))), "{stem}.{ending} is missing");
        }
        assert!(readme.contains(&format!("{stem}.svg")) && readme.contains(&format!("{stem}.csv")));
    }
    assert!(readme.contains("This range is ours"));
}
