//! What a scene asks of a study as data: the tables `fit`, `optimise` and `uncertainty`.

use peelkit::study::optimisation::{Goal, Objective, OptimisationOptions, ProfileColumn, SearchMethod};
use peelkit::study::uncertainty::{Distribution, Indices};
use peelkit::study::{Accuracy, FitOptions, PeelQuantity};

/// The table `fit`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FitTable {
    /// What is fitted
    pub parameters: Vec<FittedKey>,
    /// Measured displacement of the first jump, nm; none: looked for
    pub jump: Option<f64>,
    /// Which columns of the data hold what
    pub columns: FitColumns,
    /// Curves that are fitted together; none where one is given beside the scene
    pub curves: Vec<CurveOfFit>,
    /// Measured displacement at which the model's is zero, nm: where the search begins, if it is fitted
    pub displacement_zero: f64,
    /// Measured force at which the model's is zero, nN: likewise
    pub force_zero: f64,
    /// How
    pub options: FitOptions,
}

/// A measured curve of a fit of several.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveOfFit {
    /// The name of its CSV, beside the scene
    pub data: String,
    /// Numbers of the scene that are others for it, in the unit of the library
    pub set: Vec<(String, f64)>,
    /// As of the whole table, nm; none: that
    pub displacement_zero: Option<f64>,
    /// Likewise, nN
    pub force_zero: Option<f64>,
    /// Measured displacement of its first jump, likewise, nm
    pub jump: Option<f64>,
}

/// The columns of measured data by their names, each perhaps with its unit behind it; none: by the dimension of the unit in the header.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FitColumns {
    /// Of the displacement
    pub displacement: Option<String>,
    /// Of the force
    pub force: Option<String>,
    /// Of the standard error of the force
    pub force_error: Option<String>,
}

/// A key that is fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedKey {
    /// `strip.youngs_modulus`
    pub path: String,
    /// Lower bound, in the unit of the library
    pub from: Option<f64>,
    /// Upper bound
    pub to: Option<f64>,
}

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

impl OptimisationTable {
    /// What is free of the outline, with its bounds.
    pub(crate) fn columns(&self) -> Vec<(ProfileColumn, FreeProfile)> {
        let columns = [(ProfileColumn::Width, self.width), (ProfileColumn::Height, self.height)];
        columns.into_iter().filter_map(|(column, free)| Some((column, free?))).collect()
    }

    /// The objective; none where the text has none.
    pub(crate) fn objective(&self) -> Option<Objective> {
        let of = self.objective?;
        Some(match (self.holding_angle, self.release_angle) {
            (Some(holding_angle), Some(release_angle)) => Objective::Ratio { of, holding_angle, release_angle },
            _ => Objective::Quantity(of),
        })
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
