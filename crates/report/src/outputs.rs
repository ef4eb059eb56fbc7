//! All tables and objects that are written, each with its keys: what `docs/outputs.md` is made of.

use crate::output_key::{Output, OutputKey};
use crate::records::{observed, path, peel, sweep};
use crate::reference::*;
use crate::seta::SETA_STATE_FIELDS;
use crate::states::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField};
use crate::{rate, seta};
use std::borrow::Cow;

/// Every table and every object.
pub fn outputs() -> Vec<Output> {
    let all = [
        ("states.csv", "column", of_state(STATE_FIELDS)),
        ("states.csv in space", "column", of_state(SPATIAL_STATE_FIELDS)),
        ("peel optimise --json", "key", OPTIMISATION_SUMMARY.to_vec()),
        ("history.csv", "column", HISTORY_COLUMNS.to_vec()),
        ("peel fit", "key", FIT_SUMMARY.to_vec()),
        ("fit.csv", "column", FIT_COLUMNS.to_vec()),
        ("profiles.csv", "column", PROFILE_COLUMNS.to_vec()),
        ("summary.json of peel uncertainty", "key", UNCERTAINTY_SUMMARY.to_vec()),
        ("statistics.csv and indices.csv", "column", UNCERTAINTY_COLUMNS.to_vec()),
        ("samples.csv", "column", SAMPLE_COLUMNS.to_vec()),
        (
            "states.pvd of a seta",
            "array",
            SETA_STATE_FIELDS
                .iter()
                .map(|field| OutputKey { path: Cow::Borrowed(field.name), about: field.about, like: None })
                .collect(),
        ),
        ("peel coarsen", "key", TIP_SUMMARY.to_vec()),
        ("tip_law.csv", "column", TIP_LAW_COLUMNS.to_vec()),
        ("tip_limits.csv", "column", TIP_LIMIT_COLUMNS.to_vec()),
    ];
    let old = all.into_iter().map(|(name, parts, keys)| Output { name, parts, keys }).collect();
    [peel::outputs(), old, path::outputs(), observed::outputs(), sweep::outputs(), seta::outputs(), rate::outputs()]
        .concat()
}

/// The columns of a state, and of each place.
fn of_state<S>(fields: &[StateField<S>]) -> Vec<OutputKey> {
    let fields =
        fields.iter().map(|field| OutputKey { path: Cow::Borrowed(field.name), about: field.about, like: None });
    STATE_COLUMNS.iter().cloned().chain(fields).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output_key::paths;

    #[test]
    fn every_key_is_described_once_and_in_words() {
        for Output { name, keys, .. } in outputs() {
            let mut paths = paths(&keys);
            let all = paths.len();
            paths.sort();
            paths.dedup();
            assert_eq!(paths.len(), all, "{name}: {paths:?}");
            assert!(keys.iter().all(|key| !key.about.is_empty() && !key.about.contains('|')), "{name}");
        }
    }

    #[test]
    fn a_key_like_another_has_its_keys() {
        let all = outputs();
        let paths = paths(&all[0].keys);
        assert!(paths.contains(&"initiation_peak.error_nm".to_owned()));
        assert!(paths.contains(&"observed.jumps[].after.adheres".to_owned()));
    }
}
