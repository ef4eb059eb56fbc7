//! `peel sweep`: one number of a scene varied, each value peeled from rest to its end, or one point of the peel followed.

mod args;
mod failed;
mod no_effect;
mod peels;

pub use args::Sweep;

use crate::output::{list_files, progress_bar, say};
use crate::stop::Stop;
use crate::text_summary;
use failed::failed;
use peelkit::study::{self, FollowedSweep, PointKind, Remark, Spacing};
use peelkit_report::{self as report, ReportError, SweepSummary};
use peelkit_scene::{KEYS, Key, Scene, ValueError, find_key};
use std::cell::{Cell, RefCell};
use std::path::{Path, PathBuf};
use std::time::Instant;

pub fn sweep(args: &Sweep) -> Result<(), Stop> {
    let scene = args.scene.load()?;
    let key = key_to_vary(&args.vary)?;
    no_effect::refuse(&args.scene.overrides, &scene, key)?;
    let scenes = vary(args, &scene, key)?;
    match args.followed() {
        Some(kind) => match not_followed(&scenes) {
            Some(why) => Err(Stop::bad_input(
                format!("--follow computes a limit point {why}"),
                "Omit --follow and --peak-only: the sweep then computes whole paths.",
            )),
            None => follow(args, kind, &scene, key, &scenes),
        },
        None => peels::peel_each(args, &scene, key, &scenes),
    }
}

/// Why no point of these peels can be followed, if none can.
fn not_followed(scenes: &[(f64, Scene)]) -> Option<&'static str> {
    let why = |(_, scene): &(f64, Scene)| match &scene.model {
        model if model.friction_law().is_some() => Some("without friction only, and friction.strength is given"),
        model if !model.ground.substrate.is_flat() => Some("on a flat substrate only, and substrate.shape is another"),
        model if !model.steps.is_empty() => Some("from rest only, and drive.steps has steps before the pull"),
        _ => None,
    };
    scenes.iter().find_map(why)
}

/// Follows one point of the peel over the values.
fn follow(args: &Sweep, kind: PointKind, scene: &Scene, key: &Key, scenes: &[(f64, Scene)]) -> Result<(), Stop> {
    let folder = args.folder().map(|folder| args.out.claim(&folder)).transpose()?;
    let spacing = if args.log { Spacing::Logarithmic } else { Spacing::Linear };
    let bar = progress_bar(scenes.len());
    let mut sweep = FollowedSweep { kind, rows: Vec::with_capacity(scenes.len()), remarks: Vec::new() };
    let mut solve_s = Vec::with_capacity(scenes.len());
    for alike in alike(scenes) {
        let values: Vec<f64> = alike.iter().map(|(value, _)| *value).collect();
        let model = |value| {
            let mut scene = alike[0].1.clone();
            // a key of whole numbers takes nothing in between, and is no part of the model
            let _ = key.store_number(&mut scene, value);
            scene.model
        };
        let Scene { accuracy, bounds, .. } = &alike[0].1;
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
    let files = folder
        .map_or(Ok(Vec::new()), |folder| folder.write(|dir| write_followed(args, dir, scene, key, &sweep, &solve_s)));
    if args.json {
        say(&SweepSummary::followed(scene, key, &sweep, &solve_s).to_json().map_err(Stop::other)?)?;
    } else {
        say(&format!("{}\n{}", text_summary::followed(scene, key, &sweep, &solve_s), list_files(&files)))?;
    }
    files?;
    let lost = |remark: &&Remark| matches!(remark, Remark::NotFound { .. });
    let reasons: Vec<String> = sweep.remarks.iter().filter(lost).map(ToString::to_string).collect();
    failed(&reasons, sweep.rows.len()).map_or(Ok(()), |text| Err(Stop::cut_short(text)))
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

fn write_followed(
    args: &Sweep,
    folder: &Path,
    scene: &Scene,
    key: &Key,
    sweep: &FollowedSweep,
    solve_s: &[f64],
) -> Result<Vec<PathBuf>, ReportError> {
    let mut files = vec![report::write_followed(folder, sweep, solve_s)?];
    if sweep.rows.iter().any(|row| row.point.is_some()) {
        files.extend(report::draw_followed(sweep, &key.path(), &scene.title, args.log, folder)?);
    }
    Ok(files)
}

/// Cases that differ in the model alone: what is not part of it, the accuracy say, is one for all cases of a call.
fn alike(scenes: &[(f64, Scene)]) -> impl Iterator<Item = &[(f64, Scene)]> {
    scenes.chunk_by(|(_, a), (_, b)| a.accuracy == b.accuracy && a.bounds == b.bounds)
}

fn key_to_vary(path: &str) -> Result<&'static Key, Stop> {
    let key = find_key(path).map_err(|problem| Stop::bad_argument(format!("--vary {path}"), &problem))?;
    if key.is_numeric() {
        return Ok(key);
    }
    let numeric: Vec<String> = KEYS.iter().filter(|key| key.is_numeric()).map(Key::path).collect();
    let remedy = format!("Keys that can be varied are {}.", numeric.join(", "));
    Err(Stop::bad_input(format!("--vary {path} is not a number: it takes {}", key.takes()), remedy))
}

/// The scene with each value in its place.
fn vary(args: &Sweep, scene: &Scene, key: &Key) -> Result<Vec<(f64, Scene)>, Stop> {
    let end = |name: &str, text: &str| {
        let stop = |problem: ValueError| Stop::bad_argument(format!("--{name} for {}", key.path()), &problem);
        let value = key.parse_number(text).map_err(stop)?;
        if args.log && value <= 0.0 {
            return Err(Stop::bad_input(
                format!("--{name} {text} is not above zero, which --log needs"),
                "Give two ends above zero, or omit --log.",
            ));
        }
        key.store_number(&mut scene.clone(), value).map_err(stop)?;
        Ok(value)
    };
    if !key.belongs_to(scene) {
        return Err(Stop::bad_argument(format!("--vary {}", key.path()), &key.foreign(scene)));
    }
    let values = grid(end("from", &args.from)?, end("to", &args.to)?, args.points as usize, args.log);
    let varied = values.into_iter().map(|value| {
        let mut scene = scene.clone();
        let stop =
            |problem: ValueError| Stop::bad_argument(format!("{} between --from and --to", key.path()), &problem);
        key.store_number(&mut scene, value).map_err(stop)?;
        scene.check().map_err(|error| stop(error.into()))?;
        Ok((value, scene))
    });
    varied.collect()
}

/// `points` values from `a` to `b`, both exactly among them; at equal ratios if `log`.
fn grid(a: f64, b: f64, points: usize, log: bool) -> Vec<f64> {
    let at = |i: usize| match i {
        0 => a,
        i if i + 1 == points => b,
        i => {
            let part = i as f64 / (points - 1) as f64;
            let between = |a: f64, b: f64| a + (b - a) * part;
            if log { 10f64.powf(between(a.log10(), b.log10())) } else { between(a, b) }
        }
    };
    (0..points).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::grid;

    #[test]
    fn both_ends_are_exact_and_decades_are_round() {
        assert_eq!(grid(1.0, 3.0, 3, false), [1.0, 2.0, 3.0]);
        assert_eq!(grid(0.3, 0.1, 1, false), [0.3]);
        assert_eq!(grid(1e-4, 1e4, 9, true), [1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4]);
        let falling = grid(0.7, 0.1, 4, true);
        assert_eq!((falling[0], falling[3]), (0.7, 0.1));
        assert!(falling.windows(2).all(|pair| pair[1] < pair[0]));
    }
}
