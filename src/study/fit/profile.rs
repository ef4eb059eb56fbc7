//! The least sum of squares with one parameter held: what a standard error says is right only where that is a parabola.

use super::residuals::{Evaluator, Trial, Weights};
use super::result::Profile;
use super::search::search;
use super::statistics::Covariance;
use std::sync::Arc;

/// Step over the half interval of the standard error.
const STEP: f64 = 0.5;
/// Longest step over the way between the bounds: a parameter that is hardly determined has a standard error beyond all bounds.
const LONGEST: f64 = 0.02;
/// Most steps to a side.
const MOST: usize = 24;
/// A step grows by this where the sum has hardly risen.
const GROWTH: f64 = 1.5;

/// What a profile begins from.
pub(super) struct Least<'a> {
    pub evaluator: &'a Evaluator<'a>,
    pub weights: &'a Weights,
    pub best: &'a Arc<Trial>,
    pub sum: f64,
    /// Along which the others go with the one that is held
    pub covariance: &'a Covariance,
    /// Excess of the sum that ends the interval: the square of the half interval in standard errors
    pub level: f64,
}

impl Least<'_> {
    /// Of the coordinate `index` whose half interval by its standard error is `half`.
    pub fn profile(&self, index: usize, half: f64) -> Profile {
        let (low, high) = rayon::join(|| self.side(index, -half), || self.side(index, half));
        let coordinate = &self.evaluator.coordinates[index];
        let at_least = (self.best.x[index], 0.0);
        let all = low.0.iter().rev().chain([&at_least]).chain(&high.0);
        let value = |x: f64| coordinate.value(x);
        Profile {
            points: all.map(|&(x, excess)| (value(x), excess)).collect(),
            interval: [low.1.map(value), high.1.map(value)],
            level: self.level,
        }
    }

    /// (x, excess) to one side, and where the excess reaches the level.
    fn side(&self, index: usize, half: f64) -> (Vec<(f64, f64)>, Option<f64>) {
        let (low, high) = self.evaluator.coordinates[index].bounds();
        let others: Vec<usize> = (0..self.evaluator.coordinates.len()).filter(|&other| other != index).collect();
        let mut points: Vec<(f64, f64)> = Vec::new();
        let longest = LONGEST * (high - low);
        let (mut before, mut step) = (self.best.clone(), (STEP * half).clamp(-longest, longest));
        for _ in 0..MOST {
            let from = before.x[index];
            let to = (from + step).clamp(low, high);
            if to == from {
                break;
            }
            let mut x = before.x.clone();
            for other in 0..x.len() {
                let (low, high) = self.evaluator.coordinates[other].bounds();
                x[other] = (x[other] + self.covariance.follows(other, index) * (to - from)).clamp(low, high);
            }
            x[index] = to;
            let Ok(start) = self.evaluator.trial(&x) else { break };
            let found = search(self.evaluator, self.weights, &Arc::new(start), &others);
            let last = points.last().copied().unwrap_or((self.best.x[index], 0.0));
            let excess = (found.sum - self.sum).max(0.0);
            points.push((to, excess));
            if excess >= self.level {
                return (points, Some(crossing(last, (to, excess), self.level)));
            }
            if excess - last.1 < 0.1 * self.level {
                step *= GROWTH;
            }
            before = found.best;
        }
        (points, None)
    }
}

/// Where the root of the excess, which is a straight line if the sum is a parabola, reaches that of the level.
fn crossing(from: (f64, f64), to: (f64, f64), level: f64) -> f64 {
    let root = |excess: f64| excess.max(0.0).sqrt();
    let share = (root(level) - root(from.1)) / (root(to.1) - root(from.1));
    from.0 + share * (to.0 - from.0)
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_parabola_is_crossed_where_it_is() {
        let x = super::crossing((1.0, 1.0), (3.0, 9.0), 4.0);
        assert!((x - 2.0).abs() < 1e-15);
    }
}
