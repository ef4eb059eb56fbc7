//! The verification suite behind `peel verify`, the figures behind `peel figures`, and what an accuracy costs.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod agreement;
mod check;
mod check_text;
mod figures;
pub mod sampled;
pub mod suite;
mod work_precision;

pub use check_text::{check_line, checks_json};
pub use figures::draw::{draw_figures, holds_figures};
pub use work_precision::measure::{Errors, Line, Trial, WorkPrecision, work_precision};
pub use work_precision::report::{AUTOMATIC, write_work_precision};

/// The programs of the chapters on the library, which `cargo test` compiles and runs.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../../../docs/reference/library.md")]
    mod library {}
    #[doc = include_str!("../../../docs/reference/library/studies.md")]
    mod studies {}
    #[doc = include_str!("../../../docs/reference/library/setae.md")]
    mod setae {}
}
