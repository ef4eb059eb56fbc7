//! Peaks and limit points of uniform strips against tables computed without finite elements.
//!
//! Reference: verification/strip.csv and verification/strip_variants.csv, Gauss and Chebyshev collocation of the strong form,
//! good to the digits printed (verification/README.md).
//!
//!     P |  peak
//!       | /\            lp1 (snap-off)
//!       |/  \____________)
//!       |            ___/
//!       |  lp2 (____/
//!       +-------------------- u
//!
//! Parameters: a row of the tables each: length, height, width, E, ν, A_H, r0, shear correction, EI factor, load, grip.
//!
//! Expected: every filled value to the relative accuracy asked for, at 1e-6 (the default) and at 1e-9, plus half of the last
//! digit printed; every error bound no smaller than the true error, as far as the printed digits show it; no path that stops
//! short. Rows that are known not to be met are in [`EXCEPTIONS`], each with what is reached. Why: this is what the program is for.

use peelkit::solve::LimitPointKind;
use peelkit::study::{Accuracy, Effort, PathEnd, Peel, StopCriteria, peel};
use peelkit_checks::suite::reference::{Row, read};
use rayon::prelude::*;
use std::str::FromStr;

/// A value that is not met to the accuracy asked for, and what is allowed in its place.
struct Exception {
    /// Accuracy asked for.
    asked: f64,
    /// What distinguishes the row from others: length, EI factor, load, far face.
    row: (f64, f64, &'static str, bool),
    column: &'static str,
    /// Relative error allowed; infinite where the value may be missing.
    allowed: f64,
    /// True error allowed, in units of the error bound.
    bounds: f64,
}

/// Known extremes. None of them may get worse. What is reached stands behind each; it depends on the last bit of the input,
/// hence the factor of about 2. Where the accuracy is missed the program's own bound says so.
#[rustfmt::skip]
const EXCEPTIONS: &[Exception] = &[
    // nearly singular, the free end turns over at the snap-off: round-off, which grows with the elements, makes 1.1e-11 nN on
    // 24, and where it is larger the path goes past the snap-off to the upright position
    Exception { asked: 1e-6, row: (100.0, 1e-4, "axis-gap", true), column: "lp1_displacement_nm", allowed: f64::INFINITY, bounds: 2.0 },
    Exception { asked: 1e-6, row: (100.0, 1e-4, "axis-gap", true), column: "lp1_force_nN", allowed: f64::INFINITY, bounds: 2.0 },
    Exception { asked: 1e-9, row: (100.0, 1e-4, "axis-gap", true), column: "lp1_displacement_nm", allowed: f64::INFINITY, bounds: 1.0 },
    Exception { asked: 1e-9, row: (100.0, 1e-4, "axis-gap", true), column: "lp1_force_nN", allowed: f64::INFINITY, bounds: 1.0 },
    // 2.1e-8
    Exception { asked: 1e-9, row: (100.0, 1e-3, "force-only", true), column: "lp1_force_nN", allowed: 4e-8, bounds: 1.0 },
    // 1.4e-9
    Exception { asked: 1e-9, row: (100.0, 1e-3, "axis-gap", true), column: "lp2_force_nN", allowed: 3e-9, bounds: 1.0 },
    // 1.3e-9
    Exception { asked: 1e-9, row: (200.0, 0.1, "full", false), column: "lp1_displacement_nm", allowed: 3e-9, bounds: 1.0 },
    // 6e-9 to 2.8e-8, held sideways: round-off, of a force of 0.0025 nN where the path's largest is 0.5 nN
    Exception { asked: 1e-9, row: (100.0, 100.0, "full", true), column: "lp2_force_nN", allowed: 6e-8, bounds: 1.0 },
    // up to 2e-9, round-off: it scatters with the last bit of the length, the more the stiffer the strip
    Exception { asked: 1e-9, row: (100.0, 1e4, "full", true), column: "peak_displacement_nm", allowed: 4e-9, bounds: 1.0 },
    Exception { asked: 1e-9, row: (100.0, 1e4, "full", true), column: "peak_end_rotation_rad", allowed: 4e-9, bounds: 1.0 },
    // 6.7e-9, of a force of 1.4e-5 nN
    Exception { asked: 1e-9, row: (3000.0, 1.0, "full", true), column: "lp2_force_nN", allowed: 1.3e-8, bounds: 1.0 },
];

fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for file in ["strip.csv", "strip_variants.csv"] {
        let path = format!("{}/../../verification/{file}", env!("CARGO_MANIFEST_DIR"));
        rows.extend(read(&std::fs::read_to_string(&path).expect(&path)));
    }
    assert!(rows.len() >= 60, "the tables have shrunk to {} rows", rows.len());
    rows
}

/// A computed value with its error bound, if it has one.
type Computed = Option<(f64, Option<f64>)>;

