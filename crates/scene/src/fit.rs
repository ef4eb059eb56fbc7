//! What of a scene is fitted to a measured curve, and how: the table `fit`.

use crate::error::{ValueError, one_line};
use crate::key::Key;
use crate::keys::{KEYS, find_key};
use crate::scene::Scene;
use crate::value::{Value, show};
use peelkit::model::Range;
use peelkit::study::{FitOptions, FitParameter, Loss, ParameterOf, ProfileChoice};

/// The table `fit`.
#[derive(Clone, Debug, PartialEq)]
pub struct FitTable {
    /// What is fitted
    pub parameters: Vec<FittedKey>,
    /// Measured displacement of the first jump, nm; none: looked for
    pub jump: Option<f64>,
    /// How
    pub options: FitOptions,
}

impl Default for FitTable {
    fn default() -> Self {
        Self { parameters: Vec::new(), jump: None, options: FitOptions::default() }
    }
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
/// What the list of parameters takes.
pub(crate) const TAKES: &str = "a list of texts, each a key with a number in the scene and, optionally, bounds: \"strip.youngs_modulus\", \
                                \"strip.youngs_modulus from 1 GPa to 5 GPa\"";

/// The table of a scene, which has one from now on.
pub(crate) fn of(scene: &mut Scene) -> &mut FitTable {
    scene.fit.get_or_insert_default()
}

/// Reads the list of parameters.
pub(crate) fn read(items: &[Value]) -> Result<Vec<FittedKey>, ValueError> {
    let mut found: Vec<FittedKey> = Vec::new();
    for (index, item) in items.iter().enumerate() {
        let number = index + 1;
        let wrong = |found: String, remedy: String| ValueError { found, remedy, item: Some(index) };
        let general = format!("`parameters` takes {TAKES}.");
        let Value::Text(text) = item else {
            return Err(wrong(format!("has as parameter {number} {item}, which is no text"), general));
        };
        let one = one(text).map_err(|problem| {
            let remedy = if problem.remedy.is_empty() { general.clone() } else { problem.remedy };
            wrong(format!("has as parameter {number} \"{}\", {}", one_line(text), problem.found), remedy)
        })?;
        if found.iter().any(|other| other.path == one.path) {
            return Err(wrong(format!("names `{}` twice", one.path), "Remove one of the two.".into()));
        }
        found.push(one);
    }
    Ok(found)
}

fn one(text: &str) -> Result<FittedKey, ValueError> {
    let mut words = text.split_whitespace();
    let path = words.next().unwrap_or_default();
    let key = find_key(path).map_err(|problem| ValueError::new(format!("which {}", problem.found), problem.remedy))?;
    if !is_parameter(key) {
        let names: Vec<String> = KEYS.iter().filter(|key| is_parameter(key)).map(Key::path).collect();
        return Err(ValueError::new(
            "which is not a number of the model",
            format!("What can be fitted is {}.", names.join(", ")),
        ));
    }
    let rest: Vec<&str> = words.collect();
    let (from, to) = match rest.iter().position(|&word| word == "to") {
        Some(at) => (&rest[..at], &rest[at..]),
        None => (&rest[..], &[][..]),
    };
    let bound = |words: &[&str], name: &str| match words.split_first() {
        None => Ok(None),
        Some((word, amount)) if *word == name && !amount.is_empty() => key
            .parse_number(&amount.join(" "))
            .map(Some)
            .map_err(|problem| ValueError::new(format!("whose bound `{name}` {}", problem.found), problem.remedy)),
        Some(_) => Err(ValueError::new("behind whose key stands something else than `from A to B`", "")),
    };
    let (from, to) = (bound(from, "from")?, bound(to, "to")?);
    if let (Some(a), Some(b)) = (from, to)
        && a >= b
    {
        return Err(ValueError::new("whose first bound is not below its second", "Give the lower bound first."));
    }
    if let Some(range) = key.range() {
        for (name, value) in [("from", from), ("to", to)] {
            if let Some(value) = value.filter(|value| !range.contains(*value)) {
                let found = format!("whose bound `{name}` is {}, which is out of range", show(value));
                return Err(ValueError::new(found, format!("`{path}` takes {}.", key.takes())));
            }
        }
    }
    Ok(FittedKey { path: key.path(), from, to })
}

/// Whether a key is a number of the model, or that of the measured displacement.
fn is_parameter(key: &Key) -> bool {
    let of_model = key.table != TABLE && !NO_MODEL.contains(&key.table) && !key.table.is_empty();
    key.is_numeric() && !key.is_count() && (of_model || key.path() == ZERO)
}

/// The list as a scene writes it.
pub(crate) fn written(parameters: &[FittedKey]) -> Value {
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
    let range = key.range().unwrap_or(Range::Positive);
    Ok(FitParameter { key: path.clone(), initial, range, from: *from, to: *to, of })
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

/// The words of a loss and of a choice of profiles.
pub(crate) const LOSSES: &[(&str, Loss)] =
    &[("squares", Loss::Squares), ("huber", Loss::Huber), ("soft-l1", Loss::SoftL1)];
pub(crate) const PROFILES: &[(&str, ProfileChoice)] =
    &[("poor", ProfileChoice::Poor), ("all", ProfileChoice::All), ("none", ProfileChoice::None)];
