//! What is wrong with a model, and which values of a single number have a meaning.

use crate::adhesion::section::law::Attraction;
use crate::adhesion::spatial_section::error::SpatialSectionError;
use crate::adhesion::substrate::surface::Misfit;
use crate::model::step::{Step, StepError};
use std::fmt;

/// What is wrong with a model: the key of a scene that gives the value, what was found, and what would be right. It reads as one
/// sentence: "`strip.length` is 0 nm, which is out of range".
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("`{key}` {kind}")]
pub struct ModelError {
    key: &'static str,
    kind: ModelErrorKind,
}

impl ModelError {
    /// That the value of this key is as `kind` says.
    pub const fn new(key: &'static str, kind: ModelErrorKind) -> Self {
        Self { key, kind }
    }

    /// What a scene calls the value: "strip.length".
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// What is wrong with it, with all numbers.
    pub fn kind(&self) -> &ModelErrorKind {
        &self.kind
    }

    /// The number that was found, where the value is one.
    pub fn value(&self) -> Option<Measured> {
        self.kind.value()
    }

    /// What was found and what is wrong with it: completes "`strip.length` ...".
    pub fn found(&self) -> String {
        self.kind.to_string()
    }

    /// What would be right: a sentence of its own.
    pub fn remedy(&self) -> String {
        self.kind.remedy()
    }
}

