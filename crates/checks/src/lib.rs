//! The verification suite behind `peel verify`, the figures behind `peel figures`, and what an accuracy costs.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod agreement;
mod check_text;
mod figures;
pub mod sampled;
pub mod suite;
mod work_precision;

pub use check_text::{check_line, checks_json};
pub use figures::draw::{draw_figures, holds_figures};
pub use work_precision::measure::{Errors, Line, Trial, WorkPrecision, work_precision};
pub use work_precision::report::{AUTOMATIC, write_work_precision};

/// The programs of the chapter on the library, which `cargo test` compiles and runs.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/reference/library.md")]
mod book {}
