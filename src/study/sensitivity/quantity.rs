//! The numbers of a peel that can be differentiated, optimised, or called uncertain, and those of other pulls that can be optimised or called uncertain.

use crate::solve::points::kind::LimitPointKind;
use crate::study::peel::points::{LimitPoint, Peak};
use crate::study::peel::result::Peel;

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
    /// Of what pulls a seta, or a beam at a rate, to the end, aJ
    Work,
}

use PeelQuantity::*;

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
    /// Those of the pull-off of a seta.
    pub const OF_A_SETA: [Self; 3] = [PeakForce, PeakDisplacement, Work];
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
