//! What a scene peels: one of several bodies, each a table.

use super::scene::{Scene, UNKNOWN_STRIP};
use peelkit::beam::Material;
use peelkit::model::{Body, Profile, ProfileForm, ProfileTable, Spatula, Strip};

/// The tables of which a scene has one: what is peeled.
pub const BODIES: [&str; 3] = ["strip", "spatula", "profile"];

/// The table of what this scene peels.
pub fn body_of(scene: &Scene) -> &'static str {
    scene.model.body.geometry().name()
}

/// Makes the scene one of the body of this table, if it is none.
pub(crate) fn set_body(scene: &mut Scene, table: &str) {
    match BODIES.iter().position(|&body| body == table) {
        Some(0) => drop(strip(scene)),
        Some(1) => drop(spatula(scene)),
        Some(_) => drop(profile(scene)),
        None => {}
    }
}

/// The body of one kind, which the scene is given where it has another.
macro_rules! body {
    ($name:ident, $kind:ident, $new:expr) => {
        pub(crate) fn $name(scene: &mut Scene) -> &mut $kind {
            if !matches!(scene.model.body, Body::$kind(_)) {
                scene.model.body = Body::$kind($new);
            }
            match &mut scene.model.body {
                Body::$kind(body) => body,
                _ => unreachable!("the body has just been set"),
            }
        }
    };
}
body!(strip, Strip, UNKNOWN_STRIP);
body!(spatula, Spatula, Spatula::default());
body!(profile, Profile, {
    let material = Material { youngs_modulus: f64::NAN, ..Spatula::default().material };
    Profile { form: ProfileForm::Table(ProfileTable::default()), material }
});
