//! A limit point followed in a parameter of the model, and where two of them meet.
mod continuation;
mod cusp;
mod failure;
mod initial_limit_point;
mod result;
mod sweep;
pub use cusp::{Cusp, cusp};
pub use failure::{CuspError, PointNotFound};
pub use result::*;
pub use sweep::follow_point;
