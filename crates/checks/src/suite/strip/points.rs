//! Peak, plateau, limit points and their error bounds at six stiffnesses and three line loads.

use super::case::{Case, DEFAULT};
use crate::suite::check::{Check, Measure};
use peelkit::study::{LimitPoint, LimitPointKind};

pub(super) fn checks(cases: &[Case]) -> Vec<Check> {
    cases.iter().flat_map(one).collect()
}

/// The numbers of one strip.
fn one(case: &Case) -> Vec<Check> {
    let peel = &case.peel;
    let turn = |index| -> Option<&LimitPoint> {
        peel.limit_points.iter().filter(|p| p.kind == LimitPointKind::Displacement).nth(index)
    };
    let (peak, first, second) = (peel.initiation_peak, turn(0), turn(1));
    let values = [
        ("initiation peak, nm", "peak_displacement_nm", peak.map(|p| (p.displacement, p.displacement_error))),
        ("initiation peak, nN", "peak_force_nN", peak.map(|p| (p.force, p.force_error))),
        ("snap-off, nm", "lp1_displacement_nm", first.map(|p| (p.displacement, p.displacement_error))),
        ("snap-off, nN", "lp1_force_nN", first.map(|p| (p.force, p.force_error))),
        ("end of the snap-back, nm", "lp2_displacement_nm", second.map(|p| (p.displacement, p.displacement_error))),
        ("end of the snap-back, nN", "lp2_force_nN", second.map(|p| (p.force, p.force_error))),
    ];
    // what the table has no number for was not reached by its path
    let mut checks: Vec<Check> = values
        .iter()
        .filter(|(_, column, _)| case.row.number(column).is_some())
        .filter_map(|&(what, column, value)| case.against(what, column, value.map(|v| v.0), DEFAULT.relative))
        .collect();
    let ratios = values.iter().filter_map(|&(_, column, value)| {
        let (value, bound) = value?;
        Some((value - case.row.number(column)?).abs() / bound)
    });
    checks.push(Check::new(
        format!("largest error over its bound, {}", case.name()),
        "verification/strip_points.py: collocation; a bound is no smaller than the error",
        Ok(ratios.fold(0.0, f64::max)),
        1.0,
        Measure::AtMost,
        0.0,
    ));
    checks.extend(case.against("plateau, nN", "plateau_force_nN", peel.plateau.map(|p| p.force), DEFAULT.relative));
    checks
}
