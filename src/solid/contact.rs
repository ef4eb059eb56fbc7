//! How a half space below y = 0 acts on a solid: on its contact face, or on its whole volume.
//!
//! With B(y), T(y) and W(y) of the half space, eqs. (9), (10), each of which is minus the slope of the next, the equilibrium of a
//! solid has beside its stress
//!
//! - [`SolidContact::ReferenceTraction`]: -∫ N T(y) dS e_y over the reference length of the face, of the potential ∫ W(y) dS;
//! - [`SolidContact::CurrentTraction`]: -∫ N T(y) x,S dS e_y, eqs. (11), (12): without a potential, the tangent is not symmetric;
//! - [`SolidContact::BodyForce`]: -∫ N B(y) dV0 e_y over the reference volume, of the potential ∫ T(y) dV0.
//!
//! A traction acts on the upper face as well where that is asked for, turned round: there the half space pulls at what is not there.

use crate::adhesion::levels::half_space::HalfSpace;

/// The gap over which a change of it counts, beside itself, over r0.
pub(super) const GAP_SCALE: f64 = 0.05;
/// No point of the contact face nearer to the ground: detached, over r0.
pub(super) const DETACHED: f64 = 10.0;

/// What the half space acts on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolidContact {
    /// The traction of eq. (10) on the reference length of the contact face
    #[default]
    ReferenceTraction,
    /// The same on its current length along the substrate, eqs. (11) and (12)
    CurrentTraction,
    /// The body force of eq. (9) on the reference volume
    BodyForce,
}

impl SolidContact {
    /// Every one with its name in a scene.
    pub const NAMED: [(&'static str, Self); 3] = [
        ("reference-traction", Self::ReferenceTraction),
        ("current-traction", Self::CurrentTraction),
        ("body-force", Self::BodyForce),
    ];

    /// Whether it has a potential.
    pub fn has_potential(self) -> bool {
        self != Self::CurrentTraction
    }
}

/// Force and stiffness per length or volume at one point, with x,S of a face.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct ContactResponse {
    /// Potential, where there is one
    pub energy: f64,
    /// Upward, on the solid
    pub force: f64,
    /// Of that, by y
    pub by_height: f64,
    /// Of that, by x,S
    pub by_stretch: f64,
}

impl SolidContact {
    /// On a face (`sign` 1 on the lower one, -1 on the upper one) at the height y, with x,S there; not finite at or below the ground.
    #[inline]
    pub(crate) fn on_face(self, ground: &HalfSpace, y: f64, stretch: f64, sign: f64) -> ContactResponse {
        if y.is_nan() || y <= 0.0 {
            return ContactResponse { energy: f64::NAN, force: f64::NAN, by_height: f64::NAN, by_stretch: 0.0 };
        }
        let [potential, traction, density] = ground.levels(y).map(|level| sign * level);
        match self {
            Self::BodyForce => ContactResponse::default(),
            Self::ReferenceTraction => {
                ContactResponse { energy: potential, force: traction, by_height: -density, by_stretch: 0.0 }
            }
            Self::CurrentTraction => ContactResponse {
                energy: 0.0,
                force: traction * stretch,
                by_height: -density * stretch,
                by_stretch: traction,
            },
        }
    }

    /// In the volume at the height y; not finite at or below the ground.
    #[inline]
    pub(crate) fn in_volume(ground: &HalfSpace, y: f64) -> ContactResponse {
        if y.is_nan() || y <= 0.0 {
            return ContactResponse { energy: f64::NAN, force: f64::NAN, by_height: f64::NAN, by_stretch: 0.0 };
        }
        let (distance, scale) = (ground.equilibrium_distance, ground.potential_scale());
        let q = distance / y;
        let q5 = q * q * q * q * q;
        // B' = A/(2π r0⁵) (4 (r0/y)⁵ - 2 (r0/y)¹¹)
        let slope = scale / distance.powi(3) * q5 * (4.0 - 2.0 * q5 * q);
        ContactResponse { energy: ground.traction(y), force: ground.body_force(y), by_height: slope, by_stretch: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const GROUND: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    #[test]
    fn forces_are_slopes_of_potentials_and_stiffnesses_of_forces() {
        let step = 1e-6;
        for y in [0.22, 0.3, 0.5, 2.0] {
            for (contact, stretch) in [(SolidContact::ReferenceTraction, 1.0), (SolidContact::CurrentTraction, 0.8)] {
                let of = |y: f64, stretch: f64| contact.on_face(&GROUND, y, stretch, -1.0);
                let (here, before, after) = (of(y, stretch), of(y - step, stretch), of(y + step, stretch));
                assert_relative_eq!(here.by_height, (after.force - before.force) / (2.0 * step), max_relative = 1e-7);
                if contact.has_potential() {
                    assert_relative_eq!(
                        here.force,
                        (before.energy - after.energy) / (2.0 * step),
                        max_relative = 1e-7,
                        epsilon = 1e-9
                    );
                } else {
                    let difference = (of(y, stretch + step).force - of(y, stretch - step).force) / (2.0 * step);
                    assert_relative_eq!(here.by_stretch, difference, max_relative = 1e-7);
                }
            }
            let of = |y: f64| SolidContact::in_volume(&GROUND, y);
            let (here, before, after) = (of(y), of(y - step), of(y + step));
            assert_relative_eq!(here.force, (before.energy - after.energy) / (2.0 * step), max_relative = 1e-7);
            assert_relative_eq!(here.by_height, (after.force - before.force) / (2.0 * step), max_relative = 1e-7);
        }
        assert!(SolidContact::in_volume(&GROUND, 0.0).force.is_nan());
        assert!(SolidContact::ReferenceTraction.on_face(&GROUND, -0.1, 1.0, 1.0).force.is_nan());
    }
}
