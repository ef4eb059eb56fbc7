//! A value of a scene, whichever key it is of, and the texts, lists and tables that one may be.

pub(crate) mod form;
pub(crate) mod quantity;
pub(crate) mod seta_law;
pub(crate) mod steps;
pub(crate) mod swc;
pub(crate) mod table;
pub(crate) mod traction;
mod unit;

use crate::error::one_line;
use peelkit::model::Measured;
use std::fmt;

/// A value as it stands in a TOML text, or as a scene holds it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A TOML string.
    Text(String),
    /// A TOML integer or float; of a scene in the unit of the library.
    Number(f64),
    /// true or false
    Flag(bool),
    /// A TOML list
    List(Vec<Value>),
    /// A TOML table: names with their values
    Table(Vec<(String, Value)>),
    /// Something that no key takes: "a date".
    Other(&'static str),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(&quoted(text)),
            Self::Number(number) => f.write_str(&show(*number)),
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::List(_) => write!(f, "a list"),
            Self::Table(_) => write!(f, "a table"),
            Self::Other(what) => write!(f, "{what}"),
        }
    }
}

/// What is wrong with a value that is a list or a table.
#[derive(Debug)]
pub struct Fault {
    /// Which item of a list it is in, counted from 0, where it is in one
    pub(crate) item: Option<usize>,
    /// Completes "`profile.pieces` ..."
    pub(crate) found: String,
}

impl Fault {
    /// Of one item of a list.
    pub(crate) fn at(item: usize, found: String) -> Self {
        Self { item: Some(item), found }
    }

    /// Of the whole value.
    pub(crate) fn whole(found: String) -> Self {
        Self { item: None, found }
    }
}

/// A text in quotes, as it stands in a message.
pub(crate) fn quoted(text: &str) -> String {
    format!("\"{}\"", one_line(text))
}

/// A number as a person writes it.
pub(crate) fn show(number: f64) -> String {
    Measured { value: number, unit: "" }.to_string()
}
