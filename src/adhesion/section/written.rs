//! The adhesion model as it is written and read: by its name in a scene, or by the rows of its table.

use super::cohesive::CohesiveShape;
use super::cohesive::tabulated::{Measured, TractionTable};
use super::law::Attraction;
use serde::de::{Deserialize, Deserializer, Error as _};
use serde::ser::{Error as _, Serialize, Serializer};

/// In a format with types of its own, as JSON; others read no alternatives, and have the table as one text.
#[derive(serde::Deserialize)]
#[serde(untagged)]
enum Written {
    Name(String),
    Table(TractionTable),
}

impl Serialize for Attraction {
    /// A law of the user's own is refused: its name alone does not say what it is.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Own(own) => Err(S::Error::custom(format!(
                "the law of adhesion \"{}\" is the user's own, which cannot be written: only the laws of the library have names by \
                 which they are read again",
                own.law().name()
            ))),
            Self::BodyForce | Self::SurfaceTraction | Self::Cohesive(_) => match self.table() {
                Some(table) if serializer.is_human_readable() => table.serialize(serializer),
                Some(table) => serializer.serialize_str(&table.text()),
                None => serializer.serialize_str(self.name()),
            },
        }
    }
}

impl<'de> Deserialize<'de> for Attraction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written = match deserializer.is_human_readable() {
            true => Written::deserialize(deserializer)?,
            false => {
                let text = String::deserialize(deserializer)?;
                TractionTable::of_text(&text).map_or(Written::Name(text), Written::Table)
            }
        };
        let name = match written {
            Written::Name(name) => name,
            Written::Table(table) => return Ok(Self::Cohesive(CohesiveShape::Measured(Measured::through(&table)))),
        };
        Self::named(&name).ok_or_else(|| {
            let names: Vec<String> = Self::all().map(|law| format!("\"{}\"", law.name())).collect();
            D::Error::custom(format!("there is no law of adhesion {name:?}; it is {}", names.join(" or ")))
        })
    }
}
