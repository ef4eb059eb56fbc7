//! What of a scene is fitted to a measured curve, and how: the table `fit`.

use crate::error::{ValueError, one_line};
use crate::form::Form;
use crate::key::Key;
use crate::key::kind::Setting;
use crate::keys::find_key;
use crate::near::nearest;
use crate::scene::Scene;
use crate::value::{Fault, Value, quoted, show};
use peelkit::study::{FitOptions, FitParameter, Loss, ParameterOf, ProfileChoice};

/// The table `fit`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FitTable {
    /// What is fitted
    pub parameters: Vec<FittedKey>,
    /// Measured displacement of the first jump, nm; none: looked for
    pub jump: Option<f64>,
    /// How
    pub options: FitOptions,
}

/// A key that is fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedKey {
    /// `strip.youngs_modulus`
    pub path: String,
    /// Lower bound, in the unit of the library
    pub from: Option<f64>,
    /// Upper bound
    pub to: Option<f64>,
}

/// The table's name.
pub(crate) const TABLE: &str = "fit";
/// The key of the table that may be fitted itself.
const ZERO: &str = "fit.displacement_zero";
/// Tables whose numbers are no parameters of a model.
const NO_MODEL: [&str; 2] = ["accuracy", "bounds"];
/// `parameters`
pub(crate) static PARAMETERS: Setting = Setting {
    takes: "a list of texts, each a key with a number in the scene and, optionally, bounds: \"strip.youngs_modulus\", \"strip.youngs_modulus \
            from 1 GPa to 5 GPa\"",
    brief: "list of texts",
    example: "[\"strip.youngs_modulus from 1 GPa to 5 GPa\"]",
    form: || Form::list(Form::OfKey),
    read: |scene, value| {
        let Value::List(items) = value else { return Err(Fault::whole(format!("is {value}, no list"))) };
        of(scene).parameters = read(items)?;
        Ok(())
    },
    write: |scene| Some(written(&scene.fit.as_ref()?.parameters)),
};

/// `loss`
pub(crate) static LOSS: Setting = Setting {
    takes: "\"squares\", \"huber\" or \"soft-l1\"",
    brief: "one of three words",
    example: "\"huber\"",
    form: || Form::word(LOSSES),
    read: |scene, value| {
        of(scene).options.loss = picked(LOSSES, value)?;
        Ok(())
    },
    write: |scene| Some(word(LOSSES, scene.fit.as_ref()?.options.loss)),
};

/// `profile`
pub(crate) static PROFILE: Setting = Setting {
    takes: "\"poor\" (of those that are poorly determined), \"all\" or \"none\"",
    brief: "poor, all, none",
    example: "\"all\"",
    form: || Form::word(PROFILES),
    read: |scene, value| {
        of(scene).options.profile = picked(PROFILES, value)?;
        Ok(())
    },
    write: |scene| Some(word(PROFILES, scene.fit.as_ref()?.options.profile)),
};

const LOSSES: &[(&str, Loss)] = &[("squares", Loss::Squares), ("huber", Loss::Huber), ("soft-l1", Loss::SoftL1)];
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

/// The table of a scene, which has one from now on.
pub(crate) fn of(scene: &mut Scene) -> &mut FitTable {
    scene.fit.get_or_insert_default()
}

/// Reads the list of parameters.
fn read(items: &[Value]) -> Result<Vec<FittedKey>, Fault> {
    let mut found: Vec<FittedKey> = Vec::new();
    for (index, item) in items.iter().enumerate() {
        let number = index + 1;
        let Value::Text(text) = item else {
            return Err(Fault::at(index, format!("has as parameter {number} {item}, which is no text")));
        };
        let one = one(text)
            .map_err(|why| Fault::at(index, format!("has as parameter {number} \"{}\", {why}", one_line(text))))?;
        if found.iter().any(|other| other.path == one.path) {
            return Err(Fault::at(index, format!("names `{}` twice", one.path)));
        }
        found.push(one);
    }
    Ok(found)
}

/// One of them; else what is wrong with it.
fn one(text: &str) -> Result<FittedKey, String> {
    let mut words = text.split_whitespace();
    let path = words.next().unwrap_or_default();
    let key = find_key(path).map_err(|problem| match problem.remedy.starts_with("Did you mean") {
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
    key.is_numeric() && !key.is_count() && (of_model || key.path() == ZERO)
}

/// The list as a scene writes it.
fn written(parameters: &[FittedKey]) -> Value {
    let text = |fitted: &FittedKey| {
        let unit = find_key(&fitted.path).map_or("", |key| key.unit());
        let bound =
            |name: &str, value: Option<f64>| value.map(|value| format!(" {name} {value} {unit}").trim_end().to_owned());
        let (from, to) = (bound("from", fitted.from), bound("to", fitted.to));
        Value::Text(format!("{}{}{}", fitted.path, from.unwrap_or_default(), to.unwrap_or_default()))
    };
    Value::List(parameters.iter().map(text).collect())
}

/// What is wrong with the list of a scene whose other keys are right.
pub(crate) fn conflict(scene: &Scene) -> Option<ValueError> {
    let table = scene.fit.as_ref()?;
    table.parameters.iter().find_map(|fitted| parameter(scene, fitted).err())
}

/// A parameter with the value that it has in the scene.
fn parameter(scene: &Scene, fitted: &FittedKey) -> Result<FitParameter, ValueError> {
    let FittedKey { path, from, to } = fitted;
    let key = find_key(path)?;
    if !key.belongs_to(scene) {
        let problem = key.foreign(scene);
        return Err(ValueError::new(format!("names `{path}`, which {}", problem.found), problem.remedy));
    }
    let Some(Value::Number(initial)) = key.value(scene) else {
        return Err(ValueError::new(
            format!("names `{path}`, which has no value in the scene"),
            format!("Add `{path}` with the value at which the search begins, for example {}.", key.example_line()),
        ));
    };
    let (low, high) = (from.unwrap_or(f64::NEG_INFINITY), to.unwrap_or(f64::INFINITY));
    if !(low <= initial && initial <= high) {
        return Err(ValueError::new(
            format!("gives `{path}` bounds that do not hold its value in the scene, {} {}", show(initial), key.unit()),
            "The search begins at the value of the scene: give bounds around it.",
        ));
    }
    let of = if path == ZERO { ParameterOf::DisplacementZero } else { ParameterOf::Model };
    Ok(FitParameter { key: path.clone(), initial, range: key.range(), from: *from, to: *to, of })
}

impl Scene {
    /// The parameters that the table `fit` names, each with the value that it has in the scene.
    ///
    /// Fails as a scene does that names what it does not have.
    pub fn fit_parameters(&self) -> Result<Vec<FitParameter>, ValueError> {
        let table = self.fit.iter().flat_map(|table| &table.parameters);
        table.map(|fitted| parameter(self, fitted)).collect()
    }

    /// The scene with other values of these keys, in the unit of the library, whatever they are: the check of the model refuses those that are
    /// out of range.
    pub fn with_numbers<'k>(&self, numbers: impl IntoIterator<Item = (&'k str, f64)>) -> Self {
        let mut scene = self.clone();
        for (path, value) in numbers {
            if let Ok(key) = find_key(path) {
                key.put_number(&mut scene, value);
            }
        }
        scene
    }
}
