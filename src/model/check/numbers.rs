//! The numbers of a model, a line each: what a scene calls it, its unit, its range and where it stands.

use super::error::{Measured, ModelError, Range, Range::Positive};
use crate::beam::section::Material;
use crate::model::body::Body;
use crate::model::body::spatula::Spatula;
use crate::model::body::strip::Strip;
use crate::model::peel::PeelModel;

/// A number of something that is checked.
#[derive(Debug)]
pub struct NumberOf<T> {
    /// What a scene calls it: `strip.length`.
    pub key: &'static str,
    /// Its unit inside the library; empty where it has none.
    pub unit: &'static str,
    /// What it may be
    pub range: Range,
    /// Its value, where there is one.
    pub get: fn(&T) -> Option<f64>,
}

impl<T> NumberOf<T> {
    /// A line of a list.
    pub const fn new(key: &'static str, unit: &'static str, range: Range, get: fn(&T) -> Option<f64>) -> Self {
        Self { key, unit, range, get }
    }

    /// Whether it has a meaning.
    pub fn check(&self, of: &T) -> Result<(), ModelError> {
        let Some(value) = (self.get)(of) else { return Ok(()) };
        self.range.check(Measured { value, unit: self.unit }).map_err(|kind| ModelError::new(self.key, kind))
    }
}

const fn number(
    key: &'static str,
    unit: &'static str,
    range: Range,
    get: fn(&PeelModel) -> Option<f64>,
) -> NumberOf<PeelModel> {
    NumberOf::new(key, unit, range, get)
}

/// Every number of a model; those of the columns of a table and of the pieces of a profile are checked when these are built.
#[rustfmt::skip]
pub static MODEL_NUMBERS: &[NumberOf<PeelModel>] = &[
    number("strip.length", "nm", Positive, |m| Some(strip(m)?.length)),
    number("strip.height", "nm", Positive, |m| Some(strip(m)?.height)),
    number("strip.width", "nm", Positive, |m| Some(strip(m)?.width)),
    number("strip.youngs_modulus", "GPa", Positive, |m| Some(strip(m)?.material.youngs_modulus)),
    number("strip.poissons_ratio", "", Range::POISSONS_RATIO, |m| Some(strip(m)?.material.poissons_ratio)),
    number("strip.shear_correction", "", Positive, |m| Some(strip(m)?.material.shear_correction)),
    number("strip.bending_stiffness_factor", "", Positive, |m| Some(strip(m)?.material.bending_stiffness_factor)),
    number("strip.yield_strength", "GPa", Positive, |m| strip(m)?.material.yield_strength),
    number("strip.tangent_modulus", "GPa", Positive, |m| strip(m)?.material.tangent_modulus),
    number("strip.crack", "nm", Positive, |m| strip(m)?.crack),

    number("spatula.pad_length", "nm", Positive, |m| Some(spatula(m)?.pad_length)),
    number("spatula.neck_length", "nm", Positive, |m| Some(spatula(m)?.neck_length)),
    number("spatula.shaft_length", "nm", Positive, |m| Some(spatula(m)?.shaft_length)),
    number("spatula.bend_length", "nm", Positive, |m| Some(spatula(m)?.bend_length)),
    number("spatula.tip_width", "nm", Positive, |m| Some(spatula(m)?.tip_width)),
    number("spatula.neck_width", "nm", Positive, |m| Some(spatula(m)?.neck_width)),
    number("spatula.shaft_diameter", "nm", Positive, |m| Some(spatula(m)?.shaft_diameter)),
    number("spatula.pad_thickness", "nm", Positive, |m| Some(spatula(m)?.pad_thickness)),
    number("spatula.shaft_angle", "rad", Range::SHAFT_ANGLE, |m| Some(spatula(m)?.shaft_angle)),
    number("spatula.tip_rounding_length", "nm", Range::ROUNDING_LENGTH, |m| Some(spatula(m)?.tip_rounding_length)),
    number("spatula.tip_rounding_width", "nm", Positive, |m| Some(spatula(m)?.tip_rounding_width)),
    number("spatula.youngs_modulus", "GPa", Positive, |m| Some(spatula(m)?.material.youngs_modulus)),
    number("spatula.poissons_ratio", "", Range::POISSONS_RATIO, |m| Some(spatula(m)?.material.poissons_ratio)),
    number("spatula.shear_correction", "", Positive, |m| Some(spatula(m)?.material.shear_correction)),
    number("spatula.bending_stiffness_factor", "", Positive, |m| Some(spatula(m)?.material.bending_stiffness_factor)),

    number("profile.youngs_modulus", "GPa", Positive, |m| Some(profile(m)?.youngs_modulus)),
    number("profile.poissons_ratio", "", Range::POISSONS_RATIO, |m| Some(profile(m)?.poissons_ratio)),
    number("profile.shear_correction", "", Positive, |m| Some(profile(m)?.shear_correction)),
    number("profile.bending_stiffness_factor", "", Positive, |m| Some(profile(m)?.bending_stiffness_factor)),

    number("adhesion.hamaker_constant", "aJ", Positive, |m| Some(m.adhesion.hamaker_constant)),
    number("adhesion.equilibrium_distance", "nm", Positive, |m| Some(m.adhesion.equilibrium_distance)),
    number("adhesion.work", "J/m2", Positive, |m| m.adhesion.work),
    number("adhesion.strength", "GPa", Positive, |m| m.adhesion.strength),
    number("adhesion.shear_strength", "GPa", Positive, |m| m.adhesion.shear_strength),
    number("adhesion.shear_work", "J/m2", Positive, |m| m.adhesion.shear_work),
    number("adhesion.mixing_exponent", "", Range::MIXING_EXPONENT, |m| m.adhesion.mixing_exponent),

    number("substrate.radius", "nm", Positive, |m| of_substrate(m, "radius")),
    number("substrate.height", "nm", Positive, |m| of_substrate(m, "height")),
    number("substrate.wavelength", "nm", Positive, |m| of_substrate(m, "wavelength")),
    number("substrate.offset", "nm", Range::OFFSET, |m| of_substrate(m, "offset")),

    number("friction.strength", "GPa", Positive, |m| m.friction.strength),
    number("friction.coefficient", "", Range::FRICTION_COEFFICIENT, |m| Some(m.friction.coefficient)),
    number("friction.presliding", "nm", Positive, |m| m.friction.presliding),

    number("grip.stiffness", "N/m", Positive, |m| m.grip.stiffness),
    number("grip.pretension", "nN", Positive, |m| m.grip.pretension),

    number("drive.angle", "rad", Range::PULL_ANGLE, |m| Some(m.pull.angle)),
    number("drive.azimuth", "rad", Range::AZIMUTH, |m| Some(m.space?.azimuth)),
    number("drive.turn", "rad/nm", Range::PULL_TURN, |m| Some(m.pull.turn)),
];

fn strip(model: &PeelModel) -> Option<&Strip> {
    model.strip()
}

fn spatula(model: &PeelModel) -> Option<&Spatula> {
    if let Body::Spatula(spatula) = &model.body { Some(spatula) } else { None }
}

/// What a profile is made of.
fn profile(model: &PeelModel) -> Option<&Material> {
    if let Body::Profile(profile) = &model.body { Some(&profile.material) } else { None }
}

fn of_substrate(model: &PeelModel, key: &str) -> Option<f64> {
    model.ground.substrate.clone().number(key).copied()
}
