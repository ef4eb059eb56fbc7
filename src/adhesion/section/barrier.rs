//! What keeps a face out of the substrate, and how far it is from there.
//!
//! The half space repels without bound where a distance falls to zero. A cohesive law is a spring there: where a face is closed is a
//! reference that may be chosen at will, and one that is pressed may come below the distance zero.

/// What keeps a face out of the substrate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Barrier {
    /// A repulsion without bound at the distance zero.
    Pole,
    /// A repulsion that grows with how far a face is pressed in.
    Spring {
        /// The distance at which a face is closed, nm
        closed: f64,
        /// The opening over which the traction changes by its own size, nm
        scale: f64,
    },
}

impl Barrier {
    /// The distance (nm) of a face from what it cannot pass, above zero wherever it may be: that from a pole itself, above a spring how far the
    /// face is open, and its scale.
    pub(crate) fn clearance(&self, distance: f64) -> f64 {
        match self {
            Self::Pole => distance,
            Self::Spring { closed, scale } => scale + (distance - closed).max(0.0),
        }
    }
}
