//! The pull-off force against the direction of the pull, and against the roll at which the grip is held, in space.

use crate::figures::figure::{Figure, Table};
use crate::figures::runner::Runner;
use peelkit::model::{Hold, PeelModel, Pull, Space, Step, StripModel};
use peelkit::study::{
    Accuracy, LimitPoint, LimitPointKind, LoadingDirection, Observed, Peel, PullOff, StopCriteria, TestEnd,
};
use peelkit_report::chart::{
    Axis, Frame, Line, Mark, Note, Panel, Picture, RGBColor, Stroke, WIDTH, colour, significant,
};
use peelkit_report::{ReportError, test_end_word};
use std::path::Path;

/// L, nm
const LENGTH: f64 = 100.0;
/// Width of the strip that is pulled in all directions, and of the one that is rolled, nm.
const WIDE: f64 = 40.0;
const SQUARE: f64 = 10.0;
/// Elevations of the pull whose azimuth is varied, degrees, and how they are drawn.
const INCLINED: [(f64, RGBColor); 2] = [(30.0, colour::BLUE), (60.0, colour::GREEN)];
/// Azimuths and rolls between the ends of their ranges, degrees.
const AZIMUTH_STEP: f64 = 15.0;
const AZIMUTHS: usize = 13;
const ROLL_STEP: f64 = 2.5;
const ROLLS: usize = 5;
/// How far the grip that is to be rolled is lifted before, nm.
const LIFT: f64 = 0.5;
const ACCURACY: Accuracy = Accuracy::to(1e-6);
/// The first peak comes after fewer points, and the beam is off after fewer.
const FIRST_PEAK: StopCriteria = StopCriteria::after_points(120);
const OFF: StopCriteria = StopCriteria::after_points(800);

/// What the caption says of the dashed lines.
pub(super) const DASHED: &str = "Dashed, where it differs or the pull-off is not known: the first peak of the path (initiation peak), up to which the path is stable.";

/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize = 2 * (INCLINED.len() * AZIMUTHS + 1 + ROLLS);

/// How the grip is pulled, degrees.
#[derive(Clone, Copy)]
pub(super) struct Case {
    pub elevation: f64,
    pub azimuth: f64,
    /// At which it is held; none where it is free to roll
    pub roll: Option<f64>,
}

/// Straight up, in space: any azimuth but that of the plane.
pub(super) const UP: Case = Case { elevation: 90.0, azimuth: 90.0, roll: None };
/// So far beside the plane of the beam, degrees, its pull begins and ends.
pub(super) const BESIDE: f64 = 0.1;

impl Case {
    /// From one end of the range of the azimuth to the other.
    pub fn azimuths(elevation: f64, step: f64, number: usize) -> impl Iterator<Item = Self> {
        let azimuth = move |k: usize| (step * k as f64).clamp(BESIDE, 180.0 - BESIDE);
        (0..number).map(move |k| Self { elevation, azimuth: azimuth(k), roll: None })
    }

    /// Pulled straight up at so many rolls, from one on that is as good as none.
    pub fn rolls(step: f64, number: usize) -> impl Iterator<Item = Self> {
        const NONE: f64 = 1e-8;
        (0..number).map(move |k| Self { roll: Some((step * k as f64).max(NONE)), ..UP })
    }

    /// `body` pulled so; where it is rolled, behind these steps and held at that roll and without yaw.
    pub fn model(self, body: PeelModel, steps: impl FnOnce(Step) -> Vec<Step>) -> PeelModel {
        let held = if self.roll.is_some() { Hold::Fixed } else { Hold::Free };
        PeelModel {
            pull: Pull { angle: self.elevation.to_radians(), ..Pull::UP },
            space: Some(Space { azimuth: self.azimuth.to_radians(), roll: held, yaw: held, ..Space::default() }),
            steps: self.roll.map(|roll| steps(Step::Roll(roll.to_radians()))).unwrap_or_default(),
            ..body
        }
    }
}

/// A pull-off, and the first peak of the path from rest.
pub(super) struct Found {
    pub case: Case,
    /// None where the beam has not been pulled off
    pull_off: Option<PullOff>,
    /// Jumps before it
    jumps: usize,
    end: &'static str,
    peak: Option<LimitPoint>,
    /// Whether all points up to the first peak are stable under displacement control
    stable: bool,
}

impl Found {
    fn new(case: Case, test: &Observed, peel: &Peel) -> Self {
        let pull_off = test.peeling_force().filter(|_| test.end == TestEnd::Off);
        let before = |at: f64| pull_off.is_some_and(|off| at < off.machine);
        let retreat = test.jumps.iter().filter(|jump| jump.way == LoadingDirection::Retreat);
        let jumps = retreat.filter(|jump| before(jump.machine)).count();
        let peak = first_peak(peel);
        let stable = peak.is_some_and(|peak| {
            let up_to = &peel.points[..=peak.after.min(peel.points.len() - 1)];
            up_to.iter().all(|point| point.negative_eigenvalues == 0)
                && peel.branch_points.iter().all(|branch| branch.after > peak.after)
        });
        Self { case, pull_off, jumps, end: test_end_word(&test.end), peak, stable }
    }

