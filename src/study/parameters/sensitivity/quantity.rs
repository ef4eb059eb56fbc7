//! The numbers of a peel that can be differentiated, optimised, or called uncertain, and those of other pulls that can be optimised or called uncertain.

use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;
use crate::model::problem::build::NoSuchOrder;
use crate::solve::error::SolveError;
use crate::solve::points::search::LimitPointKind;
use crate::study::initial::error::NoEquilibrium;
use crate::study::peel::result::Peel;
use crate::study::peel::solution_history::{LimitPoint, Peak};
use PeelQuantity::*;

/// A number of a peel, of the pull-off of a seta, or of a pull at a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PeelQuantity {
    /// Of the first load limit point that is a maximum, nN
    InitiationPeakForce,
    /// Its displacement, nm
    InitiationPeakDisplacement,
    /// Of the highest load limit point up to the first jump, nN
    PeakForce,
    /// Its displacement, nm
    PeakDisplacement,
    /// Where the force changes least, nN
    PlateauForce,
    /// Of the first displacement limit point, nN
    FirstJumpForce,
    /// Its displacement, nm
    FirstJumpDisplacement,
    /// Work up to there, aJ
    FirstJumpWork,
    /// Of the displacement limit point behind which nothing adheres, nN
    DetachmentForce,
    /// Its displacement, nm
    DetachmentDisplacement,
    /// Work up to there, aJ
    DetachmentWork,
    /// Of a pull at a rate, nN
    LargestForce,
    /// Its displacement, nm
    LargestForceDisplacement,
    /// Of the pull of a seta, or of a beam at a rate, to the end, aJ
    Work,
}

impl PeelQuantity {
    /// Those of the peel of a beam, in the order in which they are reported.
    pub const OF_A_PEEL: [Self; 11] = [
        InitiationPeakForce,
        InitiationPeakDisplacement,
        PeakForce,
        PeakDisplacement,
        PlateauForce,
        FirstJumpForce,
        FirstJumpDisplacement,
        FirstJumpWork,
        DetachmentForce,
        DetachmentDisplacement,
        DetachmentWork,
    ];
    /// Those of the peel of a solid.
    pub const OF_A_SOLID: [Self; 2] = [PeakForce, PeakDisplacement];
    /// Those of the pull-off of a seta.
    pub const OF_A_SETA: [Self; 3] = [PeakForce, PeakDisplacement, Work];
    /// Those of the pull of an array of setae.
    pub const OF_AN_ARRAY: [Self; 3] = Self::OF_A_SETA;
    /// Those of a pull at a rate, of a beam or of a seta.
    pub const AT_A_RATE: [Self; 3] = [LargestForce, LargestForceDisplacement, Work];

    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::OF_A_PEEL.into_iter().chain(Self::AT_A_RATE)
    }

    /// Where it stands in a summary, with its unit.
    pub fn name(self) -> &'static str {
        match self {
            InitiationPeakForce => "initiation_peak.force_nN",
            InitiationPeakDisplacement => "initiation_peak.displacement_nm",
            PeakForce => "peak.force_nN",
            PeakDisplacement => "peak.displacement_nm",
            PlateauForce => "plateau.force_nN",
            FirstJumpForce => "first_jump.force_nN",
            FirstJumpDisplacement => "first_jump.displacement_nm",
            FirstJumpWork => "first_jump.work_aJ",
            DetachmentForce => "detachment.force_nN",
            DetachmentDisplacement => "detachment.displacement_nm",
            DetachmentWork => "detachment.work_aJ",
            LargestForce => "largest_force.force_nN",
            LargestForceDisplacement => "largest_force.displacement_nm",
            Work => "balance.work_aJ",
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            InitiationPeakForce | PeakForce | PlateauForce | FirstJumpForce | DetachmentForce | LargestForce => "nN",
            InitiationPeakDisplacement
            | PeakDisplacement
            | FirstJumpDisplacement
            | DetachmentDisplacement
            | LargestForceDisplacement => "nm",
            FirstJumpWork | DetachmentWork | Work => "aJ",
        }
    }

    /// The one with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|quantity| quantity.name() == name)
    }

    /// Its value of a peel; none where the path does not have it.
    pub fn value(self, peel: &Peel) -> Option<f64> {
        self.with_error(peel).map(|(value, _)| value)
    }

    /// The bound on the error of that; none where there is none.
    pub fn error(self, peel: &Peel) -> Option<f64> {
        self.with_error(peel).and_then(|(_, error)| error)
    }

    fn with_error(self, peel: &Peel) -> Option<(f64, Option<f64>)> {
        let force = |at: &Peak| (at.force, Some(at.force_error));
        let place = |at: &Peak| (at.displacement, Some(at.displacement_error));
        let jump = |at: &LimitPoint| match self {
            FirstJumpForce | DetachmentForce => (at.force, Some(at.force_error)),
            FirstJumpDisplacement | DetachmentDisplacement => (at.displacement, Some(at.displacement_error)),
            _ => (at.work, at.work_error),
        };
        match self {
            InitiationPeakForce => peel.initiation_peak.as_ref().map(force),
            InitiationPeakDisplacement => peel.initiation_peak.as_ref().map(place),
            PeakForce => peel.peak.as_ref().map(force),
            PeakDisplacement => peel.peak.as_ref().map(place),
            PlateauForce => peel.plateau.map(|at| (at.force, at.force_error)),
            FirstJumpForce | FirstJumpDisplacement | FirstJumpWork => peel.snap_off.as_ref().map(jump),
            DetachmentForce | DetachmentDisplacement | DetachmentWork => peel.detachment.as_ref().map(jump),
            LargestForce | LargestForceDisplacement | Work => None,
        }
    }

    /// The limit point that it belongs to, by its number among those of the path; none of the plateau.
    pub(super) fn limit_point(self, peel: &Peel) -> Option<usize> {
        let turn = |at: &Peak| {
            let is_it = |p: &LimitPoint| p.kind == LimitPointKind::Load && p.displacement == at.displacement;
            peel.limit_points.iter().position(is_it)
        };
        let jump = |at: &LimitPoint| peel.limit_points.iter().position(|p| p.after == at.after && p.kind == at.kind);
        match self {
            InitiationPeakForce | InitiationPeakDisplacement => peel.initiation_peak.as_ref().and_then(turn),
            PeakForce | PeakDisplacement => peel.peak.as_ref().and_then(turn),
            PlateauForce | LargestForce | LargestForceDisplacement | Work => None,
            FirstJumpForce | FirstJumpDisplacement | FirstJumpWork => peel.snap_off.as_ref().and_then(jump),
            DetachmentForce | DetachmentDisplacement | DetachmentWork => peel.detachment.as_ref().and_then(jump),
        }
    }
}

