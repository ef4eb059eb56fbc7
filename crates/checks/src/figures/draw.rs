//! All figures, one after the other, and their captions.

use super::figure::Figure;
use super::numerics::{beam, levels, round_off, speed, verification};
use super::peeling::{
    directions, friction, laws, out_of_plane, points, pull, rough, rough_spatula, spatula, spatula_directions,
    stiffness, strip, work,
};
use super::runner::Runner;
use super::solid;
use peelkit_report::{ReportError, write_whole};
use std::path::{Path, PathBuf};

/// The captions.
const README: &str = "README.md";
/// What they begin with.
const HEADING: &str = "# Figures\n\nWritten by `peel figures`, from computed data only.\n";

/// Whether `dir` is what [`draw_figures`] has written before.
pub fn holds_figures(dir: &Path) -> bool {
    std::fs::read(dir.join(README)).is_ok_and(|text| text.starts_with(HEADING.as_bytes()))
}

/// Regenerates every figure of `figures/` in `dir`, as SVG and PNG, with its data as CSV and its caption in `README.md`.
///
/// `progress` is called with the number of finished peels and their total, from any thread.
///
/// Fails with the first picture that cannot be drawn or file that cannot be written.
pub fn draw_figures(dir: &Path, progress: &(dyn Fn(usize, usize) + Sync)) -> Result<Vec<PathBuf>, ReportError> {
    let total = strip::PEELS
        + spatula::PEELS
        + rough::PEELS
        + rough_spatula::PEELS
        + pull::PEELS
        + friction::PEELS
        + laws::PEELS
        + out_of_plane::PEELS
        + directions::PEELS
        + spatula_directions::PEELS
        + solid::PEELS
        + stiffness::PEELS
        + work::PEELS
        + speed::PEELS;
    let runner = Runner::new(total, progress);
    let mut figures = strip::figures(&runner, dir)?;
    figures.extend(spatula::figures(&runner, dir)?);
    figures.push(solid::figure(&runner, dir)?);
    figures.push(rough::figure(&runner, dir)?);
    figures.push(rough_spatula::figure(&runner, dir)?);
    figures.push(pull::figure(&runner, dir)?);
    figures.push(friction::figure(&runner, dir)?);
    figures.extend(laws::figures(&runner, dir)?);
    figures.push(out_of_plane::figure(&runner, dir)?);
    figures.push(directions::figure(&runner, dir)?);
    figures.push(spatula_directions::figure(&runner, dir)?);
    let stiffness = stiffness::Sweeps::compute(&runner);
    figures.extend(stiffness::figures(&stiffness, dir)?);
    figures.push(points::figure(&stiffness, dir)?);
    figures.push(work::figure(&runner, &stiffness.full, dir)?);
    figures.extend(speed::figures(&runner, dir)?);
    figures.push(beam::figure(dir)?);
    figures.push(levels::figure(dir)?);
    figures.push(round_off::figure(dir)?);
    figures.extend(verification::figures(dir)?);
    // Where the largest work needed no refinement fewer peels were run than planned.
    runner.finish();
    with_captions(figures, dir)
}

/// Writes the captions; all files that are there then.
fn with_captions(figures: Vec<Figure>, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let readme = dir.join(README);
    write_whole(&readme, captions(&figures).as_bytes())?;
    let mut files: Vec<PathBuf> = figures.into_iter().flat_map(|figure| figure.files).collect();
    files.push(readme);
    Ok(files)
}

fn captions(figures: &[Figure]) -> String {
    let mut text = HEADING.to_owned();
    for Figure { stem, caption, files } in figures {
        let names = files.iter().filter_map(|f| f.file_name()?.to_str()).filter(|n| n.ends_with(".csv"));
        let data: Vec<String> = names.map(|n| format!("[{n}]({n})")).collect();
        text += &format!("\n## {stem}\n\n![{stem}]({stem}.svg)\n\n{caption}\n\nData: {}\n", data.join(", "));
    }
    text
}

#[cfg(test)]
#[path = "../../../../tests/shared/pictures.rs"]
mod pictures;

#[cfg(test)]
mod tests {
    use super::*;

    /// Those of one strip, which take two peels: pictures that are whole, with their data and captions.
    #[test]
    fn figures_come_with_their_data_and_captions() {
        let dir = tempfile::tempdir().unwrap();
        let counted = std::sync::Mutex::new(Vec::new());
        let progress = |done, total| counted.lock().unwrap().push((done, total));
        let drawn = strip::figures(&Runner::new(strip::PEELS, &progress), dir.path()).unwrap();
        assert!(!holds_figures(dir.path()), "without captions they are not known again");
        let files = with_captions(drawn, dir.path()).unwrap();
        assert!(holds_figures(dir.path()));
        let texts = pictures::check_pictures(&files);
        assert!(texts.contains("Peeling of an elastic strip, L = 200 nm"));
        let readme = std::fs::read_to_string(dir.path().join(README)).unwrap();
        for stem in ["fig09-peeling", "peel-curve", "peel-shapes"] {
            for ending in ["svg", "png", "csv"] {
                assert!(files.contains(&dir.path().join(format!("{stem}.{ending}"))), "{stem}.{ending} is missing");
            }
            assert!(readme.contains(&format!("{stem}.svg")) && readme.contains(&format!("{stem}.csv")));
        }
        let mut counted = counted.into_inner().unwrap();
        counted.sort_unstable();
        assert_eq!(counted.last(), Some(&(strip::PEELS, strip::PEELS)));
    }
}
