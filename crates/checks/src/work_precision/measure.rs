//! What an accuracy costs: one strip peeled over orders, numbers of elements, meshes, forms and steps, each timed and held
//! against a refined run, and beside them what the program chooses by itself.

use cpu_time::ThreadTime;
use peelkit::beam::MeshKind;
use peelkit::model::{Form, PeelModel};
use peelkit::study::{Accuracy, Choice, Effort, FOLLOWED_ORDER, PathEnd, Peel, peel};
use peelkit_scene::BoundsTable;

/// Errors of one run against the refined one, relative; `None` where the strip has no such point or the run did not find it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Initiation peak: the larger of force and displacement
    pub peak: Option<f64>,
    /// Snap-off, likewise
    pub snap_off: Option<f64>,
    /// Distance of the interpolated curve from the refined one, in logarithms of displacement and force
    pub curve: f64,
}

impl Errors {
    /// The larger error of the special points.
    pub fn points(&self) -> Option<f64> {
        self.peak.into_iter().chain(self.snap_off).reduce(f64::max)
    }
}

/// One run: how it was discretised, what it cost, how wrong it was.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// How it was discretised.
    pub accuracy: Accuracy,
    /// Its path points, iterations and elements.
    pub effort: Effort,
    /// CPU time of the thread that ran it, the least of several runs, s
    pub seconds: f64,
    /// How wrong it was.
    pub errors: Errors,
    /// Whether the path came to its end, as the refined one did.
    pub complete: bool,
}

/// Runs of one kind over numbers of elements.
#[derive(Clone, Debug)]
pub struct Line {
    /// What is the same in its runs: order, mesh, form.
    pub name: String,
    /// From the coarsest mesh to the finest.
    pub trials: Vec<Trial>,
}

/// All that was measured of one strip.
#[derive(Clone, Debug)]
pub struct WorkPrecision {
    /// Over orders, meshes, forms and steps.
    pub lines: Vec<Line>,
    /// What follows from the accuracy alone, from 1e-3 to 1e-10.
    pub automatic: Vec<Trial>,
}

/// The accuracies at which the program's own choice is shown.
const ASKED: [f64; 8] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
/// A line ends where its error is below this, near that of the refined run, or a run took longer than so many seconds.
const SMALL: f64 = 1e-10;
const LONG: f64 = 0.5;
/// Most unknowns of a field.
const MOST_NODES: usize = 4000;
/// Growth of the number of elements along a line.
const GROWTH: f64 = 1.3;
/// A time is the least of several, as many as fit into this time, s.
const TIMING: f64 = 0.04;
const MOST_REPEATS: usize = 9;
/// Intervals a step of the refined curve, and of one that is compared with it.
const FINE: usize = 60;
const COARSE: usize = 9;

impl WorkPrecision {
    /// The time of the fastest run that is no more wrong than `error`, and the name of its line.
    pub fn best(&self, error: f64) -> Option<(f64, &str)> {
        let runs = self.lines.iter().flat_map(|line| line.trials.iter().map(move |trial| (trial, line.name.as_str())));
        runs.filter(|(trial, _)| trial.complete && trial.errors.points().is_some_and(|e| e <= error))
            .map(|(trial, name)| (trial.seconds, name))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// Measures a strip. `done` is given the number of lines there are, once for each that is finished. An error says why the refined
/// run failed.
pub fn work_precision<'m, M>(model: &'m M, bounds: &BoundsTable, done: &dyn Fn(usize)) -> Result<WorkPrecision, String>
where
    PeelModel: From<&'m M>,
{
    let model = PeelModel::from(model);
    let truth = Truth::of(&model, bounds)?;
    let kinds = kinds();
    let mut lines = Vec::new();
    for (name, choice) in &kinds {
        lines.push(Line { name: name.clone(), trials: truth.line(choice) });
        done(kinds.len() + 1);
    }
    let automatic = ASKED.iter().map(|&relative| truth.trial(&Accuracy::to(relative))).collect();
    done(kinds.len() + 1);
    Ok(WorkPrecision { lines, automatic })
}

/// What is varied: the order; then, at the order that is chosen for most accuracies, mesh, form and steps.
fn kinds() -> Vec<(String, Choice)> {
    let plain = Accuracy::to(1e-6).choice;
    let high = Choice { order: Some(FOLLOWED_ORDER), ..plain };
    let mut kinds: Vec<_> = (1..=8).map(|p| (format!("order {p}"), Choice { order: Some(p), ..plain })).collect();
    kinds.push(("three-field".into(), Choice { form: Form::ThreeField, ..high }));
    kinds.push(("fixed graded mesh".into(), Choice { mesh: MeshKind::Graded, ..high }));
    kinds.push(("fixed uniform mesh".into(), Choice { mesh: MeshKind::Uniform, ..high }));
    for step in [1e-3, 1e-1] {
        kinds.push((format!("steps of {step:e}"), Choice { step: Some(step), ..high }));
    }
    kinds
}

/// The refined run.
struct Truth<'a> {
    model: &'a PeelModel,
    bounds: BoundsTable,
    peel: Peel,
    curve: Vec<(f64, f64)>,
    /// Below these displacement and force count as they are, above relative to themselves.
    least: (f64, f64),
}

