//! The picture of a sweep: peak force and plateau, and below them the peeling work, against the varied value.

use crate::chart::axis::Axis;
use crate::chart::canvas::{Dash, Stroke};
use crate::chart::output::save;
use crate::chart::panel::{Line, Mark, Panel};
use crate::chart::picture::{Heading, Picture};
use crate::chart::place::Frame;
use crate::chart::style::{WIDTH, colour};
use crate::swept::SweepRow;
use crate::writing::error::ReportError;
use peelkit::analytic::kendall_force;
use peelkit_scene::find_key;
use std::path::{Path, PathBuf};

/// The key that Fig. 10 of the paper varies.
pub const STIFFNESS: &str = "strip.bending_stiffness_factor";

/// The angle of the pull.
const ANGLE: &str = "drive.angle";

/// The label of an axis of forces per width.
pub const FORCE: &str = "force per width P/b (N/m)";
/// The label of an axis of work per width.
pub const WORK: &str = "work to snap-off W/b (nJ/m)";
/// The label of an axis of bending stiffness over that of the section.
pub const STIFFNESS_LABEL: &str = "EI / EI₀";

/// Draws `sweep.svg` and `sweep.png` into `dir`: peak force, plateau and the work up to the snap-off, of strips each per width,
/// against the values of `key`, on a logarithmic axis where `log` is set.
///
/// Where the bending stiffness or the angle of the pull is varied Kendall's force is drawn too.
///
/// Fails where no value has the point, a value has no place on a logarithmic axis ([`ReportError::Draw`]), or a file cannot be
/// written ([`ReportError::Write`]).
pub fn draw_sweep<'h>(
    rows: &[SweepRow],
    key: &str,
    heading: impl Into<Heading<'h>>,
    log: bool,
    dir: &Path,
) -> Result<Vec<PathBuf>, ReportError> {
    let refuse = |reason: String| ReportError::Draw { path: dir.join("sweep.svg"), reason };
    check_axis(rows.iter().map(|row| row.value), key, log).map_err(refuse)?;
    if rows.iter().all(|row| row.found.peak.is_none()) {
        return Err(refuse(format!("none of the {} values of {key} has a peak force", rows.len())));
    }
    let Heading { title, units } = heading.into();
    save(&sweep_picture(rows, key, title, log).in_units(units), dir, "sweep")
}

/// Whether all values of `key` have a place on the axis; else the first that has none.
pub(crate) fn check_axis(mut values: impl Iterator<Item = f64>, key: &str, log: bool) -> Result<(), String> {
    match values.find(|&value| log && value <= 0.0) {
        Some(value) => Err(format!("{key} = {value} has no place on a logarithmic axis")),
        None => Ok(()),
    }
}

fn sweep_picture(rows: &[SweepRow], key: &str, title: &str, log: bool) -> Picture {
    let (left, right) = (88.0, f64::from(WIDTH) - 18.0);
    let stiffness = key == STIFFNESS;
    let strips = rows.iter().all(|row| row.model.strip().is_some());
    let labels = if strips { (FORCE, WORK) } else { ("force P (nN)", "work to snap-off W (aJ)") };
    let (label, scale) = axis_of(key);
    let rows: &[SweepRow] =
        &rows.iter().map(|row| SweepRow { value: scale * row.value, ..row.clone() }).collect::<Vec<_>>();
    let x = Axis::around(&label, rows.iter().map(|r| r.value), log);
    let mut lines =
        series(rows, |r| Some(per_width(r, r.found.peak?.force)), Stroke::solid(colour::BLUE, 2.0), "peak force");
    let dashed = Stroke::dashed(colour::VERMILLION, 2.0);
    lines.extend(series(rows, plateau_per_width, dashed, "plateau"));
    if strips && (stiffness || key == ANGLE) {
        lines.extend(series(rows, |r| Some(kendall_per_width(r)), Stroke::dotted(colour::GREY, 2.0), "Kendall"));
    }
    let forces = panel(Frame { left, top: 40.0, right, bottom: 330.0 }, &x, labels.0, lines);
    let mut work = series(rows, work_per_width, Stroke::solid(colour::GREEN, 2.0), "");
    work.iter_mut().for_each(|line| line.name = None);
    let mut panels = vec![dotted(forces)];
    // one value of many that has a jump is no line
    let with_work = work.iter().map(|line| line.points.len()).sum::<usize>();
    if with_work > 1 || with_work == rows.len() {
        panels.push(dotted(panel(Frame { left, top: 400.0, right, bottom: 620.0 }, &x, labels.1, work)));
    }
    let height = panels.last().map_or(0.0, |p| p.frame.bottom) + 54.0;
    Picture { title: title.into(), height: height as u32, panels }
}

