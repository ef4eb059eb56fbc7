//! How thin adhesive beams peel from a surface.
//!
//! Units inside the library: nm and nN, hence 1 nN/nm² = 1 GPa, 1 nN/nm = 1 J/m², 1 nN·nm = 1 aJ.
//!
//! ```
//! use peelkit::prelude::*;
//!
//! // the strip of the paper, 100 nm long and 10 nm high, of 2 GPa
//! let model = StripModel::of_the_paper(100.0, 1.0);
//! let peel = peel(&model, &Accuracy::to(1e-6), &StopCriteria::default());
//! let peak = peel.initiation_peak.ok_or("the path has no peak")?;
//! println!("{:.6} nN at u = {:.6} nm", peak.force, peak.displacement);
//! assert!(peak.force_error < 1e-6 * peak.force);
//! # Ok::<(), &'static str>(())
//! ```
//!
//! The modules build on one another: `adhesion` and `solve` on nothing, `beam` on both, `model` on `beam`, `study` on `model`, `toe` on the law of a seta in `study`.

#![forbid(unsafe_code)]
#![warn(missing_docs)]
#![warn(unreachable_pub)]
// sums over fields, nodes and points read as in the equations
#![allow(clippy::needless_range_loop)]

pub mod number;

pub mod adhesion;
pub mod analytic;
pub mod beam;
pub mod model;
pub mod solid;
pub mod solve;
pub mod study;
pub mod toe;
pub mod units;

/// What most programs that peel something need: beams and trees of them, setae, and pulls at a rate.
pub mod prelude {
    pub use crate::adhesion::{Attraction, LineLoad, Substrate};
    pub use crate::beam::{BeamTree, Branch, BranchingBeam, Viscosity};
    pub use crate::model::{
        Adhesion, Body, Form, Friction, Grip, Ground, Hold, MovingMaterial, NormalPull, PeelModel, Pull, Seta,
        SetaModel, Sideways, Spatula, Step, Strip, StripModel,
    };
    pub use crate::solve::{Path, PathEvent, PathOptions, PathTracer, TraceOptions};
    pub use crate::study::{
        Accuracy, PathEnd, Peel, PullRate, SetaLoading, SetaOptions, StopCriteria, TimeAccuracy, Until, observed, peel,
        pull_in_time, pull_off, tip_curve,
    };
}
