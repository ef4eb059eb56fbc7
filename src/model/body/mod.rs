//! What is peeled.

pub(super) mod geometry;
pub(super) mod laminate;
pub(super) mod pieces;
pub(crate) mod profile;
pub(super) mod spatula;
pub(super) mod strip;
pub(super) mod transition;

use crate::beam::section::Material;
use geometry::Geometry;
use profile::Profile;
use serde::{Deserialize, Serialize};
use spatula::Spatula;
use strip::Strip;

/// What is peeled. It begins at S = 0 with its free end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Body {
    /// A strip of one section
    Strip(Strip),
    /// A spatula: pad, neck and shaft
    Spatula(Spatula),
    /// A beam whose width and height are given along it
    Profile(Profile),
}

impl Body {
    /// Its geometry and material: everything that is asked of it.
    pub fn geometry(&self) -> &dyn Geometry {
        match self {
            Self::Strip(strip) => strip,
            Self::Spatula(spatula) => spatula,
            Self::Profile(profile) => profile,
        }
    }

    /// What it is made of, to be changed.
    pub fn material_mut(&mut self) -> &mut Material {
        match self {
            Self::Strip(strip) => &mut strip.material,
            Self::Spatula(spatula) => &mut spatula.material,
            Self::Profile(profile) => &mut profile.material,
        }
    }
}
