//! The text a user writes, and every message about it.
//!
//! A scene is a TOML file; quantities are texts with their unit ("100 nm"). [`KEYS`] is the one list of what it may
//! hold.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod bodies;
mod check;
mod conflict;
mod document;
mod error;
mod form;
mod key;
mod keys;
mod near;
mod not_toml;
mod parameters;
mod scene;
mod schema;
mod shape;
mod space;
mod tables;
mod to_toml;
mod value;
mod without_files;

pub use bodies::{BODIES, body_of};
pub use error::{SceneError, ValueError};
pub use form::{Entry, Form};
pub use key::Key;
pub use key::kind::{Kind, Need, Setting};
pub use keys::{KEYS, find_key, tables};
pub use parameters::Parameters;
pub use peelkit::model::Range;
pub use scene::{Scene, TableTexts};
pub use schema::schema;
pub use tables::bounds::BoundsTable;
pub use tables::fit::{FitTable, FittedKey};
pub use tables::optimisation::{FreeKey, FreeProfile, OptimisationTable, VolumeRule};
pub use tables::rate::{Flow, TimeTable};
pub use tables::seta::SetaTable;
pub use tables::tips::SetaTipLaw;
pub use tables::uncertainty::{CorrelatedKeys, UncertainKey, UncertaintyTable};
pub use value::Value;
pub use value::quantity::{Comma, Dimension, QuantityError, parse_quantity};
pub use value::table::{CsvError, parse_heights, parse_profile};
