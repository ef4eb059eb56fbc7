//! A solid: how it is discretised, and what of a model of beams a strip as a plane solid does not have.

use super::body::Body;
use super::check::error::ModelError;
use super::peel::{Hold, PeelModel, Pull};
use super::solid_spatula::{SolidSpatulaError, SolidSpatulaSettings, drive_of, of_beams_alone};
use crate::adhesion::section::line_load::LineLoad;
use crate::solid::basis::{MOST_SOLID_ORDER, SolidElement};
use crate::solid::body::SolidBody;
use crate::solid::contact::SolidContact;
use crate::solid::grip::SolidGrip;
use crate::solid::material::{Plane, SolidMaterial};
use crate::solid::mesh::Grading;
use crate::solid::strip::{SolidStrip, StripDesign};
use std::sync::Arc;

/// How a body is computed as a solid. Of a spatula and a profile `along` and `across` count alone: their element is H1(2), one through the thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidSettings {
    /// The element
    pub element: SolidElement,
    /// Whether elements that are bilinear have incompatible modes in all rows but the contact row: they then bend without locking
    pub modes: bool,
    /// Length of an element along the strip, nm
    pub along: f64,
    /// Rows of elements through the thickness
    pub through: usize,
    /// Elements across the half width of a spatula or a profile
    pub across: usize,
    /// What holds across the plane
    pub plane: Plane,
    /// The elastic energy
    pub material: SolidMaterial,
    /// What the ground acts on
    pub contact: SolidContact,
    /// What the grip does with the end face
    pub grip: SolidGrip,
    /// Where elements are finer
    pub grading: Grading,
}

impl Default for SolidSettings {
    /// Q1CH with incompatible modes, 2 nm long, five rows, in plane stress, in the grip of a beam.
    fn default() -> Self {
        Self {
            element: SolidElement::HermiteEdge,
            modes: true,
            along: 2.0,
            through: 5,
            across: SolidSpatulaSettings::default().across,
            plane: Plane::Stress,
            material: SolidMaterial::NeoHookean,
            contact: SolidContact::ReferenceTraction,
            grip: SolidGrip::Rigid,
            grading: Grading::None,
        }
    }
}

