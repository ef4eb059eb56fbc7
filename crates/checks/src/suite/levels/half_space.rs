//! Pair potential, volume integral and half space.

use super::cells::{LAW, against, cell, rule};
use crate::check::{Check, Measure};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::{Cuboid, LennardJones, body_force_by_volume, cubic_block, double_integral, pair_sum};

const QUADRATURE: &str = "verification/pair_to_half_space.py: eq. (1) integrated over a half space";
const RANGE: &str = "verification/pair_to_half_space.py: root of |b| = 0.1 % of 0.9524 A_H/(2π r0⁴), eq. (9)";
const CUBES: &str = "verification/pair_to_half_space.py";

pub(super) fn checks() -> Vec<Check> {
    let mut checks = hamaker();
    read(include_str!("../../../verification/half_space.csv")).iter().for_each(|row| checks.extend(half_space(row)));
    read(include_str!("../../../verification/body_force_range.csv")).iter().for_each(|row| checks.push(range(row)));
    read(include_str!("../../../verification/cubes.csv")).iter().for_each(|row| checks.extend(cubes(row)));
    checks
}

/// A_H = 2π²β1β2εr0⁶: the pair potential behind the half space integrates to eq. (9) and gives A_H back.
fn hamaker() -> Vec<Check> {
    let source = "2π² β1 β2 ε r0⁶ with ε = 0.1 aJ/(2π²), β = r0⁻³";
    let pair = LennardJones { well_depth: 0.1 / (2.0 * std::f64::consts::PI.powi(2)), equilibrium_distance: 0.4 };
    let density = 0.4f64.powi(-3);
    let computed = Ok(pair.hamaker_constant(density, density));
    vec![Check::new("Hamaker's constant, aJ", source, computed, 0.1, Measure::Relative, 1e-14)]
}

fn half_space(row: &Row) -> Vec<Check> {
    let r = cell(row, "distance_nm");
    let volumes = body_force_by_volume(&LennardJones::behind(&LAW, 1.0, 1.0), 1.0, r, &rule(6))[1];
    [
        ("body force by eq. (7), 6³ points", "nN/nm³", "body_force", volumes),
        ("body force, eq. (9)", "nN/nm³", "body_force", LAW.body_force(r)),
        ("traction, eq. (10)", "nN/nm²", "traction", LAW.traction(r)),
        ("potential W", "nN/nm", "potential", LAW.potential(r)),
    ]
    .map(|(what, unit, column, value)| {
        against(format!("{what}, r = {r} nm, {unit}"), QUADRATURE, row, column, value, Measure::Relative, 3e-12)
    })
    .into()
}

/// |b| at the distance of the table over its largest attraction, which is at (r0/r)⁶ = 2.
fn range(row: &Row) -> Check {
    let r0 = LAW.equilibrium_distance;
    let largest = LAW.body_force(r0 * 2f64.powf(-1.0 / 6.0));
    let fraction = LAW.body_force(cell(row, "distance_over_r0") * r0) / largest;
    let name = format!("body force over its largest attraction at {:.4} r0", cell(row, "distance_over_r0"));
    against(name, RANGE, row, "fraction", fraction, Measure::Relative, 1e-11)
}

/// Two cubes of 2 nm as lattices and as continua; 6 dimensions take many points, so that only the wider gaps are integrated.
fn cubes(row: &Row) -> Vec<Check> {
    let (gap, count) = (cell(row, "gap_nm"), cell(row, "atoms_along_an_edge"));
    if count > 10.0 {
        return Vec::new();
    }
    let spacing = 2.0 / count;
    let density = 0.4f64.powi(-3) * spacing.powi(3);
    // an atom stands for spacing³ of the density r0⁻³
    let pair = LennardJones::behind(&LAW, 0.4f64.powi(-3), 0.4f64.powi(-3));
    let cube = |y: f64| cubic_block([0.0, y, 0.0], [count as usize; 3], spacing);
    let (energy, force) = pair_sum(&pair, &cube(gap), &cube(-2.0));
    let scale = density * density;
    let name = |what: &str| format!("two cubes of {count}³ atoms, gap {gap} nm, {what}");
    let mut checks = vec![
        (name("energy, eq. (2), aJ"), "lattice_energy_aJ", energy * scale, 1e-11),
        (name("force, eq. (2), nN"), "lattice_force_nN", force[1] * scale, 1e-11),
    ];
    if gap >= 1.0 && count == 5.0 {
        let cube = |y: f64| Cuboid { corner: [0.0, y, 0.0], edges: [2.0; 3] };
        let densities = 0.4f64.powi(-6);
        let (energy, force) = double_integral(&pair, densities, &cube(gap), &cube(-2.0), &rule(8));
        let name = |what: &str| format!("two cubes by 8⁶ points, gap {gap} nm, {what}");
        checks.push((name("energy, eq. (3), aJ"), "continuum_energy_aJ", energy, 2e-6));
        checks.push((name("force, eqs. (6) and (7), nN"), "continuum_force_nN", force[1], 2e-6));
    }
    checks
        .into_iter()
        .map(|(name, column, value, tolerance)| against(name, CUBES, row, column, value, Measure::Relative, tolerance))
        .collect()
}
