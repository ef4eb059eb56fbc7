//! A cantilever that is rolled up by an end moment, or has a dead end force across its axis: inextensible, stretching and shearing, curved at
//! rest, thick and thin.

use super::rods::{DISPLACEMENT, FORCE, cantilever, nodes, tip, under_control};
use crate::check::{Check, Measure};
use crate::suite::reference;
use crate::suite::reference::Row;
use peelkit::beam::ReferenceCurve;
use peelkit::model::{Drive, RodModel};
use peelkit::solve::Solution;
use std::f64::consts::{PI, TAU};

/// EA L²/EI and GA_s L²/EI of a rod that hardly stretches or shears: strains of 1e-9 at the largest load.
const STIFF: f64 = 1e10;

pub(super) fn checks() -> Vec<Check> {
    [rolled_up(), inextensible(), shooting(), small_load(), slender_and_thick()].concat()
}

/// Under P L²/EI up to 16 against elliptic integrals.
fn inextensible() -> Vec<Check> {
    let rows = reference::read(include_str!("../../../verification/elastica_cantilever.csv"));
    let loads: Vec<f64> = rows.iter().filter_map(|row| row.number("load")).collect();
    let found = under_control(&cantilever(STIFF, STIFF, Drive::Y), 7, 6, FORCE, &loads);
    let mut checks = Vec::new();
    for (k, row) in rows.iter().enumerate() {
        for (f, column) in COLUMNS.iter().enumerate() {
            let computed = found.as_ref().map(|s| tip(&s[k])[f]).map_err(String::clone);
            checks.push(Check::new(
                format!("{}, inextensible cantilever, P L²/EI = {}", LABELS[f], loads[k]),
                "verification/elastica.py: elliptic integrals",
                computed,
                row.number(column).unwrap_or(f64::NAN),
                Measure::Relative,
                // the rod stretches and shears by 1.6e-9
                5e-9,
            ));
        }
    }
    checks
}

const COLUMNS: [&str; 3] = ["tip_x", "tip_y", "tip_rotation"];
const LABELS: [&str; 3] = ["tip x, L", "tip y, L", "tip rotation, rad"];

/// The cantilever of a row of the table made by shooting.
fn cantilever_of(row: &Row) -> (RodModel, f64) {
    let number = |column| row.number(column).unwrap_or(f64::NAN);
    let rest = ReferenceCurve { start: [0.0; 3], curvature: ["k0", "k1", "k2"].map(number) };
    (RodModel { rest, ..cantilever(number("axial"), number("shear"), Drive::Y) }, number("load"))
}

/// The table made by shooting.
fn table() -> Vec<Row> {
    reference::read(include_str!("../../../verification/cantilever.csv"))
}

/// Rods that stretch, shear and are curved at rest.
fn shooting() -> Vec<Check> {
    let mut checks = Vec::new();
    for row in table().iter().filter(|row| row.text("case") != Some("slenderness")) {
        let (rod, load) = cantilever_of(row);
        let found = under_control(&rod, 7, 6, FORCE, &[load]);
        for f in 0..3 {
            let section = rod.section;
            checks.push(Check::new(
                format!(
                    "{}, cantilever ({}), EA = {:e}, GA_s = {} EI/L², P L²/EI = {load}",
                    LABELS[f],
                    row.text("case").unwrap_or("?"),
                    section.axial,
                    section.shear
                ),
                "verification/cantilever.py: shooting",
                found.as_ref().map(|s| tip(&s[0])[f]).map_err(String::clone),
                row.number(COLUMNS[f]).unwrap_or(f64::NAN),
                Measure::Relative,
                1e-11,
            ));
        }
    }
    checks
}

/// Timoshenko's cantilever: P L³/(3 EI) + P L/GA_s.
fn small_load() -> Vec<Check> {
    const LOAD: f64 = 1e-5;
    let deflection = |shear: f64| {
        under_control(&cantilever(1e4, shear, Drive::Y), 7, 2, FORCE, &[LOAD]).map(|found| tip(&found[0])[1])
    };
    [1e4, 10.0, 1.0]
        .map(|shear| {
            Check::new(
                format!("tip y, L, cantilever under P L²/EI = {LOAD:e}, GA_s = {shear} EI/L²"),
                "P L³/(3 EI) + P L/GA_s (Timoshenko)",
                deflection(shear),
                LOAD / 3.0 + LOAD / shear,
                Measure::Relative,
                1e-10,
            )
        })
        .to_vec()
}

