//! The curves of a fit of several.

use super::bounded::{each, entry, named, number, written_number};
use crate::key::kind::{Key, Setting};
use crate::scene::studies::CurveOfFit;
use crate::value::form::{Entry, Form};
use crate::value::quantity::Dimension;
use crate::value::{Fault, Value};
use peelkit::model::Range;

/// Most curves of one fit.
const MOST: usize = 50;

/// The entries of a curve.
const CURVE: &[Entry] = &[
    Entry::needed("data", || Form::Text),
    Entry::optional("set", || Form::Values),
    Entry::optional("displacement_zero", || Form::Quantity(Dimension::Length, Range::OFFSET)),
    Entry::optional("force_zero", || Form::Quantity(Dimension::Force, Range::FORCE_ZERO)),
    Entry::optional("jump", || Form::Quantity(Dimension::Length, Range::Positive)),
];

/// `curves`
pub(crate) static CURVES: Setting = Setting {
    takes: "a list of tables, one a measured curve, each with `data`, the name of its CSV beside the scene; `set`, a table of the numbers of the scene \
            that are others for it; and `displacement_zero`, `force_zero` and `jump`, where they are not those of all",
    brief: "list of tables",
    example: "[{ data = \"at-90.csv\" }, { data = \"at-60.csv\", set = { \"drive.angle\" = \"60 deg\" } }]",
    form: || Form::list(Form::Table(CURVE)),
    read: |scene, value, keys| {
        let curves = each(value, "curve", |value| curve(value, keys))?;
        if curves.is_empty() || curves.len() > MOST {
            return Err(Fault::whole(format!("has {} curves; it takes 1 to {MOST}", curves.len())));
        }
        scene.fit_table().curves = curves;
        Ok(())
    },
    write: |scene, keys| {
        let curves = &scene.fit.as_ref()?.curves;
        (!curves.is_empty()).then(|| Value::List(curves.iter().map(|curve| written(curve, keys)).collect()))
    },
};

fn curve(value: &Value, keys: &[Key]) -> Result<CurveOfFit, String> {
    let Value::Table(entries) = value else { return Err(format!("{value}, no table of its data")) };
    let of = |name: &str| entry(entries, CURVE, name);
    let data = match of("data")? {
        Some(Value::Text(text)) if !text.trim().is_empty() => text.trim().to_owned(),
        other => {
            return Err(format!("`data` = {}, no name of a file", other.map_or_else(String::new, ToString::to_string)));
        }
    };
    let set = match of("set")? {
        None => Vec::new(),
        Some(Value::Table(set)) => others("", set, keys)?,
        Some(other) => return Err(format!("`set` = {other}, no table of keys")),
    };
    let own = |name: &str| {
        let key = named(&format!("fit.{name}"), keys)?;
        of(name)?.map(|value| in_range(key, name, value)).transpose()
    };
    let (displacement_zero, force_zero) = (own("displacement_zero")?, own("force_zero")?);
    Ok(CurveOfFit { data, set, displacement_zero, force_zero, jump: own("jump")? })
}

/// Numbers of the scene that are others for a curve: `"drive.angle" = ..`, or `drive = { angle = .. }`.
fn others(within: &str, set: &[(String, Value)], keys: &[Key]) -> Result<Vec<(String, f64)>, String> {
    let mut found = Vec::new();
    for (name, value) in set {
        let path = if within.is_empty() { name.clone() } else { format!("{within}.{name}") };
        match value {
            Value::Table(inner) if within.is_empty() => found.extend(others(&path, inner, keys)?),
            value => found.push(other(&path, value, keys)?),
        }
    }
    Ok(found)
}

/// One of them.
fn other(path: &str, value: &Value, keys: &[Key]) -> Result<(String, f64), String> {
    let key = named(path, keys)?;
    let path = key.path();
    if !key.is_numeric() || key.is_count() || ["", "accuracy", "bounds", "fit"].contains(&key.table) {
        return Err(format!("`set` with `{path}`, which is not a number of the model"));
    }
    let number = in_range(key, &path, value).map_err(|found| format!("`set` with {found}"))?;
    Ok((path, number))
}

/// What a key may be, in the unit of the library.
fn in_range(key: &Key, name: &str, value: &Value) -> Result<f64, String> {
    let number = number(key, name, value)?;
    let is_right = key.range().contains(number);
    is_right
        .then_some(number)
        .ok_or_else(|| format!("`{name}` = {value}, which is out of range: it takes {}", key.takes()))
}

fn written(curve: &CurveOfFit, keys: &[Key]) -> Value {
    let CurveOfFit { data, set, displacement_zero, force_zero, jump } = curve;
    let set: Vec<_> = set.iter().map(|(path, number)| (path.clone(), written_number(path, *number, keys))).collect();
    let own = |name: &str, number: Option<f64>| {
        Some((name.to_owned(), written_number(&format!("fit.{name}"), number?, keys)))
    };
    let entries = [
        Some(("data".to_owned(), Value::Text(data.clone()))),
        (!set.is_empty()).then(|| ("set".to_owned(), Value::Table(set))),
        own("displacement_zero", *displacement_zero),
        own("force_zero", *force_zero),
        own("jump", *jump),
    ];
    Value::Table(entries.into_iter().flatten().collect())
}
