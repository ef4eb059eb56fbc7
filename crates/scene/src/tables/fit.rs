//! The table `fit`: what each of its keys takes, and how it is read and written.

use super::bounded::{BOUNDED, bounded, entry, written};
use crate::error::{nearest, one_line};
use crate::key::kind::{Key, Setting};
use crate::key::list::find;
use crate::scene::studies::{FitColumns, FittedKey};
use crate::value::form::{Entry, Form};
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::{Fault, Value, quoted};
use peelkit::model::Range;
use peelkit::study::{DisplacementError, Loss, ProfileChoice};

/// The table's name.
pub(crate) const TABLE: &str = "fit";
/// Keys of the table that may be fitted themselves.
pub(crate) const ZERO: &str = "fit.displacement_zero";
pub(crate) const FORCE_ZERO: &str = "fit.force_zero";
/// Tables whose numbers are no parameters of a model.
const NO_MODEL: [&str; 2] = ["accuracy", "bounds"];
/// `parameters`
pub(crate) static PARAMETERS: Setting = Setting {
    takes: "a list of keys with a number in the scene, each a text or, with bounds, a table of its `key`, `from` and `to`; one bound may be left \
            out",
    brief: "list of keys",
    example: "[{ key = \"strip.youngs_modulus\", from = \"1 GPa\", to = \"5 GPa\" }]",
    form: || Form::list(Form::Either(Box::new(Form::OfKey), Box::new(Form::Table(BOUNDED)))),
    read: |scene, value, keys| {
        let Value::List(items) = value else { return Err(Fault::whole(format!("is {value}, no list"))) };
        scene.fit_table().parameters = read(items, keys)?;
        Ok(())
    },
    write: |scene, keys| Some(written_list(&scene.fit.as_ref()?.parameters, keys)),
};

/// `displacement_error`
pub(crate) static DISPLACEMENT_ERROR: Setting = Setting {
    takes: "a length with its unit, \"estimated\" (from the residuals, which it makes larger where the curve is steep) or \"none\"",
    brief: "length, or a word",
    example: "\"0.05 mm\"",
    form: || {
        let length = Form::Quantity(Dimension::Length, Range::Positive);
        Form::Either(Box::new(Form::word(ERRORS)), Box::new(length))
    },
    read: |scene, value, _| {
        scene.fit_table().options.displacement_error = displacement_error(value)?;
        Ok(())
    },
    write: |scene, _| {
        Some(match scene.fit.as_ref()?.options.displacement_error {
            DisplacementError::Known(error) => Value::Text(format!("{error} nm")),
            choice => word(ERRORS, choice),
        })
    },
};

/// `columns`
pub(crate) static COLUMNS: Setting = Setting {
    takes: "a table of `displacement`, `force` and `force_error`, each the name of a column in the first line of the data, with its unit \
            behind it where the data have none there: \"Load (N)\"",
    brief: "a table",
    example: "{ displacement = \"Extension (mm)\", force = \"Load (N)\" }",
    form: || Form::Table(NAMED),
    read: |scene, value, _| {
        scene.fit_table().columns = columns(value).map_err(Fault::whole)?;
        Ok(())
    },
    write: |scene, _| {
        let FitColumns { displacement, force, force_error } = &scene.fit.as_ref()?.columns;
        let named = NAMED.iter().zip([displacement, force, force_error]);
        let entries: Vec<_> =
            named.filter_map(|(entry, name)| Some((entry.name.to_owned(), Value::Text(name.clone()?)))).collect();
        (!entries.is_empty()).then_some(Value::Table(entries))
    },
};

const NAMED: &[Entry] = &[
    Entry::optional("displacement", || Form::Text),
    Entry::optional("force", || Form::Text),
    Entry::optional("force_error", || Form::Text),
];

/// `loss`
pub(crate) static LOSS: Setting = Setting {
    takes: "\"squares\", \"huber\" or \"soft-l1\"",
    brief: "one of three words",
    example: "\"huber\"",
    form: || Form::word(LOSSES),
    read: |scene, value, _| {
        scene.fit_table().options.loss = picked(LOSSES, value)?;
        Ok(())
    },
    write: |scene, _| Some(word(LOSSES, scene.fit.as_ref()?.options.loss)),
};

/// `profile`
pub(crate) static PROFILE: Setting = Setting {
    takes: "\"poor\" (of those that are poorly determined), \"all\" or \"none\"",
    brief: "poor, all, none",
    example: "\"all\"",
    form: || Form::word(PROFILES),
    read: |scene, value, _| {
        scene.fit_table().options.profile = picked(PROFILES, value)?;
        Ok(())
    },
    write: |scene, _| Some(word(PROFILES, scene.fit.as_ref()?.options.profile)),
};

const LOSSES: &[(&str, Loss)] = &[("squares", Loss::Squares), ("huber", Loss::Huber), ("soft-l1", Loss::SoftL1)];
const ERRORS: &[(&str, DisplacementError)] =
    &[("estimated", DisplacementError::Estimated), ("none", DisplacementError::None)];
const PROFILES: &[(&str, ProfileChoice)] =
    &[("poor", ProfileChoice::Poor), ("all", ProfileChoice::All), ("none", ProfileChoice::None)];

fn picked<T: Copy>(words: &[(&str, T)], value: &Value) -> Result<T, Fault> {
    let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}, no word"))) };
    let found = words.iter().find(|(word, _)| word == text).map(|&(_, choice)| choice);
    found.ok_or_else(|| {
        let near = nearest(text, words.iter().map(|&(word, _)| word));
        let guess = near.map(|near| format!("; did you mean \"{near}\"?")).unwrap_or_default();
        Fault::whole(format!("is {}, which is none of its values{guess}", quoted(text)))
    })
}

