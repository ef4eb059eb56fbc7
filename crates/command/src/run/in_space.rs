//! What a run of a strip that leaves its plane does not offer.

use crate::stop::Stop;
use peelkit_scene::Scene;

/// Refuses an option that is computed in the plane alone, where the solution of the scene does not stay there.
pub fn refuse(scene: &Scene, observed: bool) -> Result<(), Stop> {
    let leaves = scene.model.space.is_some() && scene.model.in_the_plane().is_none();
    match leaves && observed {
        true => Err(Stop::bad_input(
            "--observed is computed in the plane, and the strip of this scene leaves it",
            "Omit --observed, or set drive.azimuth to 0 or 180 degrees for a rectangular section.",
        )),
        false => Ok(()),
    }
}
