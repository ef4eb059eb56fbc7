//! The native module of the Python package `peelkit`: scenes, runs and their results, as `python/peelkit/` hands them on.
//!
//! What a user of the package reads is documented there. Units are those of the mechanics: nm, nN, aJ, rad.

#![warn(missing_docs)]

mod columns;
mod errors;
mod interrupt;
mod keys;
mod peel;
mod scene;

/// The native module of the package.
#[pyo3::pymodule(name = "_native")]
mod native {
    #[pymodule_export]
    use crate::keys::keys;
    #[pymodule_export]
    use crate::peel::NativePeel;
    #[pymodule_export]
    use crate::scene::NativeScene;

    /// Version of the program.
    #[pymodule_export]
    const VERSION: &str = peelkit_report::VERSION;
    /// Of the keys of a summary.
    #[pymodule_export]
    const SCHEMA: u32 = peelkit_report::SCHEMA;
}
