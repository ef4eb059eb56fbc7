//! A limit point followed in a parameter of the model, and where two of them meet.
mod confirmation;
mod continuation;
mod cusp;
mod elements;
mod failure;
mod initial_limit_point;
mod result;
mod rows;
mod strand;
mod sweep;
mod values;
pub use cusp::{Cusp, cusp};
pub use failure::{CuspError, PointNotFound};
pub use result::*;
pub use sweep::follow_point;
