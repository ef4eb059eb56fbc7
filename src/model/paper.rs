//! The models of the paper, with their parts at hand.

use super::body::Body;
use super::body::spatula::Spatula;
use super::body::strip::Strip;
use super::peel::{Adhesion, Form, Grip, Hold, PeelModel, Pull};
use super::problem::beam_problem::BeamProblem;
use super::problem::build::NoSuchOrder;
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::section::{Material, Section};
use serde::{Deserialize, Serialize};

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
                material: Material { bending_stiffness_factor: bending, ..Material::of(2.0, 0.2) },
                crack: None,
                layers: None,
            },
            adhesion: Adhesion::of_half_space(0.1, 0.4),
            grip: Grip::FREE,
            pull: Pull::UP,
        }
    }

    /// EA, GA_s and EI.
    pub fn section(&self) -> Section {
        self.strip.material.section(self.strip.width, self.strip.height, 0.0)
    }

    /// The line load per width.
    pub fn line_law(&self) -> LineLaw {
        self.adhesion.line_law(self.strip.height)
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

impl Spatula {
    /// In a grip that holds its rotation, with the adhesion of the paper's strip: scenes/spatula.toml.
    pub fn model(self) -> PeelModel {
        let grip = Grip { rotation: Hold::Fixed, ..Grip::FREE };
        PeelModel::of(Body::Spatula(self), Adhesion::of_half_space(0.1, 0.4), grip)
    }
}
