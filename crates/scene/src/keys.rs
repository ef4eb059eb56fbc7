//! The keys of a scene: one line each. The parser, `--set`, `--vary`, the help and the summary all read this list.

use crate::body::{number_of_shape, profile, space, spatula, strip, substrate};
use crate::error::ValueError;
use crate::key::choice::{ENDS, HOLDS, LAW, LINE_LOADS, SECTIONS, STARTS, STRETCHES, TERMS, choice};
use crate::key::kind::{Key, Kind, Need, Need::Optional, Need::Required};
use crate::key::list::{find, tables_of};
use crate::key::table::{
    ACCURACY, ADHESION, BOUNDS, DRIVE, FIT, FRICTION, GRIP, LAMELLA, OPTIMISE, OUTPUT, PATCH, PATH, PROFILE, SETA,
    SETAE, SOLID, SPATULA, STRIP, SUBSTRATE, TIME, TOE, TOP, Table, UNCERTAINTY,
};
use crate::scene::Scene;
use crate::scene::array::{ArrayTable, LOADS, LamellaTable, PatchTable, ToeTable};
use crate::tables::setae::{array, branching, seta};
use crate::tables::solid::{CONTACTS, GRADINGS, GRIPS, MATERIALS, MOST_ROWS, PLANES};
use crate::tables::{curves, fit, layers, optimise, output, rate, solid, uncertainty};
use crate::value::quantity::{
    Dimension, Dimension::Angle, Dimension::AnglePerLength, Dimension::Density, Dimension::Energy, Dimension::Force,
    Dimension::Length, Dimension::Pressure, Dimension::Stiffness, Dimension::Time, Dimension::Velocity,
    Dimension::Work,
};
use crate::value::{Value, show};
use peelkit::adhesion::OpeningRate;
use peelkit::model::{Discretisation, MODEL_NUMBERS, MOST_ACROSS, MOST_FORKS, Range, angle_text};
use peelkit::study::ACCURACY_NUMBERS;
use peelkit::study::coarsening::CoarseningOptions;

const fn key(of: &'static Table, name: &'static str, need: Need, kind: Kind, about: &'static str) -> Key {
    Key { table: of.name, of, name, need, kind, about, title: ("", ""), of_space: false }
}

/// A place of a scene.
type Place<T> = fn(&mut Scene) -> &mut T;

/// One with a number of the model without a unit, in the range that the model gives it.
const fn number(of: &'static Table, name: &'static str, need: Need, place: Place<f64>, about: &'static str) -> Key {
    key(of, name, need, Kind::Number(range(of.name, name), place), about)
}

/// The same, or nothing.
const fn share(
    of: &'static Table,
    name: &'static str,
    need: Need,
    place: Place<Option<f64>>,
    about: &'static str,
) -> Key {
    key(of, name, need, Kind::Share(range(of.name, name), place), about)
}

/// One with a number of the model with a unit, in the range that the model gives it.
const fn measure(
    of: &'static Table,
    name: &'static str,
    need: Need,
    dimension: Dimension,
    place: Place<f64>,
    about: &'static str,
) -> Key {
    key(of, name, need, Kind::Measure(dimension, range(of.name, name), place), about)
}

/// The range of a number in the lists of the model and of its accuracy; a key that neither has does not compile.
const fn range(table: &str, name: &str) -> Range {
    let mut index = 0;
    while index < MODEL_NUMBERS.len() {
        if is_path(MODEL_NUMBERS[index].key, table, name) {
            return MODEL_NUMBERS[index].range;
        }
        index += 1;
    }
    index = 0;
    while index < ACCURACY_NUMBERS.len() {
        if is_path(ACCURACY_NUMBERS[index].key, table, name) {
            return ACCURACY_NUMBERS[index].range;
        }
        index += 1;
    }
    panic!("the model has no number of this key")
}

/// Whether a path is `table.name`.
const fn is_path(path: &str, table: &str, name: &str) -> bool {
    let (path, table, name) = (path.as_bytes(), table.as_bytes(), name.as_bytes());
    if path.len() != table.len() + 1 + name.len() {
        return false;
    }
    let mut index = 0;
    while index < path.len() {
        let wanted = match index {
            _ if index < table.len() => table[index],
            _ if index == table.len() => b'.',
            _ => name[index - table.len() - 1],
        };
        if path[index] != wanted {
            return false;
        }
        index += 1;
    }
    true
}

impl Key {
    /// The same, with words and symbol of an axis; the symbol may be empty.
    const fn titled(self, words: &'static str, symbol: &'static str) -> Self {
        Self { title: (words, symbol), ..self }
    }

    /// The same, of a scene in space alone.
    const fn in_space(self) -> Self {
        Self { of_space: true, ..self }
    }
}

/// The tables of an array of setae.
fn setae(scene: &mut Scene) -> &mut ArrayTable {
    scene.array_table()
}
fn patch(scene: &mut Scene) -> &mut PatchTable {
    setae(scene).patch_table()
}
fn lamella(scene: &mut Scene) -> &mut LamellaTable {
    setae(scene).lamella_table()
}
fn toe(scene: &mut Scene) -> &mut ToeTable {
    setae(scene).toe_table()
}

/// Of a seta in an array: along what its reach is measured.
const EXIT_ANGLES: Range = Range::From(1.0 * 1f64.to_radians(), 179.0 * 1f64.to_radians());

/// What the tolerance of a table of tips may be.
const TIP_TOLERANCES: Range = Range::From(CoarseningOptions::TOLERANCES[0], CoarseningOptions::TOLERANCES[1]);

