//! What every key and column of an output means: one line each. `docs/reference/outputs.md` is made of these lists, and a test holds them
//! against what the command writes.

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

/// A key of a JSON object or a column of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutputKey {
    /// `peak.force_nN`; `limit_points[].kind` is a key of every object of a list. Its unit is the end of its name.
    pub path: &'static str,
    /// In a few words.
    pub about: &'static str,
    /// The key whose object has the keys of this one, where they are described there.
    pub like: Option<&'static str>,
}

/// A key that is described here.
const fn key(path: &'static str, about: &'static str) -> OutputKey {
    OutputKey { path, about, like: None }
}

/// A key whose object has the keys of another one.
const fn like(path: &'static str, other: &'static str, about: &'static str) -> OutputKey {
    OutputKey { path, about, like: Some(other) }
}

/// Endings of names that are units, and the units.
const UNITS: &[(&str, &str)] = &[
    ("_J_per_m2", "J/m²"),
    ("_nN_nm2", "nN nm²"),
    ("_nN_per_nm", "nN/nm"),
    ("_aJ_per_nm", "aJ/nm"),
    ("_per_nm", "1/nm"),
    ("_GPa", "GPa"),
    ("_nN_nm", "nN nm"),
    ("_nN", "nN"),
    ("_nm", "nm"),
    ("_aJ", "aJ"),
    ("_rad", "rad"),
    ("_deg", "deg"),
    ("_s", "s"),
];

impl OutputKey {
    /// The unit of its number; empty where it has none.
    pub fn unit(&self) -> &'static str {
        UNITS.iter().find(|(ending, _)| self.path.ends_with(ending)).map_or("", |(_, unit)| unit)
    }
}

/// All paths of a list, the keys that are described elsewhere in it included.
pub fn paths(keys: &[OutputKey]) -> Vec<String> {
    let below =
        |path: &str, root: &str| path.strip_prefix(root).filter(|rest| rest.starts_with(['.', '['])).map(str::to_owned);
    let mut all: Vec<String> = keys.iter().map(|key| key.path.to_owned()).collect();
    for key in keys {
        let Some(other) = key.like else { continue };
        let rests = keys.iter().filter_map(|from| below(from.path, other));
        all.extend(rests.map(|rest| format!("{}{rest}", key.path)));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn units_are_the_ends_of_names() {
        let unit = |path| key(path, "").unit();
        assert_eq!(
            ["moment_nN_nm", "force_nN", "solve_s", "points", "kappa_per_nm", "EI_nN_nm2"].map(unit),
            ["nN nm", "nN", "s", "", "1/nm", "nN nm²"]
        );
    }
}
