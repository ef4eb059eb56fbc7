//! A scene as data.

pub(crate) mod array;
pub(crate) mod bounds;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod solid;
pub(crate) mod studies;

use crate::error::ValueError;
use crate::value::table::beside;
use array::ArrayTable;
use bounds::BoundsTable;
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, Hold, ModelError, PeelModel, Space, Strip, StripModel};
use peelkit::study::{self, Accuracy, EventAt, PeelQuantity, SetaTimeAccuracy, StationAt};
use peelkit::units::PreferredUnits;
use rate::TimeTable;
use seta::{SetaTable, SetaTipLaw};
use solid::SolidTable;
use std::path::{Path, PathBuf};
use studies::{FitTable, OptimisationTable, UncertaintyTable};

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
    /// How the body is computed as a solid, where the scene says so.
    pub solid: Option<SolidTable>,
    /// The setae and what they stand on, where the scene has an array of them.
    pub array: Option<ArrayTable>,
    /// The rate of the pull, where the scene has one.
    pub time: Option<TimeTable>,
    /// What the user asks of the numbers.
    pub accuracy: Accuracy,
    /// Where the path may be stopped although it goes on.
    pub bounds: BoundsTable,
    /// Where the path is computed besides.
    pub stations: Vec<StationAt>,
    /// What is looked for on the way.
    pub events: Vec<EventAt>,
    /// The units of what is printed and drawn, and of tables besides.
    pub units: PreferredUnits,
    /// What `peel fit` determines, where the scene says so.
    pub fit: Option<FitTable>,
    /// What is optimised, where the scene says so; `peel optimise` does it.
    pub optimisation: Option<OptimisationTable>,
    /// What is uncertain, where the scene says so; `peel uncertainty` samples it.
    pub uncertainty: Option<UncertaintyTable>,
    /// The tables that the text gives, as they were read.
    pub table_texts: TableTexts,
}

/// The key of what forces of a strip are over.
const WIDTH: &str = "strip.width";

/// The texts of a scene's tables, in CSV or SWC: what the model holds of them are numbers alone, and a summary reports them as they were
/// written. Each is empty where the scene has no such table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TableTexts {
    /// Of `profile.table`.
    pub profile: String,
    /// Of `substrate.table`.
    pub substrate: String,
    /// Of `adhesion.table`.
    pub law: String,
    /// Of `seta.tree`.
    pub tree: String,
}

impl TableTexts {
    /// Whether the scene has no table.
    pub fn is_empty(&self) -> bool {
        [&self.profile, &self.substrate, &self.law, &self.tree].into_iter().all(String::is_empty)
    }
}

/// What a scene describes, with the tables that say so.
#[derive(Clone, Copy, Debug)]
pub enum Described<'s> {
    /// The peel of a beam, by its equilibria
    Peel,
    /// The peel of a body that is computed as a solid, by its equilibria
    Solid(&'s SolidTable),
    /// The pull-off of a seta, by its equilibria
    Seta(&'s SetaTable),
    /// The pull of an array of setae, event by event
    Array(&'s ArrayTable),
    /// A beam pulled at a rate, or a seta
    Rate(&'s TimeTable, Option<&'s SetaTable>),
}

impl Described<'_> {
    /// The numbers that its run has.
    pub(crate) fn quantities(self) -> &'static [PeelQuantity] {
        match self {
            Self::Peel => &PeelQuantity::OF_A_PEEL,
            Self::Solid(_) => &PeelQuantity::OF_A_SOLID,
            Self::Array(_) => &PeelQuantity::OF_AN_ARRAY,
            Self::Seta(_) => &PeelQuantity::OF_A_SETA,
            Self::Rate(..) => &PeelQuantity::AT_A_RATE,
        }
    }

    /// In words.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::Peel => "a peel",
            Self::Solid(_) => "the peel of a solid",
            Self::Array(_) => "the pull of an array of setae",
            Self::Seta(_) => "the pull-off of a seta",
            Self::Rate(..) => "a pull at a rate",
        }
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Peel => "peel",
            Self::Solid(_) => "solid",
            Self::Array(_) => "array",
            Self::Seta(_) => "seta",
            Self::Rate(..) => "rate",
        }
    }
}

impl Scene {
    /// The same with every table that a scene may hold.
    pub(crate) fn of_defaults() -> Self {
        Self {
            seta: Some(SetaTable::default()),
            array: Some(ArrayTable::of_all()),
            solid: Some(SolidTable::default()),
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
            array: None,
            solid: None,
            time: None,
            stations: Vec::new(),
            events: Vec::new(),
            units: PreferredUnits::default(),
            fit: None,
            optimisation: None,
            uncertainty: None,
            table_texts: TableTexts::default(),
        }
    }
}

impl Scene {
    /// The file or folder that it names, which is beside it.
    pub fn beside(&self, named: &str) -> PathBuf {
        beside(&self.name, named)
    }

    /// Stations and events, as a run looks for them on its way.
    pub fn looked_for(&self) -> Vec<EventAt> {
        self.stations.iter().map(|&at| at.into()).chain(self.events.iter().cloned()).collect()
    }

