//! The figures of `figures/`, as `peel figures` has drawn them: each picture is whole, and its data and its caption stand beside it.
//!
//! `.ci/run` draws a third of them anew in each run.

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
        "fig05-elements",
        "fig09-peeling",
        "peel-curve",
        "peel-shapes",
        "fig10-bending-stiffness",
        "fig10-three-ways",
        "peeling-work",
        "directions",
        "spatula-directions",
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

/// A column of a row of figures/directions.csv.
fn number(row: &csv::StringRecord, header: &csv::StringRecord, column: &str) -> Option<f64> {
    let place = header.iter().position(|name| name == column).expect("a column of this name");
    row[place].parse().ok()
}

/// Pull-off forces against the direction and the roll. Reference: collocation of the strong form, in space and on the branch that leaves the plane.
/// Expected: where the path is stable up to its first peak, that is the pull-off force of these cases, both within their bounds; straight up, where
/// it is not, the pull-off is the peak of the branch. The largest force of a test is nowhere below a stable first peak, and one test of 32 fails.
#[test]
fn pull_offs_in_all_directions() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/directions.csv");
    let mut reader = csv::Reader::from_path(path).unwrap();
    let header = reader.headers().unwrap().clone();
    let rows: Vec<_> = reader.records().map(|row| row.unwrap()).collect();
    let of = |row: &csv::StringRecord, column: &str| number(row, &header, column);
    let reference = |table: &str, case: &str| {
        let line = table.lines().find_map(|line| line.strip_prefix(&format!("{case},peak_force_nN,"))).unwrap();
        line.split(',').next().unwrap().parse::<f64>().unwrap()
    };
    let [space, branch] = [
        include_str!("../../verification/space_peels.csv"),
        include_str!("../../verification/out_of_plane_branch.csv"),
    ];
    for (wanted, [elevation, azimuth], roll) in [
        (reference(space, "sideways"), [60.0, 90.0], None),
        (reference(space, "rolled"), [90.0, 90.0], Some(5.0)),
        (reference(space, "upright"), [90.0, 90.0], Some(1e-8)),
        (reference(branch, "wide_40"), [90.0, 90.0], None),
    ] {
        let at = |row: &&csv::StringRecord| {
            [of(row, "elevation_deg"), of(row, "azimuth_deg"), of(row, "roll_deg")]
                == [Some(elevation), Some(azimuth), roll]
        };
        let row = rows.iter().find(at).unwrap_or_else(|| panic!("{wanted} is missing"));
        let is_stable = row.iter().any(|cell| cell == "true");
        for kind in if is_stable { &["pull_off", "first_peak"][..] } else { &["pull_off"] } {
            let (force, error) = (of(row, &format!("{kind}_force_nN")), of(row, &format!("{kind}_error_nN")));
            let (force, error) = (force.unwrap(), error.unwrap());
            let apart = (force - wanted).abs();
            assert!(apart <= error && error <= 1e-6 * force, "{kind}: {force} ± {error}, apart by {apart:.1e}");
        }
    }
    let (off, failed): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.iter().any(|cell| cell == "off"));
    assert!(failed.len() <= 1 && off.len() >= 31, "{} and {}", failed.len(), off.len());
    for row in off.into_iter().filter(|row| row.iter().any(|cell| cell == "true")) {
        let [force, error, first] =
            ["pull_off_force_nN", "pull_off_error_nN", "first_peak_force_nN"].map(|column| of(row, column).unwrap());
        let slack = error + of(row, "first_peak_error_nN").unwrap();
        assert!(force + slack >= first, "{row:?}");
    }
}
