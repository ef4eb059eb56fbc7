//! Pictures of what a command found, as SVG and PNG, and the pieces of them that other pictures use.

mod curve;
pub(crate) mod fit;
pub(crate) mod laws;
pub(crate) mod observed;
pub(crate) mod optimisation;
pub mod peel;
pub(crate) mod sensitivities;
pub(crate) mod shapes;
pub(crate) mod steps;
pub mod sweep;
pub(crate) mod swept;
pub(crate) mod uncertainty;

pub use fit::draw_fit;
pub use laws::seta::draw_seta_law;
pub use laws::tip::draw_tip_law;
pub use observed::draw_observed;
pub use optimisation::draw_optimum;
pub use peel::{curve_svg, draw_peel, draw_peel_with_branch};
pub use sensitivities::{bars, draw_sensitivities};
pub use steps::draw_steps;
pub use sweep::{dotted, draw_sweep, panel};
pub use swept::followed::draw_followed;
pub use swept::plane::draw_plane;
pub use uncertainty::draw_uncertainty;
