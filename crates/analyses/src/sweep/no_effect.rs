//! A sweep that would change nothing: refused where that is known before, and said where it is seen.

use super::cases::Cases;
use crate::outcome::Refusal;
use peelkit::model::{Body, Spatula};
use peelkit_report::{SweepRow, SweptKeys};
use peelkit_scene::{Key, Scene};

/// Refuses a key that no result of this scene depends on.
pub fn refuse(scene: &Scene, cases: &Cases) -> Result<(), Refusal> {
    cases.keys.keys().try_for_each(|key| {
        let refused =
            |(why, remedy)| Err(Refusal::asked(format!("--vary {} would change no result: {why}", key.path()), remedy));
        why_none(scene, key).map_or(Ok(()), refused)
    })
}

/// Why no result of this scene depends on the key, and what to do, if none does.
fn why_none(scene: &Scene, key: &Key) -> Option<(&'static str, &'static str)> {
    let model = &scene.model;
    match key.path().as_str() {
        _ if key.table == "fit" => Some((
            "only peel fit reads the table [fit]",
            "Vary a key of the body, its adhesion, its grip or its loading.",
        )),
        "grip.stiffness" => Some((
            "only the displacement-controlled test uses the spring of the machine, and a sweep has none",
            "Use peel run --observed with --set grip.stiffness=... for each value.",
        )),
        "adhesion.hamaker_constant" if model.adhesion.needs_no_hamaker_constant() => Some((
            "the cohesive law of this scene has a work of adhesion and a strength of its own",
            "Vary adhesion.work or adhesion.strength, or remove one of them from the scene.",
        )),
        "spatula.tip_rounding_width" if matches!(&model.body, Body::Spatula(spatula) if is_blunt(spatula)) => Some((
            "the tip of this spatula is blunt, tip_rounding_length is 0",
            "Add --set spatula.tip_rounding_length=\"50 nm\", or vary spatula.tip_width.",
        )),
        _ => None,
    }
}

fn is_blunt(spatula: &Spatula) -> bool {
    spatula.tip_rounding_length == 0.0
}

/// That all values of a sweep gave the same results, if they did.
pub fn seen(keys: SweptKeys, rows: &[SweepRow]) -> Option<String> {
    let (first, others) = rows.split_first()?;
    let alike = |row: &SweepRow| row.found.work.is_some() && row.found == first.found;
    of_alike(keys, rows.len(), !others.is_empty() && others.iter().all(alike))
}

/// That so many values gave the same results, if they did.
pub fn of_alike(keys: SweptKeys, values: usize, alike: bool) -> Option<String> {
    let have = if keys.second.is_some() { "have" } else { "has" };
    alike.then(|| {
        format!("{} {have} no effect here: all {values} values give the same results, to the last digit", keys.names())
    })
}
