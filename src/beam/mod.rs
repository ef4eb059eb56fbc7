//! What bends: section stiffness, outline, reference curves, and the planar beam.
pub(crate) mod bonded_beam;
pub(crate) mod element;
pub(crate) mod grip_state;
pub(crate) mod material;
pub mod mesh;
pub(crate) mod planar;
pub(crate) mod reference_configuration;
pub(crate) mod section;
pub(crate) mod spatial;
pub(crate) mod torsion;
pub(crate) mod varying;
pub(crate) mod viscosity;
pub use bonded_beam::{BondedBeam, BondedMode};
pub use element::basis::MOST_ORDER;
pub use element::energy_density::{Coupling, EnergyDensity, Point, PointResponse, SectionState};
pub use element::integrand::{Integrand, PointEnergy, PointGradient};
pub use element::integration::{Element, ElementEnergy, Integration, Responses};
pub use grip_state::{ForcesInSpace, GripForces, GripState, PlaceInSpace, StepJump, StepsTaken};
pub use material::stretch_law::{StretchLaw, StretchResponse};
pub use mesh::{Focus, MeshIntervals, MeshKind, MeshPolicy, Reach};
pub use planar::chain::{
    Chain, ChainFactors, CondensedChain, Configuration, ConstraintGradient, KnownStrains, LeastPivot, NodeState, ROOT,
};
pub use planar::density::on_ground::BeamOnGround;
pub use planar::density::reduced::ReducedBeam;
pub use planar::density::reissner::{ReissnerBeam, ReissnerRod};
pub use planar::model_end::CollapsedSection;
pub use planar::model_limits::{BondedLoss, ModelLimits, PoleInReach, UprightCorner, UprightPole, UprightSection};
pub use planar::planar_beam::{BeamInertia, BeamMemory, FRONT, FrontPosition, PlanarBeam, TIP_ROTATION};
pub use reference_configuration::{ReferenceConfiguration, ReferenceCurve, VaryingReference};
pub use section::{Material, Section, SectionAt, rectangle_second_moment};
pub use spatial::chain::room::SpatialFactors;
pub use spatial::chain::spatial_chain::{SpatialChain, SpatialConfiguration, SpatialEnd, SpatialFunctional};
pub use spatial::end_rotation::{EndRotation, angles, turned};
pub use spatial::rest::{ALONG_X, BranchRest, PlacedRest, RestOutline, SpatialRest, SpatialRestCurve};
pub use spatial::rotation;
pub use spatial::section::branch_sections::{AdheringSections, BranchSections};
pub use spatial::section::density::SpatialDensity;
pub use spatial::section::held_sections::HeldSections;
pub use spatial::section::lying_section::LyingSection;
pub use spatial::section::spatial_profile::{SpatialProfile, SpatialStiffness, Station};
pub use spatial::section::strain_memory::SpatialKnownStrains;
pub use spatial::section_state::{SpatialIntegrals, SpatialSectionPlace, SpatialSectionState};
pub use spatial::spatial_beam::{SpatialBeam, SpatialInertia};
pub use spatial::tree::beam_tree::BeamTree;
pub use spatial::tree::branching_beam::{
    Branch, BranchMesh, BranchingBeam, EndEnergy, EndResponse, JointCondition, JointUnknown, TreeError, TreeMonitor,
};
pub use spatial::tree::read::BranchSection;
pub use torsion::torsion_constant;
pub use varying::{BeamGeometry, Profile, SectionGeometry, Varying};
pub use viscosity::Viscosity;
