//! Speed against error: the table and the picture of `peel accuracy`.

use super::measure::{Trial, WorkPrecision};
use peelkit::beam::MeshKind;
use peelkit_report::chart::{
    Axis, Frame, Line as Curve, Mark, Note, Panel, Picture, Stroke, Symbol, WIDTH, colour, order_shade, save,
};
use peelkit_report::{Fields, Record, ReportError, form_word, write_table};
use std::path::{Path, PathBuf};

/// The name of what the program chooses by itself.
pub const AUTOMATIC: &str = "chosen by the program";

/// Writes accuracy.csv: one row a run, and accuracy.svg and .png.
///
/// Fails where there is nothing to draw ([`ReportError::Draw`]) or a file cannot be written ([`ReportError::Write`]).
pub fn write_work_precision(dir: &Path, measured: &WorkPrecision, title: &str) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![write_trials(dir, measured)?];
    files.extend(save(&picture(measured, title), dir, "accuracy")?);
    Ok(files)
}

/// A run as a row.
struct Row<'a> {
    line: &'a str,
    trial: &'a Trial,
}

impl Record for Row<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("line", "what was chosen", |row| row.line);
        of.field("asked", "relative accuracy that was asked for", |row| row.trial.accuracy.relative);
        of.field("order", "of the elements", |row| row.trial.effort.order);
        of.field("elements", "of the final mesh", |row| row.trial.effort.elements);
        of.field("mesh", "how the elements are placed", |row| mesh_word(row.trial.accuracy.choice.mesh));
        of.field("form", "which unknowns a node has", |row| form_word(row.trial.accuracy.choice.form));
        of.field("peak_error", "of the peak, relative", |row| row.trial.errors.peak);
        of.field("snap_off_error", "of the snap-off, relative", |row| row.trial.errors.snap_off);
        of.field("curve_error", "of the curve between its points, relative", |row| row.trial.errors.curve);
        of.field("cpu_s", "computing time", |row| row.trial.seconds);
        of.field("points", "of the path", |row| row.trial.effort.points);
        of.field("newton_iterations", "on all meshes", |row| row.trial.effort.newton_iterations);
        of.field("complete", "whether the path came to its end", |row| row.trial.complete);
    }
}

fn mesh_word(mesh: MeshKind) -> &'static str {
    match mesh {
        MeshKind::Moving => "moving",
        MeshKind::Graded => "graded",
        MeshKind::Uniform => "uniform",
    }
}

fn write_trials(dir: &Path, measured: &WorkPrecision) -> Result<PathBuf, ReportError> {
    let rows = measured.lines.iter().flat_map(|l| l.trials.iter().map(|trial| Row { line: &l.name, trial }));
    let automatic = measured.automatic.iter().map(|trial| Row { line: AUTOMATIC, trial });
    write_table(dir, "accuracy.csv", rows.chain(automatic))
}

/// What is drawn of a run: an error.
type Error = fn(&Trial) -> Option<f64>;

/// Errors below this are drawn there: the refined run is not better.
const LEAST: f64 = 1e-12;

fn picture(measured: &WorkPrecision, title: &str) -> Picture {
    let points: Error = |trial| trial.errors.points();
    let curve: Error = |trial| Some(trial.errors.curve);
    let (left, right) = (78.0, f64::from(WIDTH) - 18.0);
    let upper = Frame { left, top: 40.0, right, bottom: 400.0 };
    let lower = Frame { left, top: 470.0, right, bottom: 760.0 };
    let panels = vec![
        panel(measured, upper, "error of peak and snap-off, relative", points, true),
        panel(measured, lower, "error of the curve between its points, relative", curve, false),
    ];
    Picture { title: format!("Speed against error: {title}"), height: 815, panels }
}

fn panel(measured: &WorkPrecision, frame: Frame, label: &str, error: Error, named: bool) -> Panel {
    let at = |trial: &Trial| Some((error(trial)?.max(LEAST), 1e3 * trial.seconds)).filter(|_| trial.complete);
    let all = || measured.lines.iter().flat_map(|line| &line.trials).chain(&measured.automatic).filter_map(at);
    let (mut x, y) =
        (Axis::around(label, all().map(|p| p.0), true), Axis::around("CPU time (ms)", all().map(|p| p.1), true));
    x.to = x.to.min(1.0);
    let mut panel = Panel::new(frame, x, y);
    let name = |text: &str| named.then(|| text.to_owned());
    panel.lines.push(Curve {
        points: front(all()),
        stroke: Stroke::solid(colour::PALE, 9.0),
        name: name("best of all runs"),
    });
    let others = [colour::VERMILLION, colour::ORANGE, colour::GREY, colour::GREEN, colour::BLUE];
    for (index, line) in measured.lines.iter().enumerate() {
        let points: Vec<(f64, f64)> = line.trials.iter().filter_map(at).filter(|p| p.0 <= 1.0).collect();
        let stroke = match index.checked_sub(8) {
            None => Stroke::solid(order_shade(index, 8), 1.8),
            Some(other) => Stroke::dashed(others[other % others.len()], 1.8),
        };
        if let Some(&at) = points.last().filter(|_| index < 8) {
            let note = Some(Note { badge: Some(index + 1), text: Vec::new() });
            panel.marks.push(Mark { at, symbol: Symbol::Dot, colour: order_shade(index, 8), name: None, note });
        }
        let named = if index < 8 { (index == 4).then_some("order 1 to 8 (numbers)") } else { Some(line.name.as_str()) };
        panel.lines.push(Curve { points, stroke, name: named.and_then(name) });
    }
    for (index, trial) in measured.automatic.iter().enumerate() {
        let Some(at) = at(trial) else { continue };
        let name = (index == 0).then(|| name(AUTOMATIC)).flatten();
        panel.marks.push(Mark { at, symbol: Symbol::Diamond, colour: colour::INK, name, note: None });
    }
    panel
}

/// The runs that no other beats in both error and time, from small errors to large ones.
fn front(runs: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut runs: Vec<(f64, f64)> = runs.collect();
    runs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut least = f64::INFINITY;
    let mut front: Vec<(f64, f64)> = Vec::new();
    for run in runs {
        if run.1 < least {
            least = run.1;
            front.push(run);
        }
    }
    front
}