/// Every key that a scene may hold, in the order in which a scene is written.
#[rustfmt::skip]
pub static KEYS: &[Key] = &[
    key(&TOP, "title", Optional, Kind::Text(|s| &mut s.title), "heading of pictures and tables"),
    key(&TOP, "terms", Optional, choice!(TERMS, "\"auto\"", |s| &mut s.accuracy.terms), "model terms: all, or automatic model reduction to the tolerance"),
    key(&TOP, "space", Optional, Kind::InSpace, "peels the body in space; implied by its keys"),

    key(&STRIP, "length", Required, Kind::Quantity(Length, |s| &mut strip(s).length), "length L of the strip").titled("length of the strip", "L"),
    key(&STRIP, "height", Required, Kind::Quantity(Length, |s| &mut strip(s).height), "height h of the section").titled("height of the section", "h"),
    key(&STRIP, "width", Optional, Kind::Quantity(Length, |s| &mut strip(s).width), "width of the section").titled("width of the section", "b"),
    key(&STRIP, "youngs_modulus", Required, Kind::Quantity(Pressure, |s| &mut strip(s).material.youngs_modulus), "Young's modulus E").titled("Young's modulus", "E"),
    number(&STRIP, "poissons_ratio", Optional, |s| &mut strip(s).material.poissons_ratio, "Poisson's ratio").titled("Poisson's ratio", "ν"),
    number(&STRIP, "shear_correction", Optional, |s| &mut strip(s).material.shear_correction, "shear correction factor of the section").titled("shear correction factor", "k"),
    number(&STRIP, "bending_stiffness_factor", Optional, |s| &mut strip(s).material.bending_stiffness_factor, "multiplies the bending stiffness EI alone").titled("bending stiffness over that of the section", "EI/EI₀"),
    key(&STRIP, "stretch", Optional, choice!(STRETCHES, "\"neo-hookean\"", |s| &mut strip(s).material.stretch), "force along the strip over its stretch"),
    key(&STRIP, "yield_strength", Optional, Kind::Bound(Pressure, |s| &mut strip(s).material.yield_strength), "stress at which the strip yields").titled("yield strength of the strip", "σ₀"),
    key(&STRIP, "tangent_modulus", Optional, Kind::Bound(Pressure, |s| &mut strip(s).material.tangent_modulus), "slope of stress over strain where it yields").titled("tangent modulus of the strip", "Eₜ"),
    key(&STRIP, "crack", Optional, Kind::Bound(Length, |s| &mut strip(s).crack), "length of an initial crack at the grip").titled("length of the initial crack", "a₀"),
    key(&STRIP, "layers", Optional, Kind::Setting(&layers::LAYERS), "layers from the adhering face up"),
    key(&STRIP, "section", Optional, choice!(SECTIONS, "\"ellipse\"", |s| &mut space(s).section), "in space: outline of the section").in_space(),

    key(&SPATULA, "pad_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).pad_length), "length of the flat pad at the tip").titled("length of the pad", ""),
    key(&SPATULA, "neck_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).neck_length), "length of the neck, from the pad to the shaft").titled("length of the neck", ""),
    key(&SPATULA, "shaft_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).shaft_length), "length of the shaft beyond the neck").titled("length of the shaft", ""),
    key(&SPATULA, "bend_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).bend_length), "length beyond the pad over which the axis bends up").titled("length of the bend", ""),
    key(&SPATULA, "tip_width", Optional, Kind::Quantity(Length, |s| &mut spatula(s).tip_width), "width of the pad at the tip").titled("width of the pad at the tip", "b"),
    key(&SPATULA, "neck_width", Optional, Kind::Quantity(Length, |s| &mut spatula(s).neck_width), "width of the pad at its end").titled("width of the pad at its end", ""),
    key(&SPATULA, "shaft_diameter", Optional, Kind::Quantity(Length, |s| &mut spatula(s).shaft_diameter), "diameter of the shaft").titled("diameter of the shaft", ""),
    key(&SPATULA, "pad_thickness", Optional, Kind::Quantity(Length, |s| &mut spatula(s).pad_thickness), "height of the pad's section").titled("thickness of the pad", "h"),
    measure(&SPATULA, "shaft_angle", Optional, Angle, |s| &mut spatula(s).shaft_angle, "angle of the shaft to the pad").titled("angle of the shaft to the pad", ""),
    measure(&SPATULA, "tip_rounding_length", Optional, Length, |s| &mut spatula(s).tip_rounding_length, "length over which the tip is rounded; 0: blunt").titled("length of the rounded tip", ""),
    key(&SPATULA, "tip_rounding_width", Optional, Kind::Quantity(Length, |s| &mut spatula(s).tip_rounding_width), "width of the end face of a rounded tip").titled("width of the end face of the rounded tip", ""),
    key(&SPATULA, "youngs_modulus", Optional, Kind::Quantity(Pressure, |s| &mut spatula(s).material.youngs_modulus), "Young's modulus E").titled("Young's modulus", "E"),
    number(&SPATULA, "poissons_ratio", Optional, |s| &mut spatula(s).material.poissons_ratio, "Poisson's ratio").titled("Poisson's ratio", "ν"),
    number(&SPATULA, "shear_correction", Optional, |s| &mut spatula(s).material.shear_correction, "shear correction factor of the section").titled("shear correction factor", "k"),
    number(&SPATULA, "bending_stiffness_factor", Optional, |s| &mut spatula(s).material.bending_stiffness_factor, "multiplies the bending stiffness EI alone").titled("bending stiffness over that of the section", "EI/EI₀"),

    key(&PROFILE, "table", Required, Kind::Table(|s| &mut profile(s).form), "beam as CSV, or name of its file"),
    key(&PROFILE, "pieces", Required, Kind::Pieces(|s| &mut profile(s).form), "beam piece by piece, instead of table"),
    key(&PROFILE, "youngs_modulus", Required, Kind::Quantity(Pressure, |s| &mut profile(s).material.youngs_modulus), "Young's modulus E").titled("Young's modulus", "E"),
    number(&PROFILE, "poissons_ratio", Optional, |s| &mut profile(s).material.poissons_ratio, "Poisson's ratio").titled("Poisson's ratio", "ν"),
    number(&PROFILE, "shear_correction", Optional, |s| &mut profile(s).material.shear_correction, "shear correction factor of the section").titled("shear correction factor", "k"),
    number(&PROFILE, "bending_stiffness_factor", Optional, |s| &mut profile(s).material.bending_stiffness_factor, "multiplies the bending stiffness EI alone").titled("bending stiffness over that of the section", "EI/EI₀"),

    key(&SETA, "forks", Optional, Kind::Count(MOST_FORKS, |s| &mut s.seta_table().seta.forks), "forks from root to tip: 2^forks tips").titled("forks from root to tip", "n"),
    key(&SETA, "branches", Optional, Kind::Setting(&branching::BRANCHES), "branches behind each fork, in place of forks in two"),
    key(&SETA, "tip_pitch", Optional, Kind::Quantity(Length, |s| &mut s.seta_table().seta.tip_pitch), "distance of neighbouring tips on their grid").titled("distance of neighbouring tips", ""),
    key(&SETA, "shaft_length", Optional, Kind::Quantity(Length, |s| &mut s.seta_table().seta.shaft_length), "length from the root to the first fork").titled("length of the shaft", ""),
    key(&SETA, "shaft_angle", Optional, Kind::Measure(Angle, Range::SETA_ANGLE, |s| &mut s.seta_table().seta.shaft_angle), "angle of the shaft to the normal of the ground").titled("angle of the shaft to the normal", ""),
    key(&SETA, "shaft_diameter", Optional, Kind::Quantity(Length, |s| &mut s.seta_table().seta.shaft_diameter), "diameter of the shaft").titled("diameter of the shaft", "d"),
    key(&SETA, "diameters", Optional, Kind::Setting(&branching::DIAMETERS), "diameters of shaft and branches, in place of a ratio"),
    key(&SETA, "brush_height", Optional, Kind::Quantity(Length, |s| &mut s.seta_table().seta.brush_height), "height of the first fork above the tips").titled("height of the brush", "H"),
    key(&SETA, "fork_heights", Optional, Kind::Setting(&branching::FORK_HEIGHTS), "heights of the forks above the tips, in place of q"),
    key(&SETA, "brush_angle", Optional, Kind::Measure(Angle, Range::SETA_ANGLE, |s| &mut s.seta_table().seta.brush_angle), "angle of the brush to the normal of the ground").titled("angle of the brush to the normal", ""),
    key(&SETA, "height_ratio", Optional, Kind::Number(Range::Between(0.0, 1.0), |s| &mut s.seta_table().seta.height_ratio), "q: fork k stands at H (q^k - q^n)/(1 - q^n)").titled("ratio of the heights of forks", "q"),
    key(&SETA, "diameter_ratio", Optional, Kind::Number(Range::Between(0.0, 1.0), |s| &mut s.seta_table().seta.diameter_ratio), "diameter of a branch over that of its parent").titled("ratio of the diameters of branches", ""),
    key(&SETA, "height_scatter", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut s.seta_table().seta.height_scatter), "half the range of the heights of the tips").titled("half the range of the heights of tips", "a"),
    key(&SETA, "tree", Optional, Kind::Setting(&branching::TREE), "the whole tree, in place of its geometry by levels"),
    key(&SETA, "lateral_stiffness", Optional, Kind::Bound(Stiffness, |s| &mut s.seta_table().lateral_stiffness), "stiffness that holds tips; none: they slide").titled("stiffness that holds attached tips", "k"),
    key(&SETA, "contact_height", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut s.seta_table().contact_height), "height at which a detached tip adheres again").titled("height at which a detached tip adheres again", ""),
    key(&SETA, "preload", Optional, Kind::Bound(Force, |s| &mut s.seta_table().preload), "presses the seta on first; none: it adheres").titled("preload", ""),
    key(&SETA, "tip_law", Optional, Kind::Setting(&seta::TIP_LAW), "what tips follow: curve or table of their pull; or beams"),
    key(&SETA, "tip_table", Optional, Kind::Setting(&seta::TIP_TABLE), "folder of peel coarsen with it; none: it is computed"),
    key(&SETA, "tip_tolerance", Optional, Kind::Number(TIP_TOLERANCES, |s| &mut s.seta_table().tip_tolerance), "error that it may have, relative to the largest force").titled("relative error of the table of the tips", ""),
    key(&SETA, "resolve_within", Optional, Kind::Bound(Length, |s| &mut s.seta_table().resolve_within), "tips so near to snapping off are solved; none: by table").titled("distance to snapping off from which tips are resolved", ""),
    key(&SETA, "youngs_modulus", Optional, Kind::Quantity(Pressure, |s| &mut s.seta_table().seta.material.youngs_modulus), "Young's modulus E of all branches").titled("Young's modulus", "E"),
    key(&SETA, "poissons_ratio", Optional, Kind::Number(Range::POISSONS_RATIO, |s| &mut s.seta_table().seta.material.poissons_ratio), "Poisson's ratio").titled("Poisson's ratio", "ν"),
    key(&SETA, "shear_correction", Optional, Kind::Number(Range::Positive, |s| &mut s.seta_table().seta.material.shear_correction), "shear correction factor of the section").titled("shear correction factor", "k"),
    key(&SETA, "bending_stiffness_factor", Optional, Kind::Number(Range::Positive, |s| &mut s.seta_table().seta.material.bending_stiffness_factor), "multiplies the bending stiffness EI alone").titled("bending stiffness over that of the section", "EI/EI₀"),

    key(&ADHESION, "hamaker_constant", Required, Kind::Quantity(Energy, |s| &mut s.model.adhesion.hamaker_constant), "Hamaker constant A_H of van der Waals forces").titled("Hamaker constant", "A_H"),
    key(&ADHESION, "equilibrium_distance", Required, Kind::Quantity(Length, |s| &mut s.model.adhesion.equilibrium_distance), "r0 of a pair of molecules; gap at rest").titled("equilibrium distance", "r₀"),
    key(&ADHESION, "law", Optional, Kind::Word(&LAW), "adhesion model: law of the half space, or a cohesive law"),
    key(&ADHESION, "table", Optional, Kind::Tractions(|s| &mut s.model.adhesion.attraction), "of law = \"table\": traction over opening"),
    key(&ADHESION, "work", Optional, Kind::Bound(Work, |s| &mut s.model.adhesion.work), "work of a cohesive law; else the half space's").titled("work of adhesion", "w"),
    key(&ADHESION, "strength", Optional, Kind::Bound(Pressure, |s| &mut s.model.adhesion.strength), "strength of a cohesive law; else the half space's").titled("cohesive strength", "σ"),
    key(&ADHESION, "shear_strength", Optional, Kind::Bound(Pressure, |s| &mut s.model.adhesion.shear_strength), "largest shear traction; none: it slides freely").titled("shear strength of the adhesion", "τ"),
    key(&ADHESION, "shear_work", Optional, Kind::Bound(Work, |s| &mut s.model.adhesion.shear_work), "work of slip beside it; none: that of opening").titled("work of adhesion in shear", "wₜ"),
    key(&ADHESION, "mixing_exponent", Optional, Kind::Share(Range::MIXING_EXPONENT, |s| &mut s.model.adhesion.mixing_exponent), "of Benzeggagh and Kenane; none: the linear criterion").titled("exponent of mixed modes", "η"),
    key(&ADHESION, "healing", Optional, Kind::Flag(|s| &mut s.model.adhesion.healing), "false: what has opened and closes is held less"),
    key(&ADHESION, "line_load", Optional, choice!(LINE_LOADS, "\"full\"", |s| &mut s.model.adhesion.line_load), "force and moment, force alone, or independent of rotation"),
    key(&ADHESION, "far_face", Optional, Kind::Flag(|s| &mut s.model.adhesion.far_face), "whether the attraction of the upper surface is included"),

    key(&SUBSTRATE, "shape", Optional, Kind::Shape(substrate), "shape of the substrate"),
    key(&SUBSTRATE, "radius", Required, Kind::Quantity(Length, |s| number_of_shape(substrate(s), "radius")), "radius of the sphere or cylinder").titled("radius of the substrate", "R"),
    key(&SUBSTRATE, "height", Required, Kind::Quantity(Length, |s| number_of_shape(substrate(s), "height")), "height from crest to valley").titled("height of the ground, crest to valley", "H"),
    key(&SUBSTRATE, "wavelength", Required, Kind::Quantity(Length, |s| number_of_shape(substrate(s), "wavelength")), "distance from crest to crest").titled("wavelength of the ground", "λ"),
    measure(&SUBSTRATE, "offset", Optional, Length, |s| number_of_shape(substrate(s), "offset"), "distance of a crest, or of the top, from the free end").titled("distance of a crest from the free end", ""),
    key(&SUBSTRATE, "table", Required, Kind::Heights(substrate), "height profile as a CSV, or the name of its file"),
    key(&SUBSTRATE, "start", Optional, choice!(STARTS, "\"conformed\"", |s| &mut s.model.ground.start), "initially pressed on and conforming, or lying on the crests"),

    key(&FRICTION, "strength", Optional, Kind::Bound(Pressure, |s| &mut s.model.friction.strength), "shear strength of the contact; none: it slides freely").titled("shear strength of the contact", "τ"),
    number(&FRICTION, "coefficient", Optional, |s| &mut s.model.friction.coefficient, "Coulomb's friction coefficient").titled("friction coefficient", "μ"),
    key(&FRICTION, "presliding", Optional, Kind::Bound(Length, |s| &mut s.model.friction.presliding), "elastic presliding displacement").titled("elastic presliding displacement", ""),

    key(&GRIP, "rotation", Optional, choice!(HOLDS, "\"fixed\"", |s| &mut s.model.grip.rotation), "rotation of the right end, which is pulled"),
    key(&GRIP, "horizontal", Optional, choice!(HOLDS, "\"fixed\"", |s| &mut s.model.grip.horizontal), "displacement normal to the pull direction"),
    key(&GRIP, "lateral", Optional, choice!(HOLDS, "\"fixed\"", |s| &mut space(s).lateral), "in space: displacement normal to the plane of the pull").in_space(),
    key(&GRIP, "roll", Optional, choice!(HOLDS, "\"fixed\"", |s| &mut space(s).roll), "in space: rotation of the right end about its axis").in_space(),
    key(&GRIP, "yaw", Optional, choice!(HOLDS, "\"fixed\"", |s| &mut space(s).yaw), "in space: rotation of the right end about y").in_space(),
    key(&GRIP, "stiffness", Optional, Kind::Bound(Stiffness, |s| &mut s.model.grip.stiffness), "stiffness of a spring between grip and machine").titled("stiffness of the machine", "k"),
    key(&GRIP, "pretension", Optional, Kind::Bound(Force, |s| &mut s.model.grip.pretension), "adhered under this pretension; needs horizontal = \"fixed\"").titled("pretension", "T"),

    measure(&DRIVE, "angle", Optional, Angle, |s| &mut s.model.pull.angle, "angle of the pull to the substrate; 90 deg: straight up").titled("angle of the pull to the substrate", "α"),
    measure(&DRIVE, "azimuth", Optional, Angle, |s| &mut space(s).azimuth, "in space: direction of the pull; 90 deg: sideways").in_space().titled("direction of the pull along the substrate", "β"),
    measure(&DRIVE, "turn", Optional, AnglePerLength, |s| &mut s.model.pull.turn, "rotation of a fixed grip per displacement").titled("rotation of the grip per displacement", ""),
    key(&DRIVE, "steps", Optional, Kind::Steps(|s| &mut s.model.steps), "press, lift, drag, push, turn, release, hold, shift, roll, yaw first"),

    key(&SOLID, "element", Optional, Kind::Setting(&solid::ELEMENT), "element, by its contact edge or by its orders"),
    key(&SOLID, "modes", Optional, Kind::Flag(|s| &mut s.solid_table().modes), "incompatible modes off the contact row"),
    key(&SOLID, "along", Optional, Kind::Bound(Length, |s| &mut s.solid_table().along), "length of an element; none: that of the process zone").titled("length of an element", ""),
    key(&SOLID, "through", Optional, Kind::Count(MOST_ROWS, |s| &mut s.solid_table().through), "rows of elements through the thickness").titled("rows of elements", ""),
    key(&SOLID, "across", Optional, Kind::Count(MOST_ACROSS, |s| &mut s.solid_table().across), "elements across the half width, in space").titled("elements across", ""),
    key(&SOLID, "plane", Optional, choice!(PLANES, "\"strain\"", |s| &mut s.solid_table().plane), "what is zero across the plane"),
    key(&SOLID, "material", Optional, choice!(MATERIALS, "\"neo-hookean\"", |s| &mut s.solid_table().material), "elastic energy"),
    key(&SOLID, "contact", Optional, choice!(CONTACTS, "\"body-force\"", |s| &mut s.solid_table().contact), "what the half space acts on"),
    key(&SOLID, "grip", Optional, choice!(GRIPS, "\"parabolic\"", |s| &mut s.solid_table().grip), "a rigid end face, or a parabolic shear traction on it"),
    key(&SOLID, "grading", Optional, choice!(GRADINGS, "\"grip\"", |s| &mut s.solid_table().grading), "where elements are finer: nowhere, or at the corners of the grip"),
    key(&SETAE, "rows", Optional, Kind::Count(1_000_000, |s| &mut setae(s).rows), "rows of setae; of a toe in each lamella").titled("rows of setae", "N"),
    key(&SETAE, "columns", Optional, Kind::Count(1_000_000, |s| &mut setae(s).columns), "setae in a row").titled("setae in a row", ""),
    key(&SETAE, "pitch", Optional, Kind::Quantity(Length, |s| &mut setae(s).pitch), "distance of neighbouring setae").titled("distance of neighbouring setae", "p"),
    key(&SETAE, "diameter", Optional, Kind::Quantity(Length, |s| &mut setae(s).diameter), "diameter of their shafts").titled("diameter of the setae", "d"),
    key(&SETAE, "stiffness", Optional, Kind::Quantity(Stiffness, |s| &mut setae(s).stiffness), "normal stiffness of a seta").titled("normal stiffness of a seta", "k"),
    key(&SETAE, "tangential_stiffness", Optional, Kind::Bound(Stiffness, |s| &mut setae(s).tangential_stiffness), "stiffness along the ground; none: it slides").titled("tangential stiffness of a seta", ""),
    key(&SETAE, "reach", Optional, Kind::Quantity(Length, |s| &mut setae(s).reach), "displacement at which a seta lets go or softens").titled("displacement at which a seta lets go", ""),
    key(&SETAE, "last_reach", Optional, Kind::Bound(Length, |s| &mut setae(s).last_reach), "displacement up to which it softens; none: brittle").titled("displacement up to which a seta softens", ""),
    key(&SETAE, "exit_angle", Optional, Kind::Measure(Angle, EXIT_ANGLES, |s| &mut setae(s).exit_angle), "direction in which its reach is measured, to the ground").titled("direction of the exit of a seta", ""),
    key(&SETAE, "law", Optional, Kind::Setting(&array::LAW), "folder of peel coarsen with their law; none: numbers"),
    key(&SETAE, "seta", Optional, Kind::Setting(&array::SETA), "scene of the seta of that law, to make it"),
    key(&SETAE, "cone_angle", Optional, Kind::Bound(Angle, |s| &mut setae(s).cone_angle), "critical angle of a seta, for that of a lamella").titled("critical angle of a seta", "α"),
    key(&SETAE, "height_scatter", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut setae(s).scatter.height), "half the range of the heights of setae").titled("half the range of the heights of setae", ""),
    key(&SETAE, "strength_scatter", Optional, Kind::Number(Range::From(0.0, 0.999), |s| &mut setae(s).scatter.strength), "half the range of their strengths, over the mean").titled("half the range of the strengths of setae", ""),
    key(&SETAE, "seed", Optional, Kind::Number(Range::From(0.0, 1e9), |s| &mut setae(s).seed), "shifts the sequence of heights and strengths").titled("seed of heights and strengths", ""),
    key(&SETAE, "shaft_length", Optional, Kind::Bound(Length, |s| &mut setae(s).length), "length of a seta, for the warning about bunching").titled("length of a seta", "L"),
    key(&SETAE, "youngs_modulus", Optional, Kind::Bound(Pressure, |s| &mut setae(s).youngs_modulus), "Young's modulus of a seta, for that warning").titled("Young's modulus of a seta", "E"),
    key(&SETAE, "surface_energy", Optional, Kind::Bound(Work, |s| &mut setae(s).surface_energy), "surface energy of a seta, for that warning").titled("surface energy of a seta", "γ"),
    key(&PATCH, "press", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut patch(s).press), "how far the backing is pressed first").titled("press of the backing", ""),
    key(&PATCH, "dome_radius", Optional, Kind::Bound(Length, |s| &mut patch(s).dome_radius), "radius of a dome that carries the setae; none: flat").titled("radius of the dome", "R"),
    key(&LAMELLA, "thickness", Optional, Kind::Quantity(Length, |s| &mut lamella(s).thickness), "thickness of the band").titled("thickness of the band", "h"),
    key(&LAMELLA, "youngs_modulus", Optional, Kind::Quantity(Pressure, |s| &mut lamella(s).youngs_modulus), "Young's modulus E of the band").titled("Young's modulus", "E"),
    key(&LAMELLA, "overhang", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut lamella(s).overhang), "band in front of the first row").titled("band in front of the first row", "a"),
    key(&LAMELLA, "pulled_at", Optional, Kind::Fixed(1_000_000, |s| &mut lamella(s).pulled_at), "row at which it is pulled, from 1 on; none: its end").titled("row at which the band is pulled", ""),
    key(&LAMELLA, "load", Optional, choice!(LOADS, "\"moment\"", |s| &mut lamella(s).load), "a force, or a moment that turns or presses its end"),
    key(&LAMELLA, "pretension", Optional, Kind::Measure(Force, Range::From(0.0, 1e30), |s| &mut lamella(s).pretension), "tension in which it adheres, for the steady force").titled("tension of the band", "T₀"),
    key(&TOE, "lamellae", Optional, Kind::Count(10_000, |s| &mut toe(s).lamellae), "lamellae on the pad").titled("lamellae on the pad", ""),
    key(&TOE, "lamella_pitch", Optional, Kind::Quantity(Length, |s| &mut toe(s).pitch), "distance of neighbouring lamellae").titled("distance of neighbouring lamellae", ""),
    key(&TOE, "thickness", Optional, Kind::Quantity(Length, |s| &mut toe(s).thickness), "thickness of the pad").titled("thickness of the pad", ""),
    key(&TOE, "youngs_modulus", Optional, Kind::Quantity(Pressure, |s| &mut toe(s).youngs_modulus), "Young's modulus E of the pad").titled("Young's modulus", "E"),
    key(&TOE, "joined_at", Optional, Kind::Fixed(1_000_000, |s| &mut toe(s).joined_at), "row at which lamellae are joined to it; none: rigid lamellae").titled("row at which lamellae are joined", ""),
    key(&TIME, "rate", Required, Kind::Quantity(Velocity, |s| &mut s.time_table().rate), "velocity of what moves the grip").titled("rate of the pull", "V"),
    key(&TIME, "density", Required, Kind::Measure(Density, Range::From(0.0, 1e6), |s| &mut s.time_table().density), "density of the beam; 0: without inertia, as of a seta").titled("density", "ρ"),
    key(&TIME, "material", Optional, Kind::Setting(&rate::MATERIAL), "whether and how the material flows"),
    key(&TIME, "retardation_time", Optional, Kind::Bound(Time, |s| &mut s.time_table().retardation_time), "of a Kelvin-Voigt material: viscosity over modulus").titled("retardation time", "τ"),
    key(&TIME, "relaxation_time", Optional, Kind::Bound(Time, |s| &mut s.time_table().relaxation_time), "of a standard linear solid: at constant strain").titled("relaxation time", "τ"),
    key(&TIME, "stiffness_ratio", Optional, Kind::Share(Range::Between(1.0, 1e6), |s| &mut s.time_table().stiffness_ratio), "of a standard linear solid: instantaneous over relaxed modulus").titled("instantaneous over relaxed modulus", "E₀/E∞"),
    key(&TIME, "opening_rate", Optional, Kind::Bound(Velocity, |s| &mut s.time_table().opening_rate), "rate of opening at which a cohesive traction rises; none: not").titled("rate of opening at which the traction rises", "v₀"),
    key(&TIME, "rate_exponent", Optional, Kind::Share(Range::From(OpeningRate::EXPONENTS[0], OpeningRate::EXPONENTS[1]), |s| &mut s.time_table().rate_exponent), "power with which it rises; none: 1").titled("exponent of the rate of opening", "n"),
    key(&TIME, "displacement", Optional, Kind::Bound(Length, |s| &mut s.time_table().displacement), "where the grip comes to rest; none: length of body or seta").titled("where the grip comes to rest", ""),
    key(&TIME, "held", Optional, Kind::Bound(Time, |s| &mut s.time_table().held), "time at rest behind that; none: ends where nothing adheres").titled("time at rest", ""),
    key(&TIME, "acceleration", Optional, Kind::Bound(Length, |s| &mut s.time_table().acceleration), "way on which the grip accelerates; none: about 0.1 r0, seta 20 nm").titled("way on which the grip accelerates", ""),
    key(&TIME, "tolerance", Optional, Kind::Number(Range::Between(0.0, 0.1), |s| &mut s.time_table().tolerance), "error of a step in time over the gap; of a seta over 10 nm, 1e-5").titled("error of a step in time over the equilibrium gap", ""),

    number(&ACCURACY, "relative", Optional, |s| &mut s.accuracy.relative, "relative tolerance of every reported force and displacement").titled("relative tolerance", ""),
    key(&ACCURACY, "order", Optional, Kind::Fixed(Discretisation::MOST_ORDER, |s| &mut s.accuracy.choice.order), "order p of the elements").titled("order of the elements", "p"),
    key(&ACCURACY, "elements", Optional, Kind::Fixed(2000, |s| &mut s.accuracy.choice.elements), "number of elements, never raised").titled("number of elements", ""),
    share(&ACCURACY, "step", Optional, |s| &mut s.accuracy.choice.step, "predictor tolerance over the equilibrium gap").titled("predictor tolerance over the equilibrium gap", ""),

    key(&PATH, "until", Optional, choice!(ENDS, "\"first-jump\"", |s| &mut s.bounds.until), "as far as what the path is followed"),

    key(&OUTPUT, "stations", Optional, Kind::Setting(&output::STATIONS), "exact values at which the path is computed besides"),
    key(&OUTPUT, "events", Optional, Kind::Setting(&output::EVENTS), "where a quantity passes a value: recorded, or followed no further"),
    key(&OUTPUT, "units", Optional, Kind::Setting(&output::UNITS), "units of print, pictures and tables besides; else those that fit"),

    key(&BOUNDS, "points", Optional, Kind::Count(1_000_000_000, |s| &mut s.bounds.points), "largest number of points of a path").titled("largest number of points of the path", ""),
    key(&BOUNDS, "time", Optional, Kind::Bound(Time, |s| &mut s.bounds.time_s), "longest time for a path").titled("longest time for a path", ""),
    key(&BOUNDS, "displacement", Optional, Kind::Bound(Length, |s| &mut s.bounds.displacement), "largest displacement of the grip").titled("largest displacement of the grip", ""),

    key(&FIT, "parameters", Required, Kind::Setting(&fit::PARAMETERS), "keys to determine, with bounds if wanted"),
    key(&FIT, "force_error", Optional, Kind::Bound(Force, |s| &mut s.fit_table().options.force_error), "standard error of measured forces; none: from the residuals").titled("standard error of the measured forces", ""),
    key(&FIT, "displacement_error", Optional, Kind::Setting(&fit::DISPLACEMENT_ERROR), "standard error of measured displacements"),
    key(&FIT, "curves", Optional, Kind::Setting(&curves::CURVES), "measured curves that are fitted together"),
    key(&FIT, "displacement_zero", Optional, Kind::Measure(Length, Range::OFFSET, |s| &mut s.fit_table().displacement_zero), "measured displacement at which the model's is zero").titled("zero of the measured displacement", "d"),
    key(&FIT, "force_zero", Optional, Kind::Measure(Force, Range::FORCE_ZERO, |s| &mut s.fit_table().force_zero), "measured force at which the model's is zero").titled("zero of the measured force", "f"),
    key(&FIT, "columns", Optional, Kind::Setting(&fit::COLUMNS), "which columns of the data are fitted; none: by their units"),
    key(&FIT, "jump", Optional, Kind::Bound(Length, |s| &mut s.fit_table().jump), "measured displacement of the first jump; none: looked for").titled("measured displacement of the jump", ""),
    key(&FIT, "use_jump", Optional, Kind::Flag(|s| &mut s.fit_table().options.use_jump), "whether the displacement of the jump is a datum"),
    key(&FIT, "loss", Optional, Kind::Setting(&fit::LOSS), "how much points far from the curve count"),
    key(&FIT, "profile", Optional, Kind::Setting(&fit::PROFILE), "of which parameters the profile likelihood is computed"),

    key(&OPTIMISE, "objective", Required, Kind::Setting(&optimise::OBJECTIVE), "result that is optimised"),
    key(&OPTIMISE, "goal", Optional, Kind::Setting(&optimise::GOAL), "whether it is to be large or small"),
    key(&OPTIMISE, "holding_angle", Optional, Kind::Setting(&optimise::HOLDING_ANGLE), "optimises a ratio: angle of the pull above the line"),
    key(&OPTIMISE, "release_angle", Optional, Kind::Setting(&optimise::RELEASE_ANGLE), "angle of the pull below the line of that ratio"),
    key(&OPTIMISE, "parameters", Optional, Kind::Setting(&optimise::PARAMETERS), "keys that are free, with their bounds"),
    key(&OPTIMISE, "width", Optional, Kind::Setting(&optimise::WIDTH), "bounds and smoothness of the width along the body"),
    key(&OPTIMISE, "height", Optional, Kind::Setting(&optimise::HEIGHT), "bounds and smoothness of the height along the body"),
    key(&OPTIMISE, "values", Optional, Kind::Setting(&optimise::VALUES), "values of a profile along the body"),
    key(&OPTIMISE, "volume", Optional, Kind::Setting(&optimise::VOLUME), "volume of the body, against that of the scene"),
    key(&OPTIMISE, "method", Optional, Kind::Setting(&optimise::METHOD), "how designs are chosen; automatic by the constraints"),
    key(&OPTIMISE, "starts", Optional, Kind::Setting(&optimise::STARTS), "searches, the first from the scene, others from random designs"),
    key(&OPTIMISE, "evaluations", Optional, Kind::Setting(&optimise::EVALUATIONS), "largest number of designs of one search"),
    key(&OPTIMISE, "neighbours", Optional, Kind::Setting(&optimise::NEIGHBOURS), "random designs that the optimum is compared with"),
    key(&OPTIMISE, "seed", Optional, Kind::Setting(&optimise::SEED_OF_STARTS), "another seed gives other random designs"),
    key(&OPTIMISE, "check", Optional, Kind::Setting(&optimise::CHECK), "whether a search without gradients goes on from the optimum"),

    key(&UNCERTAINTY, "inputs", Required, Kind::Setting(&uncertainty::INPUTS), "keys that are uncertain, with their distributions"),
    key(&UNCERTAINTY, "correlations", Optional, Kind::Setting(&uncertainty::CORRELATIONS), "inputs that vary together"),
    key(&UNCERTAINTY, "quantities", Optional, Kind::Setting(&uncertainty::QUANTITIES), "results that are asked for"),
    key(&UNCERTAINTY, "samples", Optional, Kind::Setting(&uncertainty::SAMPLES), "largest number of peels that are sampled"),
    key(&UNCERTAINTY, "seed", Optional, Kind::Setting(&uncertainty::SEED), "another seed gives another sample"),
    key(&UNCERTAINTY, "indices", Optional, Kind::Setting(&uncertainty::INDICES), "whether sensitivity indices are estimated"),
];

