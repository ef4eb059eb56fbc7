//! What peels of solids have in common: the path of the body of a scene.

use peelkit::model::SolidError;
use peelkit::study::{Checkpoint, SolidOptions, SolidPeel, StopCriteria, peel_solid_on};
use peelkit_scene::{Scene, SolidTable};

/// The peel of the body of a scene as the solid of its table.
pub fn peeled(scene: &Scene, table: &SolidTable, stop: StopCriteria) -> Result<SolidPeel, SolidError> {
    peeled_on(scene, table, stop, &Checkpoint::NOTHING)
}

/// The same, which goes on from an earlier run.
pub fn peeled_on(
    scene: &Scene,
    table: &SolidTable,
    stop: StopCriteria,
    checkpoint: &Checkpoint,
) -> Result<SolidPeel, SolidError> {
    let options = SolidOptions { stop, step: scene.accuracy.choice.step, ..SolidOptions::default() };
    peel_solid_on(&scene.model, &scene.solid_settings(table), &options, checkpoint)
}
