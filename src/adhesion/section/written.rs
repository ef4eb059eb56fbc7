//! The adhesion model as it is written and read: by its name in a scene, or by the rows of its table.

use super::cohesive::CohesiveShape;
use super::cohesive::tabulated::{Measured, TractionTable};
use super::law::Attraction;
use serde::de::{Deserialize, Deserializer, Error as _};
use serde::ser::{Error as _, Serialize, Serializer};

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
                Some(table) => serializer.serialize_str(&table.text()),
                None => serializer.serialize_str(self.name()),
            },
        }
    }
}

impl<'de> Deserialize<'de> for Attraction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        // one text in every format: those without types of their own read no alternatives
        let name = String::deserialize(deserializer)?;
        if let Some(table) = TractionTable::of_text(&name) {
            return Ok(Self::Cohesive(CohesiveShape::Measured(Measured::through(&table))));
        }
        Self::named(&name).ok_or_else(|| {
            let names: Vec<String> = Self::all().map(|law| format!("\"{}\"", law.name())).collect();
            D::Error::custom(format!("there is no law of adhesion {name:?}; it is {}", names.join(" or ")))
        })
    }
}
