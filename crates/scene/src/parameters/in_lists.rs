//! A number of a list as a parameter of the model.

use peelkit::model::PeelModel;
use peelkit::study::{MOST_CHANGED, Variation};

/// Puts a list into a model in which one number is so many times as large; else what is wrong with that list.
type Changed = Box<dyn Fn(&mut PeelModel, f64) -> Result<(), String> + Send + Sync>;

/// A number of a list.
pub(super) struct NumberInList {
    /// The key of the list with the place in it
    pub key: String,
    pub changed: Changed,
}

impl NumberInList {
    /// As a variation in its logarithm; its key and the reason where the list is none with the number changed alone as far as it is for a derivative.
    pub fn into_variation(self, model: &PeelModel) -> Result<Variation<'static>, (String, String)> {
        let wrong = [MOST_CHANGED, -MOST_CHANGED].map(|change| (self.changed)(&mut model.clone(), change.exp()).err());
        if let Some(wrong) = wrong.into_iter().flatten().next() {
            let percent = 100.0 * MOST_CHANGED;
            return Err((self.key, format!("changed alone by {percent} % it makes a list that {wrong}")));
        }
        let model = model.clone();
        Ok(Variation::new(self.key, move |change| {
            let mut model = model.clone();
            // farther than it was tried a list may be none, which the model does not take
            let _ = (self.changed)(&mut model, change.exp());
            model
        }))
    }
}
