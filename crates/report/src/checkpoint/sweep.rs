//! The rows of a sweep that is not finished yet, kept in a file as they come: a run that was interrupted loses none of
//! them, and the next run of the same sweep takes them up.

use super::damaged::Damaged;
use super::lines::Lines;
use super::partial_file::PartialFile;
use crate::error::ReportError;
use crate::record::Object;
use crate::records::parameters::parameters;
use crate::sweep_row::SweepRow;
use crate::swept_keys::SweptKeys;
use peelkit::study::PeelResult;
use peelkit_scene::Scene;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fmt;
use std::path::Path;

/// The file of an unfinished sweep: a line that identifies the sweep, then a line a finished value, in no order. Of each value it has what was found:
/// of a peel, or of something else that a scene describes.
#[derive(Debug)]
pub struct PartialSweep<F = PeelResult> {
    lines: Lines<Line<F>>,
    /// By the bits of the values.
    taken: HashMap<(u64, Option<u64>), Line<F>>,
}

/// Which part of a divided sweep: `index`, counted from 1, of `of`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    /// From 1 to `of`
    pub index: usize,
    /// The number of parts
    pub of: usize,
}

impl Part {
    /// Whether this part computes the case of this number, counted from 0. Neighbours lie in different parts: they cost alike, so parts do.
    pub fn has(self, case: usize) -> bool {
        Self::with_case(case, self.of) == self
    }

    /// The part, of so many, that computes the case of this number, counted from 0.
    pub fn with_case(case: usize, of: usize) -> Self {
        Self { index: case % of + 1, of }
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

/// The first line. Two sweeps are the same where these lines are: one program, one scene with its defaults, one key,
/// and of a divided sweep one part.
#[derive(Serialize)]
struct Header {
    peelkit: &'static str,
    vary: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<Part>,
    scene: Object,
}

/// A finished value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Line<F = PeelResult> {
    value: f64,
    /// Of the second key, where two are varied.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    second: Option<f64>,
    pub found: F,
    pub solve_s: f64,
}

impl<F> Line<F> {
    /// By which it is found.
    pub fn place(&self) -> (u64, Option<u64>) {
        place(self.value, self.second)
    }
}

impl From<&SweepRow> for Line {
    fn from(row: &SweepRow) -> Self {
        Self { value: row.value, second: row.second, found: row.found.clone(), solve_s: row.solve_s }
    }
}

/// What a file keeps and gives back as it was.
pub trait Storable: Clone + PartialEq + Serialize + DeserializeOwned {}

impl<F: Clone + PartialEq + Serialize + DeserializeOwned> Storable for F {}

impl<F: Storable> PartialFile for PartialSweep<F> {
    const NAME: &'static str = "sweep.partial.jsonl";

    fn damaged(&self) -> Option<&Damaged> {
        self.lines.damaged()
    }
}

impl<F: Storable> PartialSweep<F> {
    /// Opens the file in `dir`, or begins it, and takes up what it holds of this sweep: the scene in which these keys are varied,
    /// and the part of it where it is divided. The file of another sweep is refused.
    ///
    /// Fails with [`ReportError::OtherSweep`], [`ReportError::Read`] or [`ReportError::Write`].
    pub fn open<'k>(
        dir: &Path,
        scene: &Scene,
        keys: impl Into<SweptKeys<'k>>,
        part: Option<Part>,
    ) -> Result<Self, ReportError> {
        let (vary, scene) = (keys.into().names(), parameters(scene));
        let header = Header { peelkit: env!("CARGO_PKG_VERSION"), vary, part, scene };
        let other = |path| ReportError::OtherSweep { path };
        let (lines, kept) = Lines::<Line<F>>::open(&dir.join(Self::NAME), &header, other)?;
        let taken = kept.into_iter().map(|line| (line.place(), line)).collect();
        Ok(Self { lines, taken })
    }

