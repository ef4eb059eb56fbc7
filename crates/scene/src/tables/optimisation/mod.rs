//! The table `optimise`: what is free, what is to be large or small, and under which constraints.

pub(crate) mod check;
mod design;
mod read;
pub(crate) mod settings;

use crate::scene::Scene;
use peelkit::study::optimisation::{Goal, OptimisationOptions, SearchMethod};
use peelkit::study::{Accuracy, PeelQuantity};

/// Its name.
pub(crate) const TABLE: &str = "optimise";

/// The table `optimise`.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimisationTable {
    /// The number of the peel that is optimised; `None` until the text gives it
    pub objective: Option<PeelQuantity>,
    /// In which direction
    pub goal: Goal,
    /// Angles of the pull, rad, of the two peels whose ratio is optimised, the one above the line first
    pub holding_angle: Option<f64>,
    /// The one below the line
    pub release_angle: Option<f64>,
    /// Keys that are free
    pub parameters: Vec<FreeKey>,
    /// Bounds of the width along the body
    pub width: Option<FreeProfile>,
    /// Bounds of the height along the body
    pub height: Option<FreeProfile>,
    /// How many values a profile has
    pub values: usize,
    /// What holds of the volume; none: equal with a profile, free without
    pub volume: Option<VolumeRule>,
    /// How designs are chosen; none: by whether there are constraints
    pub method: Option<SearchMethod>,
    /// Searches from different starts
    pub starts: usize,
    /// Most designs of one search
    pub evaluations: usize,
    /// Random designs that the optimum is compared with
    pub neighbours: usize,
    /// Of what is random
    pub seed: u64,
    /// Whether a search without gradients goes on from the optimum
    pub check: bool,
}

impl OptimisationTable {
    /// What the table says of the search, with the peels of its ends to this accuracy; when to stop and what to keep is left to the caller.
    pub fn options(&self, accuracy: Accuracy) -> OptimisationOptions<'static> {
        OptimisationOptions {
            method: self.method,
            starts: self.starts,
            evaluations: self.evaluations,
            neighbours: self.neighbours,
            seed: self.seed,
            check: self.check,
            ..OptimisationOptions::to(accuracy)
        }
    }
}

/// A key that is free between two values, in the unit of the library.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeKey {
    /// `strip.youngs_modulus`
    pub path: String,
    /// Lower bound
    pub from: f64,
    /// Upper bound
    pub to: f64,
}

/// A profile that is free between two values, nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeProfile {
    /// Least value
    pub from: f64,
    /// Largest value
    pub to: f64,
    /// Most change from value to value over their distance; none: any
    pub slope: Option<f64>,
}

/// What holds of the volume of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VolumeRule {
    /// It is that of the scene
    Equal,
    /// It is at most that of the scene
    AtMost,
    /// It may be any
    Free,
}

impl Default for OptimisationTable {
    fn default() -> Self {
        Self {
            objective: None,
            goal: Goal::Maximise,
            holding_angle: None,
            release_angle: None,
            parameters: Vec::new(),
            width: None,
            height: None,
            values: 20,
            volume: None,
            method: None,
            starts: 2,
            evaluations: 200,
            neighbours: 100,
            seed: 0,
            check: false,
        }
    }
}

impl OptimisationTable {
    /// The rule that holds of the volume.
    pub fn volume_rule(&self) -> VolumeRule {
        let has_profile = self.width.is_some() || self.height.is_some();
        self.volume.unwrap_or(if has_profile { VolumeRule::Equal } else { VolumeRule::Free })
    }
}

/// The table of a scene, which it is given where it has none.
pub(crate) fn of(scene: &mut Scene) -> &mut OptimisationTable {
    scene.optimisation.get_or_insert_default()
}
