//! A cantilever with a dead end force across its axis: inextensible, stretching and shearing, curved at rest.

use super::rods::{FORCE, cantilever, tip, under_control};
use crate::suite::check::{Check, Measure};
use crate::suite::reference;
use crate::suite::reference::Row;
use peelkit::beam::ReferenceCurve;
use peelkit::model::{Drive, RodModel};

/// EA L²/EI and GA_s L²/EI of a rod that hardly stretches or shears: strains of 1e-9 at the largest load.
const STIFF: f64 = 1e10;

pub(super) fn checks() -> Vec<Check> {
    let mut checks = inextensible();
    checks.extend(shooting());
    checks.extend(small_load());
    checks
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
pub(super) fn cantilever_of(row: &Row) -> (RodModel, f64) {
    let number = |column| row.number(column).unwrap_or(f64::NAN);
    let rest = ReferenceCurve { start: [0.0; 3], curvature: ["k0", "k1", "k2"].map(number) };
    (RodModel { rest, ..cantilever(number("axial"), number("shear"), Drive::Y) }, number("load"))
}

/// The table made by shooting.
pub(super) fn table() -> Vec<Row> {
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
