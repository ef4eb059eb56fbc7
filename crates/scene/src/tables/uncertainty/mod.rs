//! The table `uncertainty`: which keys of the scene are uncertain, how, and what is asked for.

pub(crate) mod check;
mod correlations;
mod inputs;
mod plan;
pub(crate) mod settings;

use crate::scene::Scene;
use peelkit::study::PeelQuantity;
use peelkit::study::uncertainty::{Distribution, Indices};

/// Its name.
pub(crate) const TABLE: &str = "uncertainty";

/// The table `uncertainty`.
#[derive(Clone, Debug, PartialEq)]
pub struct UncertaintyTable {
    /// What is uncertain
    pub inputs: Vec<UncertainKey>,
    /// Which of them vary together
    pub correlations: Vec<CorrelatedKeys>,
    /// What is asked for
    pub quantities: Vec<PeelQuantity>,
    /// Most peels that are sampled
    pub samples: usize,
    /// Of the sample
    pub seed: u64,
    /// Whether sensitivity indices are estimated
    pub indices: Indices,
}

/// A key that is uncertain.
#[derive(Clone, Debug, PartialEq)]
pub struct UncertainKey {
    /// `strip.height`
    pub path: String,
    /// In the unit of the library. Its mean, median or mode is 0 where `is_centered`.
    pub distribution: Distribution,
    /// Whether the value of the scene takes the place of its mean, median or mode
    pub is_centered: bool,
}

/// Two keys that vary together.
#[derive(Clone, Debug, PartialEq)]
pub struct CorrelatedKeys {
    /// Their paths
    pub keys: [String; 2],
    /// As of [`peelkit::study::uncertainty::Correlation`]
    pub coefficient: f64,
}

impl Default for UncertaintyTable {
    fn default() -> Self {
        Self {
            inputs: Vec::new(),
            correlations: Vec::new(),
            quantities: vec![PeelQuantity::InitiationPeakForce],
            samples: 10_000,
            seed: 0,
            indices: Indices::Estimated,
        }
    }
}

/// The table of a scene, which it is given where it has none.
pub(crate) fn of(scene: &mut Scene) -> &mut UncertaintyTable {
    let first = scene.quantities().0[0];
    scene.uncertainty.get_or_insert_with(|| UncertaintyTable { quantities: vec![first], ..UncertaintyTable::default() })
}
