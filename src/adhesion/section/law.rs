//! The adhesion model of a section, and everything that is asked of it elsewhere.

use super::barrier::Barrier;
use super::calibrated::Cohesive;
use super::cohesive::CohesiveShape;
use super::cohesive::tabulated::TractionTable;
use super::own::OwnLaw;
use crate::adhesion::levels::half_space::HalfSpace;

/// The adhesion model without its numbers: what a scene names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attraction {
    /// The half space's body force over the height of the section.
    BodyForce,
    /// The half space's traction on the faces of the section.
    SurfaceTraction,
    /// A cohesive law between the bonded face and the substrate.
    Cohesive(CohesiveShape),
    /// A law of the user's own.
    Own(OwnLaw),
}

/// The adhesion of a tilted section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// The body force of eq. (9) over its height, eqs. (17)-(22). It has a potential.
    BodyForce,
    /// The traction of eq. (10) on its faces, eqs. (11) and (12). It has none.
    SurfaceTraction,
    /// A cohesive law between the bonded face and the substrate, in place of the half space's traction. It has a potential.
    Cohesive(Cohesive),
    /// A law of the user's own.
    Own(OwnLaw),
}

impl Attraction {
    /// Everything that a scene may name, in the order in which help and messages list it.
    pub fn all() -> impl Iterator<Item = Self> {
        [Self::BodyForce, Self::SurfaceTraction].into_iter().chain(Self::cohesive())
    }

    /// The cohesive ones among them.
    pub fn cohesive() -> impl Iterator<Item = Self> {
        CohesiveShape::ALL.iter().map(|&shape| Self::Cohesive(shape))
    }

    /// What a scene calls it.
    pub fn name(self) -> &'static str {
        match self {
            Self::BodyForce => "body-force",
            Self::SurfaceTraction => "surface-traction",
            Self::Cohesive(shape) => shape.name(),
            Self::Own(own) => own.law().name(),
        }
    }

    /// What a scene calls so.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|attraction| attraction.name() == name)
    }

    /// How many times as many elements its corners take: the narrower they are, the more; 1 where it has none.
    pub fn corners(self) -> f64 {
        match self {
            Self::BodyForce | Self::SurfaceTraction => 1.0,
            Self::Cohesive(shape) => shape.corners(),
            Self::Own(own) => own.law().corners(),
        }
    }

    /// Whether friction goes with it, whose limit is that of a face in the half space's contact.
    pub(crate) fn takes_friction(self) -> bool {
        self.is_of_half_space()
    }

    /// Whether work of adhesion and strength may be given; all others follow from their own constants or rows.
    pub fn takes_work_and_strength(self) -> bool {
        self.is_cohesive() && self.table().is_none()
    }

    /// Whether it is a cohesive law, which may have a shear strength.
    pub fn is_cohesive(self) -> bool {
        matches!(self, Self::Cohesive(_))
    }

    /// The rows of a measured law, from which work of adhesion and strength follow.
    pub fn table(self) -> Option<&'static TractionTable> {
        match self {
            Self::Cohesive(CohesiveShape::Measured(curve)) => Some(curve.table()),
            _ => None,
        }
    }

    fn is_of_half_space(self) -> bool {
        matches!(self, Self::BodyForce | Self::SurfaceTraction)
    }

    /// The law with its numbers: work of adhesion (nN/nm) and strength (nN/nm²) of a cohesive one, which are else those of its table or the half
    /// space's.
    pub(crate) fn law(self, half_space: &HalfSpace, work: Option<f64>, strength: Option<f64>) -> Law {
        match self {
            Self::BodyForce => Law::BodyForce,
            Self::SurfaceTraction => Law::SurfaceTraction,
            Self::Cohesive(shape) => {
                let [own_work, own_strength] = match self.table() {
                    Some(table) => [table.work(), table.strength()],
                    None => [half_space.work_of_adhesion(), half_space.strength()],
                };
                let (work, strength) = (work.unwrap_or(own_work), strength.unwrap_or(own_strength));
                Law::Cohesive(Cohesive::calibrated(shape, strength, work, half_space))
            }
            Self::Own(own) => Law::Own(own),
        }
    }
}

impl Law {
    /// Whether force and moment derive from a potential.
    pub(crate) fn has_potential(&self) -> bool {
        match self {
            Self::BodyForce | Self::Cohesive(_) => true,
            Self::SurfaceTraction => false,
            Self::Own(own) => own.law().has_potential(),
        }
    }

    /// Whether the face that looks up may make a difference.
    pub(crate) fn has_far_face(&self) -> bool {
        matches!(self, Self::BodyForce | Self::SurfaceTraction)
    }

    /// As [`super::LineLaw::has_pole`].
    pub(super) fn has_pole_of_one_face(&self) -> bool {
        matches!(self, Self::BodyForce)
    }

    /// As [`super::LineLaw::gap_scale`].
    pub(super) fn gap_scale(&self, half_space: &HalfSpace) -> f64 {
        match self {
            Self::BodyForce | Self::SurfaceTraction | Self::Own(_) => half_space.equilibrium_distance,
            Self::Cohesive(law) => HalfSpace::of_work_and_strength(law.work(), law.strength).equilibrium_distance,
        }
    }

    /// As [`super::LineLaw::barrier`].
    pub(super) fn barrier(&self, half_space: &HalfSpace) -> Barrier {
        match self {
            Self::BodyForce | Self::SurfaceTraction | Self::Own(_) => Barrier::Pole,
            Self::Cohesive(law) => Barrier::Spring { closed: law.closed, scale: self.gap_scale(half_space) },
        }
    }

    /// As [`super::LineLaw::cutoff_distance`].
    pub(super) fn cutoff_distance(&self, half_space: &HalfSpace) -> f64 {
        match self {
            Self::BodyForce | Self::SurfaceTraction => 10.0 * half_space.equilibrium_distance,
            Self::Cohesive(law) => law.cutoff_distance(),
            Self::Own(own) => own.law().cutoff_distance(),
        }
    }
}
