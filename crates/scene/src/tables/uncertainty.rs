//! The table `uncertainty`: what each of its keys takes, and how it is read and written.

use super::bounded::{named, number as of_key, written_number};
use crate::error::{nearest, one_line};
use crate::key::kind::{Key, Setting};
use crate::scene::Scene;
use crate::scene::studies::{CorrelatedKeys, UncertainKey};
use crate::value::form::{Entry, Form};
use crate::value::{Fault, Value, quoted};
use peelkit::model::Range;
use peelkit::study::PeelQuantity;
use peelkit::study::uncertainty::{Distribution, Indices};

/// Most samples.
const MOST_SAMPLES: f64 = 1e7;
/// Largest seed: whole numbers up to here are exact.
const LARGEST_SEED: f64 = 9_007_199_254_740_992.0;

/// `inputs`
pub(crate) static INPUTS: Setting = Setting {
    takes: "a list of tables, each with the `key` of a number of the scene, its `distribution` and what that needs: \"normal\" (mean, deviation), \
            \"lognormal\" (median, log_deviation of the logarithm), \"uniform\" (from, to) or \"triangular\" (from, mode, to); a mean, median \
            or mode that is left out is the value of the scene",
    brief: "list of tables",
    example: "[{ key = \"strip.height\", distribution = \"normal\", mean = \"10 nm\", deviation = \"0.5 nm\" }, { key = \"strip.width\", distribution = \
              \"lognormal\", median = \"1 nm\", log_deviation = 0.1 }]",
    form: || Form::list(Form::Table(INPUT)),
    read: |scene, value, keys| {
        scene.uncertainty_table().inputs = inputs(list(value)?, keys)?;
        Ok(())
    },
    write: |scene, keys| {
        let inputs = scene.uncertainty.as_ref()?.inputs.iter().map(|input| written_input(input, keys));
        Some(Value::List(inputs.collect()))
    },
};

/// `correlations`
pub(crate) static CORRELATIONS: Setting = Setting {
    takes: "a list of tables, each with two `keys` among those of the inputs and the `coefficient` of their correlation, between -1 and 1; of \
            inputs that are not normal it is that of the normal numbers behind them",
    brief: "list of tables",
    example: "[{ keys = [\"strip.height\", \"strip.width\"], coefficient = 0.5 }]",
    form: || Form::list(Form::Table(CORRELATION)),
    read: |scene, value, _| {
        scene.uncertainty_table().correlations = correlations(list(value)?)?;
        Ok(())
    },
    write: |scene, _| {
        let table = scene.uncertainty.as_ref()?;
        Some(Value::List(table.correlations.iter().map(written_correlation).collect()))
    },
};

/// `quantities`
pub(crate) static QUANTITIES: Setting = Setting {
    takes: "a list of numbers of a run, by their names in summary.json, such as \"peak.force_nN\" or \"first_jump.work_aJ\"",
    brief: "list of results",
    example: "[\"initiation_peak.force_nN\", \"first_jump.work_aJ\"]",
    form: || Form::list(Form::Word(PeelQuantity::all().map(PeelQuantity::name).collect())),
    read: |scene, value, _| {
        scene.uncertainty_table().quantities = quantities(list(value)?)?;
        Ok(())
    },
    write: |scene, _| {
        let names = scene.uncertainty.as_ref()?.quantities.iter().map(|of| Value::Text(of.name().to_owned()));
        Some(Value::List(names.collect()))
    },
};

/// `samples`
pub(crate) static SAMPLES: Setting = Setting {
    takes: "a whole number from 1 to 1e7",
    brief: "1 to 1e7, whole",
    example: "10000",
    form: || Form::Whole(1.0, MOST_SAMPLES),
    read: |scene, value, _| {
        scene.uncertainty_table().samples = whole(value, 1.0, MOST_SAMPLES)? as usize;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(scene.uncertainty.as_ref()?.samples as f64)),
};

/// `seed`
pub(crate) static SEED: Setting = Setting {
    takes: "a whole number from 0 to 2^53",
    brief: "0 to 2^53, whole",
    example: "1",
    form: || Form::Whole(0.0, LARGEST_SEED),
    read: |scene, value, _| {
        scene.uncertainty_table().seed = whole(value, 0.0, LARGEST_SEED)? as u64;
        Ok(())
    },
    write: |scene, _| Some(Value::Number(scene.uncertainty.as_ref()?.seed as f64)),
};

/// `indices`
pub(crate) static INDICES: Setting = Setting {
    takes: "true or false",
    brief: "true, false",
    example: "false",
    form: || Form::Flag,
    read: |scene, value, _| match value {
        Value::Flag(flag) => {
            scene.uncertainty_table().indices = if *flag { Indices::Estimated } else { Indices::Omitted };
            Ok(())
        }
        value => Err(Fault::whole(format!("is {value}"))),
    },
    write: |scene: &Scene, _| Some(Value::Flag(scene.uncertainty.as_ref()?.indices == Indices::Estimated)),
};

fn list(value: &Value) -> Result<&[Value], Fault> {
    if let Value::List(items) = value { Ok(items) } else { Err(Fault::whole(format!("is {value}"))) }
}

