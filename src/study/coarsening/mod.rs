//! The force of a spatula on what holds its end, as a table: the law of a tip of a seta.
//!
//! Coarse-graining, Section 7 of the paper: [`coarsen`] follows the spatula with its end held over ranges of height u, place along the substrate v
//! and rotation θ, and [`TipTable`] interpolates its energy, so that forces are its gradient. [`Coarsening`] solves the spatula itself where
//! a table is not enough, and [`SpatulaTip`] puts it into space.
mod adaptive;
mod answers;
mod before;
mod branch;
mod column;
mod columns;
mod error;
mod held_spatula;
mod jet;
mod near_end;
mod options;
mod outside;
mod place;
mod refine;
mod refused;
mod run;
mod seta_by_table;
mod seta_tip;
mod sheet;
mod sheet_table;
mod spline;
mod table;
mod tip_in_space;
mod visited;

pub use adaptive::{AdaptiveTable, ResolvedTips};
pub use branch::TipSheet;
pub use error::{CoarseningError, HeldError};
pub use near_end::NearEnd;
pub use options::{CoarseningOptions, OptionsError, TipRange};
pub use outside::{OutsideAt, OutsideTable, TableEnd, TableRound};
pub use place::{PadEnd, TipPlace, TipResponse};
pub use refine::{SheetErrors, TipScales};
pub use run::{Coarsening, coarsen};
pub use seta_by_table::{AfterRound, GrowingTable, pull_off_by_table};
pub use seta_tip::TableLaw;
pub use sheet::{Sheet, SheetLimit};
pub use sheet_table::{SheetNode, SheetTable};
pub use table::TipTable;
pub use tip_in_space::{OutOfPlane, SpatulaTip};
pub use visited::{Resolved, Visited};
