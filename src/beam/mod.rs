//! What bends: section stiffness, outline, reference curves, and the planar beam.
mod bonded_beam;
mod grip_state;
pub mod mesh;
mod planar;
mod reference_configuration;
mod section;
mod spatial;
mod torsion;
mod varying;
pub use bonded_beam::{BondedBeam, BondedMode};
pub use grip_state::{ForcesInSpace, GripForces, GripState, PlaceInSpace};
pub use mesh::{Focus, MeshIntervals, MeshKind, Reach, graded_ends};
pub use planar::*;
pub use reference_configuration::{ReferenceConfiguration, ReferenceCurve, VaryingReference};
pub use section::{Material, Section, rectangle_second_moment};
pub use spatial::*;
pub use torsion::torsion_constant;
pub use varying::{BeamGeometry, SectionGeometry, Varying};
