//! The numbers of a scene that results can be differentiated by.

mod in_lists;
mod pieces;
mod steps;
mod table;

use super::key::Key;
use super::keys::KEYS;
use super::scene::Scene;
use super::value::Value;
use peelkit::study::Variation;

/// Tables whose numbers describe no beam but its computation.
const NOT_OF_THE_MODEL: [&str; 2] = ["accuracy", "bounds"];
/// By how much the logarithm of a number is changed to see whether the model depends on it.
const TRIED: f64 = 1e-4;

/// The numbers of a scene as parameters of its model.
#[derive(Default)]
pub struct Parameters {
    /// Each in its logarithm
    pub variations: Vec<Variation<'static>>,
    /// Those that cannot change alone, by what each is called, with the reason
    pub fixed: Vec<(String, String)>,
}

impl Scene {
    /// Every number of the scene that its model depends on and that is not zero, as a variation in its logarithm: given or left at its default. Of
    /// a list each number by its place, counted from 1: `profile.table.width_nm[3]`, `profile.pieces[2].length`, `profile.pieces[2].height[1]` for
    /// the first of two values, `drive.steps[1]`.
    pub fn parameters(&self) -> Parameters {
        let numbers = KEYS.iter().filter(|key| key.is_numeric() && !key.is_count() && key.belongs_to(self));
        let numbers = numbers.filter(|key| !NOT_OF_THE_MODEL.contains(&key.table));
        let mut found =
            Parameters { variations: numbers.filter_map(|key| self.variation(key)).collect(), fixed: vec![] };
        let lists = [table::numbers(&self.model), pieces::numbers(&self.model), steps::numbers(&self.model)];
        for number in lists.into_iter().flatten() {
            match number.into_variation(&self.model) {
                Ok(variation) => found.variations.push(variation),
                Err(fixed) => found.fixed.push(fixed),
            }
        }
        found.variations.retain(|variation| (variation.model)(TRIED) != self.model);
        found
    }

    /// The number of one key as a variation in its logarithm; nothing where it is not set or zero.
    pub fn variation(&self, key: &'static Key) -> Option<Variation<'static>> {
        let Some(Value::Number(number)) = key.value(self) else { return None };
        if number == 0.0 || !number.is_finite() {
            return None;
        }
        let scene = self.clone();
        Some(Variation::new(key.path(), move |change| {
            let mut scene = scene.clone();
            // a number out of its range is for the check of the model to refuse
            key.put_number(&mut scene, number * change.exp());
            scene.model
        }))
    }
}
