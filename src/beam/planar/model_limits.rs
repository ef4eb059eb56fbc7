//! Where the model itself ends: states beyond which its energy has no stable equilibrium near by, or no lower bound.

use crate::adhesion::section::line_load::LineLaw;
use crate::beam::bonded_beam::{BondedBeam, BondedMode};
use serde::{Deserialize, Serialize};
use std::fmt;

/// What a planar beam asks of itself, to be within its model.
#[derive(Default)]
pub struct ModelLimits {
    /// Of a uniform beam on flat ground without friction that carries a horizontal force: one force all along what is bonded.
    pub bonded: Option<BondedBeam>,
    /// Of a law with a pole at upright sections.
    pub pole: Option<UprightPole>,
    /// Of a law without such a pole.
    pub corner: Option<UprightCorner>,
}

/// The near face's energy bW/|cos θ|, which has no lower bound where a section is upright.
///
/// By the first integral of a beam of one section, ½EI θ'² - bΨ + ... = const, what bends it is used up where b|W|/|cos θ| = ½EI θ'²: no
/// solution goes through the pole, and elements step over it where this barrier is narrow. Its half width, cos θ = 2b|W|/(EI θ'²) with the θ' of
/// the crossing, is the strength of the pole there.
pub struct UprightPole {
    /// The law of the free end
    pub law: LineLaw,
    /// EI (nN·nm²) and b (nm) at S, nm
    pub section: Box<dyn Fn(f64) -> [f64; 2] + Send + Sync>,
}

/// The line moment of a law at upright sections, which may jump there (`upright_corner.rs`).
pub struct UprightCorner {
    /// The law of the free end
    pub law: LineLaw,
    /// b at S, both nm
    pub width: Box<dyn Fn(f64) -> f64 + Send + Sync>,
}

/// Half width of a pole's barrier, cos θ, below which elements step over it without a trace, whatever their mesh. Of sampled pulls and spatulae
/// with the near face alone those that cross 6e-8 agree on all meshes; those that cross 2e-6 and more go on differently on each.
pub(super) const UNNOTICED: f64 = 1e-7;
/// The same over the relative accuracy asked for.
pub(super) const UNNOTICED_SHARE: f64 = 0.1;
/// Sections with a larger cos θ are far from a pole.
pub(super) const NEARBY: f64 = 0.3;
/// Places of an element at which its rotation is looked at.
pub(super) const LOOKS: usize = 24;

/// Length of the elements over that of [`PoleInReach::Unresolved`] from which on two meshes may agree on a number that finer ones do not give: with 0.7 and
/// 0.9 one was found wrong by 5e-5, with 0.3 none.
pub(super) const UNRESOLVED: f64 = 0.5;

/// Where a state is upright, or nearly so, in the reach of a pole.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct UprightSection {
    /// S, nm
    pub place: f64,
    /// Height of the near face above the ground, nm
    pub height: f64,
    /// What the law does there
    pub pole: PoleInReach,
}

/// What holds the beam at an upright section: the pole of the near face alone, or the corner of a pressed edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum PoleInReach {
    /// The beam passes through it.
    Crossed {
        /// Half width of the barrier, cos θ
        strength: f64,
    },
    /// The beam comes so near that elements are longer than the length over which the pole bends it, √(EI cos³θ/(b|W|)).
    Unresolved {
        /// cos θ where it comes nearest
        cosine: f64,
        /// That length, nm
        length: f64,
        /// Length of the element, nm
        element: f64,
    },
    /// The pole draws the section upright: it softens a tilt by more than tension and bending hold.
    Drawn {
        /// cos θ where it comes nearest
        cosine: f64,
        /// cos θ below which the tilt softens by more, (2b|W|/(V + EI/y²))^⅓ with V the vertical force of the grip and y the section's height
        held: f64,
    },
    /// The section stands on a pressed edge, about which it turns to neither side.
    Edge {
        /// cos θ where it is nearest to upright
        cosine: f64,
        /// Line moment to either side, nN
        moment: f64,
    },
}

