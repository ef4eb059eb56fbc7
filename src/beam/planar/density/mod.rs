//! The energy densities of planar beams, with and without adhesion: what an element integrates.
mod energy_density;
mod on_ground;
mod profile;
mod reduced;
mod reissner;
mod rod;
mod viscous;
pub use energy_density::{Coupling, EnergyDensity, PointResponse, SectionState};
pub use on_ground::BeamOnGround;
pub use profile::{Profile, SectionAt};
pub use reduced::ReducedBeam;
pub use reissner::ReissnerBeam;
pub use rod::ReissnerRod;
pub use viscous::{ElasticSections, Viscous};