/// What is wrong with a value, or with two that do not fit one another. Lengths in nm.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum ModelErrorKind {
    /// A number that is not finite.
    #[error("is {found}, which is not a finite number")]
    NotFinite { found: Measured, range: Range },
    /// A number outside of its range.
    #[error("is {found}, which is out of range{}", range.exceeded(found.value))]
    OutOfRange { found: Measured, range: Range },

    /// Work of adhesion or strength beside a law that has its own.
    #[error("belongs to a cohesive law, and the law of this scene is not cohesive")]
    NotOfCohesiveLaw { found: Measured },
    /// The same beside a table of tractions.
    #[error("follows from the table of tractions")]
    BesideTable { found: Measured },
    /// A work in shear without a shear strength.
    #[error("belongs to an adhesive that holds along the substrate, and this one has no shear strength")]
    NotHeldInShear { found: Measured },
    /// An exponent that mixes two works, without a work in shear.
    #[error("mixes the works of opening and of slip, and this adhesive has one work alone")]
    NothingToMix { found: Measured },
    /// A tangent modulus without a yield strength.
    #[error("is the slope of stress over strain beyond yielding, and the strip has no yield strength")]
    NothingToHarden { found: Measured },
    /// A tangent modulus that is not below Young's modulus.
    #[error("is no less than Young's modulus, {youngs_modulus} GPa: the strip would not yield")]
    NoSofter { found: Measured, youngs_modulus: f64 },
    /// Something beside what is not computed with it.
    #[error("is given beside {what}, which is not computed with {with}")]
    Beside { what: &'static str, with: &'static str },
    /// A pretension of something that is not stretched.
    #[error(
        "stretches a strip on a flat substrate whose grip is constrained normal to the pull direction, and this scene has none"
    )]
    NotStretched { found: Measured },

    /// A number of friction without a shear strength.
    #[error("belongs to a contact with friction, and this one has no strength")]
    NoShearStrength { found: Measured },
    /// Friction on ground that is not flat.
    #[error("is given, and the substrate is not flat; friction requires a flat substrate")]
    FrictionOffFlatGround { found: Measured },
    /// Friction beside a law that is not the half space's.
    #[error(
        "is given beside a cohesive law; friction requires a half-space law, which defines where the face is in contact"
    )]
    FrictionBesideLaw { found: Measured },
    /// A pretension of a strip that friction holds.
    #[error("is given, and friction cannot hold the stretched strip up to an arbitrary tension")]
    PretensionUnderFriction { found: Measured },

    /// A load without a potential on ground that is not flat; what a scene calls it.
    #[error(
        "is \"{load}\", which has no potential: the initial equilibrium on a substrate that is not flat is not defined"
    )]
    NoPotentialOnGround { load: &'static str },
    /// Ground of too many waves or radii.
    #[error("lets the beam lie on {found:.0} waves or radii; at most {most} are resolved")]
    TooManyDetails { found: f64, most: f64 },
    /// Ground on which a beam lies on too many process zones.
    #[error(
        "is not flat, which requires small elements along the whole contact of {found:.0} process zones; at most {most} are resolved"
    )]
    TooManyZones { found: f64, most: f64 },
    /// A beam of too many process zones.
    #[error("makes the beam {found:.1e} process zones long; at most {most:e} are resolved")]
    TooLong { found: f64, most: f64 },
    /// Numbers of a substrate that do not fit one another.
    #[error("{}", .0.found)]
    Substrate(Misfit),

    /// A grip that is free to turn and has to, rad/nm.
    #[error("is {turn} rad/nm, and `grip.rotation` is \"free\": such a grip cannot rotate the end")]
    TurnOfFreeGrip { turn: f64 },
    /// A grip that turns under a load without a potential.
    #[error(
        "rotates the grip under a load without a potential: the work of force and moment is computed as a change of energy"
    )]
    TurnWithoutPotential { found: Measured },
    /// A step that turns a grip that is free to turn.
    #[error("has the step \"{step}\", and `grip.{held}` is \"free\": such a grip cannot rotate the end")]
    StepOfFreeGrip { step: Step, held: &'static str },
    /// A step that takes a strip in the plane out of it.
    #[error("has the step \"{step}\", which leaves the plane, and this scene is in the plane")]
    StepOutOfPlane { step: Step },
    /// A step that is none; steps are counted from 1.
    #[error("has as step {number} \"{step}\", {wrong}")]
    Step { number: usize, step: Step, wrong: StepError },
    /// More steps than are taken.
    #[error("has {found} steps, more than {most}")]
    TooManySteps { found: usize, most: usize },
    /// Something that is not offered in space.
    #[error("is given, and this scene is in space, where {why}")]
    NotInSpace { why: &'static str },
    /// An adhesion law that a section in space does not have.
    #[error("is not offered in space: {0}")]
    LawInSpace(SpatialSectionError),
    /// A pull along a strip, degrees.
    #[error("is {degrees} degrees, along the strip, which is then only stretched or compressed")]
    AlongStrip { degrees: f64 },

    /// A crack as long as its strip.
    #[error("is {found} nm, and the strip is {length} nm long: nothing adheres")]
    CrackOfWholeLength { found: f64, length: f64 },

    /// A strip whose height or material is not that of its layers.
    #[error("gives the strip its height and its material, and these are others")]
    NotOfLayers,

    /// A spatula rounded over more than its pad.
    #[error("is {found} nm, more than the pad is long ({pad} nm)")]
    RoundingBeyondPad { found: f64, pad: f64 },
    /// A spatula whose end face is wider than its tip.
    #[error("is {found} nm, more than the tip is wide ({tip} nm)")]
    RoundingWiderThanTip { found: f64, tip: f64 },
    /// A spatula that bends over more than neck and shaft.
    #[error("is {found} nm, more than neck and shaft are long ({behind} nm)")]
    BendBeyondShaft { found: f64, behind: f64 },
}

impl ModelErrorKind {
    /// The number that was found, where it is one.
    pub fn value(&self) -> Option<Measured> {
        let measured = |value, unit| Some(Measured { value, unit });
        match *self {
            Self::NotFinite { found, .. }
            | Self::OutOfRange { found, .. }
            | Self::NotOfCohesiveLaw { found }
            | Self::BesideTable { found }
            | Self::NotStretched { found }
            | Self::NotHeldInShear { found }
            | Self::NothingToMix { found }
            | Self::NothingToHarden { found }
            | Self::NoSofter { found, .. }
            | Self::NoShearStrength { found }
            | Self::FrictionOffFlatGround { found }
            | Self::FrictionBesideLaw { found }
            | Self::PretensionUnderFriction { found }
            | Self::TurnWithoutPotential { found } => Some(found),
            Self::TurnOfFreeGrip { turn } => measured(turn, "rad/nm"),
            Self::AlongStrip { degrees } => measured(degrees, "deg"),
            Self::CrackOfWholeLength { found, .. }
            | Self::RoundingBeyondPad { found, .. }
            | Self::RoundingWiderThanTip { found, .. }
            | Self::BendBeyondShaft { found, .. } => measured(found, "nm"),
            Self::TooManySteps { found, .. } => measured(found as f64, ""),
            Self::NoPotentialOnGround { .. }
            | Self::TooManyDetails { .. }
            | Self::TooManyZones { .. }
            | Self::TooLong { .. }
            | Self::Substrate(_)
            | Self::NotInSpace { .. }
            | Self::Beside { .. }
            | Self::NotOfLayers
            | Self::LawInSpace(_)
            | Self::StepOfFreeGrip { .. }
            | Self::StepOutOfPlane { .. }
            | Self::Step { .. } => None,
        }
    }

    /// What would be right: a sentence of its own.
    pub fn remedy(&self) -> String {
        match self {
            Self::NotFinite { found, range } | Self::OutOfRange { found, range } if found.unit.is_empty() => {
                format!("Give {range}.")
            }
            Self::NotFinite { found, range } | Self::OutOfRange { found, range } => {
                format!("Give {range}, in {}.", found.unit)
            }
            Self::NotOfCohesiveLaw { .. } => {
                let laws: Vec<String> = Attraction::cohesive().map(|law| format!("\"{}\"", law.name())).collect();
                format!(
                    "Give `law` = {} beside it, or remove it: without `law` the adhesion is that of van der Waals forces, which `hamaker_constant` and `equilibrium_distance` define.",
                    laws.join(" or ")
                )
            }
            Self::Substrate(misfit) => misfit.remedy.into(),
            other => other.plain_remedy().into(),
        }
    }

    /// The remedy that is the same whatever the numbers.
    fn plain_remedy(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } | Self::OutOfRange { .. } | Self::NotOfCohesiveLaw { .. } | Self::Substrate(_) => "",
            Self::BesideTable { .. } => "Remove it, or use another `law` than \"table\".",
            Self::NotHeldInShear { .. } => {
                "Give `shear_strength = \"1 MPa\"` beside it under [adhesion], or remove it."
            }
            Self::NothingToMix { .. } => {
                "Give `shear_work = \"300 J/m2\"` and a `shear_strength` beside it under [adhesion], or remove it."
            }
            Self::NothingToHarden { .. } => {
                "Give `yield_strength = \"100 MPa\"` beside it under [strip], or remove it."
            }
            Self::NoSofter { .. } => "Give a smaller one: a twentieth of `youngs_modulus`, say.",
            Self::NotStretched { .. } => {
                "Peel a [strip] with `horizontal = \"fixed\"` under [grip], on a flat substrate, or remove `pretension`."
            }
            Self::NoShearStrength { .. } => {
                "Give `strength = \"50 MPa\"` beside it under [friction], or remove the table."
            }
            Self::FrictionOffFlatGround { .. } => "Remove the table [substrate] or the table [friction].",
            Self::FrictionBesideLaw { .. } => {
                "Where the adhesive holds a strip along the substrate give `shear_strength = \"1 MPa\"` under [adhesion] and remove the table [friction]; for dry friction use `law = \"body-force\"` or \"surface-traction\"."
            }
            Self::PretensionUnderFriction { .. } => "Remove `pretension` or the table [friction].",
            Self::NoPotentialOnGround { .. } => "Use another line_load or law, or remove the table [substrate].",
            Self::TooManyDetails { .. } => "Use a shorter strip or pad, a longer wave, or a profile with fewer rows.",
            Self::TooManyZones { .. } => "Use a shorter or a stiffer strip or pad.",
            Self::TooLong { .. } => {
                "Use a shorter beam: from some fifty process zones on the peak does not depend on the length. Or correct a unit."
            }
            Self::TurnOfFreeGrip { .. } => "Give `rotation = \"fixed\"` under [grip], or remove `turn`.",
            Self::TurnWithoutPotential { .. } => {
                "Use another law or line_load under [adhesion] and no `shear_work`, or remove `turn`."
            }
            Self::StepOfFreeGrip { held: "roll", .. } => "Give `roll = \"fixed\"` under [grip], or remove the step.",
            Self::StepOfFreeGrip { held: "yaw", .. } => "Give `yaw = \"fixed\"` under [grip], or remove the step.",
            Self::StepOfFreeGrip { .. } => "Give `rotation = \"fixed\"` under [grip], or remove the step.",
            Self::StepOutOfPlane { .. } => "Give `space = true`, or remove the step.",
            Self::Step { .. } => {
                "Give lengths above zero, shifts and angles that are not zero, and \"hold\" for a step that moves nothing."
            }
            Self::TooManySteps { .. } => "Take fewer steps: one that is longer in place of several.",
            Self::NotInSpace { .. } => {
                "Remove it, or remove `space` and the keys of space: `azimuth`, `lateral`, `roll`, `yaw` and `section`."
            }
            Self::LawInSpace(_) => "Use `law = \"body-force\"` or a cohesive law with `line_load = \"full\"`.",
            Self::AlongStrip { .. } => "Pull at an angle between, above 0 and below 180 degrees: `angle = \"60 deg\"`.",
            Self::CrackOfWholeLength { .. } => "Give a crack that is shorter than the strip: the rest adheres.",
            Self::NotOfLayers => "Make the strip of its layers once more: `strip.of_layers(layers)`.",
            Self::Beside { .. } => "Remove one of the two.",
            Self::RoundingBeyondPad { .. } => "Round the pad at most: `tip_rounding_length` not above `pad_length`.",
            Self::RoundingWiderThanTip { .. } => {
                "A rounded tip is narrower at its end: `tip_rounding_width` not above `tip_width`."
            }
            Self::BendBeyondShaft { .. } => {
                "Let the bend end on the shaft: `bend_length` not above `neck_length` plus `shaft_length`."
            }
        }
    }
}