// -- Why there are no sensitivities --

/// Why results cannot be differentiated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoSensitivities {
    #[error(
        "with friction what a beam does depends on its past, and no derivative of it is computed; set friction to none"
    )]
    Friction,
    #[error(
        "an adhesion that does not heal depends on its past, and no derivative of it is computed; set healing to true, which changes \
         nothing as long as nothing that has opened closes again"
    )]
    Healing,
    #[error("a film that yields depends on its past, and no derivative of it is computed; remove its yield strength")]
    Yielding,
    #[error("terms of the model were left out of the path ({terms}); ask for all of them with terms = \"all\"")]
    TermsLeftOut { terms: String },
    #[error("the solutions behind the path are not known: it was read and not computed, or it has no point")]
    NoSolutions,
    #[error(
        "{key} changed by {change:e} gives a model that cannot be computed: {cause}; it stands at an end of its range"
    )]
    AtTheEdge { key: String, change: f64, cause: ModelError },
    #[error(
        "{key} a little larger or smaller gives a model of another kind, with other unknowns; it has no derivative here"
    )]
    AnotherKind { key: String },
    #[error("{key} changed by {change:e} gives a model without a start: {cause}")]
    NoStart { key: String, change: f64, cause: NoEquilibrium },
    #[error("{key} makes the derivative of {of} no number: the model is not smooth in it here")]
    NotFinite { key: String, of: &'static str },
    #[error("at u = {displacement} nm there is no point of the first stable branch, which goes from 0 to {most} nm")]
    NotOnBranch { displacement: f64, most: f64 },
    #[error(transparent)]
    Order(#[from] NoSuchOrder),
    #[error("{of} could not be solved for again beside its limit point: {cause}")]
    NotSolved { of: &'static str, cause: SolveError },
}

impl NoSensitivities {
    /// What forbids them for a model, whose past decides what it does, if anything does.
    pub fn of(model: &PeelModel) -> Option<Self> {
        let past = [
            (model.friction_law().is_some(), Self::Friction),
            (!model.adhesion.healing, Self::Healing),
            (model.yields(), Self::Yielding),
        ];
        past.into_iter().find(|(depends, _)| *depends).map(|(_, why)| why)
    }

    /// The key of a scene, or its table, that has to be removed for there to be any.
    pub fn key(&self) -> Option<&'static str> {
        match self {
            Self::Friction => Some("friction"),
            Self::Healing => Some("adhesion.healing"),
            Self::Yielding => Some("strip.yield_strength"),
            _ => None,
        }
    }
}

/// A parameter that results are differentiated by.
pub struct Variation<'m> {
    /// What it is called: a key of a scene, say
    pub key: String,
    /// The model with the parameter changed by x, in a coordinate that is near to 1 where it matters: ln p for a number above zero. `model(0.0)` is the
    /// model that was peeled.
    pub model: Box<dyn Fn(f64) -> PeelModel + Send + Sync + 'm>,
}

impl<'m> Variation<'m> {
    /// By the coordinate of `model`.
    pub fn new(key: impl Into<String>, model: impl Fn(f64) -> PeelModel + Send + Sync + 'm) -> Self {
        Self { key: key.into(), model: Box::new(model) }
    }
}

/// The derivative of one number by one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivative {
    /// The number
    pub of: PeelQuantity,
    /// Which of the variations
    pub variation: usize,
    /// dQ/dx, in the unit of the number
    pub value: f64,
    /// Bound on its error
    pub error: f64,
}
