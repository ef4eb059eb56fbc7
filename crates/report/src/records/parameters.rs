//! The scene as it was computed, as an object of summary.json.

use crate::record::{Cell, Content, Object};
use peelkit_scene::{KEYS, Key, Kind, Scene, Value};
use std::borrow::Cow;

/// The scene as it was computed, defaults and overrides in, a table of it an object; units in the names.
pub(crate) fn parameters(scene: &Scene) -> Object {
    // the title has a place of its own
    let alone = |key: &&Key| key.table.is_empty() && !matches!(key.kind, Kind::Text(_)) && key.belongs_to(scene);
    let given = |key: &'static Key| Some((Cow::from(key.name), given(&key.value(scene)?)));
    let mut object: Vec<_> = KEYS.iter().filter(alone).filter_map(given).collect();
    let stands = |key: &Key| !key.table.is_empty() && key.belongs_to(scene);
    let tables = KEYS.chunk_by(|a, b| a.table == b.table).filter(|keys| keys.iter().any(stands));
    object.extend(tables.map(|keys| (Cow::from(keys[0].table), Cell::Object(table(scene, keys)))));
    Object(object)
}

fn table(scene: &Scene, keys: &[Key]) -> Object {
    let entry = |key: &Key| {
        let unit = key.unit().replace('/', "_per_");
        let name = if unit.is_empty() { key.name.to_owned() } else { format!("{}_{unit}", key.name) };
        let cell = match key.value(scene) {
            Some(Value::Number(count)) if key.is_written_whole(count) => Cell::Count(count as u64),
            value => value.as_ref().map_or(Cell::Nothing, given),
        };
        (Cow::from(name), cell)
    };
    Object(keys.iter().filter(|key| key.belongs_to(scene)).map(entry).collect())
}

/// A value as a scene holds it.
fn given(value: &Value) -> Cell {
    match value {
        Value::Number(number) => Cell::Number(*number),
        Value::Text(text) => text.as_str().cell(),
        Value::Flag(flag) => Cell::Flag(*flag),
        Value::List(items) => Cell::List(items.iter().map(given).collect()),
        Value::Table(entries) => {
            Cell::Object(Object(entries.iter().map(|(name, value)| (Cow::from(name.clone()), given(value))).collect()))
        }
        Value::Other(_) => Cell::Nothing,
    }
}