/// The numbers that have a meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Above zero, from [`Range::LEAST`] to [`Range::LARGEST`].
    Positive,
    /// Both ends excluded.
    Between(f64, f64),
    /// Both ends included.
    From(f64, f64),
}

/// 180 degrees, as a user may round it.
const HALF_TURN: f64 = 1.0001 * std::f64::consts::PI;

impl Range {
    /// The least number above zero that is taken, in the unit of the library: products of such numbers are doubles that keep all of their digits.
    pub const LEAST: f64 = 1e-30;
    /// The largest one.
    pub const LARGEST: f64 = 1e30;
    /// Of Poisson's ratio of an isotropic material.
    pub const POISSONS_RATIO: Self = Self::Between(-1.0, 0.5);
    /// Of the angle of a spatula's shaft, rad.
    pub const SHAFT_ANGLE: Self = Self::From(-HALF_TURN, HALF_TURN);
    /// Of the length over which a spatula's tip is rounded, nm; 0: blunt.
    pub const ROUNDING_LENGTH: Self = Self::From(0.0, 1e9);
    /// Of where a crest of the substrate is, nm.
    pub const OFFSET: Self = Self::From(-1e9, 1e9);
    /// Of what a load cell shows where nothing pulls, nN.
    pub const FORCE_ZERO: Self = Self::From(-1e12, 1e12);
    /// Of Coulomb's coefficient of friction.
    pub(crate) const FRICTION_COEFFICIENT: Self = Self::From(0.0, 1e3);
    /// Of the exponent by which works of opening and of slip mix: with these tractions keep their sign, whatever the works.
    pub const MIXING_EXPONENT: Self = Self::From(1.0, 8.0);
    /// Of the angle of the pull, rad.
    pub const PULL_ANGLE: Self = Self::From(0.0, HALF_TURN);
    /// Of the direction of the pull along the substrate, rad.
    pub(crate) const AZIMUTH: Self = Self::From(-HALF_TURN, HALF_TURN);
    /// Of the angle of a seta's shaft and of its brush to the normal of the ground, rad: up to 89 degrees.
    pub const SETA_ANGLE: Self = Self::From(-1.5533, 1.5533);
    /// Of how the grip turns as it goes, rad/nm.
    pub const PULL_TURN: Self = Self::From(-1e4, 1e4);

