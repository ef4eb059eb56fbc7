//! What peels of solids have in common: the path of the strip of a scene.

use peelkit::model::{SolidError, SolidSettings};
use peelkit::study::{SolidOptions, SolidPeel, StopCriteria, peel_solid};
use peelkit_scene::Scene;

/// The peel of the strip of a scene on these settings, with the stations that the scene asks for.
pub fn peeled(scene: &Scene, settings: &SolidSettings, stop: StopCriteria) -> Result<SolidPeel, SolidError> {
    let usual = SolidOptions::default();
    let stations = scene.stations.iter().map(|at| at.value).collect();
    let step = scene.accuracy.choice.step.unwrap_or(usual.step);
    peel_solid(&scene.model, settings, &SolidOptions { stop, stations, step, ..usual })
}
