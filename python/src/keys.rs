//! The keys of a scene, as the package needs them.

use peelkit_scene::KEYS;
use pyo3::prelude::*;

/// Every key with the unit in which a bare number is taken, as `peel keys` lists it; empty where it takes none.
#[pyfunction]
pub fn keys() -> Vec<(String, &'static str)> {
    KEYS.iter().map(|key| (key.path(), key.usual_unit())).collect()
}
