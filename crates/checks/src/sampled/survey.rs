//! What became of a whole sample: the share of each end, the causes of failures, what they cost, and the bounds that did not hold.

use super::kind::SampleKind;
use super::run::{Outside, Sampled, sampled, ways_of};
use peelkit::study::Patience;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fmt::Write;

/// What became of a sample.
#[derive(Clone, Debug)]
pub struct SampleSurvey {
    /// What was sampled.
    pub kind: SampleKind,
    /// Of the sample.
    pub seed: u64,
    /// In the order of their numbers.
    pub scenes: Vec<Sampled>,
}

/// Which scenes of a sample are peeled, by their numbers from 0 on.
#[derive(Clone, Debug)]
pub enum SampledScenes {
    /// So many from its beginning.
    First(u64),
    /// These.
    Chosen(Vec<u64>),
}

impl SampledScenes {
    /// How many they are, as far as the machine can count.
    pub fn count(&self) -> usize {
        match self {
            Self::First(count) => usize::try_from(*count).unwrap_or(usize::MAX),
            Self::Chosen(scenes) => scenes.len(),
        }
    }
}

/// Peels these scenes of a sample in the first `ways` of [`ways_of`] its kind, on all cores; `done` is called behind each.
///
/// # Errors
/// A sampled scene that cannot be read, with its text: a fault of the sampler.
pub fn survey_sample(
    kind: SampleKind,
    seed: u64,
    scenes: &SampledScenes,
    ways: usize,
    done: &(dyn Fn() + Sync),
) -> Result<SampleSurvey, String> {
    let one = |index| {
        let scene = sampled(kind, seed, index, ways, Patience::Usual);
        done();
        scene
    };
    let scenes: Result<Vec<Sampled>, String> = match scenes {
        SampledScenes::First(count) => (0..*count).into_par_iter().map(one).collect(),
        SampledScenes::Chosen(scenes) => scenes.par_iter().copied().map(one).collect(),
    };
    Ok(SampleSurvey { kind, seed, scenes: scenes? })
}

impl SampleSurvey {
    /// How many scenes ended so when peeled in a way.
    pub fn count(&self, way: usize, end: &str) -> usize {
        self.scenes.iter().filter(|scene| scene.runs[way].end == end).count()
    }

    /// Scenes that failed when peeled in a way, each with its reason.
    pub fn failed(&self, way: usize) -> impl Iterator<Item = (u64, &str)> {
        self.with_end(way, "failed")
    }

    fn with_end(&self, way: usize, end: &'static str) -> impl Iterator<Item = (u64, &str)> {
        let scenes = self.scenes.iter().filter(move |scene| scene.runs[way].end == end);
        scenes.map(move |scene| (scene.index, scene.runs[way].reason.as_deref().unwrap_or("")))
    }

    /// The median time of the runs with a result, s, and the longest run of all over it.
    pub fn times(&self, way: usize) -> Option<(f64, f64)> {
        let runs = || self.scenes.iter().map(|scene| &scene.runs[way]);
        let mut good: Vec<f64> = runs().filter(|run| run.reason.is_none()).map(|run| run.seconds).collect();
        good.sort_by(f64::total_cmp);
        let median = *good.get(good.len() / 2)?;
        Some((median, runs().map(|run| run.seconds).fold(0.0, f64::max) / median))
    }

    /// How many numbers of the first way were compared with those of another, and which lie outside of both bounds.
    pub fn against(&self, other: usize) -> (usize, Vec<Outside>) {
        let all = self.scenes.iter().map(|scene| scene.against(other));
        all.fold((0, Vec::new()), |(sum, mut list), (count, outside)| {
            list.extend(outside);
            (sum + count, list)
        })
    }

