//! What a beam lies on, how it comes to lie there, and what holds it along it.
//!
//! On ground that is not flat a beam has several equilibria without a force: it may follow the ground into a valley, or lie
//! across it. Which one a path starts in depends on how the beam got there, so that is said: from a guess it is relaxed, with
//! no grip, down the gradient of its energy to the stable equilibrium next to it (`study::prepared`). There the grip takes hold, so
//! that P = 0, u = 0 and no moment, whatever the grip then holds.

use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::substrate::Substrate;
use crate::beam::mesh::MeshKind;
use serde::{Deserialize, Serialize};

/// The guess from which a beam relaxes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Start {
    /// It follows the ground at the gap of a flat section at rest, as where it has been pressed on: everywhere it can it stays
    /// in contact. What rises in the stress-free configuration continues from there as it then would.
    #[default]
    Conformed,
    /// It lies stress-free on the crests at that gap, as where it has come near from above: it sinks in as far as adhesion
    /// draws it.
    Crests,
}

/// What a beam lies on; level ground unless given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ground {
    /// The shape of the ground
    pub substrate: Substrate,
    /// Where the beam is before it settles
    pub start: Start,
}

/// Length of elements over that in which the ground changes.
const OF_DETAIL: f64 = 0.25;
/// Lengths of elements on ground that is not flat relative to each other: everywhere, over the length of the process zone where that is short at
/// the front, and over the length in which the ground changes. On a mesh that stays a front may be anywhere.
const FLOOR: f64 = 10.0;
const FLOOR_OF_FIXED: f64 = 2.0;

impl Ground {
    /// The length that elements of such a mesh have everywhere relative to those at a front, nm: on ground that is not flat, other parts of a beam
    /// may touch.
    pub(super) fn floor(&self, process_length: f64, mesh: MeshKind) -> Option<f64> {
        let floor = if mesh == MeshKind::Moving { FLOOR } else { FLOOR_OF_FIXED };
        let floor = (floor * process_length).min(OF_DETAIL * self.substrate.feature_length());
        (!self.substrate.is_flat()).then_some(floor)
    }
}

/// Friction of the face that looks down on level ground, as [`FrictionLaw`] has it. The free end is then held by nothing else.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Friction {
    /// Shear strength τ0 of the contact, GPa; none: there is no friction
    pub strength: Option<f64>,
    /// Coulomb's coefficient μ of what presses on it
    pub coefficient: f64,
    /// How far it gives way until it slides at the strength τ0, nm; none: it is as stiff along the substrate as the half space is
    /// across, or gives way by r0/400
    pub presliding: Option<f64>,
}

/// Length of elements far from the front relative to those at it, over the length in which a strip that sticks takes over a force: sliding
/// may begin there.
pub(in crate::model) const FLOOR_OF_STICKING: f64 = 2.0;

impl Default for Friction {
    /// None.
    fn default() -> Self {
        Self::NONE
    }
}

impl Friction {
    /// None.
    pub const NONE: Self = Self { strength: None, coefficient: 0.0, presliding: None };

    /// The law of this friction on a half space, if there is any.
    pub(crate) fn law(&self, half_space: HalfSpace) -> Option<FrictionLaw> {
        let Self { strength, coefficient, presliding } = *self;
        strength.map(|strength| FrictionLaw::new(half_space, strength, coefficient, presliding))
    }
}
