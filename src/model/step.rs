//! One step of the grip before the pull, as data.

use crate::units::{LENGTHS, Unit};
use serde::{Deserialize, Serialize};
use std::fmt;

/// What the grip does before the pull.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Step {
    /// Towards the substrate, nm
    Press(f64),
    /// Away from it, nm
    Lift(f64),
    /// Along it, away from the body, nm
    Drag(f64),
    /// Along it, towards the body, nm
    Push(f64),
    /// Sideways, along z of a strip in space, nm; negative to the other side
    Shift(f64),
    /// Its rotation, at its place, rad; positive anticlockwise
    Turn(f64),
    /// Its roll, of a strip in space, at its place, rad
    Roll(f64),
    /// Its yaw, likewise
    Yaw(f64),
    /// Lets go of its height, and takes hold of it where it exerts no vertical force.
    Release,
    /// Nothing: equilibria know no time.
    Hold,
}

/// Why a step is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum StepError {
    #[error("whose amount is not a finite number")]
    NotFinite,
    #[error("whose amount is not above zero: lift reverses press, push reverses drag")]
    NotPositive,
    #[error("which is no rotation: write \"hold\"")]
    NoTurn,
    #[error("which is no displacement: write \"hold\"")]
    NoShift,
}

/// What a step moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moved {
    /// y of the grip, nm
    Height,
    /// x of the grip, nm
    Place,
    /// z of the grip, nm
    Side,
    /// θ of the grip, rad
    Rotation,
    /// ρ of the grip, rad
    Roll,
    /// ψ of the grip, rad
    Yaw,
}

impl Moved {
    /// Whether it is an angle, in rad; else a length, in nm.
    pub(crate) fn is_angle(self) -> bool {
        matches!(self, Self::Rotation | Self::Roll | Self::Yaw)
    }

    /// Whether it takes a strip out of its plane.
    pub(crate) fn leaves_plane(self) -> bool {
        matches!(self, Self::Side | Self::Roll | Self::Yaw)
    }
}

impl Step {
    /// What it moves, and by how much, nm or rad; none of a step whose amount is not given.
    pub fn motion(self) -> Option<(Moved, f64)> {
        match self {
            Self::Press(amount) => Some((Moved::Height, -amount)),
            Self::Lift(amount) => Some((Moved::Height, amount)),
            Self::Drag(amount) => Some((Moved::Place, amount)),
            Self::Push(amount) => Some((Moved::Place, -amount)),
            Self::Shift(amount) => Some((Moved::Side, amount)),
            Self::Turn(amount) => Some((Moved::Rotation, amount)),
            Self::Roll(amount) => Some((Moved::Roll, amount)),
            Self::Yaw(amount) => Some((Moved::Yaw, amount)),
            Self::Release | Self::Hold => None,
        }
    }

    /// The same with its amount times a factor.
    pub fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Press(amount) => Self::Press(amount * factor),
            Self::Lift(amount) => Self::Lift(amount * factor),
            Self::Drag(amount) => Self::Drag(amount * factor),
            Self::Push(amount) => Self::Push(amount * factor),
            Self::Shift(amount) => Self::Shift(amount * factor),
            Self::Turn(angle) => Self::Turn(angle * factor),
            Self::Roll(angle) => Self::Roll(angle * factor),
            Self::Yaw(angle) => Self::Yaw(angle * factor),
            Self::Release | Self::Hold => self,
        }
    }

    /// Whether it is one: a finite amount, above zero of a length with a word of its own for the way back, else not zero.
    pub fn check(self) -> Result<(), StepError> {
        let wrong = match self {
            Self::Release | Self::Hold => return Ok(()),
            Self::Press(amount) | Self::Lift(amount) | Self::Drag(amount) | Self::Push(amount) => {
                (!amount.is_finite(), amount <= 0.0, StepError::NotPositive)
            }
            Self::Shift(amount) => (!amount.is_finite(), amount == 0.0, StepError::NoShift),
            Self::Turn(angle) | Self::Roll(angle) | Self::Yaw(angle) => {
                (!angle.is_finite(), angle == 0.0, StepError::NoTurn)
            }
        };
        match wrong {
            (true, ..) => Err(StepError::NotFinite),
            (_, true, why) => Err(why),
            _ => Ok(()),
        }
    }

    /// Whether it moves this.
    pub(crate) fn moves(self, what: Moved) -> bool {
        self.motion().is_some_and(|(moved, _)| moved == what)
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Press(amount) => write!(f, "press {}", exact_length(*amount)),
            Self::Lift(amount) => write!(f, "lift {}", exact_length(*amount)),
            Self::Drag(amount) => write!(f, "drag {}", exact_length(*amount)),
            Self::Push(amount) => write!(f, "push {}", exact_length(*amount)),
            Self::Shift(amount) => write!(f, "shift {}", exact_length(*amount)),
            Self::Turn(amount) => write!(f, "turn {}", angle_text(*amount)),
            Self::Roll(amount) => write!(f, "roll {}", angle_text(*amount)),
            Self::Yaw(amount) => write!(f, "yaw {}", angle_text(*amount)),
            Self::Release => write!(f, "release"),
            Self::Hold => write!(f, "hold"),
        }
    }
}

/// A length, nm, with its unit: in the one that fits it, where a number of that is the same to the last digit.
fn exact_length(length: f64) -> String {
    let unit = Unit::fitting(LENGTHS, length.abs());
    let value = unit.of(length);
    if value * unit.size == length { format!("{value} {}", unit.name) } else { format!("{length} nm") }
}

/// An angle with its unit: in degrees, where a number of at most nine decimals of them is the same to the last digit.
pub fn angle_text(angle: f64) -> String {
    whole_degrees(angle).map_or_else(|| format!("{angle} rad"), |degrees| format!("{degrees} deg"))
}

/// The degrees of an angle, rad, where a number of at most nine decimals of them is the same to the last digit.
pub(crate) fn whole_degrees(angle: f64) -> Option<f64> {
    let degrees = (1e9 * angle.to_degrees()).round() / 1e9;
    (degrees * 1f64.to_radians() == angle).then_some(degrees)
}
