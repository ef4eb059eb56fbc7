//! A cantilever rolled up by an end moment: θ' = M/EI, a circle, whatever EA and GA_s are.

use super::rods::{DISPLACEMENT, cantilever, tip, under_control};
use crate::suite::check::{Check, Measure};
use peelkit::model::Drive;
use peelkit::solve::Solution;
use std::f64::consts::{PI, TAU};

const SOURCE: &str = "closed form: x + iy = (exp(iθ) - 1)/(iκ), κ = θ(L)/L = M/EI";

pub(super) fn checks() -> Vec<Check> {
    let rod = cantilever(1e4, 4e3, Drive::Rotation);
    let rolled = under_control(&rod, 7, 12, DISPLACEMENT, &[0.5 * PI, PI, TAU, 2.0 * TAU]);
    let at =
        |k: usize, value: fn(&Solution) -> f64| rolled.as_ref().map(|found| value(&found[k])).map_err(String::clone);
    let two = 2.0 * TAU;
    let name = |what: &str, turn: &str| format!("{what}, cantilever rolled up to {turn}, EA L²/EI = 1e4");
    let relative = |name, computed, expected| Check::new(name, SOURCE, computed, expected, Measure::Relative, 1e-12);
    let absolute = |name, computed| Check::new(name, SOURCE, computed, 0.0, Measure::Absolute, 1e-12);
    vec![
        relative(name("end moment, EI/L", "a quarter circle"), at(0, |s| s.at.force), 0.5 * PI),
        relative(name("tip x, L", "a quarter circle"), at(0, |s| tip(s)[0]), 2.0 / PI),
        relative(name("tip y, L", "half a circle"), at(1, |s| tip(s)[1]), 2.0 / PI),
        relative(name("end moment, EI/L", "one circle"), at(2, |s| s.at.force), TAU),
        absolute(name("distance of the tip from the clamp, L", "one circle"), at(2, |s| tip(s)[0].hypot(tip(s)[1]))),
        relative(name("end moment, EI/L", "two circles"), at(3, |s| s.at.force), two),
        absolute(name("distance of the tip from the clamp, L", "two circles"), at(3, |s| tip(s)[0].hypot(tip(s)[1]))),
        absolute(name("largest distance of a node from its circle, L", "two circles"), at(3, off_circle)),
        relative(name("stored energy, EI/L", "two circles"), at(3, |s| s.energy), 0.5 * two * two),
    ]
}

/// The largest distance of a node from the circle of radius 1/(4π) around (0, 1/(4π)).
fn off_circle(solution: &Solution) -> f64 {
    let radius = 0.5 / TAU;
    solution.at.values.chunks_exact(3).map(|n| (n[0].hypot(n[1] - radius) - radius).abs()).fold(0.0, f64::max)
}
