//! The first peak against the direction of the pull, and against the roll at which the grip is held, in space.

use super::super::figure::{Figure, Table};
use super::super::runner::Runner;
use peelkit::model::{Hold, PeelModel, Pull, Space, Step, StripModel};
use peelkit::study::{Accuracy, LimitPoint, LimitPointKind, Peel, StopCriteria};
use peelkit_report::chart::RGBColor;
use peelkit_report::chart::{
    Axis, Frame, Line, Mark, Note, Panel, Picture, Stroke, Symbol, WIDTH, colour, significant,
};
use peelkit_report::{ReportError, end_word};
use std::path::Path;

/// L, nm
const LENGTH: f64 = 100.0;
/// Width of the strip that is pulled in all directions, and of the one that is rolled, nm.
const WIDE: f64 = 40.0;
const SQUARE: f64 = 10.0;
/// Elevations of the pull whose azimuth is varied, degrees, and how they are drawn.
const INCLINED: [(f64, RGBColor); 2] = [(30.0, colour::BLUE), (60.0, colour::GREEN)];
const UP: f64 = 90.0;
/// Azimuths and rolls between the ends of their ranges, degrees.
const AZIMUTH_STEP: f64 = 5.0;
const AZIMUTHS: usize = 37;
const ROLL_STEP: f64 = 0.5;
const ROLLS: usize = 21;
/// So far beside the plane of the strip, degrees, a pull makes the strip leave it without a branch point.
const BESIDE: f64 = 0.1;
/// And so far beside it the branch point is still met, although the pull is solved in space, where it is looked for.
const WITHIN: f64 = 1e-8;
/// How far the grip that is to be rolled is lifted before, nm.
const LIFT: f64 = 0.5;
const ACCURACY: Accuracy = Accuracy::to(1e-6);
/// The first peak comes after fewer points.
const BOUNDS: StopCriteria = StopCriteria::after_points(120);

/// How many peels the figure takes.
pub(in crate::figures) const PEELS: usize = INCLINED.len() * (AZIMUTHS + 2) + ROLLS + 1;

/// How the grip is pulled, degrees.
#[derive(Clone, Copy)]
pub(super) struct Case {
    pub elevation: f64,
    pub azimuth: f64,
    /// At which it is held; none where it is free to roll
    pub roll: Option<f64>,
}

/// A first peak, and where the path has lost its stability before it, (u, P).
pub(super) struct Found {
    pub case: Case,
    /// Whether the case is that of the branch which leaves the plane
    branch: bool,
    peak: Option<LimitPoint>,
    lost: Option<(f64, f64)>,
    /// Whether no point up to it is unstable under displacement control
    stable: bool,
    end: &'static str,
}

impl Found {
    /// Of a path in space, all of whose branch points are known.
    pub fn in_space(case: Case, peel: &Peel, branch: bool) -> Self {
        let peak = first_peak(peel);
        let before = |after: usize| peak.is_some_and(|peak| after <= peak.after);
        let lost = peel.branch_points.iter().find(|at| before(at.after)).map(|at| (at.displacement, at.force));
        let mut points = peel.points.iter().enumerate().take_while(|(k, _)| before(*k));
        let stable = peak.is_some() && lost.is_none() && points.all(|(_, point)| point.negative_eigenvalues == 0);
        Found { case, branch, peak, lost, stable, end: end_word(&peel.end) }
    }

    fn force(&self) -> Option<f64> {
        self.peak.map(|peak| peak.force)
    }
}

/// The located point of the initiation peak.
fn first_peak(peel: &Peel) -> Option<LimitPoint> {
    let peak = peel.initiation_peak?;
    let same = |at: &&LimitPoint| at.kind == LimitPointKind::Load && at.displacement == peak.displacement;
    peel.limit_points.iter().find(same).copied()
}

pub(in crate::figures) fn figure(runner: &Runner<'_>, dir: &Path) -> Result<Figure, ReportError> {
    let found = found(runner);
    let caption = format!(
        "The first peak (initiation peak) of a strip of {LENGTH} nm (h = 10 nm, E = 2 GPa). Left: b = {WIDE} nm, \
         the strip of scenes/strip-sideways.toml, against the azimuth of the pull, 0 along the strip and away \
         from it, 180 degrees backwards, at three elevations; straight up the azimuth does not matter. Right: b = \
         {SQUARE} nm, pulled straight up by a grip that has been lifted by {LIFT} nm, rolled, let go of its \
         height and is held at that roll and without yaw, as in scenes/strip-rolled.toml. Red: the least force of \
         each curve. Diamonds: peaks of paths that stay in the strip's plane. They come behind a branch point, \
         where the strip leaves its plane, and are not reached: the curves begin and end {BESIDE} degrees beside \
         the plane, and straight up the line is the peak of the branch that leaves it. A peak that is not found, \
         or not known to be stable, is a gap. The data have the branch points and the error bounds."
    );
    Figure::write(dir, "directions", caption, &picture(&found), &table(&found))
}

