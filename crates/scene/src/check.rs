//! Whether the values of a scene can be computed, which the model and the accuracy say themselves.

use super::error::ValueError;
use super::scene::Scene;
use super::tables::{rate, seta};
use peelkit::model::ModelError;
use peelkit::study;
use peelkit::study::PeelQuantity;

impl Scene {
    /// Whether values fit one another that are right by themselves: else the key that does not, and why.
    pub fn check(&self) -> Result<(), ModelError> {
        match self.seta {
            None => study::checked(&self.model, &self.accuracy),
            Some(_) => study::checked(&self.tip_model(), &self.accuracy),
        }
    }

    /// The same, with what a seta and a pull at a rate need besides: what is wrong, with the key in front.
    pub fn check_whole(&self) -> Result<(), ValueError> {
        if let Some((key, problem)) = seta::problem(self).or_else(|| rate::problem(self)) {
            return Err(ValueError::new(format!("`{key}` {}", problem.found), problem.remedy));
        }
        self.check().map_err(|error| ValueError::new(format!("`{}` {}", error.key(), error.found()), error.remedy()))
    }

    /// The numbers that a run of the scene has, and in words what has them.
    pub(crate) fn quantities(&self) -> (&'static [PeelQuantity], &'static str) {
        match (&self.time, &self.seta) {
            (Some(_), _) => (&PeelQuantity::AT_A_RATE, "a pull at a rate"),
            (None, Some(_)) => (&PeelQuantity::OF_A_SETA, "the pull-off of a seta"),
            (None, None) => (&PeelQuantity::OF_A_PEEL, "a peel"),
        }
    }
}

/// That a run of a scene does not have a number; nothing where it has.
pub(crate) fn has_no(scene: &Scene, of: PeelQuantity) -> Option<ValueError> {
    let (own, subject) = scene.quantities();
    let names: Vec<&str> = own.iter().map(|of| of.name()).collect();
    let found = format!("names \"{}\", which {subject} does not have", of.name());
    (!own.contains(&of)).then(|| ValueError::new(found, format!("Of {subject} there are {}.", names.join(", "))))
}

impl From<ModelError> for ValueError {
    fn from(error: ModelError) -> Self {
        Self::new(error.found(), error.remedy())
    }
}

#[cfg(test)]
mod tests {
    use crate::key::Key;
    use crate::key::kind::Kind;
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
    /// may be larger in a program. A seta and a pull at a rate check their own numbers.
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
        for key in
            KEYS.iter().filter(|key| range(key).is_some() && !["bounds", "fit", "seta", "time"].contains(&key.table))
        {
            assert!(checked.iter().any(|&(path, ..)| path == key.path()), "{} is not checked", key.path());
        }
    }
}
