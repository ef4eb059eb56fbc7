//! The pull-off force of a spatula against the direction of the pull, and against the roll at which its grip is held.

use super::directions::{BESIDE, Case, DASHED, Found, Series, UP, draw, panels, table};
use crate::figures::figure::Figure;
use crate::figures::runner::Runner;
use peelkit::model::{PeelModel, Spatula, Step};
use peelkit::study::{Accuracy, StopCriteria};
use peelkit_report::ReportError;
use peelkit_report::chart::{Picture, RGBColor, colour};
use std::path::Path;

/// Elevations of the pull whose azimuth is varied, degrees, and how they are drawn.
const INCLINED: [(f64, RGBColor); 2] = [(30.0, colour::BLUE), (60.0, colour::GREEN)];
/// Azimuths and rolls between the ends of their ranges, degrees.
const AZIMUTH_STEP: f64 = 20.0;
const AZIMUTHS: usize = 10;
const ROLL_STEP: f64 = 20.0;
const ROLLS: usize = 4;
/// Elevation and azimuth at which the test fails behind a jump, degrees: left out.
const FAILING: [f64; 2] = [INCLINED[0].0, 180.0 - BESIDE];
/// Finer meshes for the jumps on the way take four times as long.
const ACCURACY: Accuracy = Accuracy::to(1e-4);
/// The first peak comes after fewer points, and the spatula is off after fewer.
const FIRST_PEAK: StopCriteria = StopCriteria::after_points(240);
const OFF: StopCriteria = StopCriteria::after_points(1000);

/// How many peels the figure takes: of all azimuths but one, one straight up, and the rolls.
pub(in crate::figures) const PEELS: usize = 2 * (INCLINED.len() * AZIMUTHS + ROLLS);

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let inclined = INCLINED.iter().flat_map(|&(elevation, _)| Case::azimuths(elevation, AZIMUTH_STEP, AZIMUTHS));
    let inclined = inclined.filter(|case| [case.elevation, case.azimuth] != FAILING);
    let cases: Vec<Case> = inclined.chain([UP]).chain(Case::rolls(ROLL_STEP, ROLLS)).collect();
    let found = Found::all(&cases, runner, model, ACCURACY, [&OFF, &FIRST_PEAK]);
    let caption = format!(
        "The pull-off force of the spatula of scenes/spatula.toml, whose shaft keeps its rotation in the plane and is free to roll \
         and yaw: the largest force of the displacement-controlled test until the spatula is off or stands on the face of its end. \
         Left: against the azimuth of the pull, 0 along the spatula and away from its tip, 180 degrees towards it, from {BESIDE} to \
         {} degrees, at three elevations; straight up the azimuth does not matter. Right: pulled straight up by a grip that has been \
         rolled, let go of its height and is held at that roll and without yaw. Red: the least force of each curve. {DASHED} At {} degrees \
         the azimuth of nearly 180 degrees is left out: behind a jump its test fails. The data have the error bounds.",
        180.0 - BESIDE,
        FAILING[0],
    );
    Figure::write(dir, "spatula-directions", caption, &picture(&found), &table(&found))
}

fn model(case: Case) -> PeelModel {
    case.model(Spatula::default().model(), |roll| vec![roll, Step::Release])
}

fn picture(found: &[Found]) -> Picture {
    let mut directions: Vec<Series<'_>> = INCLINED.iter().map(|&at| Series::at_elevation(found, at)).collect();
    directions.push(Series::straight_up(found));
    let mut panels = panels(ROLL_STEP * (ROLLS - 1) as f64, [48.0, 8.0]);
    draw(&mut panels[0], &directions);
    draw(&mut panels[1], &[Series::rolled(found)]);
    Picture {
        title: "Pull-off force of a spatula against direction and roll".into(),
        height: 470,
        panels: panels.into(),
    }
}
