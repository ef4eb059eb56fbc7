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
            "is of a contact that resists sliding, and this one has no strength".into(),
            "Give `strength = \"50 MPa\"` beside it under [friction], or leave the table away.",
        ));
    }
    if !model.ground.substrate.is_flat() {
        let found = "is given, and the substrate is not flat; friction is that of flat ground".to_owned();
        return Some(("friction.strength", found, "Leave the table [substrate] or the table [friction] away."));
    }
    if !model.adhesion.attraction.takes_friction() {
        let found = "is given beside a cohesive law; where the face is in contact, friction takes from the half space"
            .to_owned();
        return Some((
            "friction.strength",
            found,
            "Take `law = \"body-force\"` or \"surface-traction\" under [adhesion], or leave the table [friction] away.",
        ));
    }
    if model.grip.pretension.is_some() {
        let found = "is given, and friction holds the strip that it stretches only as far as it can".to_owned();
        return Some(("grip.pretension", found, "Leave `pretension` or the table [friction] away."));
    }
    None
}