impl<'a> Truth<'a> {
    fn of(model: &'a PeelModel, bounds: &BoundsTable) -> Result<Self, String> {
        let choice = Choice { step: Some(1e-3), ..Accuracy::to(1e-11).choice };
        let refined = peel(model, &Accuracy::to(1e-11).with(choice), &bounds.from_now());
        let peel = match refined.end {
            PathEnd::Failed(_) => peel(model, &Accuracy::to(1e-10).with(choice), &bounds.from_now()),
            _ => refined,
        };
        if let PathEnd::Failed(reason) = &peel.end {
            return Err(format!("the refined reference run failed: {reason}"));
        }
        let curve = dense(&peel, FINE);
        let largest = curve.iter().map(|&(_, force)| force).fold(0.0, f64::max);
        let displacement = peel.initiation_peak.map_or(model.adhesion.equilibrium_distance, |peak| peak.displacement);
        Ok(Self { model, bounds: *bounds, peel, curve, least: (0.1 * displacement, 1e-2 * largest) })
    }

    /// Runs on more and more elements, each as accurate along the path as the one before was on its mesh.
    fn line(&self, choice: &Choice) -> Vec<Trial> {
        let order = choice.order.unwrap_or(FOLLOWED_ORDER);
        let mut trials: Vec<Trial> = Vec::new();
        let mut elements = (40 / order).max(6);
        let mut relative = 1e-3;
        while elements * order <= MOST_NODES {
            let trial = self.trial(&Accuracy::to(relative).with(Choice { elements: Some(elements), ..*choice }));
            let error = trial.errors.points().unwrap_or(1.0);
            relative = (0.2 * error).clamp(1e-10, 1e-3);
            trials.push(trial);
            if error < SMALL || trial.seconds > LONG {
                break;
            }
            elements = (elements as f64 * GROWTH).ceil() as usize;
        }
        trials
    }

    fn trial(&self, accuracy: &Accuracy) -> Trial {
        let bounds = BoundsTable { time_s: Some(2.0 * LONG), ..self.bounds };
        let started = ThreadTime::now();
        let timed = || {
            let clock = ThreadTime::now();
            let result = peel(self.model, accuracy, &bounds.from_now());
            (clock.elapsed().as_secs_f64(), result)
        };
        let (mut seconds, result) = timed();
        for _ in 1..MOST_REPEATS {
            if started.elapsed().as_secs_f64() > TIMING {
                break;
            }
            seconds = seconds.min(timed().0);
        }
        let complete = std::mem::discriminant(&result.end) == std::mem::discriminant(&self.peel.end);
        Trial { accuracy: *accuracy, effort: result.effort, seconds, errors: self.errors(&result), complete }
    }

    fn errors(&self, peel: &Peel) -> Errors {
        let larger = |found: Option<[f64; 2]>, wanted: Option<[f64; 2]>| {
            let (found, wanted) = (found?, wanted?);
            Some((found[0] / wanted[0] - 1.0).abs().max((found[1] / wanted[1] - 1.0).abs()))
        };
        let peak = |peel: &Peel| peel.initiation_peak.map(|p| [p.force, p.displacement]);
        let snap_off = |peel: &Peel| peel.snap_off.map(|p| [p.force, p.displacement]);
        Errors {
            peak: larger(peak(peel), peak(&self.peel)),
            snap_off: larger(snap_off(peel), snap_off(&self.peel)),
            curve: self.curve_error(&dense(peel, COARSE)),
        }
    }

    /// The largest distance of a curve from the refined one, as far as that goes; both go the same way, so each point is looked
    /// for from where the last one was.
    fn curve_error(&self, curve: &[(f64, f64)]) -> f64 {
        let near = self.curve.len() / 8;
        let (mut worst, mut last) = (0.0f64, 0usize);
        for &at in curve {
            let window = last.saturating_sub(near)..(last + near).min(self.curve.len() - 1);
            let distances = window.map(|i| (self.distance(at, self.curve[i], self.curve[i + 1]), i));
            let Some((distance, place)) = distances.min_by(|a, b| a.0.total_cmp(&b.0)) else { break };
            if place + 2 >= self.curve.len() {
                break;
            }
            worst = worst.max(distance);
            last = place;
        }
        worst
    }

    fn distance(&self, at: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
        let scale = (1.0 / (at.0.abs() + self.least.0), 1.0 / (at.1.abs() + self.least.1));
        let away = |p: (f64, f64)| ((p.0 - at.0) * scale.0, (p.1 - at.1) * scale.1);
        let (a, b) = (away(from), away(to));
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let square = dx * dx + dy * dy;
        let along = if square > 0.0 { (-(a.0 * dx + a.1 * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
        (a.0 + along * dx).hypot(a.1 + along * dy)
    }
}

/// Displacement and force along a peel.
fn dense(peel: &Peel, per_step: usize) -> Vec<(f64, f64)> {
    peel.dense_curve(per_step).into_iter().map(|(displacement, force, _)| (displacement, force)).collect()
}
