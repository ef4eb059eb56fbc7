//! Speed against error: the table and the picture of `peel accuracy`.

use super::measure::{Trial, WorkPrecision};
use peelkit::beam::MeshKind;
use peelkit_report::chart::{
    Axis, Frame, Line as Curve, Mark, Note, Panel, Picture, Stroke, Symbol, WIDTH, colour, order_shade, save,
};
use peelkit_report::{Finite, ReportError, form_word, write_table};
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

fn write_trials(dir: &Path, measured: &WorkPrecision) -> Result<PathBuf, ReportError> {
    #[derive(Default, serde::Serialize)]
    struct Row<'a> {
        line: &'a str,
        asked: Finite,
        order: usize,
        elements: usize,
        mesh: &'static str,
        form: &'static str,
        peak_error: Option<Finite>,
        snap_off_error: Option<Finite>,
        curve_error: Finite,
        cpu_s: Finite,
        points: usize,
        newton_iterations: usize,
        complete: bool,
    }
    let row = |line, trial: &Trial| Row {
        line,
        asked: Finite(trial.accuracy.relative),
        order: trial.effort.order,
        elements: trial.effort.elements,
        mesh: match trial.accuracy.choice.mesh {
            MeshKind::Moving => "moving",
            MeshKind::Graded => "graded",
            MeshKind::Uniform => "uniform",
        },
        form: form_word(trial.accuracy.choice.form),
        peak_error: trial.errors.peak.map(Finite),
        snap_off_error: trial.errors.snap_off.map(Finite),
        curve_error: Finite(trial.errors.curve),
        cpu_s: Finite(trial.seconds),
        points: trial.effort.points,
        newton_iterations: trial.effort.newton_iterations,
        complete: trial.complete,
    };
    let lines = measured.lines.iter().flat_map(|l| l.trials.iter().map(|trial| row(l.name.as_str(), trial)));
    write_table(dir, "accuracy.csv", lines.chain(measured.automatic.iter().map(|trial| row(AUTOMATIC, trial))))
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
