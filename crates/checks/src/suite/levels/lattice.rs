//! An endless lattice, summed atom by atom, against Poisson's sum over its planes.

use super::cells::{LAW, against, cell};
use crate::check::{Check, Measure};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::{LatticeHalfSpace, LennardJones, Level, TiltedBlock};
use peelkit::number::root::Bracket;

const POISSON: &str = "verification/pair_to_half_space.py: Poisson's sum over the planes (Steele 1973)";
const PIECE: &str = "verification/piece_of_atoms.py: Poisson's sum over the planes (Steele 1973)";

/// In spacings. A cutoff counts whole atoms and the continuum beyond it does not: this is where the digits end.
const CUTOFF: f64 = 40.0;

pub(super) fn checks() -> Vec<Check> {
    let mut checks = Vec::new();
    for row in read(include_str!("../../../verification/lattice_half_space.csv")) {
        if [0.64, 1.0, 2.0].contains(&cell(&row, "gap_over_spacing")) {
            checks.extend(endless(&row));
        }
    }
    for row in read(include_str!("../../../verification/lattice_contact.csv")) {
        if cell(&row, "spacing_over_r0") == 0.25 {
            checks.extend(contact(&row));
        }
    }
    for row in read(include_str!("../../../verification/piece_of_atoms.csv")) {
        if cell(&row, "spacing_nm") >= 0.2 && cell(&row, "tilt_deg") != 70.0 {
            checks.extend(piece(&row));
        }
    }
    checks
}

/// Lattices of spacing r0: force on an atom and force between two of them, parts of r^-12 and r^-6 put together.
fn endless(row: &Row) -> Vec<Check> {
    let r0 = LAW.equilibrium_distance;
    let gap = cell(row, "gap_over_spacing") * r0;
    let pair = LennardJones::behind(&LAW, r0.powi(-3), r0.powi(-3));
    let lattice = LatticeHalfSpace { pair, spacing: r0, cutoff: CUTOFF * r0 };
    let (q, scale) = (r0 / gap, LAW.potential_scale());
    let mut checks = Vec::new();
    for (registry, shift) in [("top", 0.0), ("hollow", 0.5 * r0)] {
        let parts = |what: &str| {
            let part = |kind: &str| cell(row, &format!("{what}_{registry}_{kind}"));
            (part("repulsion"), part("attraction"))
        };
        let (repulsion, attraction) = parts("atom");
        let expected = scale / (r0 * r0) * (repulsion * q.powi(10) / 5.0 - attraction * q.powi(4));
        let computed = lattice.force_on([shift, gap, shift])[1] / r0.powi(3);
        let name = format!("force on an atom, {registry}, gap {:.4} a, a = r0, nN/nm³", gap / r0);
        checks.push((name, computed, expected, 2e-7));
        let (repulsion, attraction) = parts("lattice");
        let expected = scale / r0 * (repulsion * q.powi(9) / 45.0 - attraction * q.powi(3) / 3.0);
        let computed = lattice.traction(gap, shift, shift);
        let name = format!("traction between lattices, {registry}, gap {:.4} a, a = r0, nN/nm²", gap / r0);
        checks.push((name, computed, expected, 5e-6));
    }
    checks
        .into_iter()
        .map(|(name, computed, expected, tolerance)| {
            Check::new(name, POISSON, Ok(computed), expected, Measure::Relative, tolerance)
        })
        .collect()
}

/// Two lattices a quarter of a spacing out of register, where their ripples vanish to first order and the mean is left: gap at
/// rest and largest traction.
fn contact(row: &Row) -> Vec<Check> {
    let r0 = LAW.equilibrium_distance;
    let spacing = cell(row, "spacing_over_r0") * r0;
    let pair = LennardJones::behind(&LAW, spacing.powi(-3), spacing.powi(-3));
    let lattice = LatticeHalfSpace { pair, spacing, cutoff: CUTOFF * spacing };
    let traction = |gap: f64| lattice.traction(gap, 0.25 * spacing, 0.25 * spacing);
    let gaps = Bracket { low: 0.5 * r0, high: 0.8 * r0 };
    let rest = gaps.bisected(|gap| traction(gap) > 0.0, |left| left.width() <= 3e-13 * r0).low;
    let (mut left, mut right) = (rest, 2.0 * r0);
    for _ in 0..40 {
        let (a, b) = (left + (right - left) / 3.0, right - (right - left) / 3.0);
        if traction(a) < traction(b) { right = b } else { left = a }
    }
    let ratio = traction(left) / LAW.traction(LAW.strongest_gap());
    let name = |what: &str| format!("two lattices of spacing r0/4, {what}");
    vec![
        against(name("gap at rest, r0"), POISSON, row, "rest_gap_over_r0", rest / r0, Measure::Relative, 5e-6),
        against(name("strength over the continuum's"), POISSON, row, "strength_ratio", ratio, Measure::Relative, 5e-6),
    ]
}

/// A tilted piece of strip of atoms, 10 nm × 10 nm.
fn piece(row: &Row) -> Vec<Check> {
    let (degrees, gap, spacing) = (cell(row, "tilt_deg"), cell(row, "corner_gap_nm"), cell(row, "spacing_nm"));
    let piece = TiltedBlock { half_space: LAW, length: 10.0, height: 10.0, tilt: degrees.to_radians(), gap };
    let at = piece.resultant(&Level::Atoms { spacing, cutoff: CUTOFF * spacing });
    let name = |what: &str| format!("piece of atoms {spacing} nm apart, {degrees}°, gap {gap} nm, {what}");
    vec![
        against(name("force, nN/nm"), PIECE, row, "force", at.force, Measure::Relative, 1e-5),
        against(name("moment, nN"), PIECE, row, "moment", at.moment, Measure::Relative, 1e-5),
    ]
}
