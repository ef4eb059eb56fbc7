//! Strips sampled over wide ranges, each peeled twice: what the coarser run claims must hold for the finer one. Loads `full` and
//! `force-only`; strips of `axis-gap`, which is independent of the rotation of the section, may go several ways at their end.

use crate::agreement::{Reported, disagree};
use crate::check::{Check, Measure};
use peelkit::adhesion::LineLoad;
use peelkit::model::{Hold, StripModel};
use peelkit::study::{Accuracy, PathEnd, Peel, StopCriteria, peel};
use rayon::prelude::*;

/// How many there are.
pub const STRIPS: usize = 500;
/// The accuracy that is judged, and the one it is judged by.
const RELATIVE: f64 = 1e-6;
const FINER: f64 = 1e-8;
/// Least and largest of length, height, EI factor, Hamaker constant (aJ), equilibrium distance; sampled evenly in logarithms.
const RANGES: [(f64, f64); 5] = [(5.0, 1e4), (1.0, 100.0), (1e-4, 1e3), (1e-2, 1.0), (0.2, 1.0)];

/// What became of the strips.
#[derive(Clone, Debug, Default)]
struct Drawn {
    /// Numbers that both runs report, and how many of the coarser ones lie further from the finer than both bounds together.
    judged: usize,
    wrong: Vec<String>,
    /// Strips whose path ended `failed`, with the reason.
    failed: Vec<String>,
    /// Strips of which only one run has a peak or a snap-off, although both came to their end.
    differ: Vec<String>,
}

/// Place `k` of a sequence that fills the unit cube of eight dimensions evenly: multiples of powers of 1/φ, φ⁹ = φ + 1.
fn place(k: usize) -> [f64; 8] {
    let phi = (0..64).fold(1.1f64, |phi, _| (1.0 + phi).powf(1.0 / 9.0));
    std::array::from_fn(|d| (0.5 + (k + 1) as f64 * phi.powi(-1 - d as i32)).fract())
}

/// Strip `k`.
fn strip(k: usize) -> StripModel {
    let at = place(k);
    let [length, height, factor, hamaker, distance] =
        std::array::from_fn(|d| RANGES[d].0 * (RANGES[d].1 / RANGES[d].0).powf(at[d]));
    let mut model = StripModel::of_the_paper(length, factor);
    model.strip.height = height;
    model.strip.material.poissons_ratio = 0.4999 * at[5];
    (model.adhesion.hamaker_constant, model.adhesion.equilibrium_distance) = (hamaker, distance);
    model.adhesion.line_load = if at[6] < 0.2 { LineLoad::ForceOnly } else { LineLoad::Full };
    let hold = |fixed: bool| if fixed { Hold::Fixed } else { Hold::Free };
    model.grip.rotation = hold(at[7] < 0.3);
    model.grip.horizontal = hold((0.2..0.4).contains(&at[7]));
    model
}

/// Peels these, on all cores.
fn drawn(strips: &[usize]) -> Drawn {
    let outcomes: Vec<Drawn> = strips.par_iter().map(|&k| judge(k)).collect();
    outcomes.into_iter().fold(Drawn::default(), |mut all, one| {
        all.judged += one.judged;
        all.wrong.extend(one.wrong);
        all.failed.extend(one.failed);
        all.differ.extend(one.differ);
        all
    })
}

fn judge(k: usize) -> Drawn {
    let model = strip(k);
    let [coarse, fine] =
        [RELATIVE, FINER].map(|to| peel(&model, &Accuracy::to(to), &StopCriteria::after_points(20_000)));
    let mut outcome = Drawn::default();
    let named = |what: &str| format!("{what}: {:?} {:?} {:?}", model.strip, model.adhesion, model.grip);
    if let PathEnd::Failed(reason) = &coarse.end {
        outcome.failed.push(named(&reason.to_string()));
    }
    for (quantity, pair) in Reported::by(&coarse).beside(&Reported::by(&fine)) {
        match pair {
            [Some(one), Some(two)] => {
                outcome.judged += 1;
                if disagree([one, two]) {
                    let ((value, bound), (finer, finer_bound)) = (one, two);
                    outcome
                        .wrong
                        .push(named(&format!("{quantity} = {value} +- {bound:e} and {finer} +- {finer_bound:e}")));
                }
            }
            [None, None] => {}
            _ if ended(&coarse) && ended(&fine) => outcome.differ.push(named(quantity)),
            _ => {}
        }
    }
    outcome
}

/// Whether a path came to an end of its own.
fn ended(peel: &Peel) -> bool {
    !matches!(peel.end, PathEnd::Bound(_) | PathEnd::Failed(_))
}

/// Fraction of numbers that may be outside of their bounds, as on the scenes of the topic `bounds`, and of points that one run alone
/// finds: strips about to lose their snap-back.
const STRAY: f64 = 0.01;

/// Fraction of paths that may end in a refusal; in a part of the strips as many as these may come together, where 4 of all 500 are refused.
const REFUSED: f64 = 0.02;
const TOGETHER: f64 = 3.0;

/// The checks of these strips: hardly a number is wrong, and few paths fail.
pub(super) fn checks(strips: &[usize]) -> Vec<Check> {
    let Drawn { judged, wrong, failed, differ } = drawn(strips);
    let check = |name: String, list: &[String], most: f64| {
        let name = list.first().map_or(name.clone(), |first| format!("{name}; the first: {first}"));
        let source = "the same at 1e-8";
        Check::new(name, source, Ok(list.len() as f64), most, Measure::AtMost, 0.0)
    };
    let of = format!("{} randomly sampled strips", strips.len());
    vec![
        check(
            format!("{of}: of {judged} numbers at 1e-6, how many are outside of their bounds"),
            &wrong,
            STRAY * judged as f64,
        ),
        check(format!("{of}: points that one of two accuracies finds"), &differ, STRAY * judged as f64),
        check(format!("{of}: paths that end in a refusal"), &failed, (REFUSED * strips.len() as f64).max(TOGETHER)),
    ]
}
