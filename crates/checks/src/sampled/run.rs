//! One sampled scene, peeled in several ways: how each path ends, what it takes, and whether the numbers agree within their bounds.

use super::kind::SampleKind;
use super::scene::scene_text;
use crate::agreement::{Reported, disagree};
use cpu_time::ThreadTime;
use peelkit::beam::MeshKind;
use peelkit::model::SetaModel;
use peelkit::study::{
    Accuracy, Choice, Failure, InTimeFailure, InTimeFailureKind, PathEnd, Patience, SetaEnd, SetaOptions, Stage,
    StopCriteria, StopReason, TestEnd, observed, peel, pull_in_time, pull_off, tip_curve,
};
use peelkit_report::{end_word, test_end_reason, test_end_word};
use peelkit_scene::{Described, Scene, SetaTable, TimeTable};

/// The curve of a tip begins with it pressed by so much, nm.
const TIP_PRESSED: f64 = 50.0;

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

/// At an accuracy, at a finer one, on elements of order 5 and on a fixed mesh. The first is judged by the others.
const fn ways_at(relative: f64, finer: f64, names: [&'static str; 4]) -> [PeelSetting; 4] {
    let [name, of_finer, of_order, fixed] = names;
    let order = Choice { order: Some(5), ..Choice::NOTHING };
    let graded = Choice { mesh: MeshKind::Graded, ..Choice::NOTHING };
    [
        PeelSetting { name, relative, choice: Choice::NOTHING },
        PeelSetting { name: of_finer, relative: finer, choice: Choice::NOTHING },
        PeelSetting { name: of_order, relative, choice: order },
        PeelSetting { name: fixed, relative, choice: graded },
    ]
}

/// The ways in which most scenes are peeled.
pub const WAYS: [PeelSetting; 4] = ways_at(1e-6, 1e-9, ["1e-6", "1e-9", "1e-6, order 5", "1e-6, fixed mesh"]);
/// Those of tapes, which nobody measures to more digits.
const TAPE_WAYS: [PeelSetting; 4] = ways_at(1e-4, 1e-6, ["1e-4", "1e-6", "1e-4, order 5", "1e-4, fixed mesh"]);

/// The ways in which scenes of a kind are peeled: a pull in time and a pull-off of a seta have one accuracy.
pub fn ways_of(kind: SampleKind) -> &'static [PeelSetting] {
    match kind {
        SampleKind::Tape | SampleKind::Held => &TAPE_WAYS,
        SampleKind::Rate | SampleKind::Seta => &WAYS[..1],
        _ => &WAYS,
    }
}

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
    /// One for each way, in the order of [`ways_of`] its kind.
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

/// Peels scene `index` of a sample in the first `ways` of [`ways_of`] its kind.
///
/// # Errors
/// A scene that cannot be read, with its text: a fault of the sampler.
pub fn sampled(kind: SampleKind, seed: u64, index: u64, ways: usize, patience: Patience) -> Result<Sampled, String> {
    let text = scene_text(kind, seed, index);
    let scene = match Scene::parse_any("sampled", &text, &[]) {
        Ok(scene) => scene,
        // a model that its own check refuses
        Err(error) if kind == SampleKind::Rough => {
            let refused = Run {
                end: "refused",
                reason: Some(error.to_string()),
                seconds: 0.0,
                elements: 0,
                reported: Reported::nothing(),
            };
            return Ok(Sampled { index, runs: vec![refused; ways.min(ways_of(kind).len())] });
        }
        Err(error) => return Err(format!("{error}\n{text}")),
    };
    let runs = ways_of(kind).iter().take(ways).map(|way| run(kind, &scene, way, patience)).collect();
    Ok(Sampled { index, runs })
}

/// Stops a run of this thread after so many seconds of processor time; its results have as long again, and a second. Time by the clock would count what
/// other programs take.
fn stop_after(seconds: f64) -> StopCriteria {
    let now = || ThreadTime::now().as_duration();
    let started = now();
    StopCriteria::default().or_when(move |stage| {
        let most = if stage == Stage::Path { seconds } else { 2.0 * seconds + 1.0 };
        (now().saturating_sub(started).as_secs_f64() > most).then_some(StopReason::Time { seconds })
    })
}

fn run(kind: SampleKind, scene: &Scene, way: &PeelSetting, patience: Patience) -> Run {
    let stop = StopCriteria { patience, ..stop_after(kind.longest_s()) };
    let started = ThreadTime::now();
    let found = match scene.describes() {
        Described::Rate(table, _) => in_time(scene, table, &stop),
        Described::Solid(_) => Found {
            end: "refused",
            reason: Some("solids are not sampled".to_owned()),
            elements: 0,
            reported: Reported::nothing(),
        },
        Described::Array(_) => Found {
            end: "refused",
            reason: Some("arrays of setae are not sampled".to_owned()),
            elements: 0,
            reported: Reported::nothing(),
        },
        Described::Seta(table) => pulled_off(scene, table, &stop),
        Described::Peel if kind == SampleKind::Observed => tested(scene, way, &stop),
        Described::Peel => peeled(scene, way, &stop),
    };
    let Found { end, reason, elements, reported } = found;
    Run { end, reason, seconds: started.elapsed().as_secs_f64(), elements, reported }
}

