//! The words that a key with a choice takes.

use peelkit::adhesion::{LineLoad, SectionShape};
use peelkit::model::{Attraction, Hold, Start};
use peelkit::study::Terms;

pub(super) const LINE_LOADS: &[(&str, LineLoad)] =
    &[("full", LineLoad::Full), ("force-only", LineLoad::ForceOnly), ("axis-gap", LineLoad::AxisGap)];
pub(super) const STARTS: &[(&str, Start)] = &[("conformed", Start::Conformed), ("flat", Start::Crests)];
pub(super) const TERMS: &[(&str, Terms)] = &[("all", Terms::All), ("auto", Terms::Auto)];
pub(super) const SECTIONS: &[(&str, SectionShape)] =
    &[("rectangle", SectionShape::Rectangle), ("ellipse", SectionShape::Ellipse)];
pub(super) const HOLDS: &[(&str, Hold)] = &[("free", Hold::Free), ("fixed", Hold::Fixed)];

/// The names of the adhesion models in a scene.
pub(super) fn attractions() -> Vec<(&'static str, Attraction)> {
    Attraction::all().map(|attraction| (attraction.name(), attraction)).collect()
}

/// The word for a value.
pub(super) fn word<T: Copy + PartialEq>(choices: &[(&'static str, T)], value: T) -> String {
    choices.iter().find(|(_, choice)| *choice == value).map_or("", |(word, _)| word).to_owned()
}

/// All the words, as a sentence lists them.
pub(super) fn words<T>(choices: &[(&'static str, T)]) -> String {
    let words: Vec<String> = choices.iter().map(|(word, _)| format!("\"{word}\"")).collect();
    match words.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => words.concat(),
    }
}