    /// Of all cases.
    pub fn all(
        cases: &[Case],
        runner: &Runner<'_>,
        model: impl Fn(Case) -> PeelModel,
        accuracy: Accuracy,
        [off, first_peak]: [&StopCriteria; 2],
    ) -> Vec<Self> {
        let models: Vec<PeelModel> = cases.iter().map(|&case| model(case)).collect();
        let tests = runner.pull_off_all(&models, &accuracy, off);
        let peels = runner.peel_all(&models, &accuracy, |_| first_peak.clone());
        let both = tests.iter().zip(&peels);
        cases.iter().zip(both).map(|(&case, (test, peel))| Self::new(case, test, peel)).collect()
    }

    fn force(&self) -> Option<f64> {
        self.pull_off.map(|off| off.force)
    }

    fn first_force(&self) -> Option<f64> {
        self.peak.filter(|_| self.stable).map(|peak| peak.force)
    }
}

/// The located point of the initiation peak.
fn first_peak(peel: &Peel) -> Option<LimitPoint> {
    let peak = peel.initiation_peak?;
    let same = |at: &&LimitPoint| at.kind == LimitPointKind::Load && at.displacement == peak.displacement;
    peel.limit_points.iter().find(same).copied()
}

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let inclined = INCLINED.iter().flat_map(|&(elevation, _)| Case::azimuths(elevation, AZIMUTH_STEP, AZIMUTHS));
    let cases: Vec<Case> = inclined.chain([UP]).chain(Case::rolls(ROLL_STEP, ROLLS)).collect();
    let found = Found::all(&cases, runner, model, ACCURACY, [&OFF, &FIRST_PEAK]);
    let caption = format!(
        "The pull-off force of a strip of {LENGTH} nm (h = 10 nm, E = 2 GPa): the largest force of the displacement-controlled \
         test until the strip is off or stands on the face of its end. Left: b = {WIDE} nm, the strip of \
         scenes/strip-sideways.toml, against the azimuth of the pull, 0 along the strip and away from it, 180 degrees \
         backwards, from {BESIDE} to {} degrees, at three elevations; straight up the azimuth does not matter. Right: b = \
         {SQUARE} nm, pulled straight up by a grip that has been lifted by {LIFT} nm, rolled, let go of its height and is held at \
         that roll and without yaw, as in scenes/strip-rolled.toml. Red: the least force of each curve. {DASHED} A strip that is \
         not computed until it is off is a gap. The data have the error bounds.",
        180.0 - BESIDE,
    );
    Figure::write(dir, "directions", caption, &picture(&found), &table(&found))
}

fn model(case: Case) -> PeelModel {
    let mut strip = StripModel::of_the_paper(LENGTH, 1.0);
    strip.strip.width = if case.roll.is_some() { SQUARE } else { WIDE };
    case.model(strip.into(), |roll| vec![Step::Lift(LIFT), roll, Step::Release])
}

/// A curve: what is varied, and what was found there.
pub(super) struct Series<'a> {
    pub name: String,
    pub colour: RGBColor,
    pub points: Vec<(f64, &'a Found)>,
}

impl<'a> Series<'a> {
    /// All azimuths at an elevation.
    pub fn at_elevation(found: &'a [Found], (elevation, colour): (f64, RGBColor)) -> Self {
        let of = found.iter().filter(|at| at.case.roll.is_none() && at.case.elevation == elevation);
        let points = of.map(|at| (at.case.azimuth, at)).collect();
        Series { name: format!("elevation {elevation} degrees"), colour, points }
    }

    /// Straight up, where the azimuth does not matter: a level line.
    pub fn straight_up(found: &'a [Found]) -> Self {
        let of = found.iter().filter(|at| at.case.roll.is_none() && at.case.elevation == UP.elevation);
        let points = of.flat_map(|at| [0.0, 90.0, 180.0].map(|azimuth| (azimuth, at))).collect();
        Series { name: "straight up".into(), colour: colour::ORANGE, points }
    }

    /// All rolls.
    pub fn rolled(found: &'a [Found]) -> Self {
        let points = found.iter().filter_map(|at| Some((at.case.roll?, at))).collect();
        Series { name: "straight up".into(), colour: colour::BLUE, points }
    }
}

/// Against the azimuth and against the roll, each up to the largest roll and force given.
pub(super) fn panels(roll: f64, [against_azimuth, against_roll]: [f64; 2]) -> [Panel; 2] {
    let frame = |left: f64, right: f64| Frame { left, top: 40.0, right, bottom: 414.0 };
    let (middle, right) = (0.62 * f64::from(WIDTH), f64::from(WIDTH) - 18.0);
    let force = |most: f64| Axis::linear("pull-off force (nN)", 0.0, most);
    let azimuth = Axis::linear("azimuth of the pull (degrees)", 0.0, 180.0);
    [
        Panel::new(frame(74.0, middle - 12.0), azimuth, force(against_azimuth)),
        Panel::new(
            frame(middle + 62.0, right),
            Axis::linear("roll of the grip (degrees)", 0.0, roll),
            force(against_roll),
        ),
    ]
}

