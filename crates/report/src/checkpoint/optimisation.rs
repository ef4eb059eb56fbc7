//! The designs of an optimisation that is not finished yet, kept in a file as they are evaluated. The next run of the same scene makes the same choices
//! and takes what is known of its designs from there, bit for bit.

use super::damaged::Damaged;
use super::lines::Lines;
use super::partial_file::PartialFile;
use crate::error::ReportError;
use crate::record::Object;
use crate::records::parameters::parameters;
use peelkit::study::optimisation::Evaluation;
use peelkit_scene::Scene;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::Path;

/// The file of an unfinished optimisation.
#[derive(Debug)]
pub struct PartialOptimisation {
    lines: Lines<Line>,
    /// By the bits of the coordinates; of two the one with a gradient
    taken: HashMap<Vec<u64>, Evaluation>,
}

/// The first line. Two optimisations are the same where these lines are: one program, one scene with its defaults.
#[derive(Serialize)]
struct Header {
    peelkit: &'static str,
    optimised: Object,
}

/// An evaluated design.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Line {
    coordinates: Vec<f64>,
    log_value: Option<f64>,
    gradient: Vec<f64>,
}

impl PartialFile for PartialOptimisation {
    const NAME: &'static str = "optimise.partial.jsonl";

    fn damaged(&self) -> Option<&Damaged> {
        self.lines.damaged()
    }
}

impl PartialOptimisation {
    /// Opens the file in `dir`, or begins it, and takes up what it holds of this scene. The file of another scene is refused.
    ///
    /// Fails with [`ReportError::OtherOptimisation`], [`ReportError::Read`] or [`ReportError::Write`].
    pub fn open(dir: &Path, scene: &Scene) -> Result<Self, ReportError> {
        let header = Header { peelkit: env!("CARGO_PKG_VERSION"), optimised: parameters(scene) };
        let other = |path| ReportError::OtherOptimisation { path };
        let (lines, kept) = Lines::<Line>::open(&dir.join(Self::NAME), &header, other)?;
        let mut taken: HashMap<Vec<u64>, Evaluation> = HashMap::new();
        for Line { coordinates, log_value, gradient } in kept {
            let known = taken.get(&bits(&coordinates)).is_some_and(|known| !known.gradient.is_empty());
            if !known {
                taken.insert(bits(&coordinates), Evaluation { coordinates, log_value, gradient });
            }
        }
        Ok(Self { lines, taken })
    }

    /// How many designs are taken up.
    pub fn taken(&self) -> usize {
        self.taken.len()
    }

    /// What an earlier run found of the design with these coordinates.
    pub fn found(&self, coordinates: &[f64]) -> Option<&Evaluation> {
        self.taken.get(&bits(coordinates))
    }

    /// Appends an evaluated design, at once and from any thread.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn keep(&self, design: &Evaluation) -> Result<(), ReportError> {
        let Evaluation { coordinates, log_value, gradient } = design.clone();
        self.lines.keep(&Line { coordinates, log_value, gradient })
    }
}

fn bits(coordinates: &[f64]) -> Vec<u64> {
    coordinates.iter().map(|c| c.to_bits()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
        strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
        adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
        [optimise]
        objective = "first_jump.work_aJ"
        parameters = [{ key = "strip.bending_stiffness_factor", from = 0.1, to = 10 }]
    "#;

    #[test]
    fn designs_come_back_bit_for_bit_and_to_their_scene_alone() {
        let dir = tempfile::tempdir().unwrap();
        let scene = Scene::parse("a.toml", TEXT, &[]).unwrap();
        let bad = Evaluation { coordinates: vec![0.1 + 0.2], log_value: None, gradient: Vec::new() };
        let good = Evaluation { coordinates: vec![1.0 / 3.0], log_value: Some(-0.0), gradient: vec![5e-324] };
        let partial = PartialOptimisation::open(dir.path(), &scene).unwrap();
        partial.keep(&bad).unwrap();
        partial.keep(&good).unwrap();
        let partial = PartialOptimisation::open(dir.path(), &scene).unwrap();
        assert_eq!((partial.taken(), partial.found(&[0.1 + 0.2])), (2, Some(&bad)));
        assert!(partial.found(&[1.0 / 3.0]).unwrap().log_value.unwrap().is_sign_negative());
        assert_eq!(partial.found(&[0.3]), None);
        let other = Scene::parse("a.toml", &TEXT.replace("0.1, to", "0.2, to"), &[]).unwrap();
        let refused = PartialOptimisation::open(dir.path(), &other);
        assert!(matches!(refused, Err(ReportError::OtherOptimisation { .. })));
    }
}