/// The title of the axis of a key, and by what its values are multiplied there: angles are in degrees.
pub(crate) fn axis_of(key: &str) -> (String, f64) {
    match find_key(key) {
        _ if key == STIFFNESS => (STIFFNESS_LABEL.to_owned(), 1.0),
        Ok(key) => (key.axis_title(), key.per_usual_unit()),
        Err(_) => (key.to_owned(), 1.0),
    }
}

/// A force or a work of a strip over its width; as it is of a body whose width varies.
pub fn per_width(row: &SweepRow, value: f64) -> f64 {
    value / row.model.strip().map_or(1.0, |strip| strip.width)
}

/// The work up to the snap-off, per width.
pub fn work_per_width(row: &SweepRow) -> Option<f64> {
    Some(per_width(row, row.found.snap_off?.work))
}

/// A plateau is one of peeling while more than this fraction of the strip still adheres.
pub const ADHERING: f64 = 0.01;

/// The plateau of peeling per width. A stiff strip that tilts upright on its edge has none, however level its force is
/// at the end.
pub fn plateau_per_width(row: &SweepRow) -> Option<f64> {
    let plateau = row.found.plateau?;
    let tilts = row.found.plateau_front.is_some_and(|front| front < ADHERING * row.model.length());
    (!tilts).then(|| per_width(row, plateau.force))
}

/// Kendall's force per width at the angle of the pull, N/m, with the work of adhesion that the strip has at rest.
pub fn kendall_per_width(row: &SweepRow) -> f64 {
    let work = -row.model.line_law().rest_energy();
    let (width, height) = row.model.free_end();
    per_width(row, kendall_force(work, row.model.material().youngs_modulus, height, width, row.model.pull.angle))
}

/// A panel around its lines, its y axis logarithmic where the values span about a decade.
pub fn panel(frame: Frame, x: &Axis, label: &str, lines: Vec<Line>) -> Panel {
    let values = || lines.iter().flat_map(|l| l.points.iter().map(|p| p.1));
    let (low, high) = values().fold((f64::INFINITY, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
    let y = Axis::around(label, values(), low > 0.0 && high > 8.0 * low);
    Panel { lines, ..Panel::new(frame, x.clone(), y) }
}

/// Dots at the computed values, where they are not so many that the line says enough.
pub fn dotted(mut panel: Panel) -> Panel {
    for line in panel.lines.iter().filter(|l| l.stroke.dash != Dash::Dotted && l.points.len() <= 60) {
        panel.marks.extend(line.points.iter().map(|&at| Mark::dot(at, line.stroke.colour)));
    }
    panel
}

/// The values that exist, as lines that break where one is missing.
pub fn series(rows: &[SweepRow], value: impl Fn(&SweepRow) -> Option<f64>, stroke: Stroke, name: &str) -> Vec<Line> {
    let point = |row: &SweepRow| value(row).filter(|v| v.is_finite()).map(|v| (row.value, v));
    let mut lines = broken(rows.iter().map(point), stroke);
    if let Some(first) = lines.first_mut() {
        first.name = Some(name.to_string());
    }
    lines
}

/// The points that exist, as lines without a name that break where one is missing.
pub(crate) fn broken(points: impl Iterator<Item = Option<(f64, f64)>>, stroke: Stroke) -> Vec<Line> {
    let points: Vec<Option<(f64, f64)>> = points.collect();
    let pieces = points.split(Option::is_none).filter(|piece| !piece.is_empty());
    pieces.map(|piece| Line::plain(piece.iter().flatten().copied().collect(), stroke)).collect()
}