    /// What an earlier run found at this value, or these two, and the seconds that it took.
    pub fn found(&self, value: f64, second: Option<f64>) -> Option<(&F, f64)> {
        self.taken.get(&place(value, second)).map(|line| (&line.found, line.solve_s))
    }

    /// Appends what was found at a value, or a pair of them, in so many seconds: at once and from any thread.
    ///
    /// Fails with [`ReportError::Write`].
    pub fn keep_found(&self, (value, second): (f64, Option<f64>), found: &F, solve_s: f64) -> Result<(), ReportError> {
        self.lines.keep(&Line { value, second, found: found.clone(), solve_s })
    }
}

#[cfg(test)]
impl PartialSweep {
    fn keep(&self, row: &SweepRow) -> Result<(), ReportError> {
        self.keep_found((row.value, row.second), &row.found, row.solve_s)
    }
}

pub(super) fn place(value: f64, second: Option<f64>) -> (u64, Option<u64>) {
    (value.to_bits(), second.map(f64::to_bits))
}

#[cfg(test)]
mod tests {
    use super::super::lines::first_line;
    use super::*;
    use peelkit::solve::{Pace, PathError, Place, SolveError};
    use peelkit::study::{Effort, Failure, LimitPoint, LimitPointKind, PathEnd, PathFailure, Peak, Plateau};
    use peelkit_scene::find_key;
    use std::fs;

