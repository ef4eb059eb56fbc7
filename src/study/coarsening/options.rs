//! Which places of its end a table of a tip holds, and how accurately.

use crate::model::peel::PeelModel;
use crate::solve::error::SolveError;
use crate::solve::path::options::PathError;
use crate::solve::points::tracer::TraceError;
use crate::study::asked::stop_criteria::Bound;
use crate::study::initial::error::NoEquilibrium;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Which places of its end a table holds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TipRange {
    /// How far below the height without a normal force it begins, nm, zero or above
    pub press: f64,
    /// v, from and to, nm; of no use where the pad slides
    pub lateral: [f64; 2],
    /// θ, from and to, rad
    pub rotation: [f64; 2],
}

impl TipRange {
    /// Of a pad whose end slides: pressed by 50 nm, ±0.4 rad.
    pub const SLIDING: Self = Self { press: 50.0, lateral: [0.0; 2], rotation: [-0.4, 0.4] };
    /// Of a pad whose end is held: pressed by 5 nm, ±10 nm along the substrate, ±0.1 rad.
    pub(crate) const HELD: Self = Self { press: 5.0, lateral: [-10.0, 10.0], rotation: [-0.1, 0.1] };

    /// The default for a pad end.
    pub const fn of(pad_end: PadEnd) -> Self {
        match pad_end {
            PadEnd::Held => Self::HELD,
            PadEnd::Sliding => Self::SLIDING,
        }
    }
}

/// How a table of a tip is made.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CoarseningOptions {
    /// What the free end of the pad does
    pub pad_end: PadEnd,
    /// Which places it holds
    pub range: TipRange,
    /// Error wanted of forces and moment, over the largest of each in the table
    pub tolerance: f64,
    /// Most columns, pairs of v and θ at which a branch is followed, those that check the table among them
    pub most_columns: usize,
}

impl CoarseningOptions {
    /// What a tolerance may be.
    pub const TOLERANCES: [f64; 2] = [1e-6, 0.1];

    /// The default ranges of a pad end, to 1e-3.
    pub const fn of(pad_end: PadEnd) -> Self {
        Self { pad_end, range: TipRange::of(pad_end), tolerance: 1e-3, most_columns: 4000 }
    }

    /// Whether its numbers have a meaning.
    ///
    /// # Errors
    /// The number that has none.
    pub fn check(&self) -> Result<(), OptionsError> {
        let [least, most] = Self::TOLERANCES;
        let TipRange { press, lateral, rotation } = self.range;
        if !(least..=most).contains(&self.tolerance) {
            return Err(OptionsError::Tolerance { tolerance: self.tolerance, least, most });
        }
        if !(press.is_finite() && press >= 0.0) {
            return Err(OptionsError::Press { press });
        }
        let ranges = [("lateral", lateral, "nm"), ("rotation", rotation, "rad")];
        for (name, [from, to], unit) in ranges {
            let needed = name == "rotation" || self.pad_end == PadEnd::Held;
            if needed && !(from.is_finite() && to.is_finite() && from <= 0.0 && 0.0 <= to && from < to) {
                return Err(OptionsError::Range { name, from, to, unit });
            }
        }
        Ok(())
    }
}

/// Why options have no meaning.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum OptionsError {
    #[error("the tolerance {tolerance} is out of range: give {least} to {most}")]
    Tolerance { tolerance: f64, least: f64, most: f64 },
    #[error("the spatula is pressed by {press} nm: give a length of zero or above")]
    Press { press: f64 },
    #[error("the {name} range from {from} to {to} {unit} does not hold zero with room about it: give it as from,to")]
    Range { name: &'static str, from: f64, to: f64, unit: &'static str },
}

// -- Where the end of a spatula is held, and what it takes to hold it there --

/// Where the end S = L of a spatula is held, in its plane, from where it is in the stress-free configuration that lies on the substrate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TipPlace {
    /// u, away from the substrate, nm
    pub normal: f64,
    /// v, along the substrate, away from the free end of the pad, nm
    pub lateral: f64,
    /// θ, rad; positive anticlockwise
    pub rotation: f64,
}

impl TipPlace {
    /// The place at a share of the way to another one.
    pub(crate) fn toward(self, other: Self, share: f64) -> Self {
        let between = |from: f64, to: f64| from + share * (to - from);
        Self {
            normal: between(self.normal, other.normal),
            lateral: between(self.lateral, other.lateral),
            rotation: between(self.rotation, other.rotation),
        }
    }
}

/// The energy of a spatula whose end is held, with its derivatives by u, v and θ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TipResponse {
    /// E, stored and of adhesion, aJ; zero where the spatula is stress-free and far from the substrate
    pub energy: f64,
    /// ∂E/∂(u, v, θ): what holds the end, nN, nN and nN·nm
    pub force: [f64; 3],
    /// ∂²E/∂(u, v, θ)², symmetric: nN/nm, nN and nN·nm
    pub stiffness: [[f64; 3]; 3],
}

