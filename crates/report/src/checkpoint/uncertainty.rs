//! The samples of an uncertain peel that is not finished yet, kept in a file as they come. A sample depends on the seed and its place and not on how
//! many there are: with more samples asked for, those of an earlier run are taken up as well.

use super::damaged::Damaged;
use super::lines::Lines;
use super::partial_file::PartialFile;
use crate::error::ReportError;
use crate::record::Object;
use crate::records::parameters::parameters;
use peelkit::study::uncertainty::{Outcome, SamplePlace};
use peelkit_scene::Scene;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::Path;

/// The file of an unfinished sample.
#[derive(Debug)]
pub struct PartialUncertainty {
    lines: Lines<Line>,
    taken: HashMap<[usize; 3], Outcome>,
}

/// The first line. Two samples are the same where these lines are: one program, one scene with its defaults, the number of samples left out.
#[derive(Serialize)]
struct Header {
    peelkit: &'static str,
    scene: Object,
}

/// A finished sample.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Line {
    /// Replicate, point and row
    at: [usize; 3],
    outcome: Outcome,
}

impl PartialFile for PartialUncertainty {
    const NAME: &'static str = "uncertainty.partial.jsonl";

    fn damaged(&self) -> Option<&Damaged> {
        self.lines.damaged()
    }
}

impl PartialUncertainty {
    /// Opens the file in `dir`, or begins it, and takes up what it holds of this scene. The file of another scene or seed is refused.
    ///
    /// Fails with [`ReportError::OtherSample`], [`ReportError::Read`] or [`ReportError::Write`].
    pub fn open(dir: &Path, scene: &Scene) -> Result<Self, ReportError> {
        let mut scene = scene.clone();
        if let Some(table) = &mut scene.uncertainty {
            table.samples = 0;
        }
        let header = Header { peelkit: env!("CARGO_PKG_VERSION"), scene: parameters(&scene) };
        let other = |path| ReportError::OtherSample { path };
        let (lines, kept) = Lines::<Line>::open(&dir.join(Self::NAME), &header, other)?;
        Ok(Self { lines, taken: kept.into_iter().map(|line| (line.at, line.outcome)).collect() })
    }

    /// What an earlier run found there.
    pub fn found(&self, at: SamplePlace) -> Option<&Outcome> {
        self.taken.get(&numbers(at))
    }

    /// Appends a finished sample, at once and from any thread.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn keep(&self, at: SamplePlace, outcome: &Outcome) -> Result<(), ReportError> {
        self.lines.keep(&Line { at: numbers(at), outcome: outcome.clone() })
    }
}

fn numbers(at: SamplePlace) -> [usize; 3] {
    [at.replicate, at.point, at.row]
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
        strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
        adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
        uncertainty = { inputs = [{ key = "strip.height", distribution = "normal", deviation = "0.5 nm" }] }
    "#;

    fn scene(set: &[(&str, &str)]) -> Scene {
        let set: Vec<_> = set.iter().map(|&(key, value)| (key.to_owned(), value.to_owned())).collect();
        Scene::parse("a.toml", TEXT, &set).unwrap()
    }

    #[test]
    fn samples_come_back_bit_for_bit_also_where_more_are_asked_for() {
        let dir = tempfile::tempdir().unwrap();
        let at = SamplePlace { replicate: 2, point: 7, row: 1 };
        let outcome = Outcome { values: vec![Some(0.1 + 0.2), None], cut_short: Some("why".into()) };
        PartialUncertainty::open(dir.path(), &scene(&[])).unwrap().keep(at, &outcome).unwrap();
        let again = PartialUncertainty::open(dir.path(), &scene(&[("uncertainty.samples", "5000")])).unwrap();
        assert_eq!(again.found(at), Some(&outcome));
        assert_eq!(again.found(SamplePlace { row: 0, ..at }), None);
    }

    #[test]
    fn the_file_of_another_scene_or_seed_is_refused_until_it_is_discarded() {
        let dir = tempfile::tempdir().unwrap();
        PartialUncertainty::open(dir.path(), &scene(&[])).unwrap();
        for set in [("uncertainty.seed", "1"), ("strip.length", "90 nm"), ("uncertainty.indices", "false")] {
            let error = PartialUncertainty::open(dir.path(), &scene(&[set])).unwrap_err();
            assert!(matches!(error, ReportError::OtherSample { .. }), "{error}");
        }
        assert!(PartialUncertainty::is_in(dir.path()));
        PartialUncertainty::discard(dir.path()).unwrap();
        assert!(!PartialUncertainty::is_in(dir.path()));
    }
}