/// What a run found, whatever it took.
struct Found {
    end: &'static str,
    reason: Option<String>,
    elements: usize,
    reported: Reported,
}

fn peeled(scene: &Scene, way: &PeelSetting, stop: &StopCriteria) -> Found {
    let accuracy = Accuracy::to(way.relative).with(way.choice);
    let peel = peel(&scene.model, &accuracy, stop).without_solutions();
    let (end, reason) = match &peel.end {
        PathEnd::Failed(failure @ Failure::Refused { .. }) => ("refused", Some(failure.to_string())),
        end @ PathEnd::Failed(failure) => (end_word(end), Some(failure.to_string())),
        end => (end_word(end), None),
    };
    Found { end, reason, elements: peel.effort.elements, reported: Reported::by(&peel) }
}

/// A displacement-controlled test.
fn tested(scene: &Scene, way: &PeelSetting, stop: &StopCriteria) -> Found {
    let accuracy = Accuracy::to(way.relative).with(way.choice);
    let test = match observed(&scene.model, &accuracy, stop) {
        Ok(test) => test,
        Err(why) => {
            let reported = Reported::nothing();
            return Found { end: "refused", reason: Some(why.to_string()), elements: 0, reported };
        }
    };
    let failed = matches!(test.end, TestEnd::Failed(_) | TestEnd::Bound(_));
    let (end, reason) = if failed { ("failed", test_end_reason(&test.end)) } else { (test_end_word(&test.end), None) };
    Found { end, reason, elements: test.effort.elements, reported: Reported::by_test(&test) }
}

/// A pull at a rate: it has failed where it stopped before nothing adhered, or before the end of its way.
fn in_time(scene: &Scene, table: &TimeTable, stop: &StopCriteria) -> Found {
    let (pull, accuracy) = (scene.pull_rate(table), scene.time_accuracy(table));
    let pulled = pull_in_time(&scene.model, &table.moving_material(), &pull, &accuracy, stop.while_followed());
    let (end, reason, reached) = match pulled {
        Ok(pulled) => ("pulled", None, Some(pulled)),
        Err(InTimeFailure { why: why @ InTimeFailureKind::Model(_), .. }) => ("refused", Some(why.to_string()), None),
        Err(InTimeFailure { why, reached }) => ("failed", Some(why.to_string()), reached.map(|reached| *reached)),
    };
    Found { end, reason, elements: reached.map_or(0, |pulled| pulled.elements), reported: Reported::nothing() }
}

/// A pull-off of a seta whose tips follow the curve of one: it has failed where the curve or the pull-off did.
fn pulled_off(scene: &Scene, table: &SetaTable, stop: &StopCriteria) -> Found {
    let options = SetaOptions { balance: scene.accuracy.relative, ..SetaOptions::default() };
    let curve = tip_curve(&scene.tip_model(), &scene.accuracy, TIP_PRESSED).map_err(|error| error.to_string());
    let pulled = curve.and_then(|curve| {
        let model = SetaModel::new(table.seta.clone(), table.law(curve));
        pull_off(&model, &scene.seta_loading(table), &options, stop).map_err(|error| error.to_string())
    });
    let (end, reason) = match pulled.map(|pulled| pulled.end) {
        Ok(SetaEnd::Completed) => ("pulled off", None),
        Ok(SetaEnd::Bound(bound)) => ("failed", Some(bound.to_string())),
        Ok(SetaEnd::Failed(failure)) => ("failed", Some(failure.to_string())),
        Err(why) => ("refused", Some(why)),
    };
    Found { end, reason, elements: 0, reported: Reported::nothing() }
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

    /// The numbers that one of the first run and of that of way `other` reports alone, where neither failed or was refused, and which way has them.
    pub fn alone(&self, other: usize) -> Vec<(&'static str, usize)> {
        let runs = [0, other].map(|way| &self.runs[way]);
        if runs.iter().any(|run| run.reason.is_some()) {
            return Vec::new();
        }
        let beside = runs[0].reported.beside(&runs[1].reported);
        beside
            .filter_map(|(quantity, found)| match found {
                [Some(_), None] => Some((quantity, 0)),
                [None, Some(_)] => Some((quantity, other)),
                _ => None,
            })
            .collect()
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