    /// What it describes.
    pub fn describes(&self) -> Described<'_> {
        if let Some(array) = &self.array {
            return Described::Array(array);
        }
        match (&self.time, &self.seta, &self.solid) {
            (Some(time), seta, _) => Described::Rate(time, seta.as_ref()),
            (None, Some(seta), _) => Described::Seta(seta),
            (None, None, Some(solid)) => Described::Solid(solid),
            (None, None, None) => Described::Peel,
        }
    }

    /// The units of what is printed and drawn: forces of a strip are over its width, where a unit of that is given and none of forces.
    pub fn written_units(&self) -> PreferredUnits {
        self.model.strip().map_or(self.units, |strip| self.units.across(strip.width))
    }

    /// What is wrong with the units, if these keys are varied besides those that fits, searches and samples vary.
    pub fn units_problem(&self, varied: impl IntoIterator<Item = String>) -> Option<ValueError> {
        let unit = self.units.force_per_width?.name;
        let has_strip = matches!(self.describes(), Described::Peel | Described::Solid(_) | Described::Rate(_, None));
        if !has_strip || self.model.strip().is_none() {
            return Some(ValueError::new(
                format!("has {unit}, a force over the width of a strip, and the scene has no strip"),
                "Give a unit of forces, such as mN.",
            ));
        }
        let fitted = self.fit.iter().flat_map(|fit| fit.parameters.iter().map(|of| &of.path));
        let set = self.fit.iter().flat_map(|fit| &fit.curves).flat_map(|curve| curve.set.iter().map(|(path, _)| path));
        let free = self.optimisation.iter().flat_map(|search| search.parameters.iter().map(|of| &of.path));
        let sampled = self.uncertainty.iter().flat_map(|sample| sample.inputs.iter().map(|of| &of.path));
        let is_varied = varied.into_iter().any(|path| path == WIDTH)
            || fitted.chain(set).chain(free).chain(sampled).any(|path| path == WIDTH);
        (is_varied && self.units.force.is_none()).then(|| {
            ValueError::new(
                format!("has {unit}, a force over the width of a strip, and `{WIDTH}` is varied"),
                format!("Give a unit of forces beside it, such as N,{unit}."),
            )
        })
    }

    /// The body at a tip of a seta with its adhesion, its end held against rotation, on flat ground without friction: what the law of the
    /// tips is computed of. Spatulae that are beams are held along the ground in space alone: this one slides.
    pub fn tip_model(&self) -> PeelModel {
        let grip = Grip { rotation: Hold::Fixed, ..Grip::FREE };
        let adhesion = if self.has_tips_of_beams() { self.model.adhesion.sliding() } else { self.model.adhesion };
        PeelModel::of(self.model.body.clone(), adhesion, grip)
    }

    /// The same in space, with what holds it along the ground.
    pub fn tip_in_space(&self) -> PeelModel {
        PeelModel { adhesion: self.model.adhesion, space: Some(Space::default()), ..self.tip_model() }
    }

    fn has_tips_of_beams(&self) -> bool {
        self.seta.as_ref().is_some_and(|seta| seta.tip_law == SetaTipLaw::Beam)
    }

    /// Whether values fit one another that are right by themselves: else the key that does not, and why.
    pub fn check(&self) -> Result<(), ModelError> {
        match self.seta {
            // an array has no beam of its own
            None if self.array.is_some() => Ok(()),
            None => study::checked(&self.model, &self.accuracy),
            Some(_) if self.has_tips_of_beams() => study::checked(&self.tip_in_space(), &self.accuracy),
            Some(_) => study::checked(&self.tip_model(), &self.accuracy),
        }
    }
}

/// The tables of a scene, which it is given where it has none.
impl Scene {
    pub(crate) fn seta_table(&mut self) -> &mut SetaTable {
        self.seta.get_or_insert_default()
    }

    /// An array has neither a body nor adhesion of a beam: those of the paper stand there, which no key of it reads or writes.
    pub(crate) fn array_table(&mut self) -> &mut ArrayTable {
        if self.array.is_none() {
            let StripModel { strip, adhesion, .. } = StripModel::of_the_paper(100.0, 1.0);
            (self.model.body, self.model.adhesion) = (Body::Strip(strip), adhesion);
        }
        self.array.get_or_insert_default()
    }

    pub(crate) fn solid_table(&mut self) -> &mut SolidTable {
        self.solid.get_or_insert_default()
    }

    /// The steps of a seta have a tolerance of their own.
    pub(crate) fn time_table(&mut self) -> &mut TimeTable {
        let usual = TimeTable::default();
        let tolerance = if self.seta.is_some() { SetaTimeAccuracy::default().tolerance } else { usual.tolerance };
        self.time.get_or_insert(TimeTable { tolerance, ..usual })
    }

    pub(crate) fn fit_table(&mut self) -> &mut FitTable {
        self.fit.get_or_insert_default()
    }

    pub(crate) fn optimisation_table(&mut self) -> &mut OptimisationTable {
        self.optimisation.get_or_insert_default()
    }

    /// The first number that a run of the scene has is what is asked for where the scene does not say it.
    pub(crate) fn uncertainty_table(&mut self) -> &mut UncertaintyTable {
        let first = self.describes().quantities()[0];
        self.uncertainty
            .get_or_insert_with(|| UncertaintyTable { quantities: vec![first], ..UncertaintyTable::default() })
    }
}

/// The defaults of a strip; what has none is NaN until a text gives it.
pub(crate) const UNKNOWN_STRIP: Strip = Strip {
    length: f64::NAN,
    height: f64::NAN,
    width: 1.0,
    material: Material::of(f64::NAN, 0.2),
    crack: None,
    layers: None,
};
