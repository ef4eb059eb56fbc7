//! The beam on its own, without adhesion: against closed forms, elliptic integrals and shooting.
//!
//! All rods have L = 1 and EI = 1, so that lengths are in L, forces in EI/L² and moments in EI/L.

pub(crate) mod arch;
mod cantilever;
mod column;
mod motion;
pub(crate) mod rods;

use crate::check::{Check, Topic};

pub(super) const TOPIC: Topic =
    Topic { name: "beam", about: "the beam without adhesion: bending, buckling, snap-through", checks };

fn checks() -> Vec<Check> {
    let parts = [cantilever::checks, column::checks, motion::checks, arch::checks];
    parts.iter().flat_map(|part| part()).collect()
}
