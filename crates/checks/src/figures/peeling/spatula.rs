//! A gecko's spatula, Fig. 7 of the paper as a beam.

use super::strip::{curve_table, shape_table};
use crate::figures::figure::Figure;
use crate::figures::runner::Runner;
use peelkit::model::Spatula;
use peelkit::study::Peel;
use peelkit_report::ReportError;
use peelkit_report::chart::significant;
use peelkit_report::pictures::peel::{curve, numbered_points, shapes};
use std::path::Path;

/// How many peels the figures of this file take.
pub(in crate::figures) const PEELS: usize = 1;

pub(in crate::figures) fn figures(runner: &Runner<'_>, dir: &Path) -> Result<Vec<Figure>, ReportError> {
    let peel = runner.peel(&Spatula::default().model());
    let numbered = numbered_points(&peel);
    Ok(vec![force(&peel, &numbered, dir)?, deformed(&peel, &numbered, dir)?])
}

fn force(peel: &Peel, numbered: &[usize], dir: &Path) -> Result<Figure, ReportError> {
    let stem = "fig07-spatula";
    let title = "Pull-off of a gecko's spatula";
    let picture = curve(peel, numbered, title, &dir.join(format!("{stem}.svg")))?;
    let peak = peel.peak.map(|peak| significant(peak.force, 4)).unwrap_or_default();
    let caption = format!(
        "Force on the end of a spatula's shaft, whose rotation is fixed, against its displacement (scenes/spatula.toml). The peak is {peak} \
         nN; Fig. 7 of the paper has 6.7 nN, from a solid of 100 000 elements whose dimensions it does not give: those of this beam \
         are ours. Dashed: equilibria that are unstable under displacement control. The numbers are those of `spatula-shapes`."
    );
    Figure::write(dir, stem, caption, &picture, &curve_table(peel))
}

fn deformed(peel: &Peel, numbered: &[usize], dir: &Path) -> Result<Figure, ReportError> {
    let stem = "spatula-shapes";
    let title = "The spatula at the numbered points of the curve";
    let picture = shapes(peel, numbered, title, &dir.join(format!("{stem}.svg")))?;
    let caption =
        "The spatula of `fig07-spatula` from the side, drawn to scale, at the points numbered there.".to_string();
    Figure::write(dir, stem, caption, &picture, &shape_table(peel, numbered))
}
