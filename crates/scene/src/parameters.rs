//! The numbers of a scene that results can be differentiated by.

use crate::key::Key;
use crate::keys::KEYS;
use crate::scene::Scene;
use crate::value::Value;
use peelkit::model::{Body, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable};
use peelkit::study::Variation;

/// Tables whose numbers describe no beam but its computation.
const NOT_OF_THE_MODEL: [&str; 2] = ["accuracy", "bounds"];
/// By how much the logarithm of a number is changed to see whether the model depends on it.
const TRIED: f64 = 1e-4;

impl Scene {
    /// Every number of the scene that its model depends on and that is not zero, as a variation in its logarithm: given or left at its default, and of a
    /// profile by a table its widths and heights, row by row. Numbers in lists of pieces and steps are not among them.
    pub fn variations(&self) -> Vec<Variation<'static>> {
        let numbers = KEYS.iter().filter(|key| key.is_numeric() && !key.is_count() && key.belongs_to(self));
        let numbers = numbers.filter(|key| !NOT_OF_THE_MODEL.contains(&key.table));
        let mut found: Vec<Variation<'static>> = numbers.filter_map(|key| self.variation(key)).collect();
        found.extend(self.of_the_table());
        found.retain(|variation| (variation.model)(TRIED) != self.model);
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

    /// Widths and heights of the rows of a table.
    fn of_the_table(&self) -> Vec<Variation<'static>> {
        let Body::Profile(Profile { form: ProfileForm::Table(table), .. }) = &self.model.body else {
            return Vec::new();
        };
        let columns = table.columns();
        let rows = columns.places.len();
        let column = |name: &'static str, of: fn(&mut ProfileColumns) -> &mut Vec<f64>| {
            let (columns, model) = (columns.clone(), self.model.clone());
            (0..rows).map(move |row| {
                let (columns, model) = (columns.clone(), model.clone());
                Variation::new(format!("profile.table.{name}[{}]", row + 1), move |change| {
                    let mut columns = columns.clone();
                    of(&mut columns)[row] *= change.exp();
                    with_table(&model, columns)
                })
            })
        };
        let [_, width, height, ..] = ProfileTable::COLUMNS;
        column(width, |columns| &mut columns.widths).chain(column(height, |columns| &mut columns.heights)).collect()
    }
}

/// A model with another table of its profile.
fn with_table(model: &PeelModel, columns: ProfileColumns) -> PeelModel {
    let mut model = model.clone();
    if let (Body::Profile(profile), Ok(table)) = (&mut model.body, ProfileTable::new(columns)) {
        profile.form = ProfileForm::Table(table);
    }
    model
}