    /// Whether the number is in it.
    pub fn contains(self, number: f64) -> bool {
        match self {
            Self::Positive => (Self::LEAST..=Self::LARGEST).contains(&number),
            Self::Between(low, high) => low < number && number < high,
            Self::From(low, high) => low <= number && number <= high,
        }
    }

    /// What is wrong with a number that is not finite or not in it.
    pub fn check(self, found: Measured) -> Result<(), ModelErrorKind> {
        if !found.value.is_finite() {
            return Err(ModelErrorKind::NotFinite { found, range: self });
        }
        if self.contains(found.value) { Ok(()) } else { Err(ModelErrorKind::OutOfRange { found, range: self }) }
    }
}

impl Range {
    /// What a number above zero is beyond, where that is why it is out of range: completes "out of range".
    pub(super) fn exceeded(self, found: f64) -> &'static str {
        match self {
            Self::Positive if found > Self::LARGEST => ": the largest is 1e30",
            Self::Positive if found > 0.0 && found < Self::LEAST => ": the least is 1e-30",
            _ => "",
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Positive => write!(f, "a number above zero"),
            Self::Between(low, high) => write!(f, "a number between {low} and {high}, both excluded"),
            Self::From(low, high) => write!(f, "a number from {low:e} to {high:e}"),
        }
    }
}