fn whole(value: &Value, least: f64, most: f64) -> Result<f64, Fault> {
    match value {
        Value::Number(number) if number.fract() != 0.0 => Err(Fault::whole(format!("is {value}, which is not whole"))),
        Value::Number(number) if (least..=most).contains(number) => Ok(*number),
        Value::Number(_) => Err(Fault::whole(format!("is {value}, which is out of range"))),
        value => Err(Fault::whole(format!("is {value}"))),
    }
}

fn quantities(items: &[Value]) -> Result<Vec<PeelQuantity>, Fault> {
    let names: Vec<&str> = PeelQuantity::all().map(PeelQuantity::name).collect();
    let mut found = Vec::with_capacity(items.len());
    for (item, value) in items.iter().enumerate() {
        let Value::Text(name) = value else { return Err(Fault::at(item, format!("has {value} as a result"))) };
        let quantity = PeelQuantity::named(name).ok_or_else(|| {
            let guess = nearest(name, names.iter().copied())
                .map(|near| format!("; did you mean \"{near}\"?"))
                .unwrap_or_default();
            Fault::at(item, format!("has {}, which is none of {}{guess}", quoted(name), names.join(", ")))
        })?;
        if found.contains(&quantity) {
            return Err(Fault::at(item, format!("has {} twice", quoted(name))));
        }
        found.push(quantity);
    }
    if found.is_empty() { Err(Fault::whole("is empty: no result is asked for".into())) } else { Ok(found) }
}

/// The distributions: what each needs, and which of that is the value of the scene where it is left out.
const KINDS: [(&str, &[&str], Option<&str>); 4] = [
    ("normal", &["mean", "deviation"], Some("mean")),
    ("lognormal", &["median", "log_deviation"], Some("median")),
    ("uniform", &["from", "to"], None),
    ("triangular", &["from", "mode", "to"], Some("mode")),
];

/// What an input may hold, whatever its distribution.
const INPUT: &[Entry] = &[
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
fn inputs(items: &[Value], keys: &[Key]) -> Result<Vec<UncertainKey>, Fault> {
    let input = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => one_input(entries, keys).map_err(|found| format!("has in input {number} {found}")),
            value => Err(format!("has as input {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault::at(item, found))
    };
    items.iter().enumerate().map(input).collect()
}

fn one_input(entries: &[(String, Value)], keys: &[Key]) -> Result<UncertainKey, String> {
    let given = |name: &str| entries.iter().find(|(given, _)| given == name).map(|(_, value)| value);
    let text = |name: &str| match given(name) {
        Some(Value::Text(text)) => Ok(text.trim()),
        Some(value) => Err(format!("`{name}` = {value}, no text in quotes")),
        None => Err(format!("no `{name}`")),
    };
    let path = text("key")?;
    let key = named(path, keys)?;
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
        Some(Value::Number(number)) if name == PLAIN => Ok(*number),
        Some(value) if name == PLAIN => Err(format!("`{name}` = {value}, which is not a number without quotes")),
        Some(value) => of_key(key, name, value),
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

/// An input as a scene writes it.
fn written_input(input: &UncertainKey, keys: &[Key]) -> Value {
    let text = |text: &str| Value::Text(text.to_owned());
    let value = |name: &str, number: f64| match name {
        PLAIN => Value::Number(number),
        _ => written_number(&input.path, number, keys),
    };
    let kind = input.distribution.name();
    let center = KINDS.iter().find(|(name, ..)| *name == kind).and_then(|&(.., center)| center);
    let parameters = input.distribution.parameters().into_iter();
    let of_scene = |name: &str| input.is_centered && center == Some(name);
    let given = parameters.filter(|(name, _)| !of_scene(name)).map(|(name, of)| (name.to_owned(), value(name, of)));
    let entries = [("key", text(&input.path)), ("distribution", text(input.distribution.name()))];
    Value::Table(entries.into_iter().map(|(name, value)| (name.to_owned(), value)).chain(given).collect())
}

/// The entries of a correlation.
const CORRELATION: &[Entry] = &[
    Entry::needed("keys", || Form::list(Form::OfKey)),
    Entry::needed("coefficient", || Form::Number(Range::From(-1.0, 1.0))),
];

/// Reads the correlations of a list.
fn correlations(items: &[Value]) -> Result<Vec<CorrelatedKeys>, Fault> {
    let correlation = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => {
                one_correlation(entries).map_err(|found| format!("has in correlation {number} {found}"))
            }
            value => Err(format!("has as correlation {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault::at(item, found))
    };
    items.iter().enumerate().map(correlation).collect()
}

fn one_correlation(entries: &[(String, Value)]) -> Result<CorrelatedKeys, String> {
    if let Some((name, _)) = entries.iter().find(|(name, _)| CORRELATION.iter().all(|entry| entry.name != name)) {
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
fn written_correlation(of: &CorrelatedKeys) -> Value {
    let keys = Value::List(of.keys.iter().map(|key| Value::Text(key.clone())).collect());
    Value::Table(vec![("keys".into(), keys), ("coefficient".into(), Value::Number(of.coefficient))])
}
