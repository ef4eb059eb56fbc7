//! The keys of a scene: one line each. The parser, `--set`, `--vary`, the help and the summary all read this list.

use super::bodies::{profile, spatula, strip};
use super::error::ValueError;
use super::key::Key;
use super::key::kind::{Kind, Need, Need::Optional, Need::Required};
use super::near::nearest;
use super::scene::Scene;
use super::tables::optimisation::settings as opt;
use super::tables::uncertainty::settings as uncertainty;
use super::tables::{fit, rate, seta, tips};
use super::value::Value;
use super::value::quantity::{
    Dimension::Angle, Dimension::AnglePerLength, Dimension::Density, Dimension::Energy, Dimension::Force,
    Dimension::Length, Dimension::Pressure, Dimension::Stiffness, Dimension::Time, Dimension::Velocity,
    Dimension::Work,
};
use super::{shape, space};
use peelkit::adhesion::Substrate;
use peelkit::model::{Discretisation, MOST_FORKS, Range};
use peelkit::study::coarsening::CoarseningOptions;
use peelkit::study::{Accuracy, Choice};

const fn key(table: &'static str, name: &'static str, need: Need, kind: Kind, about: &'static str) -> Key {
    Key { table, name, need, kind, about }
}

/// What the tolerance of a table of tips may be.
const TIP_TOLERANCES: Range = Range::From(CoarseningOptions::TOLERANCES[0], CoarseningOptions::TOLERANCES[1]);

