//! What bends: section stiffness, outline, reference curves, and the planar beam.
pub mod mesh;
mod planar;
mod rest;
mod section;
mod varying;
pub use mesh::{Focus, MeshKind, Pieces as MeshPieces, graded_ends};
pub use planar::*;
pub use rest::{Rest, RestCurve, VaryingRest};
pub use section::{Material, Section, rectangle_second_moment};
pub use varying::{Contour, Outline, Varying};
