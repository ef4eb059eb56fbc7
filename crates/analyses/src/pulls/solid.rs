//! What peels of solids have in common: the path of the strip of a scene.

use peelkit::model::SolidError;
use peelkit::study::{SolidOptions, SolidPeel, StopCriteria, peel_solid};
use peelkit_scene::{Scene, SolidTable};

/// The peel of the strip of a scene as the solid of its table.
pub fn peeled(scene: &Scene, table: &SolidTable, stop: StopCriteria) -> Result<SolidPeel, SolidError> {
    let usual = SolidOptions::default();
    let step = scene.accuracy.choice.step.unwrap_or(usual.step);
    peel_solid(&scene.model, &scene.solid_settings(table), &SolidOptions { stop, step, ..usual })
}
