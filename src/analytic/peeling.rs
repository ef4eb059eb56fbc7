//! Forces of steady peeling, which need no beam.

use crate::beam::material::stretch_law::StretchLaw;
use crate::number::root::Bracket;

/// Kendall's peel force, nN: P²/(2 E h b²) + (P/b)(1 - cos φ) = w for a film without bending stiffness (Kendall 1975).
///
/// `work_of_adhesion` w in nN/nm, `modulus` E in GPa, `height` h and `width` b in nm, `angle` φ in rad from the substrate.
pub fn kendall_force(work_of_adhesion: f64, modulus: f64, height: f64, width: f64, angle: f64) -> f64 {
    let lift = 2.0 * (0.5 * angle).sin().powi(2);
    quadratic_root(1.0 / (2.0 * modulus * height), lift, work_of_adhesion) * width
}

/// The plateau force of a long strip peeled at 90 degrees, nN: P + P²/(2EA) = -bΨ(y_eq, 0), whatever its bending stiffness.
///
/// It follows from the first integral H x' + V y' + M θ' - stored - bΨ of a uniform beam, taken at the grip of a long
/// strip, where M = 0 and θ = 90 degrees, and at the free end at rest. `rest_adhesion` is bΨ(y_eq, 0) in nN (negative),
/// `axial_stiffness` EA in nN.
pub fn steady_force(rest_adhesion: f64, axial_stiffness: f64) -> f64 {
    quadratic_root(1.0 / (2.0 * axial_stiffness), 1.0, -rest_adhesion)
}

/// The force of a long strip that peels steadily under a pull at the angle α to a substrate without friction, nN:
/// P (1 - cos α) + P² sin² α/(2EA) = -bΨ(y_eq, 0).
///
/// It is Kendall's with P² sin² α in place of P²: what adheres is not stuck, it carries H = P cos α as well and is stretched by that before
/// it peels. From the first integral, which is P + P²/(2EA) where the strip hangs free and H + H²/(2EA) - bΨ(y_eq, 0) where it
/// adheres. `angle` α in rad, the others as in [`steady_force`], which it is at 90 degrees.
pub fn sliding_force(rest_adhesion: f64, axial_stiffness: f64, angle: f64) -> f64 {
    let (lift, across) = (2.0 * (0.5 * angle).sin().powi(2), angle.sin());
    quadratic_root(across * across / (2.0 * axial_stiffness), lift, -rest_adhesion)
}

/// Kendall's force of a film whose stretch is not linear, nN: P (λ - cos φ) - w(λ) = Γb, with P = N(λ).
///
/// A unit of length that comes off grows to λ, while the grip goes on by λ - cos φ, and w is stored in it. `energy` Γb and `axial` EA in nN, `angle` φ in
/// rad. Where `slides`, what adheres is stretched by P cos φ as well, as of [`sliding_force`]: P λ(P) - w(P) is then larger by Γb than the same of
/// P cos φ.
pub fn stretched_force(law: StretchLaw, energy: f64, axial: f64, angle: f64, slides: bool) -> f64 {
    let lift = 2.0 * (0.5 * angle).sin().powi(2);
    let stretching = |force: f64| law.complementary_energy(axial, force);
    let released = |force: f64| {
        let bonded = if slides { stretching(force * angle.cos()) } else { 0.0 };
        force * lift + stretching(force) - bonded
    };
    let mut most = quadratic_root(1.0 / (2.0 * axial), lift, energy);
    while released(most) < energy && most.is_finite() {
        most *= 2.0;
    }
    let bracket = Bracket { low: 0.0, high: most };
    bracket.bisected(|force| released(force) < energy, |left| left.width() <= 1e-15 * left.high).middle()
}

/// The force, nN, of a tape that adheres with the tension T0 in it: P²/2EA + P(1 - (1 + T0/EA) cos θ) + T0²/2EA = Γb.
///
/// `energy` Γb in nN, `axial` EA and `tension` T0 in nN, `angle` θ in rad. None where the tape peels by itself, T0 > √(2 EA Γb).
pub fn pretensioned_force(energy: f64, axial: f64, tension: f64, angle: f64) -> Option<f64> {
    let left = energy - tension * tension / (2.0 * axial);
    // the root of a x² + b x = left without cancellation, whatever the sign of b
    let b = 2.0 * (0.5 * angle).sin().powi(2) - tension / axial * angle.cos();
    let root = (b * b + 2.0 * left / axial).sqrt();
    (left > 0.0).then(|| if b > 0.0 { 2.0 * left / (b + root) } else { axial * (root - b) })
}