/// Why a body cannot be computed as a solid. Lengths in nm.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SolidError {
    /// What is wrong with the model as one of a beam.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// What is wrong with a spatula or a profile.
    #[error("{0}")]
    Spatula(#[from] SolidSpatulaError),
    /// An element of an order that is not offered.
    #[error("`solid.element` is \"{element}\": orders are 1 to {MOST_SOLID_ORDER}")]
    Order { element: SolidElement },
    /// A length that is none.
    #[error("`solid.along` is {found} nm, which is not above zero")]
    NoLength { found: f64 },
    /// Elements that are longer than the strip.
    #[error("`solid.along` is {found} nm, and the strip is {length} nm long")]
    LongerThanStrip { found: f64, length: f64 },
    /// No row.
    #[error("`solid.through` is 0: a strip has one row of elements at least")]
    NoRows,
    /// More unknowns than a computer holds.
    #[error("`solid.along` and `solid.through` make {unknowns:.1e} unknowns; at most {most:.0e} are computed")]
    TooMany { unknowns: f64, most: f64 },
    /// A grading that is none.
    #[error("`solid.grading` cuts {levels} times at {ratio} of what is left: give up to {most} cuts at a ratio from 0.05 to 0.8", most = MOST_LEVELS)]
    Grading { levels: usize, ratio: f64 },
    /// A grip that a traction cannot be.
    #[error("`solid.grip` is a parabolic traction, which leaves the end face free, and `grip.{held}` is \"fixed\"")]
    TractionHolds { held: &'static str },
    /// Something of a model that a solid does not have.
    #[error("`{key}` is given, and a solid {why}")]
    NotOfSolid { key: &'static str, why: &'static str },
}

/// Most unknowns: that is some gigabytes of factors.
const MOST_UNKNOWNS: f64 = 1e6;
/// Most cuts of a grading, and what their ratio may be.
const MOST_LEVELS: usize = 20;
const RATIOS: std::ops::RangeInclusive<f64> = 0.05..=0.8;

impl SolidError {
    /// The key of a scene that gives the value.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Model(error) => error.key(),
            Self::Spatula(error) => error.key(),
            Self::Order { .. } => "solid.element",
            Self::NoLength { .. } | Self::LongerThanStrip { .. } | Self::TooMany { .. } => "solid.along",
            Self::NoRows => "solid.through",
            Self::Grading { .. } => "solid.grading",
            Self::TractionHolds { .. } => "solid.grip",
            Self::NotOfSolid { key, .. } => key,
        }
    }

    /// What would be right: a sentence of its own.
    pub fn remedy(&self) -> String {
        match self {
            Self::Model(error) => error.remedy(),
            Self::Spatula(error) => error.remedy(),
            Self::Order { .. } => "Give \"Q1C1\" to \"Q1C8\", \"Q1CH\", \"H1(2)\" or \"Q(4,4)\", say.".into(),
            Self::NoLength { .. } => "Give a number above zero, in nm.".into(),
            Self::LongerThanStrip { length, .. } => {
                format!(
                    "Give at most {length} nm; elements as long as the process zone are the longest that resolve it."
                )
            }
            Self::NoRows => "Give a number from 1 on.".into(),
            Self::TooMany { .. } => "Give longer elements or fewer rows.".into(),
            Self::Grading { .. } => "Give three cuts at a ratio of 0.25, say.".into(),
            Self::TractionHolds { held } => {
                format!("Give `grip = \"rigid\"` under [solid], or `{held} = \"free\"` under [grip].")
            }
            Self::NotOfSolid { .. } => "Remove it, or remove the table [solid].".into(),
        }
    }
}

impl SolidSettings {
    /// That a model is computed on these settings.
    ///
    /// # Errors
    /// What is wrong first: with the model, with the settings, or what of the model a solid does not have.
    pub fn check(&self, model: &PeelModel) -> Result<(), SolidError> {
        match model.body {
            Body::Spatula(_) | Body::Profile(_) => Ok(self.in_space().mesh(model).map(drop)?),
            Body::Strip(_) => self.check_strip(model),
        }
    }

    /// The body of a model on these settings.
    ///
    /// # Errors
    /// As of [`SolidSettings::check`].
    pub fn body(&self, model: &PeelModel) -> Result<SolidBody, SolidError> {
        Ok(match model.body {
            Body::Spatula(_) | Body::Profile(_) => SolidBody::Spatula(Arc::new(self.in_space().spatula(model)?)),
            Body::Strip(_) => SolidBody::Strip(Arc::new(self.strip(model)?)),
        })
    }

    fn in_space(&self) -> SolidSpatulaSettings {
        SolidSpatulaSettings { across: self.across, ..SolidSpatulaSettings::every(self.along) }
    }

    /// A strip on these settings.
    ///
    /// # Errors
    /// What is wrong first: with the model, with the settings, or what of the model a solid does not have.
    ///
    /// ```
    /// use peelkit::model::{PeelModel, SolidSettings, StripModel};
    ///
    /// let model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    /// let strip = SolidSettings::default().strip(&model)?;
    /// assert_eq!((strip.elements(), strip.unknowns()), (250, 1505));
    /// let error = SolidSettings { along: 120.0, ..SolidSettings::default() }.strip(&model).unwrap_err();
    /// assert_eq!(error.to_string(), "`solid.along` is 120 nm, and the strip is 100 nm long");
    /// # Ok::<(), peelkit::model::SolidError>(())
    /// ```
    pub fn strip(&self, model: &PeelModel) -> Result<SolidStrip, SolidError> {
        self.check_strip(model)?;
        let Some(strip) = model.strip() else { return Err(not_a_strip(model)) };
        let design = StripDesign {
            length: strip.length,
            height: strip.height,
            width: strip.width,
            material: strip.material,
            energy: self.material,
            plane: self.plane,
            ground: model.adhesion.half_space(),
            contact: self.contact,
            far_face: model.adhesion.far_face,
            grip: self.grip,
            element: self.element,
            modes: self.modes,
            along: self.along,
            through: self.through,
            grading: self.grading,
        };
        Ok(SolidStrip::new(design, drive_of(model)))
    }

