//! All figures, one after the other, and their captions.

use super::figure::Figure;
use super::numerics::{beam, levels, round_off, speed, verification};
use super::opening_rate;
use super::peeling::{
    directions, friction, laws, out_of_plane, points, pull, rough, spatula, spatula_directions, stiffness, strip, work,
};
use super::runner::Runner;
use super::solid;
use peelkit_report::{Part, ReportError, write_whole};
use std::path::{Path, PathBuf};

/// The captions.
const README: &str = "README.md";
/// What they begin with.
const HEADING: &str = "# Figures\n\nWritten by `peel figures`, from computed data only.\n";

/// Whether `dir` is what [`draw_figures`] has written before.
pub fn holds_figures(dir: &Path) -> bool {
    std::fs::read(dir.join(README)).is_ok_and(|text| text.starts_with(HEADING.as_bytes()))
}

/// Figures that are drawn together, as they share what is computed.
struct Group {
    /// How many peels they take at most.
    peels: usize,
    draw: fn(&Runner<'_>, &Path) -> Result<Vec<Figure>, ReportError>,
}

/// All of them, as they follow one another in the captions.
const GROUPS: [Group; 17] = [
    Group { peels: strip::PEELS, draw: strip::figures },
    Group { peels: spatula::PEELS, draw: spatula::figures },
    Group { peels: solid::PEELS, draw: |runner, dir| one(solid::figure(runner, dir)) },
    Group { peels: rough::strip::PEELS, draw: |runner, dir| one(rough::strip::figure(runner, dir)) },
    Group { peels: rough::spatula::PEELS, draw: |runner, dir| one(rough::spatula::figure(runner, dir)) },
    Group { peels: pull::PEELS, draw: |runner, dir| one(pull::figure(runner, dir)) },
    Group { peels: friction::PEELS, draw: |runner, dir| one(friction::figure(runner, dir)) },
    Group { peels: laws::PEELS, draw: laws::figures },
    Group { peels: 0, draw: |_, dir| one(opening_rate::figure(dir)) },
    Group { peels: out_of_plane::PEELS, draw: |runner, dir| one(out_of_plane::figure(runner, dir)) },
    Group { peels: directions::PEELS, draw: |runner, dir| one(directions::figure(runner, dir)) },
    Group { peels: spatula_directions::PEELS, draw: |runner, dir| one(spatula_directions::figure(runner, dir)) },
    Group { peels: stiffness::PEELS + work::PEELS, draw: of_stiffness },
    Group { peels: speed::PEELS, draw: speed::figures },
    Group { peels: 0, draw: |_, dir| one(beam::figure(dir)) },
    Group { peels: 0, draw: |_, dir| Ok(vec![levels::figure(dir)?, round_off::figure(dir)?]) },
    Group { peels: 0, draw: |_, dir| verification::figures(dir) },
];

fn one(figure: Result<Figure, ReportError>) -> Result<Vec<Figure>, ReportError> {
    figure.map(|figure| vec![figure])
}

/// The figures that show the same sweeps over the bending stiffness.
fn of_stiffness(runner: &Runner<'_>, dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let sweeps = stiffness::Sweeps::compute(runner);
    let mut figures = stiffness::figures(&sweeps, dir)?;
    figures.push(points::figure(&sweeps, dir)?);
    figures.push(work::figure(runner, &sweeps.full, dir)?);
    Ok(figures)
}

/// Regenerates the figures of `figures/` in `dir`, those of one part alone where `part` says so, as SVG and PNG, with their data as CSV and their
/// captions in `README.md`. The groups of figures are dealt out to the parts in turn.
///
/// `progress` is called with the number of finished peels and their total, from any thread.
///
/// Fails with the first picture that cannot be drawn or file that cannot be written.
pub fn draw_figures(
    dir: &Path,
    part: Option<Part>,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<PathBuf>, ReportError> {
    let groups = || Part::chosen(part, GROUPS);
    let runner = Runner::new(groups().map(|group| group.peels).sum(), progress);
    let mut figures = Vec::new();
    for group in groups() {
        figures.extend((group.draw)(&runner, dir)?);
    }
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
