//! The first peak of a spatula against the direction of the pull, and against the roll at which its grip is held.

use super::super::figure::Figure;
use super::super::runner::Runner;
use super::directions::{Case, Found, Series, draw, table};
use peelkit::model::{Hold, PeelModel, Pull, Space, Spatula, Step};
use peelkit::study::{Accuracy, StopCriteria};
use peelkit_report::ReportError;
use peelkit_report::chart::{Axis, Frame, Panel, Picture, RGBColor, WIDTH, colour};
use std::path::Path;

/// Elevations of the pull whose azimuth is varied, degrees, and how they are drawn.
const INCLINED: [(f64, RGBColor); 2] = [(30.0, colour::BLUE), (60.0, colour::GREEN)];
const UP: f64 = 90.0;
/// Azimuths and rolls between the ends of their ranges, degrees.
const AZIMUTH_STEP: f64 = 10.0;
const AZIMUTHS: usize = 19;
const ROLL_STEP: f64 = 10.0;
const ROLLS: usize = 7;
/// So far beside the plane of the spatula, degrees, its pull begins and ends.
const BESIDE: f64 = 0.1;
/// A roll with which the problem is still one in space, where its branch points are looked for, degrees.
const WITHIN: f64 = 1e-8;
const ACCURACY: Accuracy = Accuracy::to(1e-6);
/// The first peak comes after fewer points.
const BOUNDS: StopCriteria = StopCriteria::after_points(240);

/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize = INCLINED.len() * AZIMUTHS + ROLLS;

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let cases = cases();
    let peels = runner.peel_all(&cases.iter().map(|&case| model(case)).collect::<Vec<_>>(), &ACCURACY, &BOUNDS);
    let found: Vec<Found> = cases.iter().zip(&peels).map(|(&case, peel)| Found::in_space(case, peel, false)).collect();
    let caption = format!(
        "The first peak (initiation peak) of the spatula of scenes/spatula.toml, whose shaft keeps its rotation in the plane and is \
         free to roll and yaw. Left: against the azimuth of the pull, 0 along the spatula and away from its tip, 180 degrees towards \
         it, at two elevations, from {BESIDE} to {} degrees. Right: pulled straight up by a grip that has been rolled, let go of its \
         height and is held at that roll and without yaw. Red: the least force of each curve. At 60 degrees an early peak ends between \
         azimuth 40 and 50: from there on the first peak is a later one. Behind the first peak \
         the force may rise above it again: these forces are not shown. A peak that is not found, or not known to be stable, is a \
         gap. The data have the error bounds.",
        180.0 - BESIDE
    );
    Figure::write(dir, "spatula-directions", caption, &picture(&found), &table(&found))
}

fn cases() -> Vec<Case> {
    let azimuth = |k: usize| (AZIMUTH_STEP * k as f64).clamp(BESIDE, 180.0 - BESIDE);
    let inclined = INCLINED
        .iter()
        .flat_map(|&(elevation, _)| (0..AZIMUTHS).map(move |k| Case { elevation, azimuth: azimuth(k), roll: None }));
    let rolls = (0..ROLLS).map(|k| if k == 0 { WITHIN } else { ROLL_STEP * k as f64 });
    inclined.chain(rolls.map(|roll| Case { elevation: UP, azimuth: 0.0, roll: Some(roll) })).collect()
}

fn model(case: Case) -> PeelModel {
    let held = if case.roll.is_some() { Hold::Fixed } else { Hold::Free };
    let space = Space { azimuth: case.azimuth.to_radians(), roll: held, yaw: held, ..Space::default() };
    let steps = |roll: f64| vec![Step::Roll(roll.to_radians()), Step::Release];
    PeelModel {
        pull: Pull { angle: case.elevation.to_radians(), ..Pull::UP },
        space: Some(space),
        steps: case.roll.map(steps).unwrap_or_default(),
        ..Spatula::default().model()
    }
}

fn picture(found: &[Found]) -> Picture {
    let free = |&(elevation, colour): &(f64, RGBColor)| {
        let of = found.iter().filter(|at| at.case.roll.is_none() && at.case.elevation == elevation);
        let points = of.map(|at| (at.case.azimuth, at)).collect();
        Series { name: format!("elevation {elevation} degrees"), colour, points }
    };
    let rolled = found.iter().filter_map(|at| Some((at.case.roll?, at))).collect();
    let rolls = Series { name: "straight up".into(), colour: colour::BLUE, points: rolled };
    let frame = |left: f64, right: f64| Frame { left, top: 40.0, right, bottom: 414.0 };
    let (middle, right) = (0.62 * f64::from(WIDTH), f64::from(WIDTH) - 18.0);
    let force = |most: f64| Axis::linear("first peak P (nN)", 0.0, most);
    let azimuth = Axis::linear("azimuth of the pull (degrees)", 0.0, 180.0);
    let roll = Axis::linear("roll of the grip (degrees)", 0.0, ROLL_STEP * (ROLLS - 1) as f64);
    let mut panels = vec![
        Panel::new(frame(74.0, middle - 12.0), azimuth, force(40.0)),
        Panel::new(frame(middle + 62.0, right), roll, force(8.0)),
    ];
    draw(&mut panels[0], &INCLINED.iter().map(free).collect::<Vec<_>>());
    draw(&mut panels[1], &[rolls]);
    Picture { title: "First peak of a spatula against direction and roll".into(), height: 470, panels }
}
