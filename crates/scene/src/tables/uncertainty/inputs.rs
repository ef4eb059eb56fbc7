//! The distributions of keys, as a scene writes them.

use super::UncertainKey;
use crate::error::one_line;
use crate::form::{Entry, Form};
use crate::key::Key;
use crate::keys::find_key;
use crate::near::nearest;
use crate::value::{Fault, Value, quoted};
use peelkit::model::Range;
use peelkit::study::uncertainty::Distribution;

/// The distributions: what each needs, and which of that is the value of the scene where it is left out.
const KINDS: [(&str, &[&str], Option<&str>); 4] = [
    ("normal", &["mean", "deviation"], Some("mean")),
    ("lognormal", &["median", "log_deviation"], Some("median")),
    ("uniform", &["from", "to"], None),
    ("triangular", &["from", "mode", "to"], Some("mode")),
];

/// What an input may hold, whatever its distribution.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::needed("key", || Form::OfKey),
    Entry::needed("distribution", || Form::Word(KINDS.map(|(name, ..)| name).to_vec())),
    Entry::optional("mean", || Form::OfItsKey),
    Entry::optional("deviation", || Form::OfItsKey),
    Entry::optional("median", || Form::OfItsKey),
    Entry::optional(PLAIN, || Form::Number(Range::Positive)),
    Entry::optional("from", || Form::OfItsKey),
    Entry::optional("mode", || Form::OfItsKey),
    Entry::optional("to", || Form::OfItsKey),
];

/// Of a logarithm, and so without a unit.
const PLAIN: &str = "log_deviation";

/// Reads the inputs of a list.
pub(super) fn read(items: &[Value]) -> Result<Vec<UncertainKey>, Fault> {
    let input = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => one(entries).map_err(|found| format!("has in input {number} {found}")),
            value => Err(format!("has as input {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault::at(item, found))
    };
    items.iter().enumerate().map(input).collect()
}

fn one(entries: &[(String, Value)]) -> Result<UncertainKey, String> {
    let given = |name: &str| entries.iter().find(|(given, _)| given == name).map(|(_, value)| value);
    let text = |name: &str| match given(name) {
        Some(Value::Text(text)) => Ok(text.trim()),
        Some(value) => Err(format!("`{name}` = {value}, no text in quotes")),
        None => Err(format!("no `{name}`")),
    };
    let path = text("key")?;
    let key = find_key(path).map_err(|error| {
        // a list of all keys is no sentence of a message
        let near = Some(error.remedy.as_str()).filter(|remedy| remedy.len() < 100);
        let remedy = near.unwrap_or("peel keys lists them");
        format!("the key {}, which {}. {remedy}", quoted(path), error.found)
    })?;
    let kind = text("distribution")?;
    let Some(&(kind, needed, center)) = KINDS.iter().find(|(name, ..)| *name == kind) else {
        let names = KINDS.map(|(name, ..)| name);
        let guess = nearest(kind, names).map(|near| format!("; did you mean \"{near}\"?")).unwrap_or_default();
        return Err(format!("the distribution {}, which is none of {}{guess}", quoted(kind), names.join(", ")));
    };
    let known = |name: &str| ["key", "distribution"].contains(&name) || needed.contains(&name);
    if let Some((name, _)) = entries.iter().find(|(name, _)| !known(name)) {
        let needs = needed.join(" and ");
        return Err(format!("`{}`, which a {kind} distribution does not have: it has {needs}", one_line(name)));
    }
    let number = |name: &str| match given(name) {
        Some(value) => number(key, name, value),
        // the scene gives it
        None if center == Some(name) => Ok(0.0),
        None => Err(format!("no `{name}`, which a {kind} distribution needs")),
    };
    let is_centered = center.is_some_and(|center| given(center).is_none());
    let distribution = match kind {
        "normal" => Distribution::Normal { mean: number("mean")?, deviation: number("deviation")? },
        "lognormal" => Distribution::Lognormal { median: number("median")?, log_deviation: number(PLAIN)? },
        "uniform" => Distribution::Uniform { from: number("from")?, to: number("to")? },
        _ => Distribution::Triangular { from: number("from")?, mode: number("mode")?, to: number("to")? },
    };
    Ok(UncertainKey { path: key.path(), distribution, is_centered })
}

/// A parameter of a distribution of this key, in the unit of the library.
fn number(key: &Key, name: &str, value: &Value) -> Result<f64, String> {
    let is_plain = name == PLAIN || key.unit().is_empty();
    match value {
        Value::Number(number) if is_plain => Ok(*number),
        Value::Number(number) => Err(format!(
            "`{name}` = {value}, a number without a unit: write \"{number} {}\" if that is meant",
            key.usual_unit()
        )),
        Value::Text(text) if !is_plain => key
            .parse_number(text)
            .map_err(|error| format!("`{name}` = {value}, and {} {}. {}", key.path(), error.found, error.remedy)),
        value => Err(format!("`{name}` = {value}, which is not a number without quotes")),
    }
}

/// An input as a scene writes it.
pub(super) fn written(input: &UncertainKey) -> Value {
    let unit = find_key(&input.path).map_or("", Key::unit);
    let text = |text: &str| Value::Text(text.to_owned());
    let value = |name: &str, number: f64| match unit {
        _ if name == PLAIN => Value::Number(number),
        "" => Value::Number(number),
        unit => Value::Text(format!("{number} {unit}")),
    };
    let kind = input.distribution.name();
    let center = KINDS.iter().find(|(name, ..)| *name == kind).and_then(|&(.., center)| center);
    let parameters = input.distribution.parameters().into_iter();
    let of_scene = |name: &str| input.is_centered && center == Some(name);
    let given = parameters.filter(|(name, _)| !of_scene(name)).map(|(name, of)| (name.to_owned(), value(name, of)));
    let named = [("key", text(&input.path)), ("distribution", text(input.distribution.name()))];
    Value::Table(named.into_iter().map(|(name, value)| (name.to_owned(), value)).chain(given).collect())
}
