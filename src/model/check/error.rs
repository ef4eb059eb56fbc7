//! What is wrong with a model.

use super::{Measured, Range};
use crate::adhesion::{Attraction, Misfit};
use crate::model::{Step, StepError};

/// What is wrong with a model: the key of a scene that gives the value, what was found, and what would be right. It reads as one
/// sentence: "`strip.length` is 0 nm, which has no meaning here".
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
pub enum ModelErrorKind {
    /// A number that is not finite.
    #[error("is {found}, which is not a finite number")]
    NotFinite { found: Measured, range: Range },
    /// A number outside of its range.
    #[error("is {found}, which has no meaning here")]
    OutOfRange { found: Measured, range: Range },

    /// Work of adhesion or strength beside a law that has its own.
    #[error("is of a cohesive law, and the law of this scene is none")]
    NotOfCohesiveLaw { found: Measured },
    /// A pretension of something that is not stretched.
    #[error("stretches a strip on flat ground whose grip is held across the pull, and this scene has none")]
    NotStretched { found: Measured },

    /// A number of friction without a shear strength.
    #[error("is of a contact that resists sliding, and this one has no strength")]
    NoShearStrength { found: Measured },
    /// Friction on ground that is not flat.
    #[error("is given, and the substrate is not flat; friction is that of flat ground")]
    FrictionOffFlatGround { found: Measured },
    /// Friction beside a law that is not the half space's.
    #[error("is given beside a cohesive law; where the face is in contact, friction takes from the half space")]
    FrictionBesideLaw { found: Measured },
    /// A pretension of a strip that friction holds.
    #[error("is given, and friction holds the strip that it stretches only as far as it can")]
    PretensionUnderFriction { found: Measured },

    /// A load without a potential on ground that is not flat; what a scene calls it.
    #[error("is \"{load}\", which has no potential: how a beam comes to lie on ground that is not flat is not defined")]
    NoPotentialOnGround { load: &'static str },
    /// Ground of too many waves or radii.
    #[error("is that of ground on which the beam lies on {found:.0} waves or radii; no more than {most} are resolved")]
    TooManyDetails { found: f64, most: f64 },
    /// Ground on which a beam lies on too many process zones.
    #[error(
        "is not flat, where elements have to be small wherever the beam lies, and it lies on {found:.0} process zones; no more than {most} are resolved"
    )]
    TooManyZones { found: f64, most: f64 },
    /// Numbers of a substrate that do not fit one another.
    #[error("{}", .0.found)]
    Substrate(Misfit),

    /// A grip that is free to turn and has to, rad/nm.
    #[error("is {turn} rad/nm, and `grip.rotation` is \"free\": such a grip does not turn the end")]
    TurnOfFreeGrip { turn: f64 },
    /// A grip that turns under a load without a potential.
    #[error(
        "turns the grip under a load that has no potential: its work, of force and moment, is told as a change of energy"
    )]
    TurnWithoutPotential { found: Measured },
    /// A step that turns a grip that is free to turn.
    #[error("has the step \"{step}\", and `grip.rotation` is \"free\": such a grip does not turn the end")]
    StepOfFreeGrip { step: Step },
    /// A step that is none; steps are counted from 1.
    #[error("has as step {number} \"{step}\", {wrong}")]
    Step { number: usize, step: Step, wrong: StepError },
    /// More steps than are taken.
    #[error("has {found} steps, more than {most}")]
    TooManySteps { found: usize, most: usize },
    /// A pull along a strip, degrees.
    #[error("is {degrees} degrees, along the strip, which that only stretches or presses")]
    AlongStrip { degrees: f64 },

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
            | Self::NotStretched { found }
            | Self::NoShearStrength { found }
            | Self::FrictionOffFlatGround { found }
            | Self::FrictionBesideLaw { found }
            | Self::PretensionUnderFriction { found }
            | Self::TurnWithoutPotential { found } => Some(found),
            Self::TurnOfFreeGrip { turn } => measured(turn, "rad/nm"),
            Self::AlongStrip { degrees } => measured(degrees, "deg"),
            Self::RoundingBeyondPad { found, .. }
            | Self::RoundingWiderThanTip { found, .. }
            | Self::BendBeyondShaft { found, .. } => measured(found, "nm"),
            Self::TooManySteps { found, .. } => measured(found as f64, ""),
            Self::NoPotentialOnGround { .. }
            | Self::TooManyDetails { .. }
            | Self::TooManyZones { .. }
            | Self::Substrate(_)
            | Self::StepOfFreeGrip { .. }
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
                    "Give `law` = {} beside it, or leave it away: without one, hamaker_constant and equilibrium_distance say all.",
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
            Self::NotStretched { .. } => {
                "Peel a [strip] with `horizontal = \"fixed\"` under [grip], on a flat substrate, or leave `pretension` away."
            }
            Self::NoShearStrength { .. } => {
                "Give `strength = \"50 MPa\"` beside it under [friction], or leave the table away."
            }
            Self::FrictionOffFlatGround { .. } => "Leave the table [substrate] or the table [friction] away.",
            Self::FrictionBesideLaw { .. } => {
                "Take `law = \"body-force\"` or \"surface-traction\" under [adhesion], or leave the table [friction] away."
            }
            Self::PretensionUnderFriction { .. } => "Leave `pretension` or the table [friction] away.",
            Self::NoPotentialOnGround { .. } => "Take another line_load or law, or leave the table [substrate] away.",
            Self::TooManyDetails { .. } => {
                "Take a shorter strip or pad, a longer wave, or a profile that is given at fewer places."
            }
            Self::TooManyZones { .. } => "Take a shorter or a stiffer strip or pad.",
            Self::TurnOfFreeGrip { .. } => "Give `rotation = \"fixed\"` under [grip], or leave `turn` away.",
            Self::TurnWithoutPotential { .. } => {
                "Take another law or line_load under [adhesion], or leave `turn` away."
            }
            Self::StepOfFreeGrip { .. } => "Give `rotation = \"fixed\"` under [grip], or leave the step away.",
            Self::Step { .. } => {
                "Give lengths above zero, angles that are not zero, and \"hold\" for a step that moves nothing."
            }
            Self::TooManySteps { .. } => "Take fewer steps: one that is longer in place of several.",
            Self::AlongStrip { .. } => "Pull at an angle between, above 0 and below 180 degrees: `angle = \"60 deg\"`.",
            Self::RoundingBeyondPad { .. } => "Round no more than the pad: `tip_rounding_length` at most `pad_length`.",
            Self::RoundingWiderThanTip { .. } => {
                "A rounded tip is narrower at its end: `tip_rounding_width` at most `tip_width`."
            }
            Self::BendBeyondShaft { .. } => {
                "Let the bend end on the shaft: `bend_length` at most `neck_length` and `shaft_length` together."
            }
        }
    }
}
