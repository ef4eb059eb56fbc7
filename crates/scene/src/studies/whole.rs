//! Whether a scene can be computed as a whole, whatever it describes, and whether a run of it has a number.

use crate::error::ValueError;
use crate::scene::Scene;
use crate::tables::rate;
use crate::tables::setae::seta;
use peelkit::study::PeelQuantity;

impl Scene {
    /// As [`Scene::check`], with what a seta and a pull at a rate need besides: what is wrong, with the key in front.
    pub fn check_whole(&self) -> Result<(), ValueError> {
        if let Some((key, problem)) = seta::problem(self).or_else(|| rate::problem(self)) {
            return Err(ValueError::new(format!("`{key}` {}", problem.found), problem.remedy));
        }
        self.check().map_err(|error| ValueError::new(format!("`{}` {}", error.key(), error.found()), error.remedy()))
    }
}

/// That a run of a scene does not have a number; nothing where it has.
pub(super) fn has_no(scene: &Scene, of: PeelQuantity) -> Option<ValueError> {
    let (own, subject) = (scene.describes().quantities(), scene.describes().words());
    let names: Vec<&str> = own.iter().map(|of| of.name()).collect();
    let found = format!("names \"{}\", which {subject} does not have", of.name());
    (!own.contains(&of)).then(|| ValueError::new(found, format!("Of {subject} there are {}.", names.join(", "))))
}
