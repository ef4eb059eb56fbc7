//! What holds a beam along the substrate.

use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::levels::half_space::HalfSpace;
use serde::{Deserialize, Serialize};

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
pub(super) const FLOOR: f64 = 2.0;

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
    pub fn law(&self, half_space: HalfSpace) -> Option<FrictionLaw> {
        let Self { strength, coefficient, presliding } = *self;
        strength.map(|strength| FrictionLaw::new(half_space, strength, coefficient, presliding))
    }
}