fn model(case: Case) -> PeelModel {
    let mut strip = StripModel::of_the_paper(LENGTH, 1.0);
    strip.strip.width = if case.roll.is_some() { SQUARE } else { WIDE };
    let held = if case.roll.is_some() { Hold::Fixed } else { Hold::Free };
    let space = Space { azimuth: case.azimuth.to_radians(), roll: held, yaw: held, ..Space::default() };
    let steps = |roll: f64| vec![Step::Lift(LIFT), Step::Roll(roll.to_radians()), Step::Release];
    PeelModel {
        pull: Pull { angle: case.elevation.to_radians(), ..Pull::UP },
        space: Some(space),
        steps: case.roll.map(steps).unwrap_or_default(),
        ..strip.into()
    }
}

fn found(runner: &Runner<'_>) -> Vec<Found> {
    let inner = (1..AZIMUTHS - 1).map(|k| AZIMUTH_STEP * k as f64);
    let azimuths: Vec<f64> =
        [WITHIN, BESIDE].into_iter().chain(inner).chain([180.0 - BESIDE, 180.0 - WITHIN]).collect();
    let inclined = INCLINED
        .iter()
        .flat_map(|&(elevation, _)| azimuths.iter().map(move |&azimuth| Case { elevation, azimuth, roll: None }));
    let rolls = (0..ROLLS).map(|k| if k == 0 { WITHIN } else { ROLL_STEP * k as f64 });
    let rolled = rolls.map(|roll| Case { elevation: UP, azimuth: 0.0, roll: Some(roll) });
    let upright = Case { elevation: UP, azimuth: 0.0, roll: None };
    let cases: Vec<Case> = inclined.chain(rolled).chain([upright]).collect();
    let peels = runner.peel_all(&cases.iter().map(|&case| model(case)).collect::<Vec<_>>(), &ACCURACY, &BOUNDS);
    let of = |(&case, peel): (&Case, &Peel)| match peel.model.space {
        Some(_) => vec![Found::in_space(case, peel, false)],
        None => in_the_plane(case, peel),
    };
    cases.iter().zip(&peels).flat_map(of).collect()
}

/// Of a path in the plane, and of the branch that leaves it, where that is found.
fn in_the_plane(case: Case, peel: &Peel) -> Vec<Found> {
    let peak = first_peak(peel);
    let branch = peel.branch(&BOUNDS);
    let loss = branch.as_ref().ok().and_then(|branch| branch.as_ref()).map(|branch| branch.loss);
    let before = loss.filter(|loss| peak.is_some_and(|peak| loss.displacement < peak.displacement));
    let lost = before.map(|loss| (loss.displacement, loss.force));
    let stable = peak.is_some() && branch.is_ok() && lost.is_none();
    let plane = Found { case, branch: false, peak, lost, stable, end: end_word(&peel.end) };
    let left = branch.ok().flatten().filter(|_| lost.is_some());
    [plane].into_iter().chain(left.map(|branch| Found::in_space(case, &branch.peel, true))).collect()
}

/// A curve: what is varied, and what was found there.
pub(super) struct Series<'a> {
    pub name: String,
    pub colour: RGBColor,
    pub points: Vec<(f64, &'a Found)>,
}

