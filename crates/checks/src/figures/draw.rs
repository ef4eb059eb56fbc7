//! All figures, one after the other, and their captions.

use super::figure::Figure;
use super::numerics::{beam, levels, round_off, speed, verification};
use super::peeling::{friction, laws, points, pull, rough, rough_spatula, spatula, stiffness, strip, work};
use super::runner::Runner;
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
pub fn draw_figures(dir: &Path, progress: &(dyn Fn(usize, usize) + Sync)) -> Result<Vec<PathBuf>, ReportError> {
    let total = strip::PEELS
        + spatula::PEELS
        + rough::PEELS
        + rough_spatula::PEELS
        + pull::PEELS
        + friction::PEELS
        + laws::PEELS
        + stiffness::PEELS
        + work::PEELS
        + speed::PEELS;
    let runner = Runner::new(total, progress);
    let mut figures = strip::figures(&runner, dir)?;
    figures.extend(spatula::figures(&runner, dir)?);
    figures.push(rough::figure(&runner, dir)?);
    figures.push(rough_spatula::figure(&runner, dir)?);
    figures.push(pull::figure(&runner, dir)?);
    figures.push(friction::figure(&runner, dir)?);
    figures.extend(laws::figures(&runner, dir)?);
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
