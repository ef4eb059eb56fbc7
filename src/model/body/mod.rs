//! What is peeled.

pub(super) mod pieces;
pub(crate) mod profile;
pub(super) mod spatula;
pub(super) mod strip;
pub(super) mod transition;

use crate::beam::section::Material;
use crate::beam::varying::BeamGeometry;
use profile::Profile;
use serde::{Deserialize, Serialize};
use spatula::Spatula;
use std::sync::Arc;
use strip::Strip;

/// What a model asks of its body. A body is a file with a type that is one, and a line of each list below.
pub trait Geometry: BeamGeometry {
    /// The table of a scene that gives it.
    fn name(&self) -> &'static str;

    /// What it is made of.
    fn material(&self) -> Material;

    /// Its outline, to be kept by a beam.
    fn shared(&self) -> Arc<dyn BeamGeometry>;

    /// Whether it is straight in its stress-free configuration, and its section the same everywhere.
    fn is_uniform(&self) -> bool {
        false
    }
}

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
}
