//! `peel sweep --follow`: one point of the peel followed over the values, without whole paths.

use super::args::Sweep;
use super::cases::{Case, Cases};
use super::failed::failed;
use crate::command_line::command_line;
use crate::output::{list_files, progress_bar, say};
use crate::stop::Stop;
use crate::text_summary::{self, WantedUnits};
use peelkit::study::{self, FollowedSweep, PointKind, Remark, Spacing};
use peelkit_report::{self as report, ReportError, SweepSummary};
use peelkit_scene::{Key, Scene};
use std::cell::{Cell, RefCell};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Follows one point of the peel over the values, where it can be followed.
pub fn follow(args: &Sweep, kind: PointKind, scene: &Scene, cases: &Cases, wanted: WantedUnits) -> Result<(), Stop> {
    if let Some(why) = not_followed(cases) {
        return Err(Stop::bad_input(
            format!("--follow computes a limit point {why}"),
            "Omit --follow and --peak-only: the sweep then computes whole paths.",
        ));
    }
    let (key, log) = (cases.keys.first, cases.log[0]);
    let folder = args.folder().map(|folder| args.out.claim(&folder)).transpose()?;
    let (sweep, solve_s) = followed(kind, key, log, &cases.all);
    let command = command_line();
    let files = folder
        .map_or(Ok(Vec::new()), |folder| folder.write(|dir| write(dir, scene, &command, (key, log), &sweep, &solve_s)));
    if args.json {
        let summary = SweepSummary::followed(scene, key, &sweep, &solve_s).with_command(&command);
        say(&summary.to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::followed(scene, key, &sweep, &solve_s, wanted), list_files(&files)))?;
    }
    files?;
    let lost = |remark: &&Remark| matches!(remark, Remark::NotFound { .. });
    let reasons: Vec<String> = sweep.remarks.iter().filter(lost).map(ToString::to_string).collect();
    failed(&reasons, sweep.rows.len()).map_or(Ok(()), |text| Err(Stop::cut_short(text)))
}

/// Why no point of these peels can be followed, if none can.
fn not_followed(cases: &Cases) -> Option<&'static str> {
    let why = |case: &Case| match &case.scene.model {
        model if model.friction_law().is_some() => Some("without friction only, and friction.strength is given"),
        model if !model.ground.substrate.is_flat() => Some("on a flat substrate only, and substrate.shape is another"),
        model if !model.steps.is_empty() => Some("from rest only, and drive.steps has steps before the pull"),
        _ => None,
    };
    let plane = cases.keys.second.map(|_| "over the values of one key only, and two are varied");
    plane.or_else(|| cases.all.iter().find_map(why))
}

/// The point at each value, and the seconds that it took.
fn followed(kind: PointKind, key: &Key, log: bool, cases: &[Case]) -> (FollowedSweep, Vec<f64>) {
    let spacing = if log { Spacing::Logarithmic } else { Spacing::Linear };
    let bar = progress_bar(cases.len());
    let mut sweep = FollowedSweep { kind, rows: Vec::with_capacity(cases.len()), remarks: Vec::new() };
    let mut solve_s = Vec::with_capacity(cases.len());
    for alike in alike(cases) {
        let values: Vec<f64> = alike.iter().map(|case| case.value).collect();
        let model = |value| {
            let mut scene = alike[0].scene.clone();
            // a key of whole numbers takes nothing in between, and is no part of the model
            let _ = key.store_number(&mut scene, value);
            scene.model
        };
        let Scene { accuracy, bounds, .. } = &alike[0].scene;
        let laps = Laps::of(values.len());
        let solved = |index: usize| {
            laps.end(index);
            bar.set_position((sweep.rows.len() + index + 1) as u64);
        };
        let stop = || bounds.from_now();
        let part = study::follow_point(kind, &values, spacing, &model, accuracy, &stop, &solved);
        solve_s.extend(laps.seconds.into_inner());
        sweep.rows.extend(part.rows);
        sweep.remarks.extend(part.remarks);
    }
    bar.finish_and_clear();
    (sweep, solve_s)
}

/// Wall clock from value to value, s.
struct Laps {
    started: Cell<Instant>,
    seconds: RefCell<Vec<f64>>,
}

impl Laps {
    fn of(values: usize) -> Self {
        Self { started: Cell::new(Instant::now()), seconds: RefCell::new(vec![0.0; values]) }
    }

    /// The value is solved for, and the next one begins.
    fn end(&self, index: usize) {
        let seconds = self.started.replace(Instant::now()).elapsed().as_secs_f64();
        self.seconds.borrow_mut()[index] = seconds;
    }
}

fn write(
    folder: &Path,
    scene: &Scene,
    command: &str,
    (key, log): (&Key, bool),
    sweep: &FollowedSweep,
    solve_s: &[f64],
) -> Result<Vec<PathBuf>, ReportError> {
    let mut files =
        vec![report::write_followed(folder, key, sweep, solve_s)?, report::write_parameters(folder, scene, command)?];
    if sweep.rows.iter().any(|row| row.point.is_some()) {
        files.extend(report::draw_followed(sweep, &key.path(), &scene.title, log, folder)?);
    }
    Ok(files)
}

/// Cases that differ in the model alone: what is not part of it, the accuracy say, is one for all cases of a call.
fn alike(cases: &[Case]) -> impl Iterator<Item = &[Case]> {
    cases.chunk_by(|a, b| a.scene.accuracy == b.scene.accuracy && a.scene.bounds == b.scene.bounds)
}
