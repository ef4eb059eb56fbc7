//! What a scene asks of a fit: its parameters with the values at which the search begins.

use crate::error::ValueError;
use crate::keys::find_key;
use crate::scene::Scene;
use crate::scene::studies::FittedKey;
use crate::tables::fit::{FORCE_ZERO, ZERO};
use crate::value::{Value, show};
use peelkit::study::{FitParameter, ParameterOf};

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
    let of = match path.as_str() {
        ZERO => ParameterOf::DisplacementZero,
        FORCE_ZERO => ParameterOf::ForceZero,
        _ => ParameterOf::Model,
    };
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
