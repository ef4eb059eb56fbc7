//! The shape of a substrate as a scene names it, and which keys belong to it.

use super::error::Problem;
use peelkit::adhesion::{LineLoad, Substrate};
use peelkit::model::PeelModel;

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
    substrate.number(name).unwrap_or_else(|| unreachable!("{name} is a number of a shape"))
}

/// That it has none.
pub(super) fn foreign(substrate: &Substrate, name: &str) -> Problem {
    let word = substrate.name();
    let found = format!("is a key of [{TABLE}] for another `shape` than \"{word}\"");
    let own = substrate.keys();
    let own = if own.is_empty() { "no other keys".to_owned() } else { format!("the keys {}", own.join(", ")) };
    let shapes = shapes_with(name).join("\" or \"");
    Problem::new(found, format!("It belongs to shape \"{shapes}\"; \"{word}\" has {own}."))
}

/// Most waves or radii, and most process zones, on which a beam lies on ground that is not flat.
const MOST_DETAILS: f64 = 100.0;
const MOST_ZONES: f64 = 1000.0;

/// What of a substrate does not fit the rest of a model: the key, what was found, and what would be right.
pub(super) fn misfit(model: &PeelModel) -> Option<(&'static str, String, &'static str)> {
    let substrate = &model.ground.substrate;
    if substrate.is_flat() {
        return None;
    }
    if !model.line_law().has_potential() {
        let (path, word) = match model.adhesion.line_load {
            LineLoad::ForceOnly => ("adhesion.line_load", "force-only"),
            LineLoad::Full | LineLoad::AxisGap => ("adhesion.law", model.adhesion.attraction.name()),
        };
        let found = format!(
            "is \"{word}\", which has no potential: the initial equilibrium on a substrate that is not flat is not defined"
        );
        return Some((path, found, "Use another line_load or law, or remove the table [substrate]."));
    }
    let reach = model.reach();
    let details = reach / substrate.detail();
    if details > MOST_DETAILS {
        let found = format!("lets the beam lie on {details:.0} waves or radii; at most {MOST_DETAILS} are resolved");
        return Some((
            "substrate.shape",
            found,
            "Use a shorter strip or pad, a longer wave, or a profile with fewer rows.",
        ));
    }
    let zones = reach / model.process_length();
    if zones > MOST_ZONES {
        let found = format!(
            "is not flat, which requires small elements along the whole contact of {zones:.0} process zones; at most {MOST_ZONES} are resolved"
        );
        return Some(("substrate.shape", found, "Use a shorter or a stiffer strip or pad."));
    }
    substrate.misfit().map(|misfit| (misfit.key, misfit.found, misfit.remedy))
}
