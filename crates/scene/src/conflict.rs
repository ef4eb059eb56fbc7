//! Keys of a scene that do not fit one another, or that are missing.

use super::error::{Origin, SceneError, ValueError};
use super::key::Key;
use super::key::kind::{Kind, Need};
use super::keys::KEYS;
use super::scene::Scene;
use super::tables::{fit, optimisation, rate, seta, uncertainty};
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
        let needed = |key: &&Key| key.need == Need::Required && key.belongs_to(scene);
        if let Some(key) = KEYS.iter().filter(needed).find(|key| !is_given(key)) {
            // a cohesive law is complete with a work and a strength, and needs no half space
            let lacks = |name: &&str| key.table == ADHESION && !given.contains(&format!("{ADHESION}.{name}"));
            let of_law = OF_LAW.into_iter().find(lacks);
            let of_law = of_law.filter(|_| scene.model.adhesion.attraction.takes_work_and_strength());
            let of_law = of_law.and_then(|name| KEYS.iter().find(|key| key.table == ADHESION && key.name == name));
            return Some(Self::missing(of_law.unwrap_or(key), given, scene));
        }
        if let Some((key, problem)) = seta::problem(scene).or_else(|| rate::problem(scene)) {
            return Some(Self { key, problem, missing: None });
        }
        let Err(error) = scene.check() else {
            let of_fit = fit::conflict(scene).map(|problem| ("fit.parameters".to_owned(), problem));
            let of_questions = of_fit.or_else(|| optimisation::check::problem(scene));
            let (key, problem) = of_questions.or_else(|| uncertainty::check::problem(scene))?;
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
