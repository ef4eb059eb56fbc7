//! Error bounds compared with true errors on 200 randomly sampled scenes.
//!
//! The true values are those of a collocation of the strong form without finite elements, good to the digits printed, for
//! the initiation peak and the first two displacement limit points where they exist.

use crate::check::{Check, Measure, Topic};
use crate::suite::reference;
use peelkit::model::StripModel;
use peelkit::study::{Accuracy, LimitPointKind, PathEnd, Peel, StopCriteria, peel};
use rayon::prelude::*;

pub(in crate::suite) const TOPIC: Topic =
    Topic { name: "bounds", about: "error bounds against true errors on 200 randomly sampled scenes", checks };

const TABLE: &str = include_str!("../../../verification/bound_scenes.csv");
/// The scenes' accuracy: the default.
const RELATIVE: f64 = 1e-6;
const SOURCE: &str = "verification/bound_scenes.py: Chebyshev collocation of the strong form";

/// One reported number with its bound and its true error.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Number of the scene.
    pub scene: usize,
    /// Name of the column, such as `lp1_force_nN`.
    pub quantity: &'static str,
    /// Relative to the true value.
    pub bound: f64,
    /// Likewise; no smaller than what the table's digits allow.
    pub error: f64,
    /// Half a unit of the last digit of the table, likewise.
    pub unknown: f64,
}

impl Judged {
    /// Whether the bound is no smaller than the error, as far as the table can tell.
    pub fn holds(&self) -> bool {
        self.error <= self.bound + self.unknown
    }

    /// Bound over error.
    pub fn effectivity(&self) -> f64 {
        self.bound / self.error.max(self.unknown)
    }
}

/// What 200 peels gave.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    pub scenes: usize,
    pub judged: Vec<Judged>,
    /// Scenes that ended `failed`, with the reason.
    pub failed: Vec<(usize, String)>,
    /// Numbers of the table that the peel did not report.
    pub missing: Vec<(usize, &'static str)>,
}

impl Survey {
    /// The fraction of bounds that hold, of all numbers in the table.
    pub fn fraction_held(&self) -> f64 {
        let held = self.judged.iter().filter(|judged| judged.holds()).count();
        held as f64 / (self.judged.len() + self.missing.len()) as f64
    }

    /// The effectivities, ascending.
    pub fn effectivities(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.judged.iter().map(Judged::effectivity).collect();
        all.sort_by(f64::total_cmp);
        all
    }
}

/// Peels every scene of the table at the default accuracy, on all cores.
pub fn survey() -> Survey {
    let rows = reference::read(TABLE);
    let scenes: Vec<(&reference::Row, StripModel)> = rows.iter().filter_map(|row| Some((row, row.strip()?))).collect();
    let accuracy = Accuracy::to(RELATIVE);
    let bounds = StopCriteria::after_points(20_000);
    let peels: Vec<Peel> =
        scenes.par_iter().map(|(_, model)| peel(model, &accuracy, &bounds).without_solutions()).collect();
    let mut survey = Survey { scenes: scenes.len(), ..Survey::default() };
    for (scene, ((row, _), peel)) in (1..).zip(scenes.iter().zip(&peels)) {
        if let PathEnd::Failed(reason) = &peel.end {
            survey.failed.push((scene, reason.to_string()));
        }
        for (quantity, reported) in reported(peel) {
            let Some(text) = row.text(quantity) else { continue };
            let Ok(exact) = text.parse::<f64>() else { continue };
            match reported {
                None => survey.missing.push((scene, quantity)),
                Some((value, bound)) => survey.judged.push(Judged {
                    scene,
                    quantity,
                    bound: bound / exact.abs(),
                    error: (value - exact).abs() / exact.abs(),
                    unknown: 0.5 * last_digit(text) / exact.abs(),
                }),
            }
        }
    }
    survey
}

/// Value and bound of every number that a row may hold.
pub(in crate::suite) fn reported(peel: &Peel) -> [(&'static str, Option<(f64, f64)>); 6] {
    let peak = peel.initiation_peak.as_ref();
    let mut turns = peel.limit_points.iter().filter(|point| point.kind == LimitPointKind::Displacement);
    let (first, second) = (turns.next(), turns.next());
    [
        ("peak_displacement_nm", peak.map(|p| (p.displacement, p.displacement_error))),
        ("peak_force_nN", peak.map(|p| (p.force, p.force_error))),
        ("lp1_displacement_nm", first.map(|p| (p.displacement, p.displacement_error))),
        ("lp1_force_nN", first.map(|p| (p.force, p.force_error))),
        ("lp2_displacement_nm", second.map(|p| (p.displacement, p.displacement_error))),
        ("lp2_force_nN", second.map(|p| (p.force, p.force_error))),
    ]
}

/// One unit of the last digit of a number as it is printed.
pub(in crate::suite) fn last_digit(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    10f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals as i32)
}

fn checks() -> Vec<Check> {
    let survey = survey();
    let effectivities = survey.effectivities();
    let median = effectivities.get(effectivities.len() / 2).copied().ok_or("no number was judged".to_owned());
    let largest = survey.judged.iter().map(|judged| judged.error - judged.unknown).fold(0.0, f64::max);
    let of = format!("{} numbers of {} scenes", survey.judged.len() + survey.missing.len(), survey.scenes);
    let check = |name: String, computed, expected, measure| Check::new(name, SOURCE, computed, expected, measure, 0.0);
    let ended = 1.0 - survey.failed.len() as f64 / survey.scenes as f64;
    vec![
        check(format!("fraction of bounds that hold, {of}"), Ok(survey.fraction_held()), 0.99, Measure::AtLeast),
        check("median of bound over true error".into(), median, 20.0, Measure::AtMost),
        check("largest true error, relative".into(), Ok(largest), RELATIVE, Measure::AtMost),
        check("fraction of scenes that end without a failure".into(), Ok(ended), 0.99, Measure::AtLeast),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn last_digits() {
        approx::assert_relative_eq!(last_digit("0.00410"), 1e-5);
        approx::assert_relative_eq!(last_digit("1.25e-07"), 1e-9);
        approx::assert_relative_eq!(last_digit("12"), 1.0);
    }
}
