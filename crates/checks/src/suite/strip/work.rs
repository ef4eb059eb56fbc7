//! The work of peeling against the energy that it must pay for.

use super::case::{Case, DEFAULT};
use crate::suite::check::{Check, Measure};
use peelkit::adhesion::LineLoad;

pub(super) fn checks(cases: &[Case]) -> Vec<Check> {
    cases.iter().flat_map(one).collect()
}

fn one(case: &Case) -> Vec<Check> {
    let mut checks = Vec::new();
    let work = case.peel.snap_off.map(|point| point.work);
    if case.row.number("work_aJ").is_some() {
        checks.extend(case.against("work of the grip up to the snap-off, aJ", "work_aJ", work, DEFAULT.relative));
    }
    if case.load() == LineLoad::ForceOnly {
        let number = |column| case.row.number(column).unwrap_or(f64::NAN);
        checks.push(Check::new(
            format!("work of the grip up to the snap-off over the energy it must pay for, {}", case.name()),
            "verification/strip_points.py: ∫ P du and stored + adhesion energy, both by collocation; 1 where energy is conserved",
            work.map(|work| work / number("energy_aJ")).ok_or_else(|| "no snap-off".to_owned()),
            number("work_aJ") / number("energy_aJ"),
            Measure::Relative,
            DEFAULT.relative,
        ));
    } else {
        let ratio = balance(case);
        checks.push(Check::new(
            format!("∫ P du over the change of stored and adhesion energy, rest to snap-off, {}", case.name()),
            "a load with a potential conserves energy",
            ratio,
            1.0,
            Measure::Relative,
            DEFAULT.relative,
        ));
    }
    checks
}

/// ∫ P du by quadrature, which knows nothing of energies, over the change of energy, both from rest to the last point of
/// the path before the snap-off, or to the end of a path without one.
fn balance(case: &Case) -> Result<f64, String> {
    let last = case.peel.snap_off.map_or(case.peel.points.len().saturating_sub(1), |point| point.after);
    let (paid, change) = case.peel.work_and_energy(last).ok_or("the path was not kept")?;
    Ok(paid / change)
}
