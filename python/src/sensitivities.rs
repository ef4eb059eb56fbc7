//! By which power of each parameter the results of a peel change.

use crate::errors::{computation_error, refused};
use crate::peel::NativePeel;
use peelkit::study::{self, NoSensitivities, Peel, PeelQuantity, Terms};
use peelkit_scene::{Parameters, Scene};
use pyo3::prelude::*;

/// Result, key, d ln Q/d ln p and the bound on its error.
type Line = (&'static str, String, f64, f64);
/// A key by which nothing could be differentiated, and why.
type Refused = (String, String);

/// The exponents of a peel, and the keys that have none.
#[pyfunction]
pub fn sensitivities(py: Python, peel: &NativePeel) -> PyResult<(Vec<Line>, Vec<Refused>)> {
    let scene = &peel.source().scene;
    if let Some(why) = NoSensitivities::of(&scene.model) {
        let remedy = why.key().map_or_else(String::new, |key| format!("Remove `{key}` from the scene."));
        return Err(refused(py, format!("there are no sensitivities: {why}"), &remedy));
    }
    if scene.accuracy.terms == Terms::Auto {
        let found = "sensitivities are those of a model with all of its terms, and the scene has terms = \"auto\"";
        return Err(refused(py, found.into(), "Give `with_(\"terms\", \"all\")`."));
    }
    let solved = peel.with_solutions(py)?;
    py.detach(|| found(scene, solved)).map_err(|why| computation_error(py, why.to_string()))
}

fn found(scene: &Scene, peel: &Peel) -> Result<(Vec<Line>, Vec<Refused>), NoSensitivities> {
    let Parameters { variations, fixed } = scene.parameters();
    let found = study::sensitivities(peel, &PeelQuantity::OF_A_PEEL, &variations)?;
    let key = |index: usize| variations[index].key.clone();
    let lines = found.exponents(peel).into_iter();
    let refused = found.refused.iter().map(|(index, why)| (key(*index), why.to_string())).chain(fixed).collect();
    Ok((lines.map(|one| (one.of.name(), key(one.variation), one.value, one.error)).collect(), refused))
}
