//! What bends: section stiffness, energy densities of the planar Reissner beam, with and without adhesion, the element that
//! integrates them.
mod basis;
mod density;
mod element;
mod reduced;
mod reissner;
mod rest;
mod rod;
mod section;
pub use basis::Basis;
pub use density::{Density, PointResponse, SectionState};
pub use element::{ElementEnergy, Spread, integrate, places, side_by_side};
pub use reduced::ReducedBeam;
pub use reissner::ReissnerBeam;
pub use rest::RestCurve;
pub use rod::ReissnerRod;
pub use section::{Section, rectangle_second_moment};
