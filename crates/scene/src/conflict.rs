//! Keys of a scene that do not fit one another, or that are missing.

use crate::error::{Origin, SceneError, ValueError};
use crate::key::kind::{Key, Kind, Need};
use crate::keys::KEYS;
use crate::scene::Scene;
use crate::studies::{fit, optimise, uncertainty};
use crate::tables::setae::{array, seta};
use crate::tables::{measured, rate, solid};
use std::collections::HashSet;

/// What is wrong with a scene of which every value is right by itself.
pub(crate) struct Conflict {
    /// The key that is wrong or missing: `strip.length`.
    pub key: String,
    /// What is wrong with it.
    pub problem: ValueError,
    /// What is said in the file of a key that is missing there.
    pub missing: Option<Missing>,
}

/// What is said of a key that a file lacks.
pub(crate) struct Missing {
    /// Of the table that lacks it.
    pub in_table: ValueError,
    /// Of the scene that lacks the table.
    pub table: ValueError,
}

/// The table of the adhesion law, and its keys that a cohesive law needs.
const ADHESION: &str = "adhesion";
const OF_LAW: [&str; 2] = ["work", "strength"];

impl Conflict {
    /// The first one of a scene to which these keys were given.
    pub(crate) fn find(scene: &Scene, given: &HashSet<String>) -> Option<Self> {
        let is_given = |key: &&Key| given.contains(&key.path());
        // one that was valid until an override gave the substrate another shape
        if let Some(key) = KEYS.iter().filter(is_given).find(|key| !key.belongs_to(scene)) {
            return Some(Self { key: key.path(), problem: key.foreign(scene), missing: None });
        }
        // a law of a table is nothing without its rows
        let of_table = |key: &&Key| matches!(key.kind, Kind::Tractions(_)) && key.belongs_to(scene);
        if let Some(key) = KEYS.iter().filter(of_table).find(|key| !is_given(key)) {
            return Some(Self::missing(key, given, scene));
        }
        let needed = |key: &&Key| key.need == Need::Required && key.belongs_to(scene);
        if let Some(key) = KEYS.iter().filter(needed).find(|key| !is_given(key)) {
            // a cohesive law is complete with a work and a strength, and needs no half space
            let lacks = |name: &&str| key.table == ADHESION && !given.contains(&format!("{ADHESION}.{name}"));
            let of_law = OF_LAW.into_iter().find(lacks);
            let of_law = of_law.filter(|_| scene.model.adhesion.attraction.takes_work_and_strength());
            let of_law = of_law.and_then(|name| KEYS.iter().find(|key| key.table == ADHESION && key.name == name));
            return Some(Self::missing(of_law.unwrap_or(key), given, scene));
        }
        if let Some(problem) = scene.units_problem([]) {
            return Some(Self { key: "output.units".to_owned(), problem, missing: None });
        }
        if let Some((key, problem)) = array::problem(scene)
            .or_else(|| seta::problem(scene))
            .or_else(|| rate::problem(scene))
            .or_else(|| solid::problem(scene))
            .or_else(|| measured::problem(scene))
        {
            return Some(Self { key, problem, missing: None });
        }
        let Err(error) = scene.check() else {
            let of_fit = fit::conflict(scene).map(|problem| ("fit.parameters".to_owned(), problem));
            let of_curves = || fit::curves_conflict(scene).map(|problem| ("fit.curves".to_owned(), problem));
            let of_questions = of_fit.or_else(of_curves).or_else(|| optimise::problem(scene));
            let (key, problem) = of_questions.or_else(|| uncertainty::problem(scene))?;
            return Some(Self { key, problem, missing: None });
        };
        Some(Self { key: error.key().to_owned(), problem: error.into(), missing: None })
    }

