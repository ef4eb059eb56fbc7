//! What a table of a tip cannot be made of.

use super::error::CoarseningError;
use crate::model::peel::PeelModel;

/// Refuses it.
pub(super) fn refuse(model: &PeelModel) -> Result<(), CoarseningError> {
    let refused = |what: &'static str, remedy: &'static str| Err(CoarseningError::Refused { what, remedy });
    if model.space.is_some() {
        return refused("the scene is in space, and a tip is coarsened in its plane", "Remove the table [space]");
    }
    if !model.ground.substrate.is_flat() {
        return refused(
            "the substrate is not flat, and a tip may adhere anywhere on it",
            "Remove the table [substrate]",
        );
    }
    if model.friction_law().is_some() {
        return refused(
            "with friction the force depends on how the pad has slid, and not on where its end is alone",
            "Remove the table [friction]; grip.horizontal = \"fixed\" holds the free end of the pad",
        );
    }
    if !model.line_law().has_potential() {
        return refused(
            "the line load has no potential, and the table is one of an energy",
            "Give adhesion.line_load = \"full\" or \"axis-gap\"",
        );
    }
    if !model.steps.is_empty() {
        return refused(
            "the grip takes steps before the pull, and the end of a tip is held anywhere",
            "Remove drive.steps",
        );
    }
    if model.grip.stiffness.is_some() || model.grip.pretension.is_some() {
        return refused(
            "the grip has a spring or a pretension, and a table is that of the spatula alone",
            "Remove grip.stiffness and grip.pretension",
        );
    }
    Ok(())
}
