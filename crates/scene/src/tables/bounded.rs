//! Keys within the value of another key: `{ key = "strip.height", from = "2 nm", to = "20 nm" }`, as [fit], [optimise] and [uncertainty]
//! write them, and numbers in the unit of the key that stands beside them.

use crate::error::one_line;
use crate::key::kind::Key;
use crate::key::list::find;
use crate::value::form::{Entry, Form};
use crate::value::{Fault, Value, quoted};

/// A key between two bounds.
pub(super) const BETWEEN: &[Entry] = &[
    Entry::needed("key", || Form::OfKey),
    Entry::needed("from", || Form::OfItsKey),
    Entry::needed("to", || Form::OfItsKey),
];
/// A key with bounds that may be left out.
pub(super) const BOUNDED: &[Entry] = &[
    Entry::needed("key", || Form::OfKey),
    Entry::optional("from", || Form::OfItsKey),
    Entry::optional("to", || Form::OfItsKey),
];

/// The value of one of the names that a table may have.
pub(super) fn entry<'v>(
    entries: &'v [(String, Value)],
    known: &[Entry],
    wanted: &str,
) -> Result<Option<&'v Value>, String> {
    let names: Vec<&str> = known.iter().map(|entry| entry.name).collect();
    match entries.iter().find(|(name, _)| !names.contains(&name.as_str())) {
        Some((name, _)) => Err(format!("`{}`, which is none of {}", one_line(name), names.join(", "))),
        None => match entries.iter().find(|(name, _)| name == wanted) {
            Some((_, value)) => Ok(Some(value)),
            None if known.iter().any(|entry| entry.name == wanted && entry.needed) => Err(format!("no `{wanted}`")),
            None => Ok(None),
        },
    }
}

/// Each item of a list; what is wrong with one is said with its number.
pub(super) fn each<T>(value: &Value, what: &str, one: impl Fn(&Value) -> Result<T, String>) -> Result<Vec<T>, Fault> {
    let Value::List(items) = value else { return Err(Fault::whole(format!("is {value}, no list"))) };
    let numbered = |(item, value): (usize, &Value)| {
        one(value).map_err(|found| Fault::at(item, format!("has in {what} {} {found}", item + 1)))
    };
    items.iter().enumerate().map(numbered).collect()
}

/// The key that a table names, with its bounds in the unit of the library.
pub(super) fn bounded<'k>(
    entries: &[(String, Value)],
    known: &[Entry],
    keys: &'k [Key],
) -> Result<(&'k Key, Option<f64>, Option<f64>), String> {
    let key = match entry(entries, known, "key")? {
        Some(Value::Text(text)) => named(text, keys)?,
        Some(value) => return Err(format!("`key` = {value}, no text in quotes")),
        None => return Err("no `key`".into()),
    };
    let bound = |name: &str| entry(entries, known, name)?.map(|value| number(key, name, value)).transpose();
    Ok((key, bound("from")?, bound("to")?))
}

/// The key of this path.
pub(super) fn named<'k>(path: &str, keys: &'k [Key]) -> Result<&'k Key, String> {
    let path = path.trim();
    find(keys, path).map_err(|error| {
        // a list of all keys is no sentence of a message
        let near = Some(error.remedy.as_str()).filter(|remedy| remedy.len() < 100);
        let remedy = near.unwrap_or("peel keys lists them");
        format!("the key {}, which {}. {remedy}", quoted(path), error.found)
    })
}

/// A number of this key, in the unit of the library.
pub(super) fn number(key: &Key, name: &str, value: &Value) -> Result<f64, String> {
    match value {
        Value::Number(number) if key.unit().is_empty() => Ok(*number),
        Value::Text(text) if !key.unit().is_empty() => key
            .parse_number(text)
            .map_err(|error| format!("`{name}` = {value}, and {} {}. {}", key.path(), error.found, error.remedy)),
        Value::Number(number) => Err(format!(
            "`{name}` = {value}, a number without a unit: write \"{number} {}\" if that is meant",
            key.usual_unit()
        )),
        value => Err(format!("`{name}` = {value}, which is not a number without quotes")),
    }
}

/// A number of the key of this path as a scene writes it.
pub(super) fn written_number(path: &str, number: f64, keys: &[Key]) -> Value {
    match find(keys, path).map_or("", Key::unit) {
        "" => Value::Number(number),
        unit => Value::Text(format!("{number} {unit}")),
    }
}

/// A key with the bounds that it has, as a scene writes it.
pub(super) fn written(path: &str, from: Option<f64>, to: Option<f64>, keys: &[Key]) -> Value {
    let bound = |name: &str, number: Option<f64>| Some((name.to_owned(), written_number(path, number?, keys)));
    let named = ("key".to_owned(), Value::Text(path.to_owned()));
    Value::Table([Some(named), bound("from", from), bound("to", to)].into_iter().flatten().collect())
}
