//! What every key and column of an output means: one line each. `docs/outputs.md` is made of these lists, and a test holds them
//! against what the command writes.

use crate::output_key::OutputKey;
use std::borrow::Cow;

mod fit;
mod optimisation;
mod rate;
mod seta;
mod summary;
mod tables;
mod tip;
mod uncertainty;

pub use fit::{FIT_COLUMNS, FIT_SUMMARY, PROFILE_COLUMNS};
pub use optimisation::{HISTORY_COLUMNS, OPTIMISATION_SUMMARY};
pub use rate::{RATE_CURVE_COLUMNS, RATE_SUMMARY, RATE_SWEEP_COLUMNS};
pub use seta::{
    SETA_CURVE_COLUMNS, SETA_EVENT_COLUMNS, SETA_SUMMARY, SETA_SWEEP_COLUMNS, SETA_TIP_COLUMNS, SETA_TIP_CURVE_COLUMNS,
};
pub use summary::{PEEL_SUMMARY, SWEEP_SUMMARY};
pub use tables::{CURVE_COLUMNS, LIMIT_POINT_COLUMNS, OBSERVED_COLUMNS, STATE_COLUMNS, SWEEP_COLUMNS};
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output_key::paths;

    const ALL: [&[OutputKey]; 26] = [
        RATE_SUMMARY,
        RATE_CURVE_COLUMNS,
        RATE_SWEEP_COLUMNS,
        SETA_SUMMARY,
        SETA_CURVE_COLUMNS,
        SETA_EVENT_COLUMNS,
        SETA_TIP_COLUMNS,
        SETA_TIP_CURVE_COLUMNS,
        TIP_SUMMARY,
        TIP_LAW_COLUMNS,
        TIP_LIMIT_COLUMNS,
        OPTIMISATION_SUMMARY,
        HISTORY_COLUMNS,
        FIT_SUMMARY,
        FIT_COLUMNS,
        PROFILE_COLUMNS,
        UNCERTAINTY_SUMMARY,
        UNCERTAINTY_COLUMNS,
        SAMPLE_COLUMNS,
        PEEL_SUMMARY,
        SWEEP_SUMMARY,
        CURVE_COLUMNS,
        LIMIT_POINT_COLUMNS,
        OBSERVED_COLUMNS,
        STATE_COLUMNS,
        SWEEP_COLUMNS,
    ];

    #[test]
    fn every_key_is_described_once_and_in_words() {
        for keys in ALL {
            let mut paths = paths(keys);
            let all = paths.len();
            paths.sort();
            paths.dedup();
            assert_eq!(paths.len(), all, "{paths:?}");
            assert!(keys.iter().all(|key| !key.about.is_empty() && !key.about.contains('|')));
        }
    }

    #[test]
    fn a_key_like_another_has_its_keys() {
        let paths = paths(PEEL_SUMMARY);
        assert!(paths.contains(&"initiation_peak.error_nm".to_owned()));
        assert!(paths.contains(&"observed.jumps[].after.adheres".to_owned()));
    }
}
