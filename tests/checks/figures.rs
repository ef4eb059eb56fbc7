//! The figures of `figures/`, drawn.

use crate::pictures::check_pictures;
use peelkit_checks::draw_figures;

#[test]
#[ignore = "takes minutes where the program is not optimised: .ci/run draws the figures with the release build"]
fn the_figures_come_with_their_data_and_captions() {
    let dir = tempfile::tempdir().unwrap();
    let counted = std::sync::Mutex::new(Vec::new());
    let files = draw_figures(dir.path(), &|done, total| counted.lock().unwrap().push((done, total))).unwrap();
    check_pictures(&files);
    let readme = std::fs::read_to_string(dir.path().join("README.md")).unwrap();
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
            assert!(files.contains(&dir.path().join(format!("{stem}.{ending}"))), "{stem}.{ending} is missing");
        }
        assert!(readme.contains(&format!("{stem}.svg")) && readme.contains(&format!("{stem}.csv")));
    }
    assert!(readme.contains("This range is ours"));
    let mut counted = counted.into_inner().unwrap();
    counted.sort_unstable();
    assert_eq!(counted.last().map(|&(done, total)| done == total), Some(true));
}
