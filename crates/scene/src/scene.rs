//! A scene as data.

use super::tables::bounds::BoundsTable;
use super::tables::fit::FitTable;
use super::tables::optimisation::OptimisationTable;
use super::tables::rate::TimeTable;
use super::tables::seta::SetaTable;
use super::tables::uncertainty::UncertaintyTable;
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Strip};
use peelkit::study::Accuracy;
use std::path::Path;

/// A whole scene, every value checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Where it was read from.
    pub name: String,
    /// What it is called; the stem of `name` where the text gives no title.
    pub title: String,
    /// The body, its adhesion, its grip and how that is moved; of a scene with a seta the body at each tip with its adhesion
    /// ([`Scene::tip_model`]), and how the root is moved.
    pub model: PeelModel,
    /// The seta, where the scene has one.
    pub seta: Option<SetaTable>,
    /// The rate of the pull, where the scene has one.
    pub time: Option<TimeTable>,
    /// What the user asks of the numbers.
    pub accuracy: Accuracy,
    /// Where the path may be stopped although it goes on.
    pub bounds: BoundsTable,
    /// What `peel fit` determines, where the scene says so.
    pub fit: Option<FitTable>,
    /// What is optimised, where the scene says so; `peel optimise` does it.
    pub optimisation: Option<OptimisationTable>,
    /// What is uncertain, where the scene says so; `peel uncertainty` samples it.
    pub uncertainty: Option<UncertaintyTable>,
    /// The tables that the text gives, as they were read.
    pub table_texts: TableTexts,
}

/// The texts of a scene's tables, in CSV: what the model holds of them are numbers alone, and a summary reports them as they were
/// written. Each is empty where the scene has no such table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TableTexts {
    /// Of `profile.table`.
    pub profile: String,
    /// Of `substrate.table`.
    pub substrate: String,
}

impl Scene {
    /// The same with every table that a scene may hold.
    pub(crate) fn of_defaults() -> Self {
        Self {
            seta: Some(SetaTable::default()),
            time: Some(TimeTable::default()),
            fit: Some(FitTable::default()),
            optimisation: Some(OptimisationTable::default()),
            uncertainty: Some(UncertaintyTable::default()),
            ..Self::empty("")
        }
    }

    /// A scene that holds the defaults; what has none is NaN until the text gives it.
    pub(crate) fn empty(name: &str) -> Self {
        let title = Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let adhesion = Adhesion::of_half_space(f64::NAN, f64::NAN);
        Self {
            name: name.to_owned(),
            title,
            model: PeelModel::of(Body::Strip(UNKNOWN_STRIP), adhesion, Grip::FREE),
            accuracy: Accuracy::to(1e-6),
            bounds: BoundsTable { points: 20_000, time_s: Some(60.0), ..BoundsTable::default() },
            seta: None,
            time: None,
            fit: None,
            optimisation: None,
            uncertainty: None,
            table_texts: TableTexts::default(),
        }
    }
}

/// The defaults of a strip; what has none is NaN until a text gives it.
pub(crate) const UNKNOWN_STRIP: Strip = Strip {
    length: f64::NAN,
    height: f64::NAN,
    width: 1.0,
    youngs_modulus: f64::NAN,
    poissons_ratio: 0.2,
    shear_correction: 5.0 / 6.0,
    bending_stiffness_factor: 1.0,
    crack: None,
};
