//! What a scene asks of a fit: its parameters with the values at which the search begins.

use crate::error::ValueError;
use crate::key::kind::Key;
use crate::keys::find_key;
use crate::scene::Scene;
use crate::scene::studies::{CurveOfFit, FitTable, FittedKey};
use crate::tables::fit::{FORCE_ZERO, ZERO};
use crate::value::{Value, show};
use peelkit::study::{FitParameter, ParameterOf};

/// What is wrong with the list of a scene whose other keys are right.
pub(crate) fn conflict(scene: &Scene) -> Option<ValueError> {
    let table = scene.fit.as_ref()?;
    table.parameters.iter().find_map(|fitted| parameter(scene, fitted).err())
}

/// What is wrong with the curves of such a scene: one whose numbers are not those of a model, or are fitted.
pub(crate) fn curves_conflict(scene: &Scene) -> Option<ValueError> {
    let table = scene.fit.as_ref()?;
    table.curves.iter().enumerate().find_map(|(index, curve)| of_curve(scene, table, index, curve).err())
}

fn of_curve(scene: &Scene, table: &FitTable, index: usize, curve: &CurveOfFit) -> Result<(), ValueError> {
    let number = index + 1;
    for (path, _) in &curve.set {
        let key = find_key(path)?;
        if !key.belongs_to(scene) {
            let problem = key.foreign(scene);
            return Err(ValueError::new(
                format!("sets in curve {number} `{path}`, which {}", problem.found),
                problem.remedy,
            ));
        }
        if table.parameters.iter().any(|fitted| fitted.path == *path) {
            return Err(ValueError::new(
                format!("sets in curve {number} `{path}`, which is fitted: it is one number of all curves"),
                format!("Remove `{path}` from one of the two."),
            ));
        }
    }
    scene.of_curve(index).check().map_err(|error| {
        ValueError::new(
            format!("gives curve {number} a scene of which `{}` {}", error.key(), error.found()),
            error.remedy(),
        )
    })
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
    let of = match path.as_str() {
        ZERO => ParameterOf::DisplacementZero { curve: 0 },
        FORCE_ZERO => ParameterOf::ForceZero { curve: 0 },
        _ => ParameterOf::Model,
    };
    Ok(FitParameter { key: path.clone(), initial, range: key.range(), from: *from, to: *to, of })
}

impl Scene {
    /// The parameters that the table `fit` names, each with the value that it has in the scene. Curves of the table have their own zeros,
    /// `fit.displacement_zero[2]` of the second.
    ///
    /// Fails as a scene does that names what it does not have.
    pub fn fit_parameters(&self) -> Result<Vec<FitParameter>, ValueError> {
        let Some(table) = &self.fit else { return Ok(Vec::new()) };
        let mut all = Vec::new();
        for fitted in &table.parameters {
            let parameter = parameter(self, fitted)?;
            if parameter.of == ParameterOf::Model || table.curves.is_empty() {
                all.push(parameter);
                continue;
            }
            for (curve, own) in table.curves.iter().enumerate() {
                let (of, given) = match parameter.of {
                    ParameterOf::ForceZero { .. } => (ParameterOf::ForceZero { curve }, own.force_zero),
                    _ => (ParameterOf::DisplacementZero { curve }, own.displacement_zero),
                };
                let key = format!("{}[{}]", parameter.key, curve + 1);
                let initial = given.unwrap_or(parameter.initial);
                all.push(FitParameter { key, initial, of, ..parameter.clone() });
            }
        }
        Ok(all)
    }

    /// The scene of one of the curves that are fitted together: with the numbers that are others for it.
    pub fn of_curve(&self, index: usize) -> Self {
        let curve = self.fit.as_ref().and_then(|table| table.curves.get(index));
        let set = curve.iter().flat_map(|curve| &curve.set);
        self.with_numbers(set.map(|(path, number)| (path.as_str(), *number)))
    }

    /// The scene with other values of these keys, in the unit of the library, whatever they are: the check of the model refuses those that are
    /// out of range.
    pub fn with_numbers<'k>(&self, numbers: impl IntoIterator<Item = (&'k str, f64)>) -> Self {
        let mut scene = self.clone();
        for (path, value) in numbers {
            match find_key(path) {
                Ok(key) => {
                    key.put_number(&mut scene, value);
                }
                Err(_) => scene.put_zero(path, value),
            }
        }
        scene
    }

    /// The zero of one curve of several.
    fn put_zero(&mut self, path: &str, value: f64) {
        let Some((path, curve)) = of_one_curve(path) else { return };
        if let Some(own) = self.fit_table().curves.get_mut(curve) {
            *(if path == FORCE_ZERO { &mut own.force_zero } else { &mut own.displacement_zero }) = Some(value);
        }
    }
}

/// The key and the place of the curve, of the zero of one of several: `fit.displacement_zero[2]`.
fn of_one_curve(path: &str) -> Option<(&str, usize)> {
    let (path, number) = path.strip_suffix(']')?.split_once('[')?;
    Some((path, number.parse::<usize>().ok()?.checked_sub(1)?))
}

/// The key of a parameter of a fit, of the zero of one curve of several as well; none of another name.
pub fn key_of_parameter(path: &str) -> Option<&'static Key> {
    find_key(of_one_curve(path).map_or(path, |(path, _)| path)).ok()
}
