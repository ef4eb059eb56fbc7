//! One equilibrium with its fields along the beam, in the plane or in space.

use super::along_beam::{PlanarReader, SectionFields, SpatialReader, SpatialSectionFields};
use crate::adhesion::spatial_section::section::SectionShape;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::Beam;
use crate::solve::newton::Solution;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::State;

/// One equilibrium of a path with its fields along the beam.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamState {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Whether it is a limit point, and of what.
    pub limit_point: Option<LimitPointKind>,
    /// How far along the path it is: 0 where the path begins, 1 where it ends, by the length of the curve of P over u, each over its range. 0 where it
    /// is no state of a whole path.
    pub path_position: f64,
    /// The beam from place to place
    pub sections: StateSections,
}

/// The beam from S = 0 to S = L.
#[derive(Clone, Debug, PartialEq)]
pub enum StateSections {
    /// Of a beam in the plane
    Planar(Vec<SectionFields>),
    /// Of a beam in space
    Spatial {
        /// Of all sections
        outline: SectionShape,
        /// From place to place
        sections: Vec<SpatialSectionFields>,
    },
}

/// What the fields of all states of one peel are read with.
pub(in crate::study) enum Reader<'p> {
    Planar(PlanarReader<'p>),
    Spatial(SpatialReader<'p>),
}

impl<'p> Reader<'p> {
    pub(crate) fn new(model: &'p PeelModel, beam: &'p Beam) -> Self {
        match beam {
            Beam::Planar(beam) => Self::Planar(PlanarReader::new(model, beam)),
            Beam::Spatial(beam) => Self::Spatial(SpatialReader::new(model, beam)),
        }
    }

    /// The state of a solution of the path.
    pub(crate) fn read(
        &self,
        solution: &Solution,
        limit_point: Option<LimitPointKind>,
        path_position: f64,
    ) -> BeamState {
        let displacement = solution.observables.displacement;
        BeamState { limit_point, path_position, ..self.state(&solution.at, displacement) }
    }

    /// The state of a beam whose grip is displaced by so much, nm, wherever on its path.
    pub(crate) fn state(&self, at: &State, displacement: f64) -> BeamState {
        BeamState {
            displacement,
            force: at.force,
            limit_point: None,
            path_position: 0.0,
            sections: match self {
                Self::Planar(reader) => StateSections::Planar(reader.sections(at)),
                Self::Spatial(reader) => {
                    StateSections::Spatial { outline: reader.outline, sections: reader.sections(at) }
                }
            },
        }
    }

    /// Distance of the nearer edge of the section at the free end, S = 0, from the ground, nm.
    pub(crate) fn free_end_gap(&self, at: &State) -> f64 {
        match self {
            Self::Planar(reader) => reader.free_end_gap(at),
            Self::Spatial(reader) => reader.free_end_gap(at),
        }
    }
}
