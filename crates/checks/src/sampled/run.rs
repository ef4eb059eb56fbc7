//! One sampled scene, peeled in several ways: how each path ends, what it takes, and whether the numbers agree within their bounds.

use super::scene::{SampleKind, scene_text};
use cpu_time::ThreadTime;
use peelkit::study::{Accuracy, Choice, Failure, LimitPoint, PathEnd, Peel, peel};
use peelkit_report::end_word;
use peelkit_scene::{BoundsTable, Scene};

/// A path is followed for so many seconds at most.
const LONGEST: f64 = 60.0;

/// One of the ways in which a scene is peeled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeelSetting {
    /// As tables name it.
    pub name: &'static str,
    /// Relative accuracy asked for.
    pub relative: f64,
    /// What is fixed.
    pub choice: Choice,
}

/// The ways in which every scene is peeled. The first is judged by the others.
pub const WAYS: [PeelSetting; 3] = [
    PeelSetting { name: "1e-6", relative: 1e-6, choice: Choice::NOTHING },
    PeelSetting { name: "1e-9", relative: 1e-9, choice: Choice::NOTHING },
    PeelSetting { name: "1e-6, order 5", relative: 1e-6, choice: Choice { order: Some(5), ..Choice::NOTHING } },
];

/// What became of one way.
#[derive(Clone, Debug)]
pub struct Run {
    /// The word of its end; `refused` where the model is not computed at all.
    pub end: &'static str,
    /// Why it failed or was refused.
    pub reason: Option<String>,
    /// CPU time of the run, s.
    pub seconds: f64,
    /// Elements of the mesh of the result.
    pub elements: usize,
    numbers: Vec<Option<(f64, f64)>>,
    ripple: usize,
}

/// What became of one scene.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// Its number in the sample.
    pub index: u64,
    /// One for each way.
    pub runs: Vec<Run>,
}

/// A number of the first run that lies further from that of another than both bounds together.
#[derive(Clone, Debug)]
pub struct Outside {
    /// The scene.
    pub index: u64,
    /// What it is of.
    pub quantity: &'static str,
    /// Value and bound of the first run and of the other.
    pub found: [(f64, f64); 2],
}

/// Peels scene `index` of a sample in every way.
pub fn sampled(kind: SampleKind, seed: u64, index: u64) -> Result<Sampled, String> {
    let text = scene_text(kind, seed, index);
    let scene = Scene::parse("sampled", &text, &[]).map_err(|error| format!("{error}\n{text}"))?;
    let runs = WAYS.iter().map(|way| run(&scene, way)).collect();
    Ok(Sampled { index, runs })
}

fn run(scene: &Scene, way: &PeelSetting) -> Run {
    let bounds = BoundsTable { points: 20_000, time_s: Some(LONGEST), displacement: None };
    let started = ThreadTime::now();
    let accuracy = Accuracy::to(way.relative).with(way.choice);
    let peel = peel(&scene.model, &accuracy, &bounds.from_now()).without_solutions();
    let seconds = started.elapsed().as_secs_f64();
    let (end, reason) = match &peel.end {
        PathEnd::Failed(failure @ (Failure::Refused { .. } | Failure::NoStart(_))) => {
            ("refused", Some(failure.to_string()))
        }
        end @ PathEnd::Failed(failure) => (end_word(end), Some(failure.to_string())),
        end => (end_word(end), None),
    };
    let numbers = if end == "refused" { vec![None; QUANTITIES.len()] } else { numbers(&peel) };
    Run { end, reason, seconds, elements: peel.effort.elements, numbers, ripple: peel.ripple }
}

/// What is compared.
const QUANTITIES: [&str; 4] =
    ["displacement of the initiation peak", "initiation peak", "displacement of the snap-off", "force of the snap-off"];

fn numbers(peel: &Peel) -> Vec<Option<(f64, f64)>> {
    let displacement = |p: &LimitPoint| (p.displacement, p.displacement_error);
    let force = |p: &LimitPoint| (p.force, p.force_error);
    let (peak, snap_off) = (peel.initiation_peak.as_ref(), peel.snap_off.as_ref());
    vec![
        peak.map(|p| (p.displacement, p.displacement_error)),
        peak.map(|p| (p.force, p.force_error)),
        snap_off.map(displacement),
        snap_off.map(force),
    ]
}

impl Sampled {
    /// How many numbers the first run and that of way `other` both report, and those that lie outside of both bounds. Where ripple is left
    /// out at one accuracy alone, the first maximum is another, and nothing is compared.
    pub fn against(&self, other: usize) -> (usize, Vec<Outside>) {
        let (one, two) = (&self.runs[0], &self.runs[other]);
        if one.ripple != two.ripple {
            return (0, Vec::new());
        }
        let both: Vec<_> = QUANTITIES
            .into_iter()
            .zip(one.numbers.iter().zip(&two.numbers))
            .filter_map(|(quantity, pair)| match pair {
                (&Some(one), &Some(two)) => Some((quantity, [one, two])),
                _ => None,
            })
            .collect();
        let outside = |&(_, [one, two]): &(&str, [(f64, f64); 2])| {
            let apart = (one.0 - two.0).abs();
            apart.is_nan() || apart > one.1 + two.1
        };
        let compared = both.len();
        let found = both.into_iter().filter(outside);
        (compared, found.map(|(quantity, found)| Outside { index: self.index, quantity, found }).collect())
    }
}

#[cfg(test)]
impl Run {
    /// A run that was not computed.
    pub(super) fn made(
        end: &'static str,
        reason: Option<&str>,
        seconds: f64,
        numbers: [Option<(f64, f64)>; QUANTITIES.len()],
    ) -> Self {
        let reason = reason.map(str::to_owned);
        Self { end, reason, seconds, elements: 8, numbers: numbers.to_vec(), ripple: 0 }
    }
}
