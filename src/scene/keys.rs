//! The keys of a scene: one line each. The parser, `--set`, `--vary`, the help and the summary all read this list.

use super::error::Problem;
use super::key::{Key, Kind, Need, Range};
use super::near::nearest;
use super::quantity::Dimension::{Energy, Length, Pressure, Stiffness, Time};
use Need::{Optional, Required};

const fn key(table: &'static str, name: &'static str, need: Need, kind: Kind, about: &'static str) -> Key {
    Key { table, name, need, kind, about }
}

/// Every key that a scene may hold, in the order in which a scene is written.
#[rustfmt::skip]
pub static KEYS: &[Key] = &[
    key("", "title", Optional, Kind::Text(|s| &mut s.title), "what the pictures and tables are headed with"),

    key("strip", "length", Required, Kind::Quantity(Length, |s| &mut s.model.strip.length), "length L of the strip"),
    key("strip", "height", Required, Kind::Quantity(Length, |s| &mut s.model.strip.height), "height h of the section"),
    key("strip", "width", Optional, Kind::Quantity(Length, |s| &mut s.model.strip.width), "width of the section"),
    key("strip", "youngs_modulus", Required, Kind::Quantity(Pressure, |s| &mut s.model.strip.youngs_modulus), "Young's modulus E"),
    key("strip", "poissons_ratio", Optional, Kind::Number(Range::Between(-1.0, 0.5), |s| &mut s.model.strip.poissons_ratio), "Poisson's ratio"),
    key("strip", "shear_correction", Optional, Kind::Number(Range::Positive, |s| &mut s.model.strip.shear_correction), "shear correction factor of the section"),
    key("strip", "bending_stiffness_factor", Optional, Kind::Number(Range::Positive, |s| &mut s.model.strip.bending_stiffness_factor), "multiplies the bending stiffness EI alone"),

    key("adhesion", "hamaker_constant", Required, Kind::Quantity(Energy, |s| &mut s.model.adhesion.hamaker_constant), "Hamaker constant A_H"),
    key("adhesion", "equilibrium_distance", Required, Kind::Quantity(Length, |s| &mut s.model.adhesion.equilibrium_distance), "equilibrium distance r0 of a pair of molecules"),
    key("adhesion", "line_load", Optional, Kind::LineLoad(|s| &mut s.model.adhesion.line_load), "line force and moment, force alone, or traction blind to tilt"),
    key("adhesion", "far_face", Optional, Kind::Flag(|s| &mut s.model.adhesion.far_face), "whether the upper face of the strip counts"),

    key("grip", "rotation", Optional, Kind::Hold(|s| &mut s.model.grip.rotation), "of the right end, where it is pulled"),
    key("grip", "horizontal", Optional, Kind::Hold(|s| &mut s.model.grip.horizontal), "of the right end; fixed stretches the strip as it lifts"),
    key("grip", "stiffness", Optional, Kind::Bound(Stiffness, |s| &mut s.model.grip.stiffness), "of a spring between grip and machine"),

    key("accuracy", "relative", Optional, Kind::Number(Range::From(1e-11, 1e-2), |s| &mut s.accuracy.relative), "relative error wanted of every force and displacement"),
    key("accuracy", "order", Optional, Kind::Fixed(8, |s| &mut s.accuracy.choice.order), "order p of the elements"),
    key("accuracy", "elements", Optional, Kind::Fixed(2000, |s| &mut s.accuracy.choice.elements), "number of elements, never raised"),
    key("accuracy", "step", Optional, Kind::Share(Range::From(1e-6, 0.5), |s| &mut s.accuracy.choice.step), "error of a step's prediction, over the gap"),

    key("bounds", "points", Optional, Kind::Count(|s| &mut s.bounds.points), "most points of a path"),
    key("bounds", "time", Optional, Kind::Bound(Time, |s| &mut s.bounds.time_s), "most time for a path, 60 s unless given"),
    key("bounds", "displacement", Optional, Kind::Bound(Length, |s| &mut s.bounds.displacement), "largest displacement of the grip"),
];

/// The tables of a scene.
pub(crate) fn tables() -> Vec<&'static str> {
    let mut tables: Vec<_> = KEYS.iter().map(|key| key.table).filter(|table| !table.is_empty()).collect();
    tables.dedup();
    tables
}

/// The key with this path, such as `strip.length`; or what would be right.
pub fn find_key(path: &str) -> Result<&'static Key, Problem> {
    let path = path.trim();
    if let Some(key) = KEYS.iter().find(|key| key.path() == path) {
        return Ok(key);
    }
    let paths: Vec<String> = KEYS.iter().map(Key::path).collect();
    let name = path.rsplit('.').next().unwrap_or(path);
    let same_name = KEYS.iter().find(|key| key.name == name).map(Key::path);
    let remedy = match same_name.as_deref().or_else(|| nearest(path, paths.iter().map(String::as_str))) {
        Some(near) => format!("Did you mean `{near}`?"),
        None => format!("The keys are {}.", paths.join(", ")),
    };
    Err(Problem::new("is not a key of a scene", remedy))
}
