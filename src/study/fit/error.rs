//! Why there is no fit.

use crate::model::check::error::ModelError;
use crate::study::sensitivity::error::NoSensitivities;

/// Why a measured curve cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum FitDataError {
    #[error("has {points} points{}, and a curve has at least {least}", match .before_jump { Some(at) => format!(" up to its jump at {at} nm"), None => String::new() })]
    TooFew { points: usize, least: usize, before_jump: Option<f64> },
    #[error("goes from {from} nm to {turn} nm and back to {to} nm: it holds the way there and the way back")]
    ThereAndBack { from: f64, turn: f64, to: f64 },
    #[error("has displacements from {from} nm to {to} nm, and the jump is said to be at {jump} nm")]
    JumpOutside { from: f64, to: f64, jump: f64 },
    #[error("has the same force, {force} nN, in all its rows")]
    NoForce { force: f64 },
}

impl FitDataError {
    /// What would be right.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "Measure more points on the branch before the first jump, or fit fewer parameters.",
            Self::ThereAndBack { .. } => "Give the rows of the retreat alone, from contact to detachment.",
            Self::JumpOutside { .. } => {
                "Give as `fit.jump` the measured displacement at which the force falls, or omit it."
            }
            Self::NoForce { .. } => "Give the column of the measured force.",
        }
    }
}

/// Why nothing is fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoFit {
    #[error("there is no parameter to fit")]
    NoParameters,
    #[error("{data} data do not determine {parameters} parameters: there have to be more data than parameters")]
    TooFewData { data: usize, parameters: usize },
    #[error("{key} = {value:e} is not between its bounds, {from:e} and {to:e}")]
    OutsideBounds { key: String, value: f64, from: f64, to: f64 },
    #[error(
        "{key} changes the force nowhere by more than {largest:.1e} nN per unit of its coordinate: it has no influence on the measured part of the curve"
    )]
    NoInfluence { key: String, largest: f64 },
    #[error("the model cannot be computed: {0}")]
    Model(#[from] ModelError),
    #[error("the curve of the scene as it is written was not computed: {0}")]
    NoStart(String),
    #[error(
        "no parameters were found within their bounds, because the measured curve is of another size: its forces reach {:.3e} nN and its displacements {:.3e} nm, those of the scene {:.3e} nN and {:.3e} nm",
        forces.measured, displacements.measured, forces.modelled, displacements.modelled
    )]
    OtherScale { forces: Scale, displacements: Scale },
    #[error("the curve cannot be differentiated: {0}")]
    NoDerivatives(#[from] NoSensitivities),
}

/// The largest number of a measured curve and that of the model, in nN or nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// As measured
    pub measured: f64,
    /// Of the model
    pub modelled: f64,
}

impl Scale {
    /// By how many powers of 1000 the measured one is larger, to the nearest.
    pub fn thousands(&self) -> i32 {
        let powers = (self.measured / self.modelled).log10() / 3.0;
        if powers.is_finite() { powers.round() as i32 } else { 0 }
    }

    /// Which unit was most likely given in place of which; nothing where both are alike, or no usual units differ so much.
    fn likely_unit(&self, what: &str, unit: char) -> Option<String> {
        const PREFIXES: [&str; 4] = ["n", "u", "m", ""];
        let powers = self.thousands();
        let other = PREFIXES.get(powers.unsigned_abs() as usize).filter(|_| powers != 0)?;
        let (given, meant) = if powers > 0 { (*other, PREFIXES[0]) } else { (PREFIXES[0], *other) };
        Some(format!(
            "Correct the unit of the {what} in the first line of the data: most likely {given}{unit} is written there and {meant}{unit} is meant. "
        ))
    }
}

impl NoFit {
    /// What would be right.
    pub fn remedy(&self) -> String {
        let remedy = match self {
            Self::NoParameters => "Add to the scene for example\n[fit]\nparameters = [\"adhesion.hamaker_constant\"]",
            Self::TooFewData { .. } => "Measure more points, or fit fewer parameters.",
            Self::OutsideBounds { .. } => "Give bounds around the value of the scene.",
            Self::NoInfluence { .. } => "Remove it from `fit.parameters`.",
            Self::Model(error) => return error.remedy(),
            Self::OtherScale { forces, displacements } => {
                let units = [forces.likely_unit("forces", 'N'), displacements.likely_unit("displacements", 'm')];
                let units: String = units.into_iter().flatten().collect();
                return format!(
                    "{units}Otherwise set the parameters of the scene nearer to the measured curve, or give wider bounds."
                );
            }
            Self::NoStart(_) => {
                "Try `peel run` with the scene. Set its parameters near to the measured curve, or raise its [bounds]."
            }
            Self::NoDerivatives(_) => "Omit what the message names, or do not fit this parameter.",
        };
        remedy.to_owned()
    }
}
