//! The values of the table, as a scene writes them.

use super::{FreeKey, FreeProfile};
use crate::error::one_line;
use crate::form::{Entry, Form};
use crate::key::Key;
use crate::keys::find_key;
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::{Fault, Value, quoted};
use peelkit::model::Range;

/// The entries of a free key.
pub(super) const FREE_KEY: &[Entry] = &[
    Entry::needed("key", || Form::OfKey),
    Entry::needed("from", || Form::OfItsKey),
    Entry::needed("to", || Form::OfItsKey),
];
/// Those of a profile.
pub(super) const FREE_PROFILE: &[Entry] = &[
    Entry::needed("from", || Form::Quantity(Dimension::Length, Range::Positive)),
    Entry::needed("to", || Form::Quantity(Dimension::Length, Range::Positive)),
    Entry::optional("slope", || Form::Number(Range::Positive)),
];

/// One of several words.
pub(super) fn word<T: Copy>(value: &Value, words: &[(&'static str, T)]) -> Result<T, Fault> {
    let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}"))) };
    let found = words.iter().find(|(word, _)| word == text);
    let names: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
    found.map(|(_, choice)| *choice).ok_or_else(|| {
        let guess = crate::near::nearest(text, names.iter().copied());
        let guess = guess.map(|near| format!("; did you mean \"{near}\"?")).unwrap_or_default();
        Fault::whole(format!("is {}, which is none of {}{guess}", quoted(text), names.join(", ")))
    })
}

/// A whole number in a range.
pub(super) fn whole(value: &Value, least: usize, most: usize) -> Result<usize, Fault> {
    match value {
        Value::Number(number) if number.fract() != 0.0 => Err(Fault::whole(format!("is {value}, which is not whole"))),
        Value::Number(number) if (least as f64..=most as f64).contains(number) => Ok(*number as usize),
        Value::Number(_) => Err(Fault::whole(format!("is {value}, which is out of range"))),
        value => Err(Fault::whole(format!("is {value}"))),
    }
}

/// An angle with its unit, rad.
pub(super) fn angle(value: &Value) -> Result<f64, Fault> {
    measure(value, Dimension::Angle).map_err(|found| Fault::whole(format!("is {found}")))
}

fn measure(value: &Value, dimension: Dimension) -> Result<f64, String> {
    let Value::Text(text) = value else { return Err(format!("{value}, which is no text with a unit")) };
    parse_quantity(text, dimension)
        .map_err(|_| format!("{value}, which is no {dimension} with its unit ({})", dimension.units().join(", ")))
}

/// The free keys of a list.
pub(super) fn keys(value: &Value) -> Result<Vec<FreeKey>, Fault> {
    let Value::List(items) = value else { return Err(Fault::whole(format!("is {value}"))) };
    let one = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => free_key(entries).map_err(|found| format!("has in parameter {number} {found}")),
            value => Err(format!("has as parameter {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault::at(item, found))
    };
    items.iter().enumerate().map(one).collect()
}

/// The value of one of the names that a table may have.
fn entry<'v>(entries: &'v [(String, Value)], known: &[Entry], wanted: &str) -> Result<Option<&'v Value>, String> {
    let names: Vec<&str> = known.iter().map(|entry| entry.name).collect();
    match entries.iter().find(|(name, _)| !names.contains(&name.as_str())) {
        Some((name, _)) => Err(format!("`{}`, which is none of {}", one_line(name), names.join(", "))),
        None => Ok(entries.iter().find(|(name, _)| name == wanted).map(|(_, value)| value)),
    }
}

fn free_key(entries: &[(String, Value)]) -> Result<FreeKey, String> {
    let given = |name: &str| entry(entries, FREE_KEY, name)?.ok_or_else(|| format!("no `{name}`"));
    let path = match given("key")? {
        Value::Text(text) => text.trim(),
        value => return Err(format!("`key` = {value}, no text in quotes")),
    };
    let key = find_key(path).map_err(|error| {
        // a list of all keys is no sentence of a message
        let near = Some(error.remedy.as_str()).filter(|remedy| remedy.len() < 100);
        let remedy = near.unwrap_or("peel keys lists them");
        format!("the key {}, which {}. {remedy}", quoted(path), error.found)
    })?;
    let (from, to) = (number(key, "from", given("from")?)?, number(key, "to", given("to")?)?);
    Ok(FreeKey { path: key.path(), from, to })
}

fn number(key: &Key, name: &str, value: &Value) -> Result<f64, String> {
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

/// The bounds of a profile.
pub(super) fn profile(value: &Value) -> Result<FreeProfile, Fault> {
    let Value::Table(entries) = value else { return Err(Fault::whole(format!("is {value}"))) };
    let given = |name: &str| entry(entries, FREE_PROFILE, name);
    let length = |name: &str| {
        let value = given(name)?.ok_or_else(|| format!("no `{name}`"))?;
        measure(value, Dimension::Length).map_err(|found| format!("`{name}` = {found}"))
    };
    let slope = || match given("slope")? {
        None => Ok(None),
        Some(Value::Number(slope)) if *slope > 0.0 => Ok(Some(*slope)),
        Some(value) => Err(format!("`slope` = {value}, which is no number above zero")),
    };
    let read = || Ok(FreeProfile { from: length("from")?, to: length("to")?, slope: slope()? });
    read().map_err(|found: String| Fault::whole(format!("has {found}")))
}

/// A free key as a scene writes it.
pub(super) fn written_key(of: &FreeKey) -> Value {
    let unit = find_key(&of.path).map_or("", Key::unit);
    let value =
        |number: f64| if unit.is_empty() { Value::Number(number) } else { Value::Text(format!("{number} {unit}")) };
    let entries = [("key", Value::Text(of.path.clone())), ("from", value(of.from)), ("to", value(of.to))];
    Value::Table(entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}

/// A profile as a scene writes it.
pub(super) fn written_profile(of: &FreeProfile) -> Value {
    let length = |number: f64| Value::Text(format!("{number} nm"));
    let mut entries = vec![("from".to_owned(), length(of.from)), ("to".to_owned(), length(of.to))];
    entries.extend(of.slope.map(|slope| ("slope".to_owned(), Value::Number(slope))));
    Value::Table(entries)
}