/// Every key that a scene may hold, in the order in which a scene is written.
#[rustfmt::skip]
pub static KEYS: &[Key] = &[
    key("", "title", Optional, Kind::Text(|s| &mut s.title), "heading of pictures and tables"),
    key("", "terms", Optional, Kind::Terms(|s| &mut s.accuracy.terms), "model terms: all, or automatic model reduction to the tolerance"),
    key("", "space", Optional, Kind::InSpace, "peels the body in space; implied by its keys"),

    key("strip", "length", Required, Kind::Quantity(Length, |s| &mut strip(s).length), "length L of the strip"),
    key("strip", "height", Required, Kind::Quantity(Length, |s| &mut strip(s).height), "height h of the section"),
    key("strip", "width", Optional, Kind::Quantity(Length, |s| &mut strip(s).width), "width of the section"),
    key("strip", "youngs_modulus", Required, Kind::Quantity(Pressure, |s| &mut strip(s).youngs_modulus), "Young's modulus E"),
    key("strip", "poissons_ratio", Optional, Kind::Number(Range::POISSONS_RATIO, |s| &mut strip(s).poissons_ratio), "Poisson's ratio"),
    key("strip", "shear_correction", Optional, Kind::Number(Range::Positive, |s| &mut strip(s).shear_correction), "shear correction factor of the section"),
    key("strip", "bending_stiffness_factor", Optional, Kind::Number(Range::Positive, |s| &mut strip(s).bending_stiffness_factor), "multiplies the bending stiffness EI alone"),
    key("strip", "crack", Optional, Kind::Bound(Length, |s| &mut strip(s).crack), "length of an initial crack at the grip"),
    key("strip", "section", Optional, Kind::Section(|s| &mut space::of(s).section), "in space: outline of the section"),

    key("spatula", "pad_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).pad_length), "length of the flat pad at the tip"),
    key("spatula", "neck_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).neck_length), "length of the neck, from the pad to the shaft"),
    key("spatula", "shaft_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).shaft_length), "length of the shaft beyond the neck"),
    key("spatula", "bend_length", Optional, Kind::Quantity(Length, |s| &mut spatula(s).bend_length), "length beyond the pad over which the axis bends up"),
    key("spatula", "tip_width", Optional, Kind::Quantity(Length, |s| &mut spatula(s).tip_width), "width of the pad at the tip"),
    key("spatula", "neck_width", Optional, Kind::Quantity(Length, |s| &mut spatula(s).neck_width), "width of the pad at its end"),
    key("spatula", "shaft_diameter", Optional, Kind::Quantity(Length, |s| &mut spatula(s).shaft_diameter), "diameter of the shaft"),
    key("spatula", "pad_thickness", Optional, Kind::Quantity(Length, |s| &mut spatula(s).pad_thickness), "height of the pad's section"),
    key("spatula", "shaft_angle", Optional, Kind::Measure(Angle, Range::SHAFT_ANGLE, |s| &mut spatula(s).shaft_angle), "angle of the shaft to the pad"),
    key("spatula", "tip_rounding_length", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut spatula(s).tip_rounding_length), "length over which the tip is rounded; 0: blunt"),
    key("spatula", "tip_rounding_width", Optional, Kind::Quantity(Length, |s| &mut spatula(s).tip_rounding_width), "width of the end face of a rounded tip"),
    key("spatula", "youngs_modulus", Optional, Kind::Quantity(Pressure, |s| &mut spatula(s).material.youngs_modulus), "Young's modulus E"),
    key("spatula", "poissons_ratio", Optional, Kind::Number(Range::POISSONS_RATIO, |s| &mut spatula(s).material.poissons_ratio), "Poisson's ratio"),
    key("spatula", "shear_correction", Optional, Kind::Number(Range::Positive, |s| &mut spatula(s).material.shear_correction), "shear correction factor of the section"),
    key("spatula", "bending_stiffness_factor", Optional, Kind::Number(Range::Positive, |s| &mut spatula(s).material.bending_stiffness_factor), "multiplies the bending stiffness EI alone"),

    key("profile", "table", Required, Kind::Table(|s| &mut profile(s).form), "beam as CSV, or name of its file"),
    key("profile", "pieces", Required, Kind::Pieces(|s| &mut profile(s).form), "beam piece by piece, instead of table"),
    key("profile", "youngs_modulus", Required, Kind::Quantity(Pressure, |s| &mut profile(s).material.youngs_modulus), "Young's modulus E"),
    key("profile", "poissons_ratio", Optional, Kind::Number(Range::POISSONS_RATIO, |s| &mut profile(s).material.poissons_ratio), "Poisson's ratio"),
    key("profile", "shear_correction", Optional, Kind::Number(Range::Positive, |s| &mut profile(s).material.shear_correction), "shear correction factor of the section"),
    key("profile", "bending_stiffness_factor", Optional, Kind::Number(Range::Positive, |s| &mut profile(s).material.bending_stiffness_factor), "multiplies the bending stiffness EI alone"),

    key("seta", "forks", Optional, Kind::Count(MOST_FORKS, |s| &mut seta::of(s).seta.forks), "forks from root to tip: 2^forks tips"),
    key("seta", "tip_pitch", Optional, Kind::Quantity(Length, |s| &mut seta::of(s).seta.tip_pitch), "distance of neighbouring tips on their grid"),
    key("seta", "shaft_length", Optional, Kind::Quantity(Length, |s| &mut seta::of(s).seta.shaft_length), "length from the root to the first fork"),
    key("seta", "shaft_angle", Optional, Kind::Measure(Angle, Range::SETA_ANGLE, |s| &mut seta::of(s).seta.shaft_angle), "angle of the shaft to the normal of the ground"),
    key("seta", "shaft_diameter", Optional, Kind::Quantity(Length, |s| &mut seta::of(s).seta.shaft_diameter), "diameter of the shaft"),
    key("seta", "brush_height", Optional, Kind::Quantity(Length, |s| &mut seta::of(s).seta.brush_height), "height of the first fork above the tips"),
    key("seta", "brush_angle", Optional, Kind::Measure(Angle, Range::SETA_ANGLE, |s| &mut seta::of(s).seta.brush_angle), "angle of the brush to the normal of the ground"),
    key("seta", "height_ratio", Optional, Kind::Number(Range::Between(0.0, 1.0), |s| &mut seta::of(s).seta.height_ratio), "q: fork k stands at H (q^k - q^n)/(1 - q^n)"),
    key("seta", "diameter_ratio", Optional, Kind::Number(Range::Between(0.0, 1.0), |s| &mut seta::of(s).seta.diameter_ratio), "diameter of a branch over that of its parent"),
    key("seta", "height_scatter", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut seta::of(s).seta.height_scatter), "half the range of the heights of the tips"),
    key("seta", "lateral_stiffness", Optional, Kind::Bound(Stiffness, |s| &mut seta::of(s).lateral_stiffness), "stiffness that holds tips; none: they slide"),
    key("seta", "contact_height", Optional, Kind::Measure(Length, Range::ROUNDING_LENGTH, |s| &mut seta::of(s).contact_height), "height at which a detached tip adheres again"),
    key("seta", "preload", Optional, Kind::Bound(Force, |s| &mut seta::of(s).preload), "presses the seta on first; none: it adheres"),
    key("seta", "tip_law", Optional, Kind::Setting(&tips::TIP_LAW), "what tips follow: the curve of their pull, or their table"),
    key("seta", "tip_table", Optional, Kind::Setting(&tips::TIP_TABLE), "folder of peel coarsen with it; none: it is computed"),
    key("seta", "tip_tolerance", Optional, Kind::Number(TIP_TOLERANCES, |s| &mut seta::of(s).tip_tolerance), "error that it may have, relative to the largest force"),
    key("seta", "resolve_within", Optional, Kind::Bound(Length, |s| &mut seta::of(s).resolve_within), "tips so near to snapping off are solved; none: by the table"),
    key("seta", "youngs_modulus", Optional, Kind::Quantity(Pressure, |s| &mut seta::of(s).seta.material.youngs_modulus), "Young's modulus E of all branches"),
    key("seta", "poissons_ratio", Optional, Kind::Number(Range::POISSONS_RATIO, |s| &mut seta::of(s).seta.material.poissons_ratio), "Poisson's ratio"),
    key("seta", "shear_correction", Optional, Kind::Number(Range::Positive, |s| &mut seta::of(s).seta.material.shear_correction), "shear correction factor of the section"),
    key("seta", "bending_stiffness_factor", Optional, Kind::Number(Range::Positive, |s| &mut seta::of(s).seta.material.bending_stiffness_factor), "multiplies the bending stiffness EI alone"),

    key("adhesion", "hamaker_constant", Required, Kind::Quantity(Energy, |s| &mut s.model.adhesion.hamaker_constant), "Hamaker constant A_H of van der Waals forces"),
    key("adhesion", "equilibrium_distance", Required, Kind::Quantity(Length, |s| &mut s.model.adhesion.equilibrium_distance), "r0 of a pair of molecules; gap at rest"),
    key("adhesion", "law", Optional, Kind::Attraction(|s| &mut s.model.adhesion.attraction), "adhesion model: law of the half space, or a cohesive law"),
    key("adhesion", "work", Optional, Kind::Bound(Work, |s| &mut s.model.adhesion.work), "work of adhesion of a cohesive law; else the half space's"),
    key("adhesion", "strength", Optional, Kind::Bound(Pressure, |s| &mut s.model.adhesion.strength), "largest traction of a cohesive law; else the half space's"),
    key("adhesion", "line_load", Optional, Kind::LineLoad(|s| &mut s.model.adhesion.line_load), "force and moment, force alone, or independent of rotation"),
    key("adhesion", "far_face", Optional, Kind::Flag(|s| &mut s.model.adhesion.far_face), "whether the attraction of the upper surface is included"),

    key("substrate", "shape", Optional, Kind::Shape(substrate), "shape of the substrate"),
    key("substrate", "radius", Required, Kind::Quantity(Length, |s| shape::number(substrate(s), "radius")), "radius of the sphere or cylinder"),
    key("substrate", "height", Required, Kind::Quantity(Length, |s| shape::number(substrate(s), "height")), "height from crest to valley"),
    key("substrate", "wavelength", Required, Kind::Quantity(Length, |s| shape::number(substrate(s), "wavelength")), "distance from crest to crest"),
    key("substrate", "offset", Optional, Kind::Measure(Length, Range::OFFSET, |s| shape::number(substrate(s), "offset")), "distance of a crest, or of the top, from the free end"),
    key("substrate", "table", Required, Kind::Heights(substrate), "height profile as a CSV, or the name of its file"),
    key("substrate", "start", Optional, Kind::Start(|s| &mut s.model.ground.start), "initially pressed on and conforming, or lying on the crests"),

    key("friction", "strength", Optional, Kind::Bound(Pressure, |s| &mut s.model.friction.strength), "shear strength of the contact; none: it slides freely"),
    key("friction", "coefficient", Optional, Kind::Number(Range::FRICTION_COEFFICIENT, |s| &mut s.model.friction.coefficient), "Coulomb's friction coefficient"),
    key("friction", "presliding", Optional, Kind::Bound(Length, |s| &mut s.model.friction.presliding), "elastic presliding displacement"),

    key("grip", "rotation", Optional, Kind::Hold(|s| &mut s.model.grip.rotation), "rotation of the right end, which is pulled"),
    key("grip", "horizontal", Optional, Kind::Hold(|s| &mut s.model.grip.horizontal), "displacement normal to the pull direction"),
    key("grip", "lateral", Optional, Kind::Hold(|s| &mut space::of(s).lateral), "in space: displacement normal to the plane of the pull"),
    key("grip", "roll", Optional, Kind::Hold(|s| &mut space::of(s).roll), "in space: rotation of the right end about its axis"),
    key("grip", "yaw", Optional, Kind::Hold(|s| &mut space::of(s).yaw), "in space: rotation of the right end about y"),
    key("grip", "stiffness", Optional, Kind::Bound(Stiffness, |s| &mut s.model.grip.stiffness), "stiffness of a spring between grip and machine"),
    key("grip", "pretension", Optional, Kind::Bound(Force, |s| &mut s.model.grip.pretension), "adhered under this pretension; needs horizontal = \"fixed\""),

    key("drive", "angle", Optional, Kind::Measure(Angle, Range::PULL_ANGLE, |s| &mut s.model.pull.angle), "angle of the pull to the substrate; 90 deg: straight up"),
    key("drive", "azimuth", Optional, Kind::Measure(Angle, Range::AZIMUTH, |s| &mut space::of(s).azimuth), "in space: direction of the pull; 90 deg: sideways"),
    key("drive", "turn", Optional, Kind::Measure(AnglePerLength, Range::PULL_TURN, |s| &mut s.model.pull.turn), "rotation of a fixed grip per displacement"),
    key("drive", "steps", Optional, Kind::Steps(|s| &mut s.model.steps), "press, lift, drag, push, turn, release, hold, shift, roll, yaw first"),

    key("time", "rate", Required, Kind::Quantity(Velocity, |s| &mut rate::of(s).rate), "velocity of what moves the grip"),
    key("time", "density", Required, Kind::Measure(Density, Range::From(0.0, 1e6), |s| &mut rate::of(s).density), "density of the beam; 0: without inertia, as of a seta"),
    key("time", "material", Optional, Kind::Setting(&rate::MATERIAL), "whether and how the material flows"),
    key("time", "retardation_time", Optional, Kind::Bound(Time, |s| &mut rate::of(s).retardation_time), "of a Kelvin-Voigt material: viscosity over modulus"),
    key("time", "relaxation_time", Optional, Kind::Bound(Time, |s| &mut rate::of(s).relaxation_time), "of a standard linear solid: at constant strain"),
    key("time", "stiffness_ratio", Optional, Kind::Share(Range::Between(1.0, 1e6), |s| &mut rate::of(s).stiffness_ratio), "of a standard linear solid: instantaneous over relaxed modulus"),
    key("time", "displacement", Optional, Kind::Bound(Length, |s| &mut rate::of(s).displacement), "where the grip comes to rest; none: length of body or seta"),
    key("time", "held", Optional, Kind::Bound(Time, |s| &mut rate::of(s).held), "time at rest behind that; none: ends where nothing adheres"),
    key("time", "acceleration", Optional, Kind::Bound(Length, |s| &mut rate::of(s).acceleration), "way on which the grip accelerates; none: about 0.1 r0, seta 20 nm"),
    key("time", "tolerance", Optional, Kind::Number(Range::Between(0.0, 0.1), |s| &mut rate::of(s).tolerance), "error of a step in time over the gap; of a seta over 10 nm, 1e-5"),

    key("accuracy", "relative", Optional, Kind::Number(Accuracy::RELATIVE, |s| &mut s.accuracy.relative), "relative tolerance of every reported force and displacement"),
    key("accuracy", "order", Optional, Kind::Fixed(Discretisation::MOST_ORDER, |s| &mut s.accuracy.choice.order), "order p of the elements"),
    key("accuracy", "elements", Optional, Kind::Fixed(2000, |s| &mut s.accuracy.choice.elements), "number of elements, never raised"),
    key("accuracy", "step", Optional, Kind::Share(Choice::STEP, |s| &mut s.accuracy.choice.step), "predictor tolerance over the equilibrium gap"),

    key("path", "until", Optional, Kind::Until(|s| &mut s.bounds.until), "as far as what the path is followed"),

    key("bounds", "points", Optional, Kind::Count(1_000_000_000, |s| &mut s.bounds.points), "largest number of points of a path"),
    key("bounds", "time", Optional, Kind::Bound(Time, |s| &mut s.bounds.time_s), "longest time for a path"),
    key("bounds", "displacement", Optional, Kind::Bound(Length, |s| &mut s.bounds.displacement), "largest displacement of the grip"),

    key("fit", "parameters", Required, Kind::Setting(&fit::PARAMETERS), "keys to determine, with bounds if wanted"),
    key("fit", "force_error", Optional, Kind::Bound(Force, |s| &mut fit::of(s).options.force_error), "standard error of measured forces; none: from the residuals"),
    key("fit", "displacement_error", Optional, Kind::Bound(Length, |s| &mut fit::of(s).options.displacement_error), "standard error of measured displacements; none: exact"),
    key("fit", "displacement_zero", Optional, Kind::Measure(Length, Range::OFFSET, |s| &mut fit::of(s).options.displacement_zero), "measured displacement at which the model's is zero"),
    key("fit", "jump", Optional, Kind::Bound(Length, |s| &mut fit::of(s).jump), "measured displacement of the first jump; none: looked for"),
    key("fit", "use_jump", Optional, Kind::Flag(|s| &mut fit::of(s).options.use_jump), "whether the displacement of the jump is a datum"),
    key("fit", "loss", Optional, Kind::Setting(&fit::LOSS), "how much points far from the curve count"),
    key("fit", "profile", Optional, Kind::Setting(&fit::PROFILE), "of which parameters the profile likelihood is computed"),

    key("optimise", "objective", Required, Kind::Setting(&opt::OBJECTIVE), "result that is optimised"),
    key("optimise", "goal", Optional, Kind::Setting(&opt::GOAL), "whether it is to be large or small"),
    key("optimise", "holding_angle", Optional, Kind::Setting(&opt::HOLDING_ANGLE), "optimises a ratio: angle of the pull above the line"),
    key("optimise", "release_angle", Optional, Kind::Setting(&opt::RELEASE_ANGLE), "angle of the pull below the line of that ratio"),
    key("optimise", "parameters", Optional, Kind::Setting(&opt::PARAMETERS), "keys that are free, with their bounds"),
    key("optimise", "width", Optional, Kind::Setting(&opt::WIDTH), "bounds and smoothness of the width along the body"),
    key("optimise", "height", Optional, Kind::Setting(&opt::HEIGHT), "bounds and smoothness of the height along the body"),
    key("optimise", "values", Optional, Kind::Setting(&opt::VALUES), "values of a profile along the body"),
    key("optimise", "volume", Optional, Kind::Setting(&opt::VOLUME), "volume of the body, against that of the scene"),
    key("optimise", "method", Optional, Kind::Setting(&opt::METHOD), "how designs are chosen; automatic by the constraints"),
    key("optimise", "starts", Optional, Kind::Setting(&opt::STARTS), "searches, the first from the scene, others from random designs"),
    key("optimise", "evaluations", Optional, Kind::Setting(&opt::EVALUATIONS), "largest number of designs of one search"),
    key("optimise", "neighbours", Optional, Kind::Setting(&opt::NEIGHBOURS), "random designs that the optimum is compared with"),
    key("optimise", "seed", Optional, Kind::Setting(&opt::SEED_OF_STARTS), "another seed gives other random designs"),
    key("optimise", "check", Optional, Kind::Setting(&opt::CHECK), "whether a search without gradients goes on from the optimum"),

    key("uncertainty", "inputs", Required, Kind::Setting(&uncertainty::INPUTS), "keys that are uncertain, with their distributions"),
    key("uncertainty", "correlations", Optional, Kind::Setting(&uncertainty::CORRELATIONS), "inputs that vary together"),
    key("uncertainty", "quantities", Optional, Kind::Setting(&uncertainty::QUANTITIES), "results that are asked for"),
    key("uncertainty", "samples", Optional, Kind::Setting(&uncertainty::SAMPLES), "largest number of peels that are sampled"),
    key("uncertainty", "seed", Optional, Kind::Setting(&uncertainty::SEED), "another seed gives another sample"),
    key("uncertainty", "indices", Optional, Kind::Setting(&uncertainty::INDICES), "whether sensitivity indices are estimated"),
];

/// What the scene's body lies on.
fn substrate(scene: &mut Scene) -> &mut Substrate {
    &mut scene.model.ground.substrate
}

/// The tables of a scene.
pub fn tables() -> Vec<&'static str> {
    let mut tables: Vec<_> = KEYS.iter().map(|key| key.table).filter(|table| !table.is_empty()).collect();
    tables.dedup();
    tables
}

