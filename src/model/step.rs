//! One step of the grip before the pull, as data.

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
    /// Its rotation, at its place, rad; positive anticlockwise
    Turn(f64),
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
}

/// What a step moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moved {
    /// y of the grip, nm
    Height,
    /// x of the grip, nm
    Place,
    /// θ of the grip, rad
    Rotation,
}

impl Step {
    /// What it moves, and by how much, nm or rad; none of a step that moves nothing.
    pub fn motion(self) -> Option<(Moved, f64)> {
        match self {
            Self::Press(amount) => Some((Moved::Height, -amount)),
            Self::Lift(amount) => Some((Moved::Height, amount)),
            Self::Drag(amount) => Some((Moved::Place, amount)),
            Self::Push(amount) => Some((Moved::Place, -amount)),
            Self::Turn(amount) => Some((Moved::Rotation, amount)),
            Self::Hold => None,
        }
    }

    /// Whether it is one: a finite amount, above zero of a length, not zero of an angle.
    pub fn check(self) -> Result<(), StepError> {
        match self {
            Self::Hold => Ok(()),
            Self::Press(amount) | Self::Lift(amount) | Self::Drag(amount) | Self::Push(amount) | Self::Turn(amount)
                if !amount.is_finite() =>
            {
                Err(StepError::NotFinite)
            }
            Self::Turn(angle) => {
                if angle != 0.0 {
                    Ok(())
                } else {
                    Err(StepError::NoTurn)
                }
            }
            Self::Press(length) | Self::Lift(length) | Self::Drag(length) | Self::Push(length) => {
                if length > 0.0 {
                    Ok(())
                } else {
                    Err(StepError::NotPositive)
                }
            }
        }
    }

    /// Whether it moves this.
    pub fn moves(self, what: Moved) -> bool {
        self.motion().is_some_and(|(moved, _)| moved == what)
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Press(amount) => write!(f, "press {amount} nm"),
            Self::Lift(amount) => write!(f, "lift {amount} nm"),
            Self::Drag(amount) => write!(f, "drag {amount} nm"),
            Self::Push(amount) => write!(f, "push {amount} nm"),
            Self::Turn(amount) => write!(f, "turn {}", angle_text(*amount)),
            Self::Hold => write!(f, "hold"),
        }
    }
}

/// An angle with its unit: in degrees, where a number of at most nine decimals of them is the same to the last digit.
pub fn angle_text(angle: f64) -> String {
    let degrees = (1e9 * angle.to_degrees()).round() / 1e9;
    if degrees * 1f64.to_radians() == angle { format!("{degrees} deg") } else { format!("{angle} rad") }
}
