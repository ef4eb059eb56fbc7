//! What bends: section stiffness, energy densities of the planar Reissner beam, with and without adhesion, the element that
//! integrates them.
mod basis;
mod density;
mod element;
mod front;
mod reduced;
mod reissner;
mod rest;
mod rod;
mod section;
pub use basis::Basis;
pub use density::{Coupling, Density, PointResponse, SectionState};
pub use element::{Element, ElementEnergy, WeightedPoints};
pub use front::{Front, FrontRow, Pivots};
pub use reduced::ReducedBeam;
pub use reissner::ReissnerBeam;
pub use rest::RestCurve;
pub use rod::ReissnerRod;
pub use section::{Section, rectangle_second_moment};
