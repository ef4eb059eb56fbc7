//! The shape of a substrate as a scene names it, and which keys belong to it.

use super::error::ValueError;
use peelkit::adhesion::Substrate;

/// The table of a scene.
pub(super) const TABLE: &str = "substrate";

/// What a scene may call the shape.
pub(super) fn names() -> Vec<(&'static str, &'static str)> {
    Substrate::all().into_iter().map(|(name, _)| (name, name)).collect()
}

/// Whether a substrate of this shape has a key of this name.
pub(super) fn has(substrate: &Substrate, name: &str) -> bool {
    name == "shape" || substrate.keys().contains(&name)
}

/// The shapes that have a key of this name, as a scene calls them.
pub(super) fn shapes_with(name: &str) -> Vec<&'static str> {
    Substrate::all().iter().filter(|(_, substrate)| has(substrate, name)).map(|(word, _)| *word).collect()
}

/// The number of this key; a substrate that has none becomes the first shape that has one.
pub(super) fn number<'a>(substrate: &'a mut Substrate, name: &str) -> &'a mut f64 {
    if substrate.number(name).is_none() {
        let shapes = Substrate::all().into_iter();
        shapes.filter(|(_, shape)| has(shape, name)).take(1).for_each(|(_, shape)| *substrate = shape);
    }
    substrate
        .number(name)
        .expect("KEYS asks for the numbers of shapes alone, and the shape has just become one that has it")
}

/// That it has none.
pub(super) fn foreign(substrate: &Substrate, name: &str) -> ValueError {
    let word = substrate.name();
    let found = format!("is a key of [{TABLE}] for another `shape` than \"{word}\"");
    let own = substrate.keys();
    let own = if own.is_empty() { "no other keys".to_owned() } else { format!("the keys {}", own.join(", ")) };
    let shapes = shapes_with(name).join("\" or \"");
    ValueError::new(found, format!("It belongs to shape \"{shapes}\"; \"{word}\" has {own}."))
}