    fn scene() -> Scene {
        let text = r#"
            strip = { length = "100 nm", height = "10 nm", youngs_modulus = "2 GPa" }
            adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }
        "#;
        Scene::parse("a.toml", text, &[]).unwrap()
    }

    fn failure() -> Failure {
        let place = Place { element: 3, position: 0.1 + 0.2 };
        let cause = SolveError::Singular { pivot: 1.0 / 3.0, place };
        let path = PathError { point: 4, displacement_nm: -0.0, force: 2e-9, tries: 14, cause };
        Failure::Path { cause: PathFailure::Path(path), elements: 8, order: 7, asked: 1e-6, given_up: false }
    }

    /// Numbers whose last digit a careless reader loses.
    fn row(value: f64) -> SweepRow {
        let peak = Peak {
            displacement: 0.1 + 0.2,
            force: 1.0 / 3.0,
            end_rotation: -5e-324,
            force_error: 1.797_693_134_862_315_7e308,
            displacement_error: 2.225_073_858_507_201e-308,
        };
        let snap_off = LimitPoint {
            kind: LimitPointKind::Displacement,
            displacement: 48.215_617_822_8,
            force: 9.007_199_254_740_993e15,
            end_rotation: 0.9,
            work: std::f64::consts::PI,
            displacement_error: 7.038_531_3e-26,
            force_error: 4e-9,
            work_error: Some(2e-17),
            flat: true,
            after: 17,
            in_space: None,
        };
        let found = PeelResult {
            initiation_peak: None,
            peak: Some(peak),
            largest_computed_force: None,
            plateau: Some(Plateau {
                stable: true,
                after: 3,
                displacement: 1e23,
                force: 8.41e21,
                force_error: None,
                displacement_error: Some(1e21),
            }),
            plateau_front: Some(-0.0),
            snap_off: Some(snap_off),
            pad_detachment: Some(snap_off),
            detachment: None,
            work: Some(5e-5),
            reached: Some(1.0 / 3.0),
            asked: 1e-6,
            end: PathEnd::Failed(failure()),
            effort: Effort { points: 3, newton_iterations: 5, elements: 8, order: 7, pace: Pace::Wary },
        };
        SweepRow { value, second: None, model: scene().model, found, solve_s: 0.001 }
    }

    fn open(dir: &Path, scene: &Scene) -> PartialSweep {
        PartialSweep::open(dir, scene, find_key("strip.length").unwrap(), None).unwrap()
    }

    #[test]
    fn rows_come_back_bit_for_bit() {
        let dir = tempfile::tempdir().unwrap();
        for value in [0.1, 0.1 + 0.2] {
            open(dir.path(), &scene()).keep(&row(value)).unwrap();
        }
        let partial = open(dir.path(), &scene());
        for value in [0.1, 0.1 + 0.2] {
            let ((found, solve_s), expected) = (partial.found(value, None).unwrap(), row(value));
            assert_eq!((found, solve_s), (&expected.found, expected.solve_s));
            assert!(found.plateau_front.unwrap().is_sign_negative());
        }
        assert_eq!(partial.found(0.3, None), None);
    }

    #[test]
    fn of_two_keys_both_values_count() {
        let dir = tempfile::tempdir().unwrap();
        let keys =
            SweptKeys { first: find_key("strip.length").unwrap(), second: Some(find_key("strip.height").unwrap()) };
        let open = || PartialSweep::open(dir.path(), &scene(), keys, None).unwrap();
        open().keep(&SweepRow { second: Some(2.0), ..row(1.0) }).unwrap();
        let partial = open();
        assert!(partial.found(1.0, Some(2.0)).is_some());
        assert!(partial.found(1.0, None).is_none() && partial.found(1.0, Some(3.0)).is_none());
        let one = <PartialSweep>::open(dir.path(), &scene(), keys.first, None);
        assert!(matches!(one, Err(ReportError::OtherSweep { .. })));
    }

    #[test]
    fn every_double_comes_back() {
        let mut bits = 1u64;
        for _ in 0..20_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let number = f64::from_bits(bits);
            if number.is_finite() {
                let back: f64 = serde_json::from_slice(&first_line(&number).unwrap()).unwrap();
                assert_eq!(back.to_bits(), bits, "{number:e}");
            }
        }
    }

    #[test]
    fn a_torn_line_is_no_row_and_spoils_none() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join(<PartialSweep>::NAME);
        for value in [1.0, 2.0] {
            open(dir.path(), &scene()).keep(&row(value)).unwrap();
        }
        let whole = fs::read(&path).unwrap();
        fs::write(&path, &whole[..whole.len() - 40]).unwrap();
        let partial = open(dir.path(), &scene());
        assert!(partial.found(1.0, None).is_some() && partial.found(2.0, None).is_none());
        partial.keep(&row(3.0)).unwrap();
        let partial = open(dir.path(), &scene());
        assert!(partial.found(1.0, None).is_some() && partial.found(3.0, None).is_some());
    }

    #[test]
    fn the_file_of_another_scene_key_or_version_is_refused_until_it_is_discarded() {
        let other_scene = {
            let mut scene = scene();
            scene.accuracy.relative = 1e-7;
            scene
        };
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join(<PartialSweep>::NAME);
        let refused = |scene: &Scene, key: &str| {
            let before = fs::read(&path).unwrap();
            let error = <PartialSweep>::open(dir.path(), scene, find_key(key).unwrap(), None).unwrap_err();
            assert!(
                matches!(error, ReportError::OtherSweep { .. }) && error.to_string().contains(<PartialSweep>::NAME)
            );
            assert_eq!(fs::read(&path).unwrap(), before);
        };
        open(dir.path(), &scene()).keep(&row(1.0)).unwrap();
        refused(&other_scene, "strip.length");
        refused(&scene(), "strip.height");
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, text.replace(env!("CARGO_PKG_VERSION"), "0.0.9")).unwrap();
        refused(&scene(), "strip.length");
        assert!(<PartialSweep>::is_in(dir.path()));
        <PartialSweep>::discard(dir.path()).unwrap();
        assert!(!<PartialSweep>::is_in(dir.path()));
        assert!(open(dir.path(), &scene()).found(1.0, None).is_none());
        <PartialSweep>::discard(&dir.path().join("none")).unwrap();
    }

    #[test]
    fn a_row_without_a_number_is_computed_again() {
        let dir = tempfile::tempdir().unwrap();
        let mut row = row(1.0);
        row.found.work = Some(f64::NAN);
        open(dir.path(), &scene()).keep(&row).unwrap();
        assert!(open(dir.path(), &scene()).found(1.0, None).is_none());
    }
}