/// What the columns of the tables are called here.
fn computed(peel: &Peel) -> Vec<(&'static str, Computed)> {
    let peak = peel.initiation_peak;
    let mut turns = peel.limit_points.iter().filter(|l| l.kind == LimitPointKind::Displacement);
    let (lp1, lp2) = (turns.next(), turns.next());
    vec![
        ("peak_displacement_nm", peak.map(|p| (p.displacement, Some(p.displacement_error)))),
        ("peak_force_nN", peak.map(|p| (p.force, Some(p.force_error)))),
        ("peak_end_rotation_rad", peak.map(|p| (p.end_rotation, None))),
        ("lp1_displacement_nm", lp1.map(|l| (l.displacement, Some(l.displacement_error)))),
        ("lp1_force_nN", lp1.map(|l| (l.force, Some(l.force_error)))),
        ("lp2_displacement_nm", lp2.map(|l| (l.displacement, Some(l.displacement_error)))),
        ("lp2_force_nN", lp2.map(|l| (l.force, Some(l.force_error)))),
    ]
}

/// Half of the last digit printed.
fn rounding(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    let exponent = i32::from_str(exponent).expect("an exponent is a whole number");
    0.5 * 10f64.powi(exponent - i32::try_from(decimals).expect("few digits"))
}

/// What came of one row.
struct Compared {
    wrong: Vec<String>,
    values: usize,
    /// Whether no exception stands for it.
    plain: bool,
    effort: Effort,
}

/// Peels the strip of a row and compares.
fn compare(row: &Row, relative: f64) -> Compared {
    let model = row.strip().unwrap_or_else(|| panic!("not understood: {row:?}"));
    let peel = peel(&model, &Accuracy::to(relative), &StopCriteria::after_points(5000));
    let key = (
        model.strip.length,
        model.strip.material.bending_stiffness_factor,
        row.text("line_load").unwrap_or("full"),
        model.adhesion.far_face,
    );
    let mut wrong = Vec::new();
    let mut compared = 0;
    if let PathEnd::Failed(reason) = &peel.end {
        wrong.push(format!("the path stopped short: {reason}"));
    }
    for (column, value) in computed(&peel) {
        let Some(text) = row.text(column) else { continue };
        compared += 1;
        let wanted = row.number(column).unwrap_or_else(|| panic!("{column} is no number: {text}"));
        let exception = EXCEPTIONS.iter().find(|e| e.asked == relative && e.row == key && e.column == column);
        let (allowed, bounds) = exception.map_or((relative, 1.0), |e| (e.allowed, e.bounds));
        let Some((value, bound)) = value else {
            if allowed.is_finite() {
                wrong.push(format!("{column} is missing, expected {wanted}"));
            }
            continue;
        };
        let (error, rounding) = ((value - wanted).abs(), rounding(text));
        let share = error / wanted.abs();
        if error > allowed * wanted.abs() + rounding {
            wrong.push(format!("{column} = {value}, expected {wanted}: relative error {share:.2e}"));
        }
        if let Some(bound) = bound
            && allowed.is_finite()
            && error > bounds * bound + 4.0 * rounding
        {
            wrong.push(format!("{column} = {value} ± {bound:.1e}, expected {wanted}: true error {error:.1e}"));
        }
    }
    let head = format!(
        "L {} f {} {} far {} {:?} h {} E {} A_H {} r0 {}, {:?}, {:?}",
        key.0,
        key.1,
        key.2,
        key.3,
        model.grip,
        model.strip.height,
        model.strip.material.youngs_modulus,
        model.adhesion.hamaker_constant,
        model.adhesion.equilibrium_distance,
        peel.end,
        peel.effort
    );
    Compared {
        wrong: wrong.into_iter().map(|w| format!("{w}\n    in {head}")).collect(),
        values: compared,
        plain: !EXCEPTIONS.iter().any(|e| e.row == key),
        effort: peel.effort,
    }
}

/// `most` is the largest effort allowed, points and Newton iterations of all rows without exceptions.
fn assert_tables_are_met(relative: f64, most: (usize, usize)) {
    let found: Vec<_> = rows().par_iter().map(|row| compare(row, relative)).collect();
    let values: usize = found.iter().map(|f| f.values).sum();
    assert!(values >= 400, "only {values} values compared");
    let wrong: Vec<&str> = found.iter().flat_map(|f| &f.wrong).map(String::as_str).collect();
    assert!(wrong.is_empty(), "at relative = {relative:e}:\n{}", wrong.join("\n"));
    let plain = found.iter().filter(|f| f.plain).map(|f| f.effort);
    let effort = plain.fold((0, 0), |sum, e| (sum.0 + e.points, sum.1 + e.newton_iterations));
    assert!(effort.0 <= most.0 && effort.1 <= most.1, "effort {effort:?}, at most {most:?}");
}

#[test]
fn tables_are_met_at_the_default_accuracy() {
    // 7525 and 63 415 when written
    assert_tables_are_met(1e-6, (9400, 79_000));
}

#[test]
fn tables_are_met_at_1e_9() {
    // 7557 and 102 316 when written
    assert_tables_are_met(1e-9, (12_600, 95_000));
}
