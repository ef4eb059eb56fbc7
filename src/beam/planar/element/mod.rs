//! An element: its shape functions and Gauss points, the integrand there, and the frontal matrix into which it is assembled.
mod basis;
mod frontal_matrix;
mod integrand;
mod piecewise;
mod planar_element;
pub use basis::{AnyNumber, Basis, Fixed, MOST_NODES, MOST_ORDER, Nodes, PerNode, slot};
pub use frontal_matrix::{FrontalMatrix, FrontalRow, Pivots};
pub use integrand::{Integrand, MEMORY, PlanarIntegrand, Point, PointEnergy, PointGradient};
pub use piecewise::PiecePoint;
pub use planar_element::{Element, ElementEnergy, Integration, Responses};
