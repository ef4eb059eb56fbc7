//! Solids that adhere: strips as plane solids with enriched contact elements, each in its grip a [`crate::solve::System`]; `spatula/`: a spatula in space.
//!
//! A beam has no thickness to deform. A solid has: its first peak depends on how the end is gripped, because it is made within a few nanometres
//! of it; in steady peeling the two agree. Source of the elements: R. A. Sauer, Int. J. Numer. Meth. Engng 87 (2011) 708, and eqs. (9) to
//! (16) of the paper.

pub(crate) mod basis;
pub(crate) mod body;
pub(crate) mod contact;
pub(crate) mod front;
pub(crate) mod grip;
pub(crate) mod material;
pub(crate) mod mesh;
pub mod spatula;
pub(crate) mod strip;
mod system;
mod tables;
mod transfer;
pub use basis::{MOST_SOLID_ORDER, SolidElement};
pub use body::SolidBody;
pub use contact::SolidContact;
pub use grip::{GripDrive, SolidGrip};
pub use material::{Plane, SolidMaterial};
pub use mesh::Grading;
pub use strip::SolidStrip;