fn word<T: Copy + PartialEq>(words: &[(&str, T)], choice: T) -> Value {
    Value::Text(words.iter().find(|(_, own)| *own == choice).map_or("", |(word, _)| word).to_owned())
}

/// A length above zero, or one of the words.
fn displacement_error(value: &Value) -> Result<DisplacementError, Fault> {
    let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}, no text in quotes"))) };
    match parse_quantity(text, Dimension::Length) {
        Ok(error) if error > 0.0 && error.is_finite() => Ok(DisplacementError::Known(error)),
        Ok(_) => Err(Fault::whole(format!("is {}, which is not above zero", quoted(text)))),
        Err(_) => picked(ERRORS, value),
    }
}

/// The names of columns.
fn columns(value: &Value) -> Result<FitColumns, String> {
    let Value::Table(entries) = value else { return Err(format!("is {value}, no table")) };
    if entries.is_empty() {
        return Err("names no column".to_owned());
    }
    let name = |wanted: &str| match entry(entries, NAMED, wanted).map_err(|found| format!("has {found}"))? {
        None => Ok(None),
        Some(Value::Text(text)) if !text.trim().is_empty() => Ok(Some(text.trim().to_owned())),
        Some(value) => Err(format!("has `{wanted}` = {value}, no name of a column in quotes")),
    };
    Ok(FitColumns { displacement: name("displacement")?, force: name("force")?, force_error: name("force_error")? })
}

/// Reads the list of parameters.
fn read(items: &[Value], keys: &[Key]) -> Result<Vec<FittedKey>, Fault> {
    let mut found: Vec<FittedKey> = Vec::new();
    for (index, item) in items.iter().enumerate() {
        let number = index + 1;
        let one = match item {
            Value::Text(text) => {
                one(text, keys).map_err(|why| format!("has as parameter {number} \"{}\", {why}", one_line(text)))
            }
            Value::Table(entries) => of_table(entries, keys).map_err(|why| format!("has in parameter {number} {why}")),
            item => Err(format!(
                "has as parameter {number} {item}, which is neither a text nor a table of a key and its bounds"
            )),
        };
        let one = one.map_err(|found| Fault::at(index, found))?;
        if found.iter().any(|other| other.path == one.path) {
            return Err(Fault::at(index, format!("names `{}` twice", one.path)));
        }
        found.push(one);
    }
    Ok(found)
}

/// One of them that is a table; else what is wrong with it.
fn of_table(entries: &[(String, Value)], keys: &[Key]) -> Result<FittedKey, String> {
    let (key, from, to) = bounded(entries, BOUNDED, keys)?;
    let path = key.path();
    if !is_parameter(key) {
        return Err(format!("`{path}`, which is not a number of the model"));
    }
    for (name, value) in [("from", from), ("to", to)] {
        if value.is_some_and(|value| !key.range().contains(value)) {
            return Err(format!("a bound `{name}` of `{path}` that is out of range: it takes {}", key.takes()));
        }
    }
    if from.zip(to).is_some_and(|(from, to)| from >= to) {
        return Err(format!("bounds of `{path}` of which `from` is not below `to`"));
    }
    Ok(FittedKey { path, from, to })
}

/// One of them that is a text, alone or as "strip.height from 2 nm to 20 nm"; else what is wrong with it.
fn one(text: &str, keys: &[Key]) -> Result<FittedKey, String> {
    let mut words = text.split_whitespace();
    let path = words.next().unwrap_or_default();
    let key = find(keys, path).map_err(|problem| match problem.remedy.starts_with("Did you mean") {
        true => format!("which {}: {}", problem.found, lowered(&problem.remedy)),
        false => format!("which {}", problem.found),
    })?;
    if !is_parameter(key) {
        return Err("whose key is not a number of the model".into());
    }
    let rest: Vec<&str> = words.collect();
    let (from, to) = match rest.iter().position(|&word| word == "to") {
        Some(at) => rest.split_at(at),
        None => (&rest[..], &[][..]),
    };
    let (from, to) = (bound(key, from, "from")?, bound(key, to, "to")?);
    if from.zip(to).is_some_and(|(from, to)| from >= to) {
        return Err("whose first bound is not below its second".into());
    }
    Ok(FittedKey { path: key.path(), from, to })
}

/// "from 1 GPa"
fn bound(key: &Key, words: &[&str], name: &str) -> Result<Option<f64>, String> {
    let Some((word, amount)) = words.split_first() else { return Ok(None) };
    if *word != name || amount.is_empty() {
        return Err("behind whose key stands something else than from A to B".into());
    }
    let value = key.parse_number(&amount.join(" ")).map_err(|problem| format!("whose bound {}", problem.found))?;
    if !key.range().contains(value) {
        return Err(format!("whose bound {} is out of range: it takes {}", amount.join(" "), key.takes()));
    }
    Ok(Some(value))
}

fn lowered(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or(String::new(), |first| first.to_lowercase().chain(letters).collect())
}

/// Whether a key is a number of the model, or that of the measured displacement.
fn is_parameter(key: &Key) -> bool {
    let of_model = key.table != TABLE && !NO_MODEL.contains(&key.table) && !key.table.is_empty();
    key.is_numeric() && !key.is_count() && (of_model || [ZERO, FORCE_ZERO].contains(&key.path().as_str()))
}

/// The list as a scene writes it: keys without bounds as texts.
fn written_list(parameters: &[FittedKey], keys: &[Key]) -> Value {
    let one = |FittedKey { path, from, to }: &FittedKey| match (from, to) {
        (None, None) => Value::Text(path.clone()),
        _ => written(path, *from, *to, keys),
    };
    Value::List(parameters.iter().map(one).collect())
}
