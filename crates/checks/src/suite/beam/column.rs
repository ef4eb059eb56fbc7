//! Columns under compression: their buckling loads, and the elastica beyond the first.

use super::rods::{FORCE, LEFT_ROTATION, TOLERANCE, cantilever, problem, tip, under_control};
use crate::check::{Check, Measure};
use crate::suite::reference;
use peelkit::analytic::{buckling_load, propped_buckling_load};
use peelkit::beam::{ReferenceCurve, Section};
use peelkit::model::{Drive, Hold, RodModel, Support};
use peelkit::solve::{Solution, controlled};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Constrained normal to the axis, free along it.
const SLIDING_HINGE: Support = Support { x: Hold::Free, y: Hold::Fixed, rotation: Hold::Free };
const SLIDING_CLAMP: Support = Support { x: Hold::Free, y: Hold::Fixed, rotation: Hold::Fixed };

pub(super) fn checks() -> Vec<Check> {
    let mut checks = buckling(1e4, 1e4, 2e-10);
    checks.extend(buckling(400.0, 150.0, 1e-11));
    checks.extend(elastica());
    checks
}

/// `tolerance`: round-off in the tangent is about 1e-14 EA L²/EI.
fn buckling(axial: f64, shear: f64, tolerance: f64) -> Vec<Check> {
    let section = Section { axial, shear, bending: 1.0 };
    let sine = |wave_number| buckling_load(&section, wave_number);
    let cases = [
        ("clamped and free", Support::CLAMPED, Support::FREE, 1, sine(FRAC_PI_2)),
        ("two hinges", Support::HINGED, SLIDING_HINGE, 1, sine(PI)),
        ("two hinges", Support::HINGED, SLIDING_HINGE, 2, sine(TAU)),
        ("clamped and hinged", Support::CLAMPED, SLIDING_HINGE, 1, propped_buckling_load(&section, 1.0)),
        ("two clamps", Support::CLAMPED, SLIDING_CLAMP, 1, sine(TAU)),
    ];
    cases
        .into_iter()
        .map(|(ends, left, right, mode, expected)| {
            let column = RodModel { left, right, ..cantilever(axial, shear, Drive::X) };
            Check::new(
                format!("buckling load {mode}, EI/L², column with {ends}, EA = {axial:e}, GA_s = {shear:e} EI/L²"),
                "P (1 - P/EA + P/GA_s) = EI k² and its kind (Euler; with stretch and shear: analytic::buckling_load)",
                critical_load(&column, mode),
                expected,
                Measure::Relative,
                tolerance,
            )
        })
        .collect()
}

/// The load under which the straight column gets its negative eigenvalue number `mode`, by bisection of that count.
fn critical_load(column: &RodModel, mode: usize) -> Result<f64, String> {
    let problem = problem(column, 7)?;
    let buckled = |load: f64| {
        let found = controlled(&problem, problem.initial(4), FORCE, &[-load], TOLERANCE);
        found.map(|s| s[0].negative_load >= mode).map_err(|error| error.to_string())
    };
    let (mut low, mut high) = (0.0, 1.0);
    while !buckled(high)? {
        (low, high) = (high, 1.5 * high);
        if high > 1e3 {
            return Err("no buckling load below 1000 EI/L²".into());
        }
    }
    for _ in 0..45 {
        let middle = 0.5 * (low + high);
        if buckled(middle)? { high = middle } else { low = middle }
    }
    Ok(0.5 * (low + high))
}

/// EA L²/EI and GA_s L²/EI of a column that hardly stretches or shears: strains of 3e-9 at the largest load, which is what
/// it differs from the elastica by.
const STIFF: f64 = 1e10;
const ELEMENTS: usize = 8;

/// A label, the column of the table, and how to read it off a solution.
type Observed = (&'static str, &'static str, fn(&Solution) -> f64);

/// The inextensible column on two hinges beyond its Euler load.
fn elastica() -> Vec<Check> {
    let rows = reference::read(include_str!("../../../verification/elastica_column.csv"));
    let degrees: Vec<f64> = rows.iter().filter_map(|row| row.number("end_rotation_degrees")).collect();
    let found = buckled_columns(&degrees);
    let observed: [Observed; 3] = [
        ("load, EI/L²", "load", |s| -s.at.force),
        ("shortening, L", "shortening", |s| 1.0 - tip(s)[0]),
        ("deflection at the middle, L", "deflection", |s| s.at.values[3 * (ELEMENTS / 2 * 7) + 1].abs()),
    ];
    let mut checks = Vec::new();
    for (k, row) in rows.iter().enumerate() {
        for (label, column, value) in observed {
            let (measure, tolerance) =
                if column == "shortening" { (Measure::Absolute, 5e-9) } else { (Measure::Relative, 1e-10) };
            checks.push(Check::new(
                format!("{label}, elastica on two hinges, end rotation {} degrees", degrees[k]),
                "verification/elastica.py: elliptic integrals",
                found.as_ref().map(|s| value(&s[k])).map_err(String::clone),
                row.number(column).unwrap_or(f64::NAN),
                measure,
                tolerance,
            ));
        }
    }
    checks
}

/// The buckled column at rotations of its left end. The branch is reached along a slightly arched column (by a
/// thousandth of a radian), which has no straight state to branch off, and then followed without the arch, downwards to the smallest rotation and up.
fn buckled_columns(degrees: &[f64]) -> Result<Vec<Solution>, String> {
    let straight = RodModel { left: Support::HINGED, right: SLIDING_HINGE, ..cantilever(STIFF, STIFF, Drive::X) };
    let arched = RodModel { rest: ReferenceCurve::arc(5e-4, -1e-3), ..straight };
    let far = 1.0;
    let start = under_control(&arched, 7, ELEMENTS, LEFT_ROTATION, &[far])?.remove(0).at;
    let column = problem(&straight, 7)?;
    let rotations: Vec<f64> = degrees.iter().map(|d| d.to_radians()).collect();
    let (above, mut below): (Vec<f64>, Vec<f64>) = rotations.into_iter().partition(|&r| r > far);
    below.reverse();
    let follow = |targets: &[f64]| {
        controlled(&column, start.clone(), LEFT_ROTATION, targets, TOLERANCE).map_err(|error| error.to_string())
    };
    let mut found = follow(&below)?;
    found.reverse();
    found.extend(follow(&above)?);
    Ok(found)
}