/// A number with its unit; the unit is empty where it has none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// In this unit
    pub value: f64,
    /// As in the library: nm, nN, GPa, J/m2, rad
    pub unit: &'static str,
}

impl fmt::Display for Measured {
    /// As a person writes it: "0.4 nm", "1e-19 nm".
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { value, unit } = *self;
        let plain = value == 0.0 || !value.is_finite() || (1e-4..1e7).contains(&value.abs());
        if plain { write!(f, "{value}") } else { write!(f, "{value:e}") }?;
        if unit.is_empty() { Ok(()) } else { write!(f, " {unit}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_as_they_are_written() {
        let shown = |value, unit| Measured { value, unit }.to_string();
        assert_eq!([shown(0.4, "nm"), shown(-0.0, "")], ["0.4 nm", "-0"]);
        assert_eq!([shown(1e7, "nm"), shown(9e-5, ""), shown(-1e-20, "J")], ["1e7 nm", "9e-5", "-1e-20 J"]);
        assert_eq!([shown(f64::NAN, "rad"), shown(f64::NEG_INFINITY, "")], ["NaN rad", "-inf"]);
    }

    #[test]
    fn ends_are_in_or_out() {
        for (range, inside, outside) in [
            (Range::Positive, [1e-30, 1e30], [0.0, -1.0]),
            (Range::Positive, [1e-29, 1e29], [f64::MIN_POSITIVE, 1e300]),
            (Range::Between(-1.0, 0.5), [-0.999, 0.499], [-1.0, 0.5]),
            (Range::From(0.0, 2.0), [0.0, 2.0], [-1e-300, 2.1]),
        ] {
            let unit = "";
            assert!(inside.into_iter().all(|value| range.check(Measured { value, unit }).is_ok()), "{range:?}");
            for value in outside {
                let found = Measured { value, unit };
                assert_eq!(range.check(found), Err(ModelErrorKind::OutOfRange { found, range }));
            }
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let error = range.check(Measured { value, unit }).unwrap_err();
                assert!(matches!(error, ModelErrorKind::NotFinite { .. }), "{value}: {error}");
            }
        }
    }
}
