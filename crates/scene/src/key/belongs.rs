//! Which keys a scene may hold, and what is said of the others.

use super::kind::{Key, Kind};
use super::table::{ADHESION, SETA, SETAE, SOLID, STRIP, SUBSTRATE};
use crate::body::{BODIES, body_of, shape_has, shapes_with, solids_with};
use crate::error::ValueError;
use crate::scene::Scene;
use peelkit::model::{Body, ProfileForm};

/// Why a scene may not hold a key.
enum Misfit {
    /// It has a seta, which has no such key.
    BesideSeta,
    /// It has an array of setae, which has no such key.
    BesideArray,
    /// It does not have the table.
    NoTable,
    /// It is in the plane.
    InPlane,
    /// Its substrate has another shape.
    Shape,
    /// It is computed as a solid, of another body.
    OfSolid,
    /// Its law of adhesion is another.
    Law,
    /// It follows from the table of the law.
    OfTable,
    /// It follows from another key of its table.
    Follows(&'static str),
    /// Its beam, or its seta, has another key in place of this one.
    Beside(&'static str, &'static str),
}

impl Key {
    /// Whether it may stand in this scene: one of a body that the scene does not peel may not, nor one of a substrate of another
    /// shape, nor one of space in the plane.
    pub fn belongs_to(&self, scene: &Scene) -> bool {
        self.misfit(scene).is_none()
    }

    fn misfit(&self, scene: &Scene) -> Option<Misfit> {
        if scene.array.is_some() && !self.of.stands_beside_setae(self.name) {
            return Some(Misfit::BesideArray);
        }
        if scene.seta.is_some() && !self.of.beside_seta.has(self.name) {
            return Some(Misfit::BesideSeta);
        }
        if !(self.of.is_in)(scene) {
            return Some(Misfit::NoTable);
        }
        if self.is_of_space() && scene.model.space.is_none() {
            return Some(Misfit::InPlane);
        }
        if self.table == SUBSTRATE.name && !shape_has(&scene.model.ground.substrate, self.name) {
            return Some(Misfit::Shape);
        }
        if self.table == SOLID.name && !solids_with(self.name).contains(&body_of(scene)) {
            return Some(Misfit::OfSolid);
        }
        if follows_from_law(scene, self) {
            return Some(Misfit::Follows("law"));
        }
        if scene.model.has_layers() && self.table == STRIP.name && BY_LAYERS.contains(&self.name) {
            return Some(Misfit::Follows("layers"));
        }
        if self.table == SETA.name
            && let Some(other) = in_place_of(scene, self.name)
        {
            return Some(Misfit::Beside(other, "seta"));
        }
        let law = scene.model.adhesion.attraction;
        match (self.table == ADHESION.name, &self.kind) {
            (true, Kind::Tractions(_)) if law.table().is_none() => return Some(Misfit::Law),
            (true, _) if law.table().is_some() && ["work", "strength"].contains(&self.name) => {
                return Some(Misfit::OfTable);
            }
            _ => {}
        }
        // a profile takes a table or pieces, and not both
        let Body::Profile(profile) = &scene.model.body else { return None };
        match (&self.kind, &profile.form) {
            (Kind::Table(_), ProfileForm::Pieces(_)) => Some(Misfit::Beside("pieces", "beam")),
            (Kind::Pieces(_), ProfileForm::Table(_)) if !scene.table_texts.profile.is_empty() => {
                Some(Misfit::Beside("table", "beam"))
            }
            _ => None,
        }
    }

    /// The key of its table that a scene may hold in its place.
    pub fn alternative(&self) -> Option<&'static str> {
        match self.kind {
            Kind::Table(_) => Some("pieces"),
            Kind::Pieces(_) => Some("table"),
            _ => None,
        }
    }