/// Whether the free end of the pad stays where it adheres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PadEnd {
    /// It stays at x = 0 and carries the force along the substrate.
    #[default]
    Held,
    /// It slides without friction: there is no force along the substrate, and v changes nothing.
    Sliding,
}

// -- Why a spatula is not solved where its end is held, and why there is no table --

impl fmt::Display for TipPlace {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { normal, lateral, rotation } = self;
        write!(f, "u = {normal:.6} nm, v = {lateral:.6} nm, θ = {rotation:.6} rad")
    }
}

/// Why a spatula was not solved at a place of its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum HeldError {
    #[error("{0}")]
    NoStart(NoEquilibrium),
    #[error("the spatula does not come to rest on the substrate: {0}")]
    NoRest(PathError),
    #[error("no stable equilibrium was reached from {from} at {to}; the last one is at {reached}: {cause}")]
    NotReached { from: TipPlace, to: TipPlace, reached: TipPlace, cause: SolveError },
    #[error("the equilibria from {from} on cannot be followed to a limit point: {cause}")]
    Path { from: TipPlace, cause: TraceError },
    #[error("the equilibria from {from} on have no limit point up to u = {last:.6} nm, after {points} points")]
    NoLimit { from: TipPlace, points: usize, last: f64 },
    #[error(
        "the equilibria from {from} on lose their stability at u = {last:.6} nm, where the displacement does not turn"
    )]
    Unstable { from: TipPlace, last: f64 },
    #[error("the branch from {at} to its limit point has no length")]
    Level { at: TipPlace },
    #[error(
        "at {at} the pad presses on the substrate so that less of it adheres: what the table goes along turns back there. Press less"
    )]
    Folded { at: TipPlace },
    #[error("the equilibrium at the share {share:.6} of the branch that begins at {at} was not found: {cause}")]
    NoNode { at: TipPlace, share: f64, cause: SolveError },
    #[error(
        "the branch ends at {at}, where {adhering:.3} nm of the pad still adhere, of {rest:.3} nm at rest: from there the pad goes over to another attached state, of which there is no table"
    )]
    StillAdheres { at: TipPlace, adhering: f64, rest: f64 },
    #[error("the nodes of the table have no interpolant")]
    NoTable,
    #[error(
        "the table would take {nodes} nodes along its branch, more than {most}: the branch turns sharply where the spatula is pressed far"
    )]
    Rough { nodes: usize, most: usize },
    #[error("solving the spatula was stopped")]
    Stopped,
}

/// Why there is no table of a tip.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CoarseningError {
    /// A number of the options
    #[error("{0}")]
    Options(#[from] OptionsError),
    /// A model of which there is none
    #[error("{what}")]
    Refused {
        /// Why
        what: &'static str,
        /// What to do
        remedy: &'static str,
    },
    /// A criterion that was met
    #[error("{bound}: {equilibria} equilibria on {columns} paths were solved, too few for the table of a tip")]
    Stopped {
        /// Which
        bound: Bound,
        /// Paths that were followed
        columns: usize,
        /// Equilibria that were solved
        equilibria: usize,
    },
    /// A place of the end
    #[error("{0}")]
    Held(#[from] HeldError),
}

impl CoarseningError {
    /// What to try.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Options(_) => "peel coarsen --help has the ranges.",
            Self::Refused { remedy, .. } => remedy,
            Self::Stopped { .. } => "Give it more time: bounds.time of the scene.",
            Self::Held(HeldError::NoStart(_) | HeldError::NoRest(_)) => {
                "peel run of the same scene says more about where the path begins."
            }
            Self::Held(_) => "Narrow the ranges of v and θ, or press less.",
        }
    }
}

// -- What a table of a tip cannot be made of --

/// Refuses it.
pub(super) fn refuse(model: &PeelModel) -> Result<(), CoarseningError> {
    let refused = |what: &'static str, remedy: &'static str| Err(CoarseningError::Refused { what, remedy });
    if model.space.is_some() {
        return refused("the scene is in space, and a tip is coarsened in its plane", "Remove the table [space]");
    }
    if !model.ground.substrate.is_flat() {
        return refused(
            "the substrate is not flat, and a tip may adhere anywhere on it",
            "Remove the table [substrate]",
        );
    }
    if model.friction_law().is_some() {
        return refused(
            "with friction the force depends on how the pad has slid, and not on where its end is alone",
            "Remove the table [friction]; grip.horizontal = \"fixed\" holds the free end of the pad",
        );
    }
    if !model.has_potential() {
        return refused(
            "the load has no potential, and the table is one of an energy",
            "Give adhesion.line_load = \"full\" or \"axis-gap\", and no adhesion.shear_work",
        );
    }
    if !model.steps.is_empty() {
        return refused(
            "the grip takes steps before the pull, and the end of a tip is held anywhere",
            "Remove drive.steps",
        );
    }
    if model.grip.stiffness.is_some() || model.grip.pretension.is_some() {
        return refused(
            "the grip has a spring or a pretension, and a table is that of the spatula alone",
            "Remove grip.stiffness and grip.pretension",
        );
    }
    Ok(())
}
