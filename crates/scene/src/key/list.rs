//! A key of a list by its path.

use super::kind::Key;
use crate::error::{ValueError, nearest};

/// The names of the tables of a list of keys.
pub(crate) fn tables_of(keys: &[Key]) -> Vec<&'static str> {
    let mut tables: Vec<_> = keys.iter().map(|key| key.table).filter(|table| !table.is_empty()).collect();
    tables.dedup();
    tables
}

/// The key with this path, such as `strip.length`; or what would be right.
pub(crate) fn find<'k>(keys: &'k [Key], path: &str) -> Result<&'k Key, ValueError> {
    let path = path.trim();
    if let Some(key) = keys.iter().find(|key| key.path() == path) {
        return Ok(key);
    }
    let paths: Vec<String> = keys.iter().map(Key::path).collect();
    let name = path.rsplit('.').next().unwrap_or(path);
    let same_name = keys.iter().find(|key| key.name == name).map(Key::path);
    let remedy = match same_name.as_deref().or_else(|| nearest(path, paths.iter().map(String::as_str))) {
        Some(near) => format!("Did you mean `{near}`?"),
        None => what_there_is(keys, path.split_once('.').map_or("", |(table, _)| table)),
    };
    Err(ValueError::new("is not a key of a scene", remedy))
}

/// The keys of this table; the tables where there is none of this name.
fn what_there_is(keys: &[Key], table: &str) -> String {
    let names: Vec<&str> = keys.iter().filter(|key| key.table == table).map(|key| key.name).collect();
    if table.is_empty() || names.is_empty() {
        format!(
            "A key is written table.key, such as strip.height; `peel keys` lists them. The tables are {}.",
            tables_of(keys).join(", ")
        )
    } else {
        format!("The keys of [{table}] are {}.", names.join(", "))
    }
}
