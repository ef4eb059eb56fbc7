//! All tables and objects that are written, each with its keys: what the pages in `docs/reference/outputs` are made of.

use crate::writing::reference::Output;
use crate::{pulls, records, states};

/// Every table and every object.
pub fn outputs() -> Vec<Output> {
    [records::outputs(), states::outputs(), pulls::outputs()].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::writing::reference::paths;

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