    /// The scenes of which the first way or another reports numbers that the other of both does not, with these and which way has them.
    pub fn alone(&self, other: usize) -> Vec<(u64, Vec<(&'static str, usize)>)> {
        let all = self.scenes.iter().map(|scene| (scene.index, scene.alone(other)));
        all.filter(|(_, alone)| !alone.is_empty()).collect()
    }

    /// The survey as text.
    pub fn table(&self) -> String {
        let mut text = String::new();
        let total = self.scenes.len();
        let ways = self.scenes.first().map_or(0, |scene| scene.runs.len());
        for (way, name) in ways_of(self.kind)[..ways].iter().map(|way| way.name).enumerate() {
            let mut ends: BTreeMap<&str, usize> = BTreeMap::new();
            self.scenes.iter().for_each(|scene| *ends.entry(scene.runs[way].end).or_default() += 1);
            let shares: Vec<String> = ends
                .iter()
                .map(|(end, count)| format!("{end} {count} ({:.2} %)", 100.0 * *count as f64 / total as f64))
                .collect();
            let times = self.times(way).map_or(String::new(), |(median, slowest)| {
                format!("; median {median:.3} s, slowest {slowest:.0} times that")
            });
            let _ = writeln!(text, "{} at {name}: {} scenes: {}{times}", self.kind.name(), total, shares.join(", "));
            for end in ["failed", "refused"] {
                for (cause, scenes) in causes(self.with_end(way, end)) {
                    let list: Vec<String> = scenes.iter().take(12).map(u64::to_string).collect();
                    let _ = writeln!(text, "  {end}: {} x {cause}: scenes {}", scenes.len(), list.join(" "));
                }
            }
        }
        for other in 1..ways {
            let (compared, outside) = self.against(other);
            let [one, two] = [0, other].map(|way| ways_of(self.kind)[way].name);
            let _ = writeln!(
                text,
                "{} at {one} against {two}: of {compared} numbers {} lie outside of both bounds",
                self.kind.name(),
                outside.len()
            );
            for Outside { index, quantity, found: [one, two] } in outside {
                let _ = writeln!(
                    text,
                    "  scene {index}: {quantity} {:.9e} ± {:.1e} and {:.9e} ± {:.1e}",
                    one.0, one.1, two.0, two.1
                );
            }
            let alone = self.alone(other);
            let _ = writeln!(
                text,
                "{} at {one} against {two}: {} scenes have a number at one of both alone",
                self.kind.name(),
                alone.len()
            );
            for (index, numbers) in alone {
                let named =
                    |&(quantity, way): &(&str, usize)| format!("{quantity} at {}", ways_of(self.kind)[way].name);
                let numbers: Vec<String> = numbers.iter().map(named).collect();
                let _ = writeln!(text, "  scene {index}: {}", numbers.join(", "));
            }
        }
        text
    }
}

/// Reasons without their numbers, the most frequent first, with the scenes.
fn causes<'a>(reasons: impl Iterator<Item = (u64, &'a str)>) -> Vec<(String, Vec<u64>)> {
    let mut causes: BTreeMap<String, Vec<u64>> = BTreeMap::new();
    for (index, reason) in reasons {
        let kind: String = reason.chars().filter(|c| !c.is_ascii_digit()).take(160).collect();
        causes.entry(kind).or_default().push(index);
    }
    let mut causes: Vec<(String, Vec<u64>)> = causes.into_iter().collect();
    causes.sort_by_key(|(_, scenes)| std::cmp::Reverse(scenes.len()));
    causes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampled::run::Run;

    fn run(end: &'static str, reason: Option<&str>, seconds: f64, peak: Option<(f64, f64)>) -> Run {
        Run::made(end, reason, seconds, [None, peak, None, None])
    }

    fn scene(index: u64, first: Run, others: [Run; 3]) -> Sampled {
        Sampled { index, runs: std::iter::once(first).chain(others).collect() }
    }

    /// Two scenes: of one the force agrees at 1e-9 and not on the other mesh; the other one fails, at two places for the same reason.
    #[test]
    fn what_became_of_a_sample_is_counted() {
        let good = |force| run("detached", None, 0.1, Some((force, 1e-6)));
        let bad = |point: usize| run("failed", Some(&format!("stopped at point {point}")), 3.0, None);
        let scenes = vec![
            scene(0, good(1.0), [good(1.0 + 1.5e-6), good(1.0 + 2.5e-6), good(1.0)]),
            scene(1, bad(17), [good(2.0), bad(3), bad(4)]),
            scene(2, bad(4), [good(2.0), good(2.0), good(2.0)]),
        ];
        let survey = SampleSurvey { kind: SampleKind::Strip, seed: 1, scenes };
        assert_eq!((survey.count(0, "detached"), survey.count(0, "failed"), survey.count(1, "failed")), (1, 2, 0));
        assert_eq!(causes(survey.failed(0)), vec![("stopped at point ".to_owned(), vec![1, 2])]);
        assert_eq!(survey.times(0).map(|(median, slowest)| (median, slowest.round())), Some((0.1, 30.0)));
        assert_eq!(survey.times(3).map(|(median, slowest)| (median, slowest.round())), Some((0.1, 30.0)));
        let ([fine, other], [_, outside]) =
            ([1, 2].map(|way| survey.against(way).0), [1, 2].map(|way| survey.against(way).1));
        assert_eq!((fine, other, outside.len()), (1, 1, 1));
        assert_eq!((outside[0].index, outside[0].quantity), (0, "initiation peak"));
        // of a scene that failed in one way nothing is compared
        assert_eq!(survey.alone(1), []);
        let one_sided = scene(3, good(1.0), [run("detached", None, 0.1, None), good(1.0), good(1.0)]);
        assert_eq!(one_sided.alone(1), [("initiation peak", 0)]);
        assert!(survey.table().contains("strip at 1e-6: 3 scenes: detached 1 (33.33 %), failed 2 (66.67 %)"));
    }
}
