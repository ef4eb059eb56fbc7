//! The text a user writes, and every message about it.
//!
//! A scene is a TOML file; quantities are texts with their unit ("100 nm"). [`KEYS`] is the one list of what it may
//! hold.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod body;
mod conflict;
mod document;
mod error;
mod key;
mod keys;
mod scene;
mod schema;
mod studies;
mod tables;
mod value;

pub use body::{BODIES, body_of};
pub use error::{SceneError, ValueError};
pub use key::choice::Choice;
pub use key::kind::{Key, Kind, Need, Setting};
pub use key::table::Table;
pub use keys::{KEYS, find_key, tables};

pub use peelkit::model::Range;
pub use scene::array::{ArrayTable, BandLoad, FittedSeta, LamellaTable, PatchTable, SetaOfLaw, ToeTable};
pub use scene::bounds::BoundsTable;
pub use scene::rate::{Flow, TimeTable};
pub use scene::seta::{SetaTable, SetaTipLaw};
pub use scene::solid::SolidTable;
pub use scene::studies::{
    CorrelatedKeys, CurveOfFit, FitColumns, FitTable, FittedKey, FreeKey, FreeProfile, OptimisationTable, UncertainKey,
    UncertaintyTable, VolumeRule,
};
pub use scene::{Described, Scene, TableTexts};
pub use schema::schema;
pub use studies::fit::key_of_parameter;
pub use studies::parameters::Parameters;
pub use tables::measured::problem as refused_quantity;
pub use tables::output::{event, station, units};
pub use tables::setae::array::{array_warnings, seta_lines};
pub use value::Value;
pub use value::form::{Entry, Form};
pub use value::quantity::{Comma, Dimension, QuantityError, parse_quantity};
pub use value::seta_law::{CHECK, SETA_LAW, parse_seta_law};
pub use value::swc::{SwcError, parse_swc};
pub use value::table::{CsvError, parse_heights, parse_profile};
pub use value::traction::parse_tractions;
