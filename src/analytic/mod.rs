//! Closed forms to hold the computed against.
mod array;
mod column;
pub(crate) mod peeling;
pub use array::{
    SofteningPeak, array_modulus, bunching_length, bundle_strength, dome_pull_off, shear_lag, shear_lag_number,
    softening_peak, winkler_force, winkler_moment, winkler_number,
};
pub use column::{buckling_load, propped_buckling_load};
pub use peeling::{
    kendall_force, pretensioned_force, self_peeling_tension, sliding_force, steady_force, stretched_force,
};