/// The tables of a scene.
pub fn tables() -> Vec<&'static str> {
    tables_of(KEYS)
}

/// The key with this path, such as `strip.length`; or what would be right.
pub fn find_key(path: &str) -> Result<&'static Key, ValueError> {
    find(KEYS, path)
}

impl Key {
    /// Puts a value into the scene if it is in range.
    pub(crate) fn store(&self, scene: &mut Scene, value: &Value) -> Result<(), ValueError> {
        self.put(KEYS, scene, value)
    }

    /// What the scene holds for this key; nothing for a bound that is not set.
    pub fn value(&self, scene: &Scene) -> Option<Value> {
        self.held(KEYS, scene)
    }

    /// What holds where a scene does not give the key.
    pub fn default_value(&self) -> Option<Value> {
        match self.need {
            Need::Required => None,
            Need::Optional => self.value(&Scene::of_defaults()),
        }
    }

    /// What holds where a scene does not give the key, in words: "1 nm", "90 deg", "none", "automatic", "required".
    pub fn default_text(&self) -> String {
        if self.need == Need::Required {
            return self.required_text();
        }
        match (&self.kind, self.value(&Scene::of_defaults())) {
            (Kind::Text(_), _) => "file name".into(),
            (Kind::Fixed(..) | Kind::Share(..), _) if self.table == "accuracy" => "automatic".into(),
            (Kind::Bound(..), None) => "none".into(),
            (Kind::Steps(_), _) => "[]".into(),
            (Kind::Setting(_), Some(Value::List(items))) if items.is_empty() => "[]".into(),
            (Kind::Setting(_), Some(Value::List(items))) => {
                let text = |item: &Value| if let Value::Text(text) = item { text.clone() } else { item.to_string() };
                items.iter().map(text).collect::<Vec<_>>().join(", ")
            }
            (_, Some(Value::Number(angle))) if self.dimension() == Some(Dimension::Angle) => angle_text(angle),
            // an angle per length of zero is that in any unit
            (_, Some(Value::Number(0.0))) if !self.unit().is_empty() => format!("0 {}", self.usual_unit()),
            (_, Some(Value::Number(number))) if !self.unit().is_empty() => format!("{} {}", show(number), self.unit()),
            (_, Some(Value::Text(text))) => text,
            (_, Some(value)) => value.to_string(),
            (_, None) => "none".into(),
        }
    }