    /// That a scene lacks a key, beside these.
    fn missing(key: &Key, given: &HashSet<String>, scene: &Scene) -> Self {
        // of two of which one is wanted the first is shown
        let needed = |other: &Key| other.need == Need::Required && !matches!(other.kind, Kind::Pieces(_));
        let of_law = |other: &Key| OF_LAW.contains(&other.name);
        let shown = |other: &&Key| {
            if matches!(key.kind, Kind::Tractions(_)) {
                return other.path() == key.path();
            }
            let is_meant = if key.need == Need::Required { needed(other) } else { of_law(other) };
            other.table == key.table && is_meant && other.belongs_to(scene)
        };
        let wanted: Vec<&Key> = KEYS.iter().filter(shown).filter(|other| !given.contains(&other.path())).collect();
        let lines: Vec<String> = wanted.iter().map(|other| other.example_line()).collect();
        let lines = lines.join(", ");
        let instead = key.alternative().map(|other| format!(" or `{other}` instead")).unwrap_or_default();
        let (name, table, about) = (key.name, key.table, key.about);
        let sets: Vec<String> =
            wanted.iter().map(|other| format!("--set {}={}", other.path(), other.example())).collect();
        let all = match key.shapes() {
            shapes if shapes.is_empty() => String::new(),
            _ => format!(" by `shape` = \"{}\"", scene.model.ground.substrate.name()),
        };
        Self {
            key: key.path(),
            problem: ValueError::new(
                format!("is required{all}, and is not given"),
                format!("It is the {about}. Add for example {}", sets.join(" ")),
            ),
            missing: Some(Missing {
                in_table: ValueError::new(
                    format!("lacks `{name}`{instead}"),
                    format!("`{name}` is the {about}. Add for example {lines}"),
                ),
                table: ValueError::new(
                    format!("lacks the table [{table}]"),
                    format!("Add a line [{table}] and below it for example {lines}"),
                ),
            }),
        }
    }

    /// The message about the override from which it comes.
    pub(crate) fn of_override(self, path: &str, value: &str) -> SceneError {
        let text = format!("{path}={value}");
        Origin::Override { text: &text }.error(0..text.len(), &format!("`{}`", self.key), self.problem)
    }
}

#[cfg(test)]
mod tests {
    use crate::key::kind::{Key, Kind};
    use crate::keys::{KEYS, find_key};
    use peelkit::model::{MODEL_NUMBERS, Range};
    use peelkit::study::ACCURACY_NUMBERS;

    /// The range of a key that takes one number.
    fn range(key: &Key) -> Option<Range> {
        match key.kind {
            Kind::Number(range, _) | Kind::Share(range, _) | Kind::Measure(_, range, _) => Some(range),
            Kind::Quantity(..) | Kind::Bound(..) => Some(Range::Positive),
            Kind::Count(most, _) | Kind::Fixed(most, _) => Some(Range::From(1.0, most as f64)),
            _ => None,
        }
    }

    /// A scene refuses what the model refuses and nothing else, by the same name and in the same unit; the number of elements alone
    /// may be larger in a program. A seta, an array of them, a solid and a pull at a rate check their own numbers.
    #[test]
    fn the_numbers_of_a_scene_are_those_of_the_model() {
        let model = MODEL_NUMBERS.iter().map(|number| (number.key, number.unit, number.range));
        let accuracy = ACCURACY_NUMBERS.iter().map(|number| (number.key, number.unit, number.range));
        let checked: Vec<_> = model.chain(accuracy).collect();
        for &(path, unit, allowed) in &checked {
            let key = find_key(path).unwrap();
            assert_eq!((key.unit(), path), (unit, path));
            if path != "accuracy.elements" {
                assert_eq!((range(key), path), (Some(allowed), path));
            }
        }
        for key in KEYS.iter().filter(|key| {
            range(key).is_some()
                && !["bounds", "fit", "lamella", "patch", "seta", "setae", "solid", "time", "toe"].contains(&key.table)
        }) {
            assert!(checked.iter().any(|&(path, ..)| path == key.path()), "{} is not checked", key.path());
        }
    }
}
