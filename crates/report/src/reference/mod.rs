//! What every key and column of an output means: one line each. `docs/outputs.md` is made of these lists, and a test holds them
//! against what the command writes.

use crate::output_key::OutputKey;
use std::borrow::Cow;

mod fit;
mod optimisation;
mod tables;
mod tip;
mod uncertainty;

pub use fit::{FIT_COLUMNS, FIT_SUMMARY, PROFILE_COLUMNS};
pub use optimisation::{HISTORY_COLUMNS, OPTIMISATION_SUMMARY};
pub use tables::STATE_COLUMNS;
pub use tip::{TIP_LAW_COLUMNS, TIP_LIMIT_COLUMNS, TIP_SUMMARY};
pub use uncertainty::{SAMPLE_COLUMNS, UNCERTAINTY_COLUMNS, UNCERTAINTY_SUMMARY};

/// A key that is described here.
const fn key(path: &'static str, about: &'static str) -> OutputKey {
    OutputKey { path: Cow::Borrowed(path), about, like: None }
}

/// A key whose object has the keys of another one.
const fn like(path: &'static str, other: &'static str, about: &'static str) -> OutputKey {
    OutputKey { path: Cow::Borrowed(path), about, like: Some(Cow::Borrowed(other)) }
}
