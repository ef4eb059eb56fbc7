//! What of a scene's friction does not fit the rest.

use peelkit::model::PeelModel;

/// The key, what was found, and what would be right.
pub(super) fn misfit(model: &PeelModel) -> Option<(&'static str, String, &'static str)> {
    let friction = &model.friction;
    if friction.strength.is_none() {
        let given = [
            ("friction.coefficient", friction.coefficient > 0.0),
            ("friction.presliding", friction.presliding.is_some()),
        ];
        let (path, _) = given.into_iter().find(|(_, given)| *given)?;
        return Some((
            path,
            "belongs to a contact with friction, and this one has no strength".into(),
            "Give `strength = \"50 MPa\"` beside it under [friction], or remove the table.",
        ));
    }
    if !model.ground.substrate.is_flat() {
        let found = "is given, and the substrate is not flat; friction requires a flat substrate".to_owned();
        return Some(("friction.strength", found, "Remove the table [substrate] or the table [friction]."));
    }
    if !model.adhesion.attraction.takes_friction() {
        let found = "is given beside a cohesive law; friction requires a half-space law, which defines where the face is in contact"
            .to_owned();
        return Some((
            "friction.strength",
            found,
            "Use `law = \"body-force\"` or \"surface-traction\" under [adhesion], or remove the table [friction].",
        ));
    }
    if model.grip.pretension.is_some() {
        let found = "is given, and friction cannot hold the stretched strip up to an arbitrary tension".to_owned();
        return Some(("grip.pretension", found, "Remove `pretension` or the table [friction]."));
    }
    None
}
