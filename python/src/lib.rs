//! The native module of the Python package `peelkit`: scenes, runs and their results, as `python/peelkit/` hands them on.
//!
//! What a user of the package reads is documented there. Units are those of the mechanics: nm, nN, aJ, rad.

#![warn(missing_docs)]

mod analyses;
mod columns;
mod errors;
mod found;
mod interrupt;
mod number;
mod path;
mod peel;
mod rows;
mod scene;
mod sensitivities;
mod states;

/// The native module of the package.
#[pyo3::pymodule(name = "_native")]
mod native {
    #[pymodule_export]
    use crate::analyses::{
        NativeTest, coarsen, fit, optimise, out_of_plane, peel_solid, pull_array, pull_at_rate, pull_off, test,
        uncertainty,
    };
    #[pymodule_export]
    use crate::found::NativeFound;
    #[pymodule_export]
    use crate::path::{NativePath, path};
    #[pymodule_export]
    use crate::peel::NativePeel;
    #[pymodule_export]
    use crate::rows::NativeRows;
    #[pymodule_export]
    use crate::scene::{NativeScene, keys, usual};
    #[pymodule_export]
    use crate::sensitivities::sensitivities;
    #[pymodule_export]
    use crate::states::NativeState;

    /// Version of the program.
    #[pymodule_export]
    const VERSION: &str = peelkit_report::VERSION;
    /// Of the keys of a summary.
    #[pymodule_export]
    const SCHEMA: u32 = peelkit_report::SCHEMA;
}
