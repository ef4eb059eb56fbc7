//! What the face of a beam remembers of its sliding: the rows of its [`History`] are place, mobilisation and shear strength.

use crate::adhesion::friction::dahl::FrictionState;
use crate::solve::state::History;

/// A history read as that of friction.
#[derive(Clone, Copy, Debug)]
pub struct FrictionHistory<'a>(pub &'a History);

/// Share of the friction that is all of it.
const ALL: f64 = 1.0 - 1e-9;

impl FrictionHistory<'_> {
    /// S of each place (nm), with what it remembers.
    pub fn iter(&self) -> impl Iterator<Item = (f64, FrictionState)> + '_ {
        self.0.iter().map(|(s, [place, mobilisation, limit])| (s, FrictionState { place, mobilisation, limit }))
    }

    /// ∫ τ dS, the friction that the contact bears per width, nN/nm.
    pub fn capacity(&self) -> f64 {
        self.0.spacing * self.0.rows.iter().map(|row| row[2]).sum::<f64>()
    }

    /// ∫ t dS, what of it is carried, likewise; its sign is that of the way gone.
    pub fn carried(&self) -> f64 {
        self.0.spacing * self.0.rows.iter().map(|row| row[1] * row[2]).sum::<f64>()
    }

    /// Whether all that is in contact slides one way, or the friction that it bears is below `little`, nN/nm.
    pub fn slides(&self, little: f64) -> bool {
        let capacity = self.capacity();
        capacity < little || self.carried().abs() > ALL * capacity
    }
}