/// The key with this path, such as `strip.length`; or what would be right.
pub fn find_key(path: &str) -> Result<&'static Key, ValueError> {
    let path = path.trim();
    if let Some(key) = KEYS.iter().find(|key| key.path() == path) {
        return Ok(key);
    }
    let paths: Vec<String> = KEYS.iter().map(Key::path).collect();
    let name = path.rsplit('.').next().unwrap_or(path);
    let same_name = KEYS.iter().find(|key| key.name == name).map(Key::path);
    let remedy = match same_name.as_deref().or_else(|| nearest(path, paths.iter().map(String::as_str))) {
        Some(near) => format!("Did you mean `{near}`?"),
        None => what_there_is(path.split_once('.').map_or("", |(table, _)| table)),
    };
    Err(ValueError::new("is not a key of a scene", remedy))
}

/// The keys of this table; the tables where there is none of this name.
fn what_there_is(table: &str) -> String {
    let keys: Vec<&str> = KEYS.iter().filter(|key| key.table == table).map(|key| key.name).collect();
    if table.is_empty() || keys.is_empty() {
        format!(
            "A key is written table.key, such as strip.height; `peel keys` lists them. The tables are {}.",
            tables().join(", ")
        )
    } else {
        format!("The keys of [{table}] are {}.", keys.join(", "))
    }
}

impl Key {
    /// What holds where a scene does not give the key.
    pub fn default_value(&self) -> Option<Value> {
        match self.need {
            Need::Required => None,
            Need::Optional => self.value(&Scene::of_defaults()),
        }
    }
}
