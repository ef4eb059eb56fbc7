//! The keys of a scene, as the package needs them.

use peelkit_scene::{KEYS, find_key, parse_quantity};
use pyo3::prelude::*;

/// Every key with the unit in which a bare number is taken, as `peel keys` lists it; empty where it takes none.
#[pyfunction]
pub fn keys() -> Vec<(String, &'static str)> {
    KEYS.iter().map(|key| (key.path(), key.usual_unit())).collect()
}

/// Whether a text is a quantity with a unit that this key takes.
#[pyfunction]
pub fn takes(path: &str, text: &str) -> bool {
    let dimension = find_key(path).ok().and_then(|key| key.dimension());
    dimension.is_some_and(|dimension| parse_quantity(text, dimension).is_ok())
}
