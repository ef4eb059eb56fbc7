//! The force of a spatula on what holds its end, as a table: the law of a tip of a seta.
//!
//! Coarse-graining, Section 7 of the paper: [`coarsen`] follows the spatula with its end held over ranges of height u, place along the substrate v
//! and rotation θ, and [`TipTable`] interpolates its energy, so that forces are its gradient. [`Coarsening`] solves the spatula itself where
//! a table is not enough, and [`SpatulaTip`] puts it into space. One level up, [`SetaLaw`] is the law of a whole seta.
mod columns;
mod held_spatula;
mod near_end;
mod options;
mod refine;
mod run;
mod seta_by_table;
pub(crate) mod seta_law;
mod sheet;
mod spline;
mod table;
mod tip_in_space;

pub use columns::TipSheet;
pub use near_end::{NearEnd, Resolved, Visited};
pub use options::{
    CoarseningError, CoarseningOptions, HeldError, OptionsError, PadEnd, TipPlace, TipRange, TipResponse,
};
pub use refine::{SheetErrors, TipScales};
pub use run::{Coarsening, coarsen};
pub use seta_by_table::{AfterRound, GrowingTable, OutsideAt, OutsideTable, TableEnd, TableRound, pull_off_by_table};
pub use seta_law::{
    ExitPlane, LawSheet, RootPath, RootPoint, RootResponse, SetaLaw, SetaLawError, SetaLawErrors, SetaLawOptions,
};
pub use sheet::{Sheet, SheetLimit, SheetNode, SheetTable};
pub use table::TipTable;
pub use tip_in_space::{OutOfPlane, SpatulaTip, TableLaw};
