//! Where a path was lost on one mesh, beside where it was lost on another.

/// Relative difference of two places at which two meshes lose a path for one reason: in the random samples they lay within 1e-9 to 3e-4 of each other.
const SAME_PLACE: f64 = 1e-3;

/// The newest point of a path that cannot be continued.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lost {
    pub(super) displacement: f64,
    pub(super) force: f64,
}

impl Lost {
    /// Whether this is the same place, as far as two meshes can tell.
    pub(super) fn is_near(&self, other: &Self) -> bool {
        let near = |one: f64, other: f64| (one - other).abs() <= SAME_PLACE * one.abs();
        near(self.displacement, other.displacement) && near(self.force, other.force)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a plateau the force is the same everywhere, and on the way back the displacement is passed twice: both count.
    #[test]
    fn the_same_place_has_the_same_force_and_displacement() {
        let lost = Lost { displacement: 4.108591, force: 0.0343317 };
        assert!(lost.is_near(&Lost { displacement: 4.108925, force: 0.0343314 }));
        assert!(!lost.is_near(&Lost { displacement: 4.15, ..lost }));
        assert!(!lost.is_near(&Lost { force: 0.0344, ..lost }));
    }
}
