//! The initiation peak over many decades of EI: the law EI^(1/4), how it saturates, and what it comes down to.

use super::case::{Case, DEFAULT};
use crate::check::{Check, Measure};
use crate::suite::reference;
use crate::suite::reference::{Row, published};
use peelkit::adhesion::LineLoad;
use peelkit::study::power_law;

const PEAKS: &str = include_str!("../../../verification/strip_peaks.csv");

/// EI/EI0 between which a shear-rigid strip of 1000 nm follows EI^(1/4): above, it feels its other end; below, the moment
/// of the adhesion.
const FOURTH_ROOT: (f64, f64) = (1e3, 1e6);

pub(super) fn checks() -> Vec<Check> {
    // what follows a peak is not looked at; without a moment's overshoot the first maximum is at the end of the plateau
    let until = |row: &Row| match row.text("line_load") {
        Some("axis-gap") => None,
        _ => row.number("peak_displacement_nm").map(|peak| 1.5 * peak),
    };
    let cases = Case::all(PEAKS, until);
    let mut checks: Vec<Check> = cases
        .iter()
        .filter_map(|case| {
            let shear = if is_rigid(case) { "rigid in shear, " } else { "" };
            let peak = case.peel.initiation_peak.map(|p| p.force);
            case.against(&format!("initiation peak, {shear}nN"), "peak_force_nN", peak, DEFAULT.relative)
        })
        .collect();
    checks.extend(stiff(&cases));
    checks.extend(soft(&cases));
    checks
}

fn is_rigid(case: &Case) -> bool {
    case.row.number("shear_correction") == Some(f64::INFINITY)
}

/// Force of the initiation peak, nN; NaN, which fails, where there is none.
fn force(case: &Case) -> f64 {
    case.peel.initiation_peak.map_or(f64::NAN, |p| p.force)
}

/// d ln P / d ln EI by least squares over (EI, P) with EI within the range.
fn exponent(peaks: &[(f64, f64)], (from, to): (f64, f64)) -> f64 {
    power_law(peaks.iter().filter(|p| p.0 > 0.99 * from && p.0 < 1.01 * to).copied()).1
}

/// (EI/EI0, peak) of the strips of 1000 nm, rigid in shear or not, by the crate and by the table.
fn long(cases: &[Case], rigid: bool) -> [Vec<(f64, f64)>; 2] {
    let chosen = || cases.iter().filter(|c| c.peel.model.length() == 1000.0 && is_rigid(c) == rigid);
    let table = |c: &Case| (c.factor(), c.row.number("peak_force_nN").unwrap_or(f64::NAN));
    [chosen().map(|c| (c.factor(), force(c))).collect(), chosen().map(table).collect()]
}

/// Strips of 1000 nm: rigid in shear and not.
fn stiff(cases: &[Case]) -> Vec<Check> {
    let ([rigid, rigid_table], [shear, shear_table]) = (long(cases, true), long(cases, false));
    let last = |peaks: &[(f64, f64)]| peaks.iter().max_by(|a, b| a.0.total_cmp(&b.0)).map_or(f64::NAN, |p| p.1);
    let range = format!("EI × {:e} to {:e}, L = 1000 nm", FOURTH_ROOT.0, FOURTH_ROOT.1);
    let rigid_body = reference::read(PEAKS);
    let rigid_body = rigid_body.iter().find(|row| row.number("bending_stiffness_factor") == Some(f64::INFINITY));
    vec![
        Check::new(
            format!("exponent of the peak in EI, rigid in shear, {range}"),
            "a beam on a foundation: P ~ EI^(1/4)",
            Ok(exponent(&rigid, FOURTH_ROOT)),
            0.25,
            Measure::Absolute,
            5e-4,
        ),
        Check::new(
            format!("exponent of the peak in EI, rigid in shear, {range}"),
            "verification/strip_peaks.py: collocation",
            Ok(exponent(&rigid, FOURTH_ROOT)),
            exponent(&rigid_table, FOURTH_ROOT),
            Measure::Absolute,
            1e-6,
        ),
        Check::new(
            format!("exponent of the peak in EI with shear, {range}: it saturates earlier"),
            "verification/strip_peaks.py: collocation",
            Ok(exponent(&shear, FOURTH_ROOT)),
            exponent(&shear_table, FOURTH_ROOT),
            Measure::Absolute,
            1e-6,
        ),
        Check::new(
            "initiation peak, rigid in shear, EI × 1e12, L = 1000 nm, nN",
            "a rigid body, verification/strip_peaks.py; the stretch P sin θ/EA = 3e-4 is left",
            Ok(last(&rigid)),
            rigid_body.and_then(|row| row.number("peak_force_nN")).unwrap_or(f64::NAN),
            Measure::Relative,
            2e-4,
        ),
        Check::new(
            "initiation peak, rigid in shear, EI × 1e12, over the largest attraction times length and width",
            "saturates below the cohesive strength, T(5^(-1/6) r0) b L",
            Ok(last(&rigid) / (1000.0 * published("largest_attraction_nN_per_nm2"))),
            1.0,
            Measure::AtMost,
            0.0,
        ),
        Check::new(
            "initiation peak, EI × 1e8, L = 1000 nm, nN: bound of finite shear",
            "first integral at the grip: P cos θ < (2 GA_s w)^(1/2), w = -bΨ(y_eq, 0)",
            Ok(last(&shear)),
            published("strip_shear_bound_nN_per_nm"),
            Measure::AtMost,
            0.0,
        ),
    ]
}

/// Strips of 50 nm towards EI = 0, in units of Kendall's force.
fn soft(cases: &[Case]) -> Vec<Check> {
    let kendall = published("strip_steady_force_nN_per_nm");
    let ratio = |load: LineLoad, factor: f64| {
        let case = cases.iter().find(|c| c.load() == load && c.factor() == factor);
        case.map(|c| force(c) / kendall).ok_or_else(|| "not in the table".to_owned())
    };
    let source = "Kendall's force at 90 degrees with the strip's work of adhesion, verification/published.py: mpmath";
    vec![
        Check::new(
            "initiation peak over Kendall's force, full, EI × 1e-6: never comes down to it",
            source,
            ratio(LineLoad::Full, 1e-6),
            2.4,
            Measure::AtLeast,
            0.0,
        ),
        Check::new(
            "first maximum over Kendall's force, axis-gap, EI × 1e-5: reaches it",
            source,
            ratio(LineLoad::AxisGap, 1e-5),
            1.0,
            Measure::Absolute,
            2e-5,
        ),
        Check::new(
            "initiation peak over Kendall's force, force-only, EI × 1e-6: falls below it",
            source,
            ratio(LineLoad::ForceOnly, 1e-6),
            1.0,
            Measure::AtMost,
            0.0,
        ),
    ]
}