impl UprightSection {
    /// Whether the pole draws it upright.
    pub const fn is_drawn(&self) -> bool {
        matches!(self.pole, PoleInReach::Drawn { .. })
    }
}

impl fmt::Display for UprightSection {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { place, height, pole } = self;
        write!(f, "the section at S = {place:.3} nm, {height:.3} nm above the substrate, ")?;
        match pole {
            PoleInReach::Crossed { strength } => write!(
                f,
                "stands upright, where the energy of the near face alone, W/cos θ, has no lower bound (it turns sections within cos θ = {strength:.1e})"
            ),
            PoleInReach::Unresolved { cosine, length, element } => write!(
                f,
                "is so nearly upright, cos θ = {cosine:.1e}, that the energy of the near face alone, W/cos θ, bends the beam within {length:.2} nm, \
                 where elements are {element:.2} nm long"
            ),
            PoleInReach::Drawn { cosine, held } => write!(
                f,
                "is drawn upright by the energy of the near face alone, W/cos θ, which has no lower bound there: cos θ = {cosine:.1e}, and below \
                 {held:.1e} it softens a tilt by more than tension and bending hold"
            ),
            PoleInReach::Edge { cosine, moment } => write!(
                f,
                "stands upright, cos θ = {cosine:.1e}, on an edge that is pressed on the substrate, which turns it back from either side with a \
                 line moment of {moment:.3e} nN: the beam is no longer smooth there"
            ),
        }
    }
}

/// How what is bonded has lost its stability.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BondedLoss {
    /// In which mode
    pub mode: BondedMode,
    /// H of the bonded part where the path ends, nN
    pub force: f64,
    /// H at which the criterion is met, nN
    pub critical: f64,
}

impl fmt::Display for BondedLoss {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { mode, force, critical } = self;
        let what = if *force < 0.0 { "compression" } else { "tension" };
        write!(
            f,
            "what is bonded loses its stability under a {what} of H = {force:.6} nN, critical {critical:.6} nN: {mode}"
        )
    }
}

/// How near to its criterion a mode is taken to be met where a path cannot be continued: the front disturbs what is bonded.
const NEAR: f64 = 0.99;
/// Halvings of an interval of H until a critical one is known to the machine's precision.
const HALVINGS: usize = 60;

impl ModelLimits {
    /// Whether what is bonded without a tilt is unstable under this horizontal force, nN. The free end comes first; the mode is the one that
    /// its whole length has next.
    pub fn bonded_loss(&self, force: f64) -> Option<BondedLoss> {
        self.loss(force, 1.0)
    }

    /// The same where that is nearly so.
    pub fn near_bonded_loss(&self, force: f64) -> Option<BondedLoss> {
        self.loss(force, NEAR)
    }

    fn loss(&self, force: f64, least: f64) -> Option<BondedLoss> {
        let beam = self.bonded.as_ref()?;
        let ratio = |mode| move |force| beam.ratio(mode, force);
        if ratio(BondedMode::FreeEnd)(force) < least {
            return None;
        }
        let bulk = [BondedMode::Tilting, BondedMode::Wrinkling].into_iter().find(|&mode| ratio(mode)(force) >= least);
        let mode = bulk.unwrap_or(BondedMode::FreeEnd);
        Some(BondedLoss { mode, force, critical: critical(&ratio(mode), force) })
    }
}

/// The force at which a ratio that is about 1 at `near` is 1; zero where it is no less at rest.
fn critical(ratio: &dyn Fn(f64) -> f64, near: f64) -> f64 {
    if ratio(0.0) >= 1.0 {
        return 0.0;
    }
    let (mut below, mut above) = (0.0, near);
    while ratio(above) < 1.0 && above.is_finite() {
        above *= 2.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        *(if ratio(middle) >= 1.0 { &mut above } else { &mut below }) = middle;
    }
    above
}