fn picture(found: &[Found]) -> Picture {
    let free = |elevation: f64| {
        found.iter().filter(move |at| at.case.roll.is_none() && at.case.elevation == elevation).collect::<Vec<_>>()
    };
    let mut directions: Vec<Series<'_>> = INCLINED
        .iter()
        .map(|&(elevation, colour)| Series {
            name: format!("elevation {elevation} degrees"),
            colour,
            points: free(elevation).into_iter().map(|at| (at.case.azimuth, at)).collect(),
        })
        .collect();
    // the azimuth does not matter: a level line, and the path in the plane at both ends of the range
    let places = |at: &Found| if at.stable { vec![0.0, 90.0, 180.0] } else { vec![0.0, 180.0] };
    let level = |at| places(at).into_iter().map(move |azimuth| (azimuth, at));
    let points = free(UP).into_iter().flat_map(level).collect();
    directions.push(Series { name: "straight up".into(), colour: colour::ORANGE, points });
    let rolled = found.iter().filter_map(|at| Some((at.case.roll?, at))).collect();
    let rolls = Series { name: "straight up".into(), colour: colour::BLUE, points: rolled };
    let frame = |left: f64, right: f64| Frame { left, top: 40.0, right, bottom: 414.0 };
    let (middle, right) = (0.62 * f64::from(WIDTH), f64::from(WIDTH) - 18.0);
    let force = |most: f64| Axis::linear("first peak P (nN)", 0.0, most);
    let azimuth = Axis::linear("azimuth of the pull (degrees)", 0.0, 180.0);
    let roll = Axis::linear("roll of the grip (degrees)", 0.0, ROLL_STEP * (ROLLS - 1) as f64);
    let mut panels = vec![
        Panel::new(frame(74.0, middle - 12.0), azimuth, force(36.0)),
        Panel::new(frame(middle + 62.0, right), roll, force(4.0)),
    ];
    draw(&mut panels[0], &directions);
    draw(&mut panels[1], &[rolls]);
    Picture { title: "First peak against direction and roll".into(), height: 470, panels }
}

/// Stable peaks as curves with gaps, the least of each marked and the least of all named; those behind a branch point
/// as diamonds.
pub(super) fn draw(panel: &mut Panel, all: &[Series<'_>]) {
    let leasts: Vec<Option<(f64, f64)>> = all.iter().map(|series| least(series, &panel.x)).collect();
    let of_all = leasts.iter().flatten().map(|at| at.1).fold(f64::INFINITY, f64::min);
    for (Series { name, colour, points }, least) in all.iter().zip(leasts) {
        let force = |force: f64| format!("least {} nN", significant(force, 4));
        let told = least.filter(|_| all.len() > 1);
        let mut name = Some(told.map_or(name.clone(), |at| format!("{name}: {}", force(at.1))));
        for run in points.split(|(_, at)| !at.stable) {
            let points: Vec<(f64, f64)> = run.iter().filter_map(|(x, at)| Some((*x, at.force()?))).collect();
            if points.len() > 1 {
                panel.lines.push(Line { points, stroke: Stroke::solid(*colour, 2.0), name: name.take() });
            }
        }
        for at in points.iter().filter(|(_, at)| at.lost.is_some()).filter_map(|(x, at)| Some((*x, at.force()?))) {
            let named = panel.marks.iter().any(|mark| mark.symbol == Symbol::Diamond);
            let name = (!named).then(|| "in the plane, not reached".to_owned());
            panel.marks.push(Mark { at, symbol: Symbol::Diamond, colour: colour::GREY, name, note: None });
        }
        if let Some(at) = least {
            let note = (at.1 == of_all).then(|| Note { badge: None, text: vec![force(at.1)] });
            panel.marks.push(Mark { note, ..Mark::dot(at, colour::VERMILLION) });
        }
    }
}

/// The least stable peak; of equal ones the one nearest to the middle of the axis.
fn least(series: &Series<'_>, axis: &Axis) -> Option<(f64, f64)> {
    let from_middle = |x: f64| (x - 0.5 * (axis.from + axis.to)).abs();
    let stable = series.points.iter().filter(|(_, at)| at.stable).filter_map(|(x, at)| Some((*x, at.force()?)));
    stable.min_by(|a, b| a.1.total_cmp(&b.1).then(from_middle(a.0).total_cmp(&from_middle(b.0))))
}

pub(super) fn table(found: &[Found]) -> Table {
    let mut table = Table::new(&[
        "varied",
        "path",
        "elevation_deg",
        "azimuth_deg",
        "roll_deg",
        "displacement_nm",
        "displacement_error_nm",
        "force_nN",
        "force_error_nN",
        "branch_point_displacement_nm",
        "branch_point_force_nN",
        "stable",
        "end",
    ]);
    for Found { case, branch, peak, lost, stable, end } in found {
        let (varied, path) = (
            if case.roll.is_some() { "roll" } else { "azimuth" },
            if *branch { "out-of-plane branch" } else { "path" },
        );
        let numbers = [
            Some(case.elevation),
            Some(case.azimuth),
            case.roll,
            peak.map(|at| at.displacement),
            peak.map(|at| at.displacement_error),
            peak.map(|at| at.force),
            peak.map(|at| at.force_error),
            lost.map(|at| at.0),
            lost.map(|at| at.1),
        ];
        table.push(&[varied, path], &numbers, &[&stable.to_string(), end]);
    }
    table
}