// -- A cantilever rolled up by an end moment: θ' = M/EI, a circle, whatever EA and GA_s are --

const CIRCLE: &str = "closed form: x + iy = (exp(iθ) - 1)/(iκ), κ = θ(L)/L = M/EI";

fn rolled_up() -> Vec<Check> {
    let rod = cantilever(1e4, 4e3, Drive::Rotation);
    let rolled = under_control(&rod, 7, 12, DISPLACEMENT, &[0.5 * PI, PI, TAU, 2.0 * TAU]);
    let at =
        |k: usize, value: fn(&Solution) -> f64| rolled.as_ref().map(|found| value(&found[k])).map_err(String::clone);
    let two = 2.0 * TAU;
    let name = |what: &str, turn: &str| format!("{what}, cantilever rolled up to {turn}, EA L²/EI = 1e4");
    let relative = |name, computed, expected| Check::new(name, CIRCLE, computed, expected, Measure::Relative, 1e-12);
    let absolute = |name, computed| Check::new(name, CIRCLE, computed, 0.0, Measure::Absolute, 1e-12);
    vec![
        relative(name("end moment, EI/L", "a quarter circle"), at(0, |s| s.at.force), 0.5 * PI),
        relative(name("tip x, L", "a quarter circle"), at(0, |s| tip(s)[0]), 2.0 / PI),
        relative(name("tip y, L", "half a circle"), at(1, |s| tip(s)[1]), 2.0 / PI),
        relative(name("end moment, EI/L", "one circle"), at(2, |s| s.at.force), TAU),
        absolute(name("distance of the tip from the clamp, L", "one circle"), at(2, |s| tip(s)[0].hypot(tip(s)[1]))),
        relative(name("end moment, EI/L", "two circles"), at(3, |s| s.at.force), two),
        absolute(name("distance of the tip from the clamp, L", "two circles"), at(3, |s| tip(s)[0].hypot(tip(s)[1]))),
        absolute(
            name("largest distance of a node from its circle, L", "two circles"),
            rolled.as_ref().map_err(String::clone).and_then(|found| Ok(off_circle(&nodes(&rod, 7, &found[3])?))),
        ),
        relative(name("stored energy, EI/L", "two circles"), at(3, |s| s.energy), 0.5 * two * two),
    ]
}

/// The largest distance of a node from the circle of radius 1/(4π) around (0, 1/(4π)).
fn off_circle(nodes: &[(f64, f64)]) -> f64 {
    let radius = 0.5 / TAU;
    nodes.iter().map(|(x, y)| (x.hypot(y - radius) - radius).abs()).fold(0.0, f64::max)
}

// -- Thick and thin limits: the error of a mesh of few elements does not depend on the slenderness --

/// Order and number of elements of each mesh.
const MESHES: [(usize, usize); 3] = [(1, 8), (2, 4), (3, 2)];

/// A mesh that locks errs by a factor of about (L/h)² more. Where the beam is as high as long, shear adds to the tip's path
/// what every mesh gets right, so that the error is smaller;
/// at slenderness 10 that fraction is still a hundredth.
fn slender_and_thick() -> Vec<Check> {
    let rows = table();
    let rods: Vec<_> = rows.iter().filter(|row| row.text("case") == Some("slenderness")).collect();
    let mut checks = Vec::new();
    for (order, elements) in MESHES {
        let errors: Vec<Result<f64, String>> = rods
            .iter()
            .map(|row| {
                let (rod, load) = cantilever_of(row);
                let found = under_control(&rod, order, elements, FORCE, &[load])?;
                let expected = row.number("tip_y").ok_or("the table has no tip_y")?;
                Ok((tip(&found[0])[1] / expected - 1.0).abs())
            })
            .collect();
        let Some(Ok(usual)) = errors.get(2).cloned() else { continue };
        for (k, error) in errors.into_iter().enumerate() {
            checks.push(Check::new(
                format!(
                    "relative error of tip y, slenderness 1e{k}, {elements} elements of order {order}, P L²/EI = 1, over \
                     that at slenderness 100"
                ),
                "1: no locking (exact values: verification/cantilever.py, shooting)",
                error.map(|error| error / usual),
                1.0,
                if k == 0 { Measure::AtMost } else { Measure::Relative },
                if k < 2 { 0.02 } else { 1e-3 },
            ));
        }
    }
    checks
}
