//! "Did you mean ...?"

/// Longer words are misspellings of nothing.
const LONGEST: usize = 64;

/// The candidate that `word` is most likely a misspelling of, if one is near enough.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    // the comparison takes time and memory in proportion to the word, and no name is as long
    if length > LONGEST {
        return None;
    }
    let word = word.to_lowercase();
    let slips = 1 + length / 4;
    let slips_to = |candidate: &str| strsim::damerau_levenshtein(&word, &candidate.to_lowercase());
    // Two short words are never far apart: more than half of the word has to be right.
    let near_enough = |slip: usize, candidate: &str| slip <= slips && 2 * slip < candidate.chars().count().max(2);
    candidates
        .into_iter()
        .map(|candidate| (slips_to(candidate), candidate))
        .filter(|&(slip, candidate)| near_enough(slip, candidate))
        .min_by_key(|&(slip, _)| slip)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn finds_slips_and_leaves_the_rest_alone() {
        let words = ["length", "height", "width"];
        assert_eq!(nearest("lenght", words), Some("length"));
        assert_eq!(nearest("Height", words), Some("height"));
        assert_eq!(nearest("colour", words), None);
        assert_eq!(nearest("", words), None);
        assert_eq!(nearest(&"length".repeat(1_000_000), words), None);
    }
}
