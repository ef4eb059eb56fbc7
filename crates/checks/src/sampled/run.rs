//! One sampled scene, peeled in several ways: how each path ends, what it takes, and whether the numbers agree within their bounds.

use super::scene::{SampleKind, scene_text};
use crate::agreement::{Reported, disagree};
use cpu_time::ThreadTime;
use peelkit::beam::MeshKind;
use peelkit::study::{Accuracy, Choice, Failure, PathEnd, peel};
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
pub const WAYS: [PeelSetting; 4] = [
    PeelSetting { name: "1e-6", relative: 1e-6, choice: Choice::NOTHING },
    PeelSetting { name: "1e-9", relative: 1e-9, choice: Choice::NOTHING },
    PeelSetting { name: "1e-6, order 5", relative: 1e-6, choice: Choice { order: Some(5), ..Choice::NOTHING } },
    PeelSetting {
        name: "1e-6, fixed mesh",
        relative: 1e-6,
        choice: Choice { mesh: MeshKind::Graded, ..Choice::NOTHING },
    },
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
    reported: Reported,
}

/// What became of one scene.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// Its number in the sample.
    pub index: u64,
    /// One for each way, in the order of [`WAYS`].
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

/// Peels scene `index` of a sample in the first `ways` of [`WAYS`].
///
/// # Errors
/// A scene that cannot be read, with its text: a fault of the sampler.
pub fn sampled(kind: SampleKind, seed: u64, index: u64, ways: usize) -> Result<Sampled, String> {
    let text = scene_text(kind, seed, index);
    let scene = Scene::parse("sampled", &text, &[]).map_err(|error| format!("{error}\n{text}"))?;
    let runs = WAYS.iter().take(ways).map(|way| run(&scene, way)).collect();
    Ok(Sampled { index, runs })
}

fn run(scene: &Scene, way: &PeelSetting) -> Run {
    let bounds = BoundsTable { points: 20_000, time_s: Some(LONGEST), ..BoundsTable::default() };
    let started = ThreadTime::now();
    let accuracy = Accuracy::to(way.relative).with(way.choice);
    let peel = peel(&scene.model, &accuracy, &bounds.from_now()).without_solutions();
    let seconds = started.elapsed().as_secs_f64();
    let (end, reason) = match &peel.end {
        PathEnd::Failed(failure @ Failure::Refused { .. }) => ("refused", Some(failure.to_string())),
        end @ PathEnd::Failed(failure) => (end_word(end), Some(failure.to_string())),
        end => (end_word(end), None),
    };
    Run { end, reason, seconds, elements: peel.effort.elements, reported: Reported::by(&peel) }
}

impl Sampled {
    /// How many numbers the first run and that of way `other` both report, and those that lie outside of both bounds.
    pub fn against(&self, other: usize) -> (usize, Vec<Outside>) {
        let both: Vec<_> = self.runs[0]
            .reported
            .beside(&self.runs[other].reported)
            .filter_map(|(quantity, [one, two])| Some((quantity, [one?, two?])))
            .collect();
        let compared = both.len();
        let outside = both.into_iter().filter(|&(_, found)| disagree(found));
        (compared, outside.map(|(quantity, found)| Outside { index: self.index, quantity, found }).collect())
    }
}

#[cfg(test)]
impl Run {
    /// A run that was not computed.
    pub(super) fn made(
        end: &'static str,
        reason: Option<&str>,
        seconds: f64,
        numbers: [Option<(f64, f64)>; 4],
    ) -> Self {
        let reason = reason.map(str::to_owned);
        Self { end, reason, seconds, elements: 8, reported: Reported::made(numbers) }
    }
}
