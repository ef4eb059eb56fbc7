//! The verification suite and its tables, held against what is computed.

mod cusp;
mod figures;
mod followed_again;
mod ground;
mod levels;
mod lost_peaks;
mod other_kinds;
mod out_of_plane;
#[path = "../shared/pictures.rs"]
mod pictures;
mod reference_values;
mod tapes;
mod toe;
