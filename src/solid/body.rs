//! What is peeled as a solid: a strip in the plane, or a spatula in space.

use super::spatula::solid_spatula::SolidSpatula;
use super::strip::SolidStrip;
use crate::adhesion::substrate::Substrate;
use crate::solve::problem::Problem;
use crate::solve::state::State;
use std::sync::Arc;

/// A solid in its grip.
#[derive(Clone, Debug)]
pub enum SolidBody {
    /// A strip as a plane solid
    Strip(Arc<SolidStrip>),
    /// A spatula in space. What is said of a section of it is said of its plane of symmetry.
    Spatula(Arc<SolidSpatula>),
}

/// A body on a mesh of half the size, or of elements of one order more.
pub(crate) struct FinerBody {
    pub body: SolidBody,
    /// What the difference to it counts: once for a higher order; twice for half the size, which is enough from an order of convergence of one on
    pub factor: f64,
}

/// What a difference to a mesh of half the size counts.
const OF_HALF_THE_SIZE: f64 = 2.0;

impl SolidBody {
    /// What is to be solved.
    pub(crate) fn problem(&self) -> Problem {
        match self {
            Self::Strip(strip) => strip.problem(),
            Self::Spatula(spatula) => spatula.problem(),
        }
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        match self {
            Self::Strip(strip) => strip.elements(),
            Self::Spatula(spatula) => spatula.elements(),
        }
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        match self {
            Self::Strip(strip) => strip.unknowns(),
            Self::Spatula(spatula) => spatula.unknowns(),
        }
    }

    /// The name of its element.
    pub fn element(&self) -> String {
        match self {
            Self::Strip(strip) => strip.element().to_string(),
            Self::Spatula(_) => "H1(2)".to_owned(),
        }
    }

    /// S of the lines of its mesh across it, and where those along it lie through the thickness, ascending, each from the underside on: heights
    /// over it of a strip, nm, and ζ from -1 to 1 of a spatula.
    pub fn mesh_lines(&self) -> (&[f64], &[f64]) {
        match self {
            Self::Strip(strip) => strip.mesh_lines(),
            Self::Spatula(spatula) => spatula.mesh_lines(),
        }
    }

    /// Where its underside and its upper face lie through the thickness, as of [`SolidBody::mesh_lines`].
    pub fn faces(&self) -> [f64; 2] {
        let (_, through) = self.mesh_lines();
        [through.first(), through.last()].map(|face| face.copied().unwrap_or(0.0))
    }

    /// Its length along S, nm.
    pub fn length(&self) -> f64 {
        self.mesh_lines().0.last().copied().unwrap_or(0.0)
    }

    /// Thickness of the free end, nm.
    pub fn thickness(&self) -> f64 {
        match self {
            Self::Strip(_) => self.faces()[1],
            Self::Spatula(spatula) => spatula.thickness(),
        }
    }

    /// Displacement (u_x, u_y) of the point at S and that far through the thickness, nm.
    pub fn displacement_at(&self, values: &[f64], [along, through]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Strip(strip) => strip.displacement_at(values, along, through),
            Self::Spatula(spatula) => spatula.displacement_at(values, along, through),
        }
    }

    /// Where the point at S and that far through the thickness is, x and y over the ground, nm.
    pub fn place_at(&self, values: &[f64], [along, through]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Strip(strip) => {
                let [x, y] = strip.displacement_at(values, along, through);
                [along + x, strip.rest_gap() + through + y]
            }
            Self::Spatula(spatula) => spatula.place_at(values, along, through),
        }
    }

    /// σ, Cauchy's stress xx, yy, xy there, GPa.
    pub fn stress_at(&self, values: &[f64], [along, through]: [f64; 2]) -> [f64; 3] {
        match self {
            Self::Strip(strip) => strip.stress_at(values, along, through),
            Self::Spatula(spatula) => spatula.stress_at(values, along, through),
        }
    }

    /// The gap at rest, nm.
    pub fn rest_gap(&self) -> f64 {
        match self {
            Self::Strip(strip) => strip.rest_gap(),
            Self::Spatula(spatula) => spatula.rest_gap(),
        }
    }

    /// Whether the load has a potential.
    pub(crate) fn has_potential(&self) -> bool {
        match self {
            Self::Strip(strip) => strip.has_potential(),
            Self::Spatula(_) => true,
        }
    }

    /// Whether no vertex of the contact face is nearer to the ground than 10 r0.
    pub(crate) fn is_detached(&self, values: &[f64]) -> bool {
        match self {
            Self::Strip(strip) => strip.is_detached(values),
            Self::Spatula(spatula) => spatula.is_detached(values),
        }
    }

    /// What it lies on.
    pub fn substrate(&self) -> &Substrate {
        match self {
            Self::Strip(_) => &Substrate::Flat,
            Self::Spatula(spatula) => spatula.substrate(),
        }
    }

    /// Length of its underside that adheres at rest, nm.
    pub fn adhering_length(&self) -> f64 {
        match self {
            Self::Strip(_) => self.length(),
            Self::Spatula(spatula) => spatula.mesh.adhering,
        }
    }

    /// S up to which it still adheres, nm: by the logarithm of the gap all along a strip, of which the length that has come off is `off`.
    pub(crate) fn front(&self, values: &[f64], off: f64) -> f64 {
        match self {
            Self::Strip(_) => self.length() - off,
            Self::Spatula(spatula) => spatula.front(values),
        }
    }

    /// The gap of the free end, nm.
    pub(crate) fn free_end_gap(&self, values: &[f64]) -> f64 {
        let [under, upper] = self.faces().map(|face| self.place_at(values, [0.0, face])[1]);
        under.min(upper)
    }

    /// Rotation of the end face, rad.
    pub(crate) fn end_rotation(&self, values: &[f64]) -> f64 {
        match self {
            Self::Strip(strip) => strip.end_rotation(&strip.displacements(values)),
            Self::Spatula(spatula) => spatula.end_rotation(values),
        }
    }

    /// Length of its longest column in contact, nm.
    pub(crate) fn longest_column(&self) -> f64 {
        match self {
            Self::Strip(strip) => strip.longest_column(),
            Self::Spatula(spatula) => spatula.longest_column(),
        }
    }

    /// The same body on a finer mesh.
    pub(crate) fn finer(&self) -> FinerBody {
        match self {
            Self::Strip(strip) => {
                let fine = strip.refined();
                let factor = if fine.element() == strip.element() { OF_HALF_THE_SIZE } else { 1.0 };
                FinerBody { body: Self::Strip(Arc::new(fine)), factor }
            }
            Self::Spatula(spatula) => {
                FinerBody { body: Self::Spatula(Arc::new(spatula.refined())), factor: OF_HALF_THE_SIZE }
            }
        }
    }

    /// The state of this mesh that has the displacements of one of another mesh of the same body; none of another body.
    pub(crate) fn state_of(&self, other: &Self, at: &State) -> Option<State> {
        match (self, other) {
            (Self::Strip(own), Self::Strip(other)) => Some(own.state_of(other, at)),
            (Self::Spatula(own), Self::Spatula(other)) => Some(own.state_of(other, at)),
            (Self::Strip(_), Self::Spatula(_)) | (Self::Spatula(_), Self::Strip(_)) => None,
        }
    }
}
