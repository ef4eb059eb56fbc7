//! What can be asked of a scene: its peel, its pull-off, its pull at a rate, and what is made of many of these.
//!
//! An [`Analysis`] is made of a scene that it is checked against; [`Analysis::run`] computes it in a [`Session`], which says who looks on and where
//! it keeps what it finds; an [`Outcome`] hands on the numbers and writes the files. The command `peel` and the Python package are made of these.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod coarsen;
mod fit;
mod missing_law;
mod optimise;
mod outcome;
mod pulls;
mod run;
mod session;
mod seta_law;
mod sweep;
mod uncertainty;

pub use coarsen::{TipCoarsening, TipOutcome};
pub use fit::{Data, FitOutcome, Fitting};
pub use missing_law::MissingLaw;
pub use optimise::{Optimisation, OptimisationOutcome};
pub use outcome::{Analysis, End, Outcome, Refusal};
pub use run::{
    ArrayOutcome, ArrayRun, Asked, Exponents, OfSeta, PeelOutcome, PeelRun, Pull, RateOutcome, RateRun, Run,
    RunOutcome, SetaOutcome, SetaRun, SolidOutcome, SolidRun,
};
pub use session::{Cost, Keeping, Nobody, Parts, Progress, Session, Watcher};
pub use seta_law::{SetaLawCoarsening, SetaLawOutcome};
pub use sweep::{Axis, Case, Cases, Rows, SceneRows, Sweep, SweepOutcome, place};
pub use uncertainty::{Uncertainty, UncertaintyOutcome};
