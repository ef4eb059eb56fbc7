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

/// First peaks against the direction are those of the collocation, and what is not drawn as stable lies behind a branch
/// point, above the stable peak beside it.
#[test]
fn first_peaks_in_all_directions() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/directions.csv");
    let mut reader = csv::Reader::from_path(path).unwrap();
    let header = reader.headers().unwrap().clone();
    let rows: Vec<_> = reader.records().map(|row| row.unwrap()).collect();
    let of = |row: &csv::StringRecord, column: &str| number(row, &header, column);
    let reference = |case: &str| {
        let table = include_str!("../../verification/space_peels.csv").lines();
        let row = table.filter_map(|line| line.strip_prefix(&format!("{case},peak_force_nN,"))).next().unwrap();
        row.split(',').next().unwrap().parse::<f64>().unwrap()
    };
    for (case, [elevation, azimuth], roll) in
        [("sideways", [60.0, 90.0], None), ("rolled", [90.0, 0.0], Some(5.0)), ("upright", [90.0, 0.0], Some(1e-8))]
    {
        let at = |row: &&csv::StringRecord| {
            [of(row, "elevation_deg"), of(row, "azimuth_deg"), of(row, "roll_deg")]
                == [Some(elevation), Some(azimuth), roll]
        };
        let row = rows.iter().find(at).unwrap_or_else(|| panic!("{case} is missing"));
        let (force, error) = (of(row, "force_nN").unwrap(), of(row, "force_error_nN").unwrap());
        let apart = (force - reference(case)).abs();
        assert!(apart <= error && error <= 1e-6 * force, "{case}: {force} ± {error}, apart by {apart:.1e}");
    }
    let (stable, unstable): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.iter().any(|cell| cell == "true"));
    assert!(unstable.len() == 5 && stable.len() >= 90, "{} and {}", unstable.len(), stable.len());
    assert!(stable.iter().all(|row| of(row, "branch_point_force_nN").is_none()));
    for row in unstable {
        let (force, place) = (of(row, "force_nN").unwrap(), of(row, "displacement_nm").unwrap());
        assert!(
            of(row, "branch_point_force_nN").unwrap() < force
                && of(row, "branch_point_displacement_nm").unwrap() < place
        );
        let beside = |other: &&&csv::StringRecord| {
            of(other, "roll_deg").is_none()
                && of(other, "elevation_deg") == of(row, "elevation_deg")
                && (of(other, "azimuth_deg").unwrap() - of(row, "azimuth_deg").unwrap()).abs() < 0.2
        };
        let beside = stable.iter().find(beside).expect("a stable peak beside it");
        assert!(of(beside, "force_nN").unwrap() < force, "{row:?}");
    }
}
