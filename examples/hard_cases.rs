//! What the hard scenes do to other ways of computing them: a fixed mesh, secant steps, displacement control.
//!
//!     cargo run --release --example hard_cases
//!
//! prints the table of verification/README.md; behind `--` the names of scenes may stand, whose rows alone are computed.

use peelkit::beam::{FRONT, MeshKind, TIP_ROTATION};
use peelkit::model::Form;
use peelkit::solve::{MOST_POINTS, Observables, Pace, Path, PathOptions, controlled};
use peelkit::study::{Accuracy, Choice, PathEnd, Peel, peel};
use peelkit_report::end_word;
use peelkit_scene::{BoundsTable, Scene};
use rayon::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut files: Vec<_> =
        std::fs::read_dir("scenes/hard")?.map(|file| Ok(file?.path())).collect::<std::io::Result<_>>()?;
    files.sort();
    let read = |file: &std::path::PathBuf| -> Result<(String, Scene), Box<dyn std::error::Error>> {
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok((name.clone(), Scene::parse(&name, &std::fs::read_to_string(file)?, &[])?))
    };
    let mut scenes = files.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    if let Some(other) = wanted.iter().find(|&wanted| scenes.iter().all(|(name, _)| name != wanted)) {
        return Err(format!("{other} is none of the hard scenes: scenes/hard has no {other}.toml").into());
    }
    scenes.retain(|(name, _)| wanted.is_empty() || wanted.contains(name));
    println!(
        "| scene | end | initiation peak, nN | bound | points, iterations, elements | fixed mesh | secant steps | displacement control |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let rows: Vec<String> = scenes.par_iter().map(|(name, scene)| row(name, scene)).collect();
    rows.iter().for_each(|row| println!("{row}"));
    Ok(())
}

fn row(name: &str, scene: &Scene) -> String {
    let result = peel(&scene.model, &scene.accuracy, &scene.bounds.from_now());
    let peak = result.initiation_peak.as_ref();
    let (force, bound) =
        peak.map_or(("none".into(), String::new()), |p| (format!("{:.9}", p.force), format!("{:.0e}", p.force_error)));
    let effort = &result.effort;
    let counts = format!("{}, {}, {}", effort.points, effort.newton_iterations, effort.elements);
    let (mesh, secant, control) =
        (on_a_fixed_mesh(scene, &result), by_secants(scene, &result), by_displacement(scene, &result));
    format!("| {name} | {} | {force} | {bound} | {counts} | {mesh} | {secant} | {control} |", end_word(&result.end))
}

/// Eight times as many elements, equally long, that do not follow the front; five seconds.
fn on_a_fixed_mesh(scene: &Scene, own: &Peel) -> String {
    let choice = Choice { mesh: MeshKind::Uniform, elements: Some(8 * own.effort.elements), ..scene.accuracy.choice };
    let bounds = BoundsTable { time_s: Some(5.0), ..scene.bounds };
    let other = peel(&scene.model, &Accuracy { choice, ..scene.accuracy }, &bounds.from_now());
    let off = match (own.initiation_peak, other.initiation_peak) {
        (Some(a), Some(b)) => format!("peak off by {:.0e}", (b.force / a.force - 1.0).abs()),
        (Some(_), None) => "no peak".into(),
        _ => "as here".into(),
    };
    format!("{off}, {}, {} points", end_word(&other.end), other.effort.points)
}

/// The same mesh and the same error of predictions, through two points; ten times as many points at most.
fn by_secants(scene: &Scene, own: &Peel) -> String {
    let problem = match scene.model.problem(Form::TwoField, own.effort.order) {
        Ok(problem) => problem,
        Err(error) => return error.to_string(),
    };
    let relative = scene.accuracy.relative;
    let options = PathOptions {
        elements: own.effort.elements,
        step_tolerance: 1.2e-2 * (1e6 * relative).powf(0.25),
        stride: 1.0,
        longest: None,
        tolerance: 1e-2 * relative,
        prediction: 2,
        first_displacement: 0.02 * scene.model.adhesion.equilibrium_distance.min(scene.model.process_length()),
        pace: Pace::Quick,
    };
    let run = |options: PathOptions| {
        let mut path = Path::new(&problem, options);
        let most = 10 * own.effort.points;
        let end = own.points.last().map_or(0.0, |p| p.front);
        while path.points().len() < most {
            match path.advance() {
                Err(_) => return (path.points().len(), path.iterations(), false),
                Ok(point) => {
                    let o = point.observables;
                    let over = path.points().len() > 3
                        && (o.force <= 0.0
                            || o.displacement <= 0.0
                            || problem.beam.is_clear(&point.at, 10.0 * scene.model.adhesion.equilibrium_distance));
                    let passed = scene.bounds.displacement.is_some_and(|most| o.displacement > most);
                    if over
                        || passed
                        || (matches!(own.end, PathEnd::Pivoting)
                            && path.points().len() > 3
                            && o.monitors[FRONT] < 1.0001 * end
                            && o.monitors[TIP_ROTATION] > 1.57)
                    {
                        return (path.points().len(), path.iterations(), true);
                    }
                }
            }
        }
        (path.points().len(), path.iterations(), false)
    };
    let (secant, many) = (run(options), run(PathOptions { prediction: MOST_POINTS, ..options }));
    let share = secant.1 as f64 / many.1 as f64;
    if secant.2 && many.2 {
        format!("{share:.1} times the iterations")
    } else if many.2 {
        format!("stuck after {} points", secant.0)
    } else {
        "as here".into()
    }
}

/// The grip's displacement raised to the largest of the path.
fn by_displacement(scene: &Scene, own: &Peel) -> String {
    let problem = match scene.model.problem(Form::TwoField, own.effort.order) {
        Ok(problem) => problem,
        Err(error) => return error.to_string(),
    };
    let largest = own.points.iter().map(|p| p.displacement).fold(0.0, f64::max);
    let targets: Vec<f64> = (1..=400).map(|k| largest * f64::from(k) / 400.0).collect();
    let weights = Observables::DISPLACEMENT;
    let mut start = problem.initial(own.effort.elements);
    for (k, &target) in targets.iter().enumerate() {
        match controlled(&problem, start, weights, &[target], 1e-2 * scene.accuracy.relative) {
            Ok(found) => start = found.into_iter().next().map(|s| s.at).unwrap_or_default(),
            Err(_) if k == 0 => return "fails at the first step".into(),
            Err(_) => return format!("fails at {:.0} % of the largest u", 100.0 * targets[k - 1] / largest),
        }
    }
    "comes through".into()
}
