//! Pictures of what a command found, as SVG and PNG, and the pieces of them that other pictures use.

mod contour;
mod curve;
mod fit;
mod followed;
mod in_space;
mod observed;
mod optimisation;
pub mod peel;
mod plane;
mod projection;
mod sensitivities;
mod shapes;
pub mod sweep;
mod swept_pulls;
mod tip;
mod uncertainty;

pub use fit::draw_fit;
pub use followed::draw_followed;
pub use observed::draw_observed;
pub use optimisation::draw_optimum;
pub use peel::{curve_svg, draw_peel, draw_peel_with_branch};
pub(crate) use plane::draw_maps;
pub use plane::draw_plane;
pub use sensitivities::{bars, draw_sensitivities};
pub use sweep::draw_sweep;
pub(crate) use sweep::{axis_of, broken, check_axis};
pub use sweep::{dotted, panel};
pub(crate) use swept_pulls::{Quantity, draw_swept_pulls};
pub use tip::draw_tip_law;
pub use uncertainty::draw_uncertainty;