    /// The shapes of a substrate that have it, where it is a key of one.
    pub fn shapes(&self) -> Vec<&'static str> {
        if self.table == SUBSTRATE.name { shapes_with(self.name) } else { Vec::new() }
    }

    /// That it may not stand in this scene, and what to do.
    pub fn foreign(&self, scene: &Scene) -> ValueError {
        let (table, name) = (self.table, self.name);
        match self.misfit(scene).unwrap_or(Misfit::NoTable) {
            Misfit::BesideSeta => ValueError::new(
                "is given, and the scene has a [seta], which has no such key",
                format!(
                    "Remove `{name}`: beside [seta] stand the table of its tips, [adhesion], `angle`, `azimuth` and `steps` of [drive], `relative` and `order` of [accuracy], [output], [bounds], [fit], [optimise], [uncertainty], and [time] without `held`.",
                ),
            ),
            Misfit::BesideArray => ValueError::new(
                "is given, and the scene has [setae], an array, which has no such key",
                format!(
                    "Remove `{name}`: beside [setae] stand [patch], [lamella], [toe], `angle` of [drive], `time` of [bounds], `units` of [output], [optimise] and [uncertainty]."
                ),
            ),
            Misfit::NoTable if BODIES.contains(&table) => ValueError::new(
                format!("is a key of [{table}], and the scene peels a [{}]", body_of(scene)),
                format!(
                    "A scene has one of the tables [{}]; a [seta] may stand beside a [spatula].",
                    BODIES.join("], [")
                ),
            ),
            Misfit::NoTable => {
                let example = if table == SETA.name { "; scenes/seta.toml is one with a seta" } else { "" };
                ValueError::new(
                    format!("is a key of [{table}], a table that the scene does not have"),
                    format!("Add the table [{table}] to the scene{example}."),
                )
            }
            Misfit::InPlane => ValueError::new(
                "is a key of a scene in space, and this scene has `space` = false",
                format!("Write `space = true`, or remove `{name}`."),
            ),
            Misfit::Shape => {
                let substrate = &scene.model.ground.substrate;
                let (word, own) = (substrate.name(), substrate.keys());
                let own = if own.is_empty() { "no other keys".into() } else { format!("the keys {}", own.join(", ")) };
                let shapes = shapes_with(name).join("\" or \"");
                ValueError::new(
                    format!("is a key of [substrate] for another `shape` than \"{word}\""),
                    format!("It belongs to shape \"{shapes}\"; \"{word}\" has {own}."),
                )
            }
            Misfit::OfSolid => ValueError::new(
                format!(
                    "is a key of [solid] for a {}, and the scene peels a [{}]",
                    solids_with(name).join(" or "),
                    body_of(scene)
                ),
                format!("Remove `{name}`."),
            ),
            Misfit::Law => ValueError::new(
                format!(
                    "is a key of [adhesion] for `law` = \"table\", and the law is \"{}\"",
                    scene.model.adhesion.attraction.name()
                ),
                format!("Write `law = \"table\"`, or remove `{name}`."),
            ),
            Misfit::OfTable => ValueError::new(
                "is given beside `law` = \"table\", from whose rows it follows",
                format!("Remove `{name}`, or use another `law`."),
            ),
            Misfit::Follows(other) => ValueError::new(
                format!("is given beside `{other}`, from which it follows"),
                format!("Remove `{name}`, or `{other}`."),
            ),
            Misfit::Beside(other, body) => ValueError::new(
                format!("is given beside `{table}.{other}`, and the {body} has one geometry"),
                format!("Remove one of `{name}` and `{other}`."),
            ),
        }
    }
}

/// Keys of `strip` which its layers give.
pub(crate) const BY_LAYERS: [&str; 5] =
    ["height", "youngs_modulus", "poissons_ratio", "shear_correction", "bending_stiffness_factor"];

// -- Lists of a seta, and its tree, in place of other keys --

/// Keys of `seta` whose place a tree takes.
const OF_LEVELS: [&str; 13] = [
    "forks",
    "branches",
    "tip_pitch",
    "shaft_length",
    "shaft_angle",
    "shaft_diameter",
    "diameters",
    "brush_height",
    "fork_heights",
    "brush_angle",
    "height_ratio",
    "diameter_ratio",
    "height_scatter",
];
/// Those whose place lists take.
const OF_BRANCHES: [&str; 1] = ["forks"];
const OF_HEIGHTS: [&str; 2] = ["brush_height", "height_ratio"];
const OF_DIAMETERS: [&str; 2] = ["shaft_diameter", "diameter_ratio"];

/// The key of the seta of a scene that stands in place of the one with this name, if one does.
pub(crate) fn in_place_of(scene: &Scene, name: &str) -> Option<&'static str> {
    let seta = &scene.seta.as_ref()?.seta;
    let lists: [(&str, bool, &[&str]); 4] = [
        ("tree", seta.tree.is_some(), &OF_LEVELS),
        ("branches", !seta.branches.is_empty(), &OF_BRANCHES),
        ("fork_heights", !seta.fork_heights.is_empty(), &OF_HEIGHTS),
        ("diameters", !seta.diameters.is_empty(), &OF_DIAMETERS),
    ];
    lists.into_iter().find(|(_, is_given, names)| *is_given && names.contains(&name)).map(|(key, ..)| key)
}

// -- The law of setae in place of its numbers --

/// Keys that say by numbers what `law` says by a potential.
const BY_NUMBERS: [&str; 5] = ["stiffness", "tangential_stiffness", "reach", "last_reach", "exit_angle"];

/// Whether a key of the setae says by a number what the law of the scene has.
fn follows_from_law(scene: &Scene, key: &Key) -> bool {
    let has_law = scene.array.as_ref().is_some_and(|table| table.fitted.is_some());
    has_law && key.table == SETAE.name && BY_NUMBERS.contains(&key.name)
}
