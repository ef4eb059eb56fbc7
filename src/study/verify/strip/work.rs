//! The work of peeling against the energy that it must pay for.

use super::{Case, Check, DEFAULT, Measure, check};
use crate::adhesion::LineLoad;

pub(super) fn checks(cases: &[Case]) -> Vec<Check> {
    cases.iter().flat_map(one).collect()
}

fn one(case: &Case) -> Vec<Check> {
    let mut checks = Vec::new();
    let work = case.peel.snap_off.map(|point| point.work);
    checks.extend(case.against("work of the grip up to the snap-off, aJ", "work_aJ", work, DEFAULT.relative));
    let energy = case.row.number("energy_aJ").unwrap_or(f64::NAN);
    let integral = grip_work(case);
    if case.load() == LineLoad::ForceOnly {
        let share = case.row.number("work_aJ").unwrap_or(f64::NAN) / energy;
        checks.push(check(
            format!("work of the grip over the energy it must pay for, {}", case.name()),
            "verification/strip_points.py: ∫ P du and stored + adhesion energy, both by collocation; 1 where energy is conserved",
            integral.map(|integral| integral / energy),
            share,
            Measure::Relative,
            1e-5,
        ));
    } else {
        checks.push(check(
            format!("∫ P du of the curve up to the snap-off, aJ, {}", case.name()),
            "change of stored and adhesion energy, verification/strip_points.py: collocation",
            integral,
            energy,
            Measure::Relative,
            1e-5,
        ));
    }
    checks
}

/// Intervals of the curve a step of the path.
const INTERVALS: usize = 128;

/// ∫ P du of the curve from rest to the snap-off by trapezia, which knows nothing of energies, aJ.
fn grip_work(case: &Case) -> Result<f64, String> {
    let snap_off = case.peel.snap_off.ok_or("no snap-off")?;
    let curve = case.peel.dense_curve(INTERVALS);
    let end = curve.iter().position(|p| p.0 == snap_off.displacement).ok_or("no snap-off on the curve")?;
    Ok(curve[..=end].windows(2).map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0)).sum())
}
