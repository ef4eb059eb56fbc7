//! What a beam lies on, and how it comes to lie there.
//!
//! On ground that is not flat a beam has several equilibria without a force: it may follow the ground into a valley, or lie
//! across it. Which one a path starts in depends on how the beam got there, so that is said: from a guess it is relaxed, with
//! no grip, down the gradient of its energy to the stable equilibrium next to it (`study::prepared`). There the grip takes hold, so
//! that P = 0, u = 0 and no moment, whatever the grip then holds.

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
