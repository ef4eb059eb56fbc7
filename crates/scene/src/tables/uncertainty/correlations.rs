//! Keys that vary together, as a scene writes them.

use super::CorrelatedKeys;
use crate::error::one_line;
use crate::form::{Entry, Form};
use crate::value::{Fault, Value};
use peelkit::model::Range;

/// The entries of a correlation.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::needed("keys", || Form::list(Form::OfKey)),
    Entry::needed("coefficient", || Form::Number(Range::From(-1.0, 1.0))),
];

/// Reads the correlations of a list.
pub(super) fn read(items: &[Value]) -> Result<Vec<CorrelatedKeys>, Fault> {
    let correlation = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => one(entries).map_err(|found| format!("has in correlation {number} {found}")),
            value => Err(format!("has as correlation {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault::at(item, found))
    };
    items.iter().enumerate().map(correlation).collect()
}

fn one(entries: &[(String, Value)]) -> Result<CorrelatedKeys, String> {
    if let Some((name, _)) = entries.iter().find(|(name, _)| ENTRIES.iter().all(|entry| entry.name != name)) {
        return Err(format!("`{}`, which it does not have: it has keys and coefficient", one_line(name)));
    }
    let given = |name: &str| entries.iter().find(|(given, _)| given == name).map(|(_, value)| value);
    let keys = match given("keys") {
        Some(Value::List(items)) => match &items[..] {
            [Value::Text(first), Value::Text(second)] => Ok([first.clone(), second.clone()]),
            _ => Err("`keys` that are not two texts".to_owned()),
        },
        _ => Err("no list `keys` of two inputs".to_owned()),
    }?;
    match given("coefficient") {
        Some(Value::Number(coefficient)) => Ok(CorrelatedKeys { keys, coefficient: *coefficient }),
        _ => Err("no number `coefficient`".into()),
    }
}

/// A correlation as a scene writes it.
pub(super) fn written(of: &CorrelatedKeys) -> Value {
    let keys = Value::List(of.keys.iter().map(|key| Value::Text(key.clone())).collect());
    Value::Table(vec![("keys".into(), keys), ("coefficient".into(), Value::Number(of.coefficient))])
}
