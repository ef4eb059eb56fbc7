//! What a scene peels: one of several bodies, in the plane or in space, on ground of one of several shapes.

use crate::scene::{Scene, UNKNOWN_STRIP};
use peelkit::adhesion::Substrate;
use peelkit::beam::Material;
use peelkit::model::{Body, Profile, ProfileForm, ProfileTable, Space, Spatula, Strip};

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

/// What the scene has besides one in the plane, which it is from now on not.
pub(crate) fn space(scene: &mut Scene) -> &mut Space {
    scene.model.space.get_or_insert_default()
}

/// Makes it one in space or in the plane.
pub(crate) fn set_space(scene: &mut Scene, in_space: bool) {
    scene.model.space = in_space.then(|| scene.model.space.unwrap_or_default());
}

/// What the scene's body lies on.
pub(crate) fn substrate(scene: &mut Scene) -> &mut Substrate {
    &mut scene.model.ground.substrate
}

/// What a scene may call the shape.
pub(crate) fn shape_names() -> Vec<&'static str> {
    Substrate::all().into_iter().map(|(name, _)| name).collect()
}

/// Whether a substrate of this shape has a key of this name.
pub(crate) fn shape_has(substrate: &Substrate, name: &str) -> bool {
    name == "shape" || substrate.keys().contains(&name)
}

/// The shapes that have a key of this name, as a scene calls them.
pub(crate) fn shapes_with(name: &str) -> Vec<&'static str> {
    Substrate::all().iter().filter(|(_, substrate)| shape_has(substrate, name)).map(|(word, _)| *word).collect()
}

/// The number of this key; a substrate that has none becomes the first shape that has one.
pub(crate) fn number_of_shape<'a>(substrate: &'a mut Substrate, name: &str) -> &'a mut f64 {
    if substrate.number(name).is_none() {
        let shapes = Substrate::all().into_iter();
        shapes.filter(|(_, shape)| shape_has(shape, name)).take(1).for_each(|(_, shape)| *substrate = shape);
    }
    substrate
        .number(name)
        .expect("KEYS asks for the numbers of shapes alone, and the shape has just become one that has it")
}

// -- Keys of the table `solid`: the one that a body in space alone has, and the one that it has like a strip --

const IN_SPACE: &str = "across";
const OF_ALL: &str = "along";

/// The bodies that have a key of the table `solid`.
pub(crate) fn solids_with(key: &str) -> &'static [&'static str] {
    match key {
        OF_ALL => &["strip", "spatula", "profile"],
        IN_SPACE => &["spatula", "profile"],
        _ => &["strip"],
    }
}
