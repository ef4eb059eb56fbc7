//! The scene as it was computed, as an object of summary.json.

use crate::number::Finite;
use peelkit_scene::{KEYS, Key, Kind, Scene, Value};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// The scene as it was computed, defaults and overrides in, a table of it an object; units in the names.
#[derive(Debug)]
pub(crate) struct Parameters(pub Scene);

impl Serialize for Parameters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tables = serializer.serialize_map(None)?;
        // the title has a place of its own
        for key in KEYS
            .iter()
            .filter(|key| key.table.is_empty() && !matches!(key.kind, Kind::Text(_)) && key.belongs_to(&self.0))
        {
            if let Some(value) = key.value(&self.0) {
                tables.serialize_entry(key.name, &Given(&value))?;
            }
        }
        let stands = |key: &Key| !key.table.is_empty() && key.belongs_to(&self.0);
        for keys in KEYS.chunk_by(|a, b| a.table == b.table).filter(|keys| keys.iter().any(stands)) {
            tables.serialize_entry(keys[0].table, &Table { scene: &self.0, keys })?;
        }
        tables.end()
    }
}

struct Table<'a> {
    scene: &'a Scene,
    keys: &'a [Key],
}

impl Serialize for Table<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut table = serializer.serialize_map(None)?;
        for key in self.keys.iter().filter(|key| key.belongs_to(self.scene)) {
            let unit = key.unit().replace('/', "_per_");
            let name = if unit.is_empty() { key.name.to_owned() } else { format!("{}_{unit}", key.name) };
            match key.value(self.scene) {
                Some(Value::Number(count)) if key.is_written_whole(count) => {
                    table.serialize_entry(&name, &(count as u64))?
                }
                value => table.serialize_entry(&name, &value.as_ref().map(Given))?,
            }
        }
        table.end()
    }
}

/// A value as a scene holds it.
struct Given<'a>(&'a Value);

impl Serialize for Given<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Number(number) => Finite(*number).serialize(serializer),
            Value::Text(text) => serializer.serialize_str(text),
            Value::Flag(flag) => serializer.serialize_bool(*flag),
            Value::List(items) => serializer.collect_seq(items.iter().map(Given)),
            Value::Table(entries) => serializer.collect_map(entries.iter().map(|(name, value)| (name, Given(value)))),
            Value::Other(_) => serializer.serialize_none(),
        }
    }
}
