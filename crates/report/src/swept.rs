//! The rows of sweeps, and the keys that they vary.
use peelkit::model::PeelModel;
use peelkit::study::{Peel, PeelResult};
use peelkit_scene::Key;
use std::time::Instant;

/// The key that a sweep varies, or the two keys of a plane.
#[derive(Clone, Copy, Debug)]
pub struct SweptKeys<'k> {
    /// Of `value`
    pub first: &'k Key,
    /// Of `value_2`
    pub second: Option<&'k Key>,
}

impl<'k> From<&'k Key> for SweptKeys<'k> {
    fn from(first: &'k Key) -> Self {
        Self { first, second: None }
    }
}

impl SweptKeys<'_> {
    /// The names of their columns, with the units in which a user gives them: `strip.length_nm`, `drive.angle_deg`.
    pub fn columns(&self) -> Vec<String> {
        self.keys().map(|key| column(key, key.usual_unit())).collect()
    }

    /// One key or two.
    pub fn keys(&self) -> impl Iterator<Item = &Key> {
        [Some(self.first), self.second].into_iter().flatten()
    }

    /// As messages and checkpoints call them: `strip.length and strip.height`.
    pub fn names(&self) -> String {
        match self.second {
            None => self.first.path(),
            Some(second) => format!("{} and {}", self.first.path(), second.path()),
        }
    }
}

/// A number in the unit in which a user gives the key: an angle in degrees, with what the change of the unit rounds rounded back.
pub fn as_given(key: &Key, number: f64) -> f64 {
    match key.per_usual_unit() {
        1.0 => number,
        scale => format!("{:.13e}", scale * number).parse().unwrap_or(scale * number),
    }
}

/// The key with the unit of its number in its name.
pub(crate) fn column(key: &Key, unit: &str) -> String {
    let unit = unit.replace('/', "_per_");
    if unit.is_empty() { key.path() } else { format!("{}_{unit}", key.path()) }
}

// -- One value of a sweep of whole peels --

/// One value of a sweep and what its peel found.
#[derive(Clone, Debug)]
pub struct SweepRow {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    /// The value of the second one, where two are varied.
    pub second: Option<f64>,
    /// What was peeled.
    pub model: PeelModel,
    /// Peak, plateau, snap-off and end: forces in nN, displacements in nm, work in aJ.
    pub found: PeelResult,
    /// Wall clock that the peel took, s.
    pub solve_s: f64,
}

impl SweepRow {
    /// What `peel` finds of a model, of a sweep over one parameter.
    pub fn of(value: f64, model: PeelModel, peel: impl FnOnce(&PeelModel) -> Peel) -> Self {
        let (found, solve_s) = timed(|| PeelResult::from(&peel(&model)));
        Self { value, second: None, model, found, solve_s }
    }
}

// -- One value of a sweep of pulls --

/// One value of a sweep and what was found of its pull.
#[derive(Clone, Debug)]
pub struct PullRow<F> {
    /// The value of the varied parameter, in its own unit.
    pub value: f64,
    /// The value of the second one, where two are varied.
    pub second: Option<f64>,
    /// What was found, or why there is no pull.
    pub found: Result<F, String>,
    /// Wall clock that it took, s.
    pub solve_s: f64,
}

impl<F> PullRow<F> {
    /// A number of what was found, where it was.
    pub(crate) fn of<T>(&self, of: impl FnOnce(&F) -> Option<T>) -> Option<T> {
        self.found.as_ref().ok().and_then(of)
    }
}

// -- How long a computation takes --

/// What a computation gives, and the seconds of wall clock that it took.
pub fn timed<T>(computation: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let found = computation();
    (found, started.elapsed().as_secs_f64())
}
