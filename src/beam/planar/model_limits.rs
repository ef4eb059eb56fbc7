//! Where the model itself ends: states beyond which its energy has no stable equilibrium near by, or no lower bound.

use super::planar_beam::PlanarBeam;
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::bonded_beam::{BondedBeam, BondedMode};
use crate::solve::state::State;
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
const UNNOTICED: f64 = 1e-7;
/// The same over the relative accuracy asked for.
const UNNOTICED_SHARE: f64 = 0.1;
/// Sections with a larger cos θ are far from a pole.
const NEARBY: f64 = 0.3;
/// Places of an element at which its rotation is looked at.
const LOOKS: usize = 24;

/// Length of the elements over that of [`PoleInReach::Unresolved`] from which on two meshes may agree on a number that finer ones do not give: with 0.7 and
/// 0.9 one was found wrong by 5e-5, with 0.3 none.
const UNRESOLVED: f64 = 0.5;

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

impl PlanarBeam {
    /// The first section of a state, from the free end on, that stands upright where a pole of the law changes what is computed by more than the accuracy
    /// `relative`.
    pub fn upright_section(&self, at: &State, relative: f64) -> Option<UprightSection> {
        let pole = self.limits.pole.as_ref()?;
        let least = UNNOTICED.min(UNNOTICED_SHARE * relative);
        self.elements_near_upright(at).find_map(|element| {
            let crossed = self.looks(at, element).windows(2).find_map(|pair| self.crossed(pair, pole));
            crossed.filter(|&(_, strength)| strength > least).map(|(section, _)| section)
        })
    }

    /// The first section of a state, from the free end on, that is so nearly upright that the elements do not resolve a pole of the law.
    pub fn unresolved_section(&self, at: &State) -> Option<UprightSection> {
        self.nearly_upright(at, UNRESOLVED).next()
    }

    /// The first section of a state, from the free end on, that the pole of its law draws upright, and the same as one that is to be resolved.
    pub fn drawn_section(&self, at: &State) -> Option<[UprightSection; 2]> {
        let pole = self.limits.pole.as_ref()?;
        let tension = self.grip_forces(at).vertical.max(0.0);
        self.nearly_upright(at, 0.0).find_map(|section| {
            let PoleInReach::Unresolved { cosine, length, .. } = section.pole else { return None };
            let [bending, _] = (pole.section)(section.place);
            let held_by = tension + bending / (section.height * section.height);
            let softened = 2.0 * bending / (length * length);
            let held = cosine * (softened / held_by).cbrt();
            let drawn = UprightSection { pole: PoleInReach::Drawn { cosine, held }, ..section };
            (softened > held_by).then_some([drawn, section])
        })
    }

    /// The sections nearest to upright of elements that are longer than this many times the length over which the pole bends the beam there.
    fn nearly_upright(&self, at: &State, longer: f64) -> impl Iterator<Item = UprightSection> {
        let pole = self.limits.pole.as_ref();
        let near = pole.map(|pole| self.elements_near_upright(at).map(move |element| (element, pole)));
        let nearest = move |(element, pole)| self.nearest_to_upright(&self.looks(at, element), pole, longer);
        near.into_iter().flatten().filter_map(nearest)
    }

    pub(super) fn elements_near_upright(&self, at: &State) -> impl Iterator<Item = usize> {
        (0..at.mesh.elements()).filter(|&element| self.is_near_upright(at, element))
    }

    /// Whether a node of an element is nearly upright, or its nodes lie on both sides of that.
    fn is_near_upright(&self, at: &State, element: usize) -> bool {
        let (order, fields) = (self.chain.order(), self.fields());
        let nodes = &self.nodes(&at.values)[element * order * fields..][..(order + 1) * fields];
        let mut cosines = nodes.chunks(fields).map(|node| node[self.rotation].cos());
        let first = cosines.next().unwrap_or(1.0);
        first.abs() < NEARBY || cosines.any(|cos| cos.abs() < NEARBY || cos.signum() != first.signum())
    }

    /// [S, height of the axis, rotation] at places along an element.
    pub(super) fn looks(&self, at: &State, element: usize) -> Vec<[f64; 3]> {
        let ends = &at.mesh.boundaries;
        let look = |k: usize| {
            let share = k as f64 / LOOKS as f64;
            let (values, _) = self.chain.sample(self.configuration(at), element, 2.0 * share - 1.0);
            let place = ends[element] + share * (ends[element + 1] - ends[element]);
            [place, values[self.rotation - 1], values[self.rotation]]
        };
        (0..=LOOKS).map(look).collect()
    }

    /// EI (nN·nm²), height of the near face of an upright section (nm) and b|W| there (nN).
    fn pole_at(&self, pole: &UprightPole, place: f64, axis: f64) -> [f64; 3] {
        let height = axis + 0.5 * self.height_at(place);
        let [bending, width] = (pole.section)(place);
        [bending, height, width * pole.law.half_space.potential(height).abs()]
    }

    /// The upright section between two places, with the strength of the pole.
    fn crossed(&self, pair: &[[f64; 3]], pole: &UprightPole) -> Option<(UprightSection, f64)> {
        let [[start, low, left], [end, high, right]] = [pair[0], pair[1]];
        let [from, to] = [left.cos(), right.cos()];
        if from.signum() == to.signum() {
            return None;
        }
        let share = from / (from - to);
        let place = start + share * (end - start);
        let [bending, height, attraction] = self.pole_at(pole, place, low + share * (high - low));
        let turn = (right - left) / (end - start);
        let strength = 2.0 * attraction / (bending * turn * turn);
        Some((UprightSection { place, height, pole: PoleInReach::Crossed { strength } }, strength))
    }

    /// The section of an element that is nearest to upright on one side, where the element is longer than so many times the length over which the pole bends
    /// the beam.
    fn nearest_to_upright(&self, looks: &[[f64; 3]], pole: &UprightPole, longer: f64) -> Option<UprightSection> {
        let [place, axis, rotation] = *looks.iter().min_by(|a, b| a[2].cos().abs().total_cmp(&b[2].cos().abs()))?;
        let cosine = rotation.cos().abs();
        let one_sided = looks.iter().all(|look| look[2].cos().signum() == looks[0][2].cos().signum());
        let [bending, height, attraction] = self.pole_at(pole, place, axis);
        let length = (bending * cosine.powi(3) / attraction).sqrt();
        let element = looks[LOOKS][0] - looks[0][0];
        (one_sided && element > longer * length).then_some(UprightSection {
            place,
            height,
            pole: PoleInReach::Unresolved { cosine, length, element },
        })
    }
}