    /// That a scene has to hold it, or what in its place.
    fn required_text(&self) -> String {
        match self.alternative() {
            Some(other) => format!("required, or {other}"),
            None if self.table == "adhesion" => "or work and strength".into(),
            None => "required".into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_that_can_be_varied_has_a_title_in_words() {
        for key in KEYS {
            assert_eq!(key.title.0.is_empty(), !key.is_numeric(), "{}", key.path());
        }
        for key in KEYS.iter().filter(|key| key.is_numeric()) {
            let title = key.axis_title();
            assert!(!title.contains(&key.path()) && !title.contains("_") || title.contains("A_H"), "{title}");
        }
    }

    #[test]
    fn titles_have_symbol_and_unit() {
        let title = |path| find_key(path).unwrap().axis_title();
        assert_eq!(title("strip.height"), "height of the section h (nm)");
        assert_eq!(title("spatula.youngs_modulus"), "Young's modulus E (GPa)");
        assert_eq!(title("drive.angle"), "angle of the pull to the substrate α (deg)");
        assert_eq!(title("adhesion.work"), "work of adhesion w (J/m²)");
        assert_eq!(find_key("drive.angle").unwrap().per_usual_unit(), 180.0 / std::f64::consts::PI);
    }

    #[test]
    fn ranges_are_those_of_the_model() {
        let of = |path: &str| find_key(path).unwrap().range();
        assert_eq!(of("strip.poissons_ratio"), Range::Between(-1.0, 0.5));
        assert_eq!(of("accuracy.step"), Range::From(1e-6, 0.5));
        assert_eq!(of("drive.turn"), Range::PULL_TURN);
    }
}
