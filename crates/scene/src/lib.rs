//! The text a user writes, and every message about it.
//!
//! A scene is a TOML file; quantities are texts with their unit ("100 nm"). [`KEYS`] is the one list of what it may
//! hold.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod bodies;
mod bounds;
mod check;
mod conflict;
mod document;
mod error;
mod fit;
mod key;
mod keys;
mod near;
mod not_toml;
mod optimisation;
mod parameters;
mod rate;
mod scene;
mod seta;
mod shape;
mod space;
mod tips;
mod to_toml;
mod uncertainty;
mod value;
mod without_files;

pub use bodies::{BODIES, body_of};
pub use bounds::BoundsTable;
pub use error::{SceneError, ValueError};
pub use fit::{FitTable, FittedKey};
pub use key::{Key, Kind, Need, Setting};
pub use keys::{KEYS, find_key, tables};
pub use optimisation::{FreeKey, FreeProfile, OptimisationTable, VolumeRule};
pub use parameters::Parameters;
pub use peelkit::model::Range;
pub use rate::{Flow, TimeTable};
pub use scene::{Scene, TableTexts};
pub use seta::SetaTable;
pub use tips::SetaTipLaw;
pub use uncertainty::{CorrelatedKeys, UncertainKey, UncertaintyTable};
pub use value::Value;
pub use value::quantity::{Comma, Dimension, QuantityError, parse_quantity};
pub use value::table::{CsvError, parse_heights, parse_profile};
