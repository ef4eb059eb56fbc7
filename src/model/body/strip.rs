//! A uniform strip of rectangular section.

use super::{Body, Geometry};
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::section::{Material, Section};
use crate::beam::varying::{BeamGeometry, SectionGeometry};
use crate::model::beam_problem::BeamProblem;
use crate::model::build::NoSuchOrder;
use crate::model::peel::{Adhesion, Form, Grip, PeelModel, Pull};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Geometry and material of a uniform strip of rectangular section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// nm
    pub length: f64,
    /// nm
    pub height: f64,
    /// nm
    pub width: f64,
    /// GPa = nN/nm²
    pub youngs_modulus: f64,
    /// ν, without a unit
    pub poissons_ratio: f64,
    /// k_s, without a unit
    pub shear_correction: f64,
    /// Multiplies EI alone.
    pub bending_stiffness_factor: f64,
}

impl Strip {
    /// What it is made of.
    pub fn material(&self) -> Material {
        Material {
            youngs_modulus: self.youngs_modulus,
            poissons_ratio: self.poissons_ratio,
            shear_correction: self.shear_correction,
            bending_stiffness_factor: self.bending_stiffness_factor,
        }
    }
}

impl BeamGeometry for Strip {
    fn length(&self) -> f64 {
        self.length
    }

    fn breaks(&self) -> Vec<f64> {
        Vec::new()
    }

    fn at(&self, _place: f64) -> SectionGeometry {
        SectionGeometry { width: self.width, height: [self.height, 0.0, 0.0], roundness: 0.0, underside: [0.0; 2] }
    }
}

impl Geometry for Strip {
    fn name(&self) -> &'static str {
        "strip"
    }

    fn material(&self) -> Material {
        Self::material(self)
    }

    fn shared(&self) -> Arc<dyn BeamGeometry> {
        Arc::new(*self)
    }

    fn is_uniform(&self) -> bool {
        true
    }
}

/// A strip, its adhesion, its grip and how that is moved: the [`PeelModel`] of Section 4 of the paper, with its parts at hand.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct StripModel {
    /// Geometry and material
    pub strip: Strip,
    /// What attracts it to the ground
    pub adhesion: Adhesion,
    /// Which unknowns of its end are constrained
    pub grip: Grip,
    /// Where its end is moved
    pub pull: Pull,
}

impl StripModel {
    /// The strip of Figs. 9 and 10 of the paper, of the given length in nm, in a free grip, with EI times `bending`.
    pub fn of_the_paper(length: f64, bending: f64) -> Self {
        Self {
            strip: Strip {
                length,
                height: 10.0,
                width: 1.0,
                youngs_modulus: 2.0,
                poissons_ratio: 0.2,
                shear_correction: 5.0 / 6.0,
                bending_stiffness_factor: bending,
            },
            adhesion: Adhesion::of_half_space(0.1, 0.4),
            grip: Grip::FREE,
            pull: Pull::UP,
        }
    }

    /// EA, GA_s and EI.
    pub fn section(&self) -> Section {
        self.strip.material().section(self.strip.width, self.strip.height, 0.0)
    }

    /// The line load per width.
    pub fn line_law(&self) -> LineLaw {
        self.adhesion.line_law(self.strip.height)
    }

    /// As [`PeelModel::bending_length`].
    pub fn bending_length(&self) -> f64 {
        PeelModel::from(self).bending_length()
    }

    /// As [`PeelModel::process_length`].
    pub fn process_length(&self) -> f64 {
        PeelModel::from(self).process_length()
    }

    /// As [`PeelModel::problem`].
    ///
    /// # Errors
    /// An order that there is not.
    pub fn problem(&self, form: Form, order: usize) -> Result<BeamProblem, NoSuchOrder> {
        PeelModel::from(self).problem(form, order)
    }
}

impl From<&StripModel> for PeelModel {
    fn from(model: &StripModel) -> Self {
        Self { pull: model.pull, ..Self::of(Body::Strip(model.strip), model.adhesion, model.grip) }
    }
}

impl From<StripModel> for PeelModel {
    fn from(model: StripModel) -> Self {
        Self::from(&model)
    }
}
