//! Values printed in the paper, from their closed forms and by another road.

use super::reference::published;
use crate::check::{Check, Measure, Topic};
use peelkit::adhesion::HalfSpace;
use peelkit::analytic::kendall_force;
use peelkit::model::StripModel;

pub(super) const TOPIC: Topic = Topic { name: "published", about: "values that the paper prints", checks };

const HALF_SPACE: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

fn checks() -> Vec<Check> {
    let mut checks = work_of_adhesion();
    checks.push(bending_stiffness());
    checks.extend(kendall());
    checks
}

fn check(name: &str, source: &str, computed: f64, expected: f64, measure: Measure, tolerance: f64) -> Check {
    Check::new(name, source, Ok(computed), expected, measure, tolerance)
}

/// w_adh as printed, from its closed form, and as the work of the traction.
fn work_of_adhesion() -> Vec<Check> {
    let closed = HALF_SPACE.work_of_adhesion();
    let worked = work_of_traction();
    let table = |quantity: &str| published(&format!("work_of_adhesion_{quantity}_nN_per_nm"));
    let mpmath = "verification/published.py: mpmath";
    vec![
        check("w_adh, closed form, J/m²", "footnote 5: 0.0307 J/m²", closed, 0.0307, Measure::Absolute, 5e-5),
        check("w_adh, closed form, J/m²", mpmath, closed, table("closed_form"), Measure::Relative, 1e-12),
        check("w_adh, -∫ T dr from r_eq, J/m²", "footnote 5: 0.0307 J/m²", worked, 0.0307, Measure::Absolute, 5e-5),
        check(
            "w_adh, -∫ T dr from r_eq, J/m²",
            mpmath,
            worked,
            table("integral_of_traction"),
            Measure::Relative,
            1e-12,
        ),
        check(
            "largest attraction T(5^(-1/6) r0), nN/nm²",
            mpmath,
            -HALF_SPACE.traction(HALF_SPACE.strongest_gap()),
            published("largest_attraction_nN_per_nm2"),
            Measure::Relative,
            1e-12,
        ),
    ]
}

/// -∫ T dr from the equilibrium gap to infinity, nN/nm: over q = r0/r, where T dr = -T r0/q² dq is a polynomial of
/// degree 7 in q, by Boole's rule on 64 parts.
fn work_of_traction() -> f64 {
    const PARTS: usize = 64;
    let r0 = HALF_SPACE.equilibrium_distance;
    let end = r0 / HALF_SPACE.equilibrium_gap();
    // T falls like q³: nothing is lost at q = 0
    let integrand = |q: f64| if q == 0.0 { 0.0 } else { -HALF_SPACE.traction(r0 / q) * r0 / (q * q) };
    let step = end / PARTS as f64;
    let part = |i: usize| {
        let at = |quarters: f64| integrand((i as f64 + 0.25 * quarters) * step);
        step / 90.0 * (7.0 * (at(0.0) + at(4.0)) + 32.0 * (at(1.0) + at(3.0)) + 12.0 * at(2.0))
    };
    (0..PARTS).map(part).sum()
}

/// EI0 of Fig. 10, per unit width.
fn bending_stiffness() -> Check {
    let computed = StripModel::of_the_paper(100.0, 1.0).section().bending;
    let expected = published("bending_stiffness_EI0_nN_nm");
    check("EI0, nN·nm² at width 1 nm", "Fig. 10: E h³/12", computed, expected, Measure::Relative, 1e-12)
}

/// Kendall's force with extension at six angles, and for another width.
fn kendall() -> Vec<Check> {
    let w = HALF_SPACE.work_of_adhesion();
    let source = "root of P²/(2E h b²) + (P/b)(1 - cos φ) = w; verification/published.py: mpmath";
    let one = |degrees: u32, width: f64, quantity: String| {
        let force = kendall_force(w, 2.0, 10.0, width, f64::from(degrees).to_radians());
        let name = format!("Kendall's force at {degrees} degrees, width {width} nm, nN");
        check(&name, source, force, published(&quantity), Measure::Relative, 1e-12)
    };
    let mut checks: Vec<Check> =
        [0, 30, 45, 60, 90, 180].map(|d| one(d, 1.0, format!("kendall_{d}_degrees_nN_per_nm"))).into();
    checks.push(one(45, 3.0, "kendall_45_degrees_width_3_nN".into()));
    checks
}