    fn check_strip(&self, model: &PeelModel) -> Result<(), SolidError> {
        model.check()?;
        let length = model.length();
        if !self.element.is_offered() {
            return Err(SolidError::Order { element: self.element });
        }
        if !self.along.is_finite() || self.along <= 0.0 {
            return Err(SolidError::NoLength { found: self.along });
        }
        if self.along > length {
            return Err(SolidError::LongerThanStrip { found: self.along, length });
        }
        if self.through == 0 {
            return Err(SolidError::NoRows);
        }
        let an_element = 2.0 * (self.element.order_along(true) * self.element.order_through()) as f64;
        let unknowns = length / self.along * self.through as f64 * an_element;
        if unknowns > MOST_UNKNOWNS {
            return Err(SolidError::TooMany { unknowns, most: MOST_UNKNOWNS });
        }
        if let Grading::Grip { levels, ratio } = self.grading
            && (levels > MOST_LEVELS || !RATIOS.contains(&ratio))
        {
            return Err(SolidError::Grading { levels, ratio });
        }
        if self.grip == SolidGrip::Parabolic {
            for (held, hold) in [("rotation", model.grip.rotation), ("horizontal", model.grip.horizontal)] {
                if hold == Hold::Fixed {
                    return Err(SolidError::TractionHolds { held });
                }
            }
            if model.pull != Pull::UP {
                return Err(not_of_solid("drive.angle", "in a parabolic grip is pulled straight up"));
            }
        }
        what_a_solid_has(model)
    }
}

fn not_of_solid(key: &'static str, why: &'static str) -> SolidError {
    SolidError::NotOfSolid { key, why }
}

fn not_a_strip(model: &PeelModel) -> SolidError {
    not_of_solid(model.body.geometry().name(), "is a strip")
}

/// That a model has nothing that a solid does not have.
fn what_a_solid_has(model: &PeelModel) -> Result<(), SolidError> {
    let Some(strip) = model.strip() else { return Err(not_a_strip(model)) };
    let refused = [
        (strip.crack.is_some(), "strip.crack", "adheres over its whole length"),
        (strip.layers.is_some(), "strip.layers", "is of one material"),
        (!strip.material.stretch.is_linear(), "strip.stretch", "stretches as its `solid.material` does"),
        (strip.material.yield_strength.is_some(), "strip.yield_strength", "is elastic"),
        (model.adhesion.line_load != LineLoad::Full, "adhesion.line_load", "has no line load"),
        (model.adhesion.shear_strength.is_some(), "adhesion.shear_strength", "slides freely along the ground"),
        (!model.adhesion.healing, "adhesion.healing", "adheres again where it comes back"),
        (!model.ground.substrate.is_flat(), "substrate.shape", "lies on flat ground"),
        (model.space.is_some(), "space", "is computed in the plane"),
    ];
    let found = refused.into_iter().chain(of_beams_alone(model)).find(|refused| refused.0);
    found.map_or(Ok(()), |(_, key, why)| Err(not_of_solid(key, why)))
}

/// Elements that are longer than what they have to resolve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LongElements {
    /// Length of an element, nm
    pub along: f64,
    /// Length of the process zone, nm
    pub process_length: f64,
}

impl SolidSettings {
    /// Whether elements are longer than the process zone at the front of this model: each then comes off by itself, and the force oscillates.
    pub fn long_elements(&self, model: &PeelModel) -> Option<LongElements> {
        let found = LongElements { along: self.along, process_length: model.process_length() };
        (found.along > found.process_length).then_some(found)
    }
}
