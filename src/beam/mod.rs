//! What bends: section stiffness, energy densities of the planar Reissner beam, with and without adhesion, the element that
//! integrates them.
mod basis;
mod density;
mod element;
mod front;
mod integrand;
mod on_ground;
mod profile;
mod reduced;
mod reissner;
mod rest;
mod rod;
mod section;
mod varying;
pub use basis::{AnyNumber, Basis, Fixed, MOST_NODES, MOST_ORDER, Nodes, PerNode, slot};
pub use density::{Coupling, Density, PointResponse, SectionState};
pub use element::{Element, ElementEnergy, Integration, Responses};
pub use front::{Front, FrontRow, Pivots};
pub use integrand::{Integrand, Point, PointEnergy};
pub use on_ground::BeamOnGround;
pub use profile::{Profile, Station};
pub use reduced::ReducedBeam;
pub use reissner::ReissnerBeam;
pub use rest::{Rest, RestCurve, VaryingRest};
pub use rod::ReissnerRod;
pub use section::{Material, Section, rectangle_second_moment};
pub use varying::{Contour, Outline, Varying};