/// The tension at which a tape peels by itself, nN: √(2 EA Γb).
pub fn self_peeling_tension(energy: f64, axial: f64) -> f64 {
    (2.0 * axial * energy).sqrt()
}

/// The positive root of a x² + b x = c for a, c > 0 and b >= 0, without cancellation.
fn quadratic_root(a: f64, b: f64, c: f64) -> f64 {
    2.0 * c / (b + (b * b + 4.0 * a * c).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn kendall_satisfies_its_equation_from_along_the_surface_to_backwards() {
        let (w, e, h, b) = (0.0307, 2.0, 10.0, 3.0);
        for degrees in [0.0, 30.0, 45.0, 60.0, 90.0, 180.0f64] {
            let angle = degrees.to_radians();
            let p = kendall_force(w, e, h, b, angle);
            assert_relative_eq!(p * p / (2.0 * e * h * b * b) + p / b * (1.0 - angle.cos()), w, max_relative = 1e-13);
        }
        assert_relative_eq!(kendall_force(w, e, h, b, 0.0), b * (2.0 * e * h * w).sqrt(), max_relative = 1e-13);
        assert_relative_eq!(kendall_force(w, 1e12, h, b, PI), 0.5 * w * b, max_relative = 1e-9);
    }

    #[test]
    fn sliding_force_is_the_steady_one_at_90_degrees_and_kendalls_where_nothing_stretches() {
        assert_relative_eq!(sliding_force(-0.03, 20.0, FRAC_PI_2), steady_force(-0.03, 20.0), max_relative = 1e-14);
        for angle in [0.2, 1.0, 2.0, PI] {
            let stiff = kendall_force(0.03, 1e13, 1.0, 1.0, angle);
            assert_relative_eq!(sliding_force(-0.03, 1e13, angle), stiff, max_relative = 1e-9);
            let p = sliding_force(-0.03, 20.0, angle);
            let hanging = p + p * p / 40.0;
            let (h, w) = (p * angle.cos(), 0.03);
            assert_relative_eq!(hanging, h + h * h / 40.0 + w, max_relative = 1e-13);
        }
    }

    /// Where the law is linear they are those of the quadratic equations; of a neo-Hookean film they satisfy their own.
    #[test]
    fn stretched_forces_satisfy_their_equations() {
        let force = |law, angle, slides| stretched_force(law, 0.03, 0.2, angle, slides);
        for angle in [0.3, 0.8, FRAC_PI_2, 2.5f64] {
            let kendall = kendall_force(0.03, 0.2, 1.0, 1.0, angle);
            assert_relative_eq!(force(StretchLaw::Linear, angle, false), kendall, max_relative = 1e-13);
            assert_relative_eq!(
                force(StretchLaw::Linear, angle, true),
                sliding_force(-0.03, 0.2, angle),
                max_relative = 1e-13
            );
            for law in [StretchLaw::NeoHookean, StretchLaw::NeoHookeanWide] {
                let p = force(law, angle, false);
                let stretch = 1.0 + law.strain(p / 0.2);
                assert_relative_eq!(p * (stretch - angle.cos()) - law.energy(0.2, p), 0.03, max_relative = 1e-12);
                let q = force(law, angle, true);
                let along = |force: f64| force * (1.0 + law.strain(force / 0.2)) - law.energy(0.2, force);
                assert_relative_eq!(along(q) - along(q * angle.cos()), 0.03, max_relative = 1e-12);
            }
        }
    }

    #[test]
    fn steady_force_is_kendalls_at_90_degrees() {
        assert_relative_eq!(
            steady_force(-0.03, 20.0),
            kendall_force(0.03, 2.0, 10.0, 1.0, FRAC_PI_2),
            max_relative = 1e-14
        );
    }
}
