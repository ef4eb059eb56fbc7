//! A peel and what was asked for beside it, as one JSON object.

mod accuracy;
mod branch;
mod branch_point;
mod derived;
mod ground;
mod limit_point;
mod observed;
mod out_of_plane;
mod place;
mod sensitivities;
mod sliding;
mod summary;
mod term_summary;

pub use accuracy::left_out;
pub use ground::ground_warning;
pub use observed::ObservedSummary;
pub use summary::PeelSummary;
pub use term_summary::why_kept;