fn picture(found: &[Found]) -> Picture {
    let mut directions: Vec<Series<'_>> = INCLINED.iter().map(|&at| Series::at_elevation(found, at)).collect();
    directions.push(Series::straight_up(found));
    let mut panels = panels(ROLL_STEP * (ROLLS - 1) as f64, [36.0, 4.0]);
    draw(&mut panels[0], &directions);
    draw(&mut panels[1], &[Series::rolled(found)]);
    Picture { title: "Pull-off force against direction and roll".into(), height: 470, panels: panels.into() }
}

/// Pull-off forces as curves with gaps, the least of each marked and the least of all named; first peaks that differ dashed.
pub(super) fn draw(panel: &mut Panel, all: &[Series<'_>]) {
    let leasts: Vec<Option<(f64, f64)>> = all.iter().map(|series| least(series, &panel.x)).collect();
    let of_all = leasts.iter().flatten().map(|at| at.1).fold(f64::INFINITY, f64::min);
    for (series @ Series { name, colour, points }, least) in all.iter().zip(leasts) {
        let force = |force: f64| format!("least {} nN", significant(force, 4));
        let told = least.filter(|_| all.len() > 1);
        let mut name = Some(told.map_or(name.clone(), |at| format!("{name}: {}", force(at.1))));
        for points in runs(points, Found::force) {
            panel.lines.push(Line { points, stroke: Stroke::solid(*colour, 2.0), name: name.take() });
        }
        if series.wants_first_peaks() {
            for points in runs(points, Found::first_force) {
                panel.lines.push(Line { points, stroke: Stroke::dashed(*colour, 1.2), name: None });
            }
        }
        if let Some(at) = least {
            let note = (at.1 == of_all).then(|| Note { badge: None, text: vec![force(at.1)] });
            panel.marks.push(Mark { note, ..Mark::dot(at, colour::VERMILLION) });
        }
    }
}

/// Pieces of a curve between its gaps.
fn runs(points: &[(f64, &Found)], force: impl Fn(&Found) -> Option<f64>) -> Vec<Vec<(f64, f64)>> {
    let pieces = points.split(|(_, at)| force(at).is_none());
    let piece = |run: &[(f64, &Found)]| run.iter().filter_map(|(x, at)| Some((*x, force(at)?))).collect::<Vec<_>>();
    pieces.map(piece).filter(|run| run.len() > 1).collect()
}

impl Series<'_> {
    /// Whether a first peak is not beneath the curve.
    fn wants_first_peaks(&self) -> bool {
        const VISIBLE: f64 = 5e-3;
        let is_beneath = |force: f64, first: f64| (force / first - 1.0).abs() <= VISIBLE;
        let seen =
            |at: &Found| at.first_force().is_some_and(|first| at.force().is_none_or(|force| !is_beneath(force, first)));
        self.points.iter().any(|(_, at)| seen(at))
    }
}

/// The least pull-off force; of equal ones the one nearest to the middle of the axis.
fn least(series: &Series<'_>, axis: &Axis) -> Option<(f64, f64)> {
    let from_middle = |x: f64| (x - 0.5 * (axis.from + axis.to)).abs();
    let known = series.points.iter().filter_map(|(x, at)| Some((*x, at.force()?)));
    known.min_by(|a, b| a.1.total_cmp(&b.1).then(from_middle(a.0).total_cmp(&from_middle(b.0))))
}

pub(super) fn table(found: &[Found]) -> Table {
    let mut table = Table::new(&[
        "varied",
        "elevation_deg",
        "azimuth_deg",
        "roll_deg",
        "pull_off_displacement_nm",
        "pull_off_force_nN",
        "pull_off_error_nN",
        "jumps_before",
        "first_peak_displacement_nm",
        "first_peak_force_nN",
        "first_peak_error_nN",
        "first_peak_stable",
        "end",
    ]);
    for Found { case, pull_off, jumps, end, peak, stable } in found {
        let varied = if case.roll.is_some() { "roll" } else { "azimuth" };
        let numbers = [
            Some(case.elevation),
            Some(case.azimuth),
            case.roll,
            pull_off.map(|off| off.machine),
            pull_off.map(|off| off.force),
            pull_off.map(|off| off.force_error),
            pull_off.map(|_| *jumps as f64),
            peak.map(|at| at.displacement),
            peak.map(|at| at.force),
            peak.map(|at| at.force_error),
        ];
        table.push(&[varied], &numbers, &[&stable.to_string(), end]);
    }
    table
}
