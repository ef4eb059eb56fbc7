//! A key that takes one of several words: which, and where in a scene the one that is chosen stands.

use crate::scene::Scene;
use peelkit::adhesion::{CohesiveShape, LineLoad, Measured, SectionShape, TractionTable};
use peelkit::beam::StretchLaw;
use peelkit::model::{Attraction, Hold, Start};
use peelkit::study::{FollowedUntil, Terms};

/// Words with what they mean.
type Named<T> = &'static [(&'static str, T)];

pub(crate) const LINE_LOADS: Named<LineLoad> =
    &[("full", LineLoad::Full), ("force-only", LineLoad::ForceOnly), ("axis-gap", LineLoad::AxisGap)];
pub(crate) const STARTS: Named<Start> = &[("conformed", Start::Conformed), ("flat", Start::Crests)];
pub(crate) const TERMS: Named<Terms> = &[("all", Terms::All), ("auto", Terms::Auto)];
pub(crate) const SECTIONS: Named<SectionShape> =
    &[("rectangle", SectionShape::Rectangle), ("ellipse", SectionShape::Ellipse)];
pub(crate) const STRETCHES: Named<StretchLaw> = &StretchLaw::NAMED;
pub(crate) const HOLDS: Named<Hold> = &[("free", Hold::Free), ("fixed", Hold::Fixed)];
pub(crate) const ENDS: Named<FollowedUntil> = &FollowedUntil::NAMED;

/// The adhesion models that a scene may name; that of a table has its rows under a key of its own.
fn attractions() -> Vec<Attraction> {
    Attraction::all().chain([measured(&TractionTable::default())]).collect()
}

/// The law of a table.
pub(crate) fn measured(table: &TractionTable) -> Attraction {
    Attraction::Cohesive(CohesiveShape::Measured(Measured::through(table)))
}

/// The adhesion model of a scene.
pub(crate) static LAW: Choice = Choice {
    words: || attractions().into_iter().map(Attraction::name).collect(),
    example: "\"bilinear\"",
    put: |scene, number| {
        let place = &mut scene.model.adhesion.attraction;
        let chosen = attractions().get(number).copied().filter(|chosen| chosen.name() != place.name());
        if let Some(chosen) = chosen {
            *place = chosen;
            scene.table_texts.law.clear();
        }
    },
    held: |scene| attractions().iter().position(|law| law.name() == scene.model.adhesion.attraction.name()),
};

/// What a key of words takes, and where it goes.
#[derive(Debug)]
pub struct Choice {
    /// The words
    pub words: fn() -> Vec<&'static str>,
    /// A word that is right, in quotes, as it stands in a scene
    pub example: &'static str,
    /// Puts the word with this number into a scene
    pub(crate) put: fn(&mut Scene, usize),
    /// The number of the word that a scene holds
    pub(crate) held: fn(&mut Scene) -> Option<usize>,
}

/// The choice of one of these words with what they mean, for a place of a scene.
macro_rules! choice {
    ($named:expr, $example:literal, $place:expr) => {
        $crate::key::kind::Kind::Word(&$crate::key::choice::Choice {
            words: || $named.iter().map(|(word, _)| *word).collect(),
            example: $example,
            put: |scene, number| {
                let place: fn(&mut $crate::scene::Scene) -> &mut _ = $place;
                if let Some(&(_, chosen)) = $named.get(number) {
                    *place(scene) = chosen;
                }
            },
            held: |scene| {
                let place: fn(&mut $crate::scene::Scene) -> &mut _ = $place;
                $named.iter().position(|(_, choice)| *choice == *place(scene))
            },
        })
    };
}
pub(crate) use choice;

impl Choice {
    /// The word that a scene holds.
    pub(crate) fn word(&self, scene: &mut Scene) -> Option<&'static str> {
        (self.words)().get((self.held)(scene)?).copied()
    }
}

/// All the words, as a sentence lists them.
pub(crate) fn listed(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    match words.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => words.concat(),
    }
}
