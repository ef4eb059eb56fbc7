//! The figures of `figures/`: computed, drawn, and written with the data and a caption beside each.

use super::chart::{Picture, save};
use super::{
    ReportError, figure_beam, figure_friction, figure_laws, figure_levels, figure_points, figure_pull, figure_rough,
    figure_rough_spatula, figure_round_off, figure_spatula, figure_speed, figure_stiffness, figure_strip,
    figure_verification, figure_work, write_whole,
};
use crate::model::{PeelModel, StripModel};
use crate::study::{Accuracy, Bounds, Peel, SweepCase, SweepRow, peel, sweep};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

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
    let total = figure_strip::PEELS
        + figure_spatula::PEELS
        + figure_rough::PEELS
        + figure_rough_spatula::PEELS
        + figure_pull::PEELS
        + figure_friction::PEELS
        + figure_laws::PEELS
        + figure_stiffness::PEELS
        + figure_work::PEELS
        + figure_speed::PEELS;
    let runner = Runner { done: AtomicUsize::new(0), total, progress };
    let mut figures = figure_strip::figures(&runner, dir)?;
    figures.extend(figure_spatula::figures(&runner, dir)?);
    figures.push(figure_rough::figure(&runner, dir)?);
    figures.push(figure_rough_spatula::figure(&runner, dir)?);
    figures.push(figure_pull::figure(&runner, dir)?);
    figures.push(figure_friction::figure(&runner, dir)?);
    figures.extend(figure_laws::figures(&runner, dir)?);
    let stiffness = figure_stiffness::Sweeps::compute(&runner);
    figures.extend(figure_stiffness::figures(&stiffness, dir)?);
    figures.push(figure_points::figure(&stiffness, dir)?);
    figures.push(figure_work::figure(&runner, &stiffness.full, dir)?);
    figures.extend(figure_speed::figures(&runner, dir)?);
    figures.push(figure_beam::figure(dir)?);
    figures.push(figure_levels::figure(dir)?);
    figures.push(figure_round_off::figure(dir)?);
    figures.extend(figure_verification::figures(dir)?);
    // Where the largest work needed no refinement fewer peels were run than planned.
    if runner.done.load(Ordering::Relaxed) < total {
        progress(total, total);
    }
    let readme = dir.join(README);
    write_whole(&readme, captions(&figures).as_bytes())?;
    let mut files: Vec<PathBuf> = figures.into_iter().flat_map(|figure| figure.files).collect();
    files.push(readme);
    Ok(files)
}

/// One figure as it was written.
pub(super) struct Figure {
    pub stem: &'static str,
    pub caption: String,
    pub files: Vec<PathBuf>,
}

impl Figure {
    /// Writes the picture and the data behind it.
    pub fn write(
        dir: &Path,
        stem: &'static str,
        caption: String,
        picture: &Picture,
        data: &Table,
    ) -> Result<Self, ReportError> {
        let mut figure = Figure { stem, caption, files: save(picture, dir, stem)? };
        figure.add_table(dir, stem, data)?;
        Ok(figure)
    }

    /// Writes `dir/stem.csv`, data behind this figure.
    pub fn add_table(&mut self, dir: &Path, stem: &str, data: &Table) -> Result<(), ReportError> {
        let path = dir.join(format!("{stem}.csv"));
        let text = data.text().map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, &text)?;
        self.files.push(path);
        Ok(())
    }
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

/// The data behind a figure.
pub(super) struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new(header: &[&str]) -> Self {
        Table { rows: vec![header.iter().map(|name| name.to_string()).collect()] }
    }

    /// A row: words, then numbers that may be missing, then words.
    pub fn push(&mut self, before: &[&str], numbers: &[Option<f64>], after: &[&str]) {
        let words = |words: &[&str]| words.iter().map(|word| word.to_string()).collect::<Vec<_>>();
        let numbers = numbers.iter().map(|v| v.map(|v| v.to_string()).unwrap_or_default());
        self.rows.push(words(before).into_iter().chain(numbers).chain(words(after)).collect());
    }

    fn text(&self) -> std::io::Result<Vec<u8>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        self.rows.iter().try_for_each(|row| writer.write_record(row))?;
        writer.into_inner().map_err(|e| e.into_error())
    }
}

/// Runs peels and counts them.
pub(super) struct Runner<'a> {
    done: AtomicUsize,
    total: usize,
    progress: &'a (dyn Fn(usize, usize) + Sync),
}

pub(super) const ACCURACY: Accuracy = Accuracy::to(1e-6);
pub(super) const BOUNDS: Bounds = Bounds { points: 20_000, time_s: None, displacement: None };

impl Runner<'_> {
    pub fn peel<'m, M>(&self, model: &'m M) -> Peel
    where
        PeelModel: From<&'m M>,
    {
        let peel = peel(model, &ACCURACY, &BOUNDS);
        self.count();
        peel
    }

    /// The same of several, on all cores, as far as `bounds` say and as well as `accuracy` says.
    pub fn peel_all(&self, models: &[PeelModel], accuracy: &Accuracy, bounds: &Bounds) -> Vec<Peel> {
        let peel = |model: &PeelModel| {
            let peel = peel(model, accuracy, bounds);
            self.count();
            peel
        };
        models.par_iter().map(peel).collect()
    }

    pub fn sweep<M: Clone + Into<PeelModel>>(&self, cases: &[(f64, M)]) -> Vec<SweepRow> {
        self.sweep_to(ACCURACY, cases)
    }

    pub fn sweep_to<M: Clone + Into<PeelModel>>(&self, accuracy: Accuracy, cases: &[(f64, M)]) -> Vec<SweepRow> {
        let case = |(value, model): &(f64, M)| SweepCase {
            value: *value,
            model: model.clone().into(),
            accuracy,
            bounds: BOUNDS,
        };
        sweep(&cases.iter().map(case).collect::<Vec<_>>(), &|| true, &|_| self.count())
    }

    fn count(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        (self.progress)(done, self.total);
    }
}

/// The strip of Section 6 of the paper, of the given length in nm.
pub(super) fn paper_strip(length: f64) -> StripModel {
    StripModel::of_the_paper(length, 1.0)
}
