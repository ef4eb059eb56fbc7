//! The shape of a substrate as a scene names it, and which keys belong to it.

use super::error::Problem;
use peelkit::adhesion::{Heights, LineLoad, Round, Shape, Sinusoid, Substrate};
use peelkit::model::PeelModel;
use std::sync::Arc;

/// The table of a scene.
pub(super) const TABLE: &str = "substrate";

/// What a scene calls the shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    Flat,
    Round(Shape),
    Sinusoid,
    Profile,
}

pub(super) const SHAPES: &[(&str, Named)] = &[
    ("flat", Named::Flat),
    ("sphere", Named::Round(Shape::Sphere)),
    ("cylinder", Named::Round(Shape::Cylinder)),
    ("sinusoid", Named::Sinusoid),
    ("profile", Named::Profile),
];

/// The shape of a substrate.
pub(super) fn of(substrate: &Substrate) -> Named {
    match substrate {
        Substrate::Flat => Named::Flat,
        Substrate::Round(round) => Named::Round(round.shape),
        Substrate::Sinusoid(_) => Named::Sinusoid,
        Substrate::Profile(_) => Named::Profile,
    }
}

/// Makes the substrate one of this shape; what both shapes have stays.
pub(super) fn set(substrate: &mut Substrate, named: Named) {
    match named {
        Named::Flat => *substrate = Substrate::Flat,
        Named::Round(shape) => round(substrate).shape = shape,
        Named::Sinusoid => drop(sinusoid(substrate)),
        Named::Profile if of(substrate) == Named::Profile => {}
        Named::Profile => *substrate = Substrate::Profile(Arc::new(Heights::level())),
    }
}

/// The keys of each shape besides `shape` itself.
fn keys(substrate: &Substrate) -> &'static [&'static str] {
    match substrate {
        Substrate::Flat => &[],
        Substrate::Round(_) => &["radius", "offset", "start"],
        Substrate::Sinusoid(_) => &["height", "wavelength", "offset", "start"],
        Substrate::Profile(_) => &["table", "start"],
    }
}

/// Whether a substrate of this shape has a key of this name.
pub(super) fn has(substrate: &Substrate, name: &str) -> bool {
    name == "shape" || keys(substrate).contains(&name)
}

/// The shapes that have a key of this name, as a scene calls them.
pub(super) fn shapes_with(name: &str) -> Vec<&'static str> {
    let with = |named: Named| {
        let mut substrate = Substrate::Flat;
        set(&mut substrate, named);
        has(&substrate, name)
    };
    SHAPES.iter().filter(|(_, named)| with(*named)).map(|(word, _)| *word).collect()
}

/// That it has none.
pub(super) fn foreign(substrate: &Substrate, name: &str) -> Problem {
    let shape = of(substrate);
    let word = SHAPES.iter().find(|(_, named)| *named == shape).map_or("", |(word, _)| word);
    let found = format!("is a key of [{TABLE}] for another `shape` than \"{word}\"");
    let own = keys(substrate);
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
            LineLoad::Full | LineLoad::AxisGap => ("adhesion.law", "surface-traction"),
        };
        let found = format!(
            "is \"{word}\", which has no potential: how a beam comes to lie on ground that is not flat is not defined"
        );
        return Some((path, found, "Take another line_load or law, or leave the table [substrate] away."));
    }
    let reach = model.reach();
    let details = reach / substrate.detail();
    if details > MOST_DETAILS {
        let found = format!(
            "is that of ground on which the beam lies on {details:.0} waves or radii; no more than {MOST_DETAILS} are resolved"
        );
        return Some((
            "substrate.shape",
            found,
            "Take a shorter strip or pad, a longer wave, or a profile that is given at fewer places.",
        ));
    }
    let zones = reach / model.process_length();
    if zones > MOST_ZONES {
        let found = format!(
            "is not flat, where elements have to be small wherever the beam lies, and it lies on {zones:.0} process zones; no more than {MOST_ZONES} are resolved"
        );
        return Some(("substrate.shape", found, "Take a shorter or a stiffer strip or pad."));
    }
    match substrate {
        Substrate::Round(round) if round.offset.abs() >= round.radius => Some((
            "substrate.offset",
            format!(
                "is {} nm, and the strip begins beside the body, whose radius is {} nm",
                round.offset, round.radius
            ),
            "Let the strip begin above it: an `offset` less than `radius`.",
        )),
        _ => None,
    }
}

/// The circle, which the substrate becomes where it has another shape.
pub(super) fn round(substrate: &mut Substrate) -> &mut Round {
    if !matches!(substrate, Substrate::Round(_)) {
        *substrate = Substrate::Round(Round { shape: Shape::Cylinder, radius: f64::NAN, offset: 0.0 });
    }
    match substrate {
        Substrate::Round(round) => round,
        _ => unreachable!("the shape has just been set"),
    }
}

/// The wave, likewise.
pub(super) fn sinusoid(substrate: &mut Substrate) -> &mut Sinusoid {
    if !matches!(substrate, Substrate::Sinusoid(_)) {
        *substrate = Substrate::Sinusoid(Sinusoid { height: f64::NAN, wavelength: f64::NAN, offset: 0.0 });
    }
    match substrate {
        Substrate::Sinusoid(sinusoid) => sinusoid,
        _ => unreachable!("the shape has just been set"),
    }
}

/// x of the top or of a crest; of a wave where the substrate has none.
pub(super) fn offset(substrate: &mut Substrate) -> &mut f64 {
    match substrate {
        Substrate::Round(round) => &mut round.offset,
        _ => &mut sinusoid(substrate).offset,
    }
}
