//! The deformed axis of a strip, sampled for pictures.

use super::Shape;
use crate::solve::{Equilibrium, Problem};

/// Samples an element gets.
const SAMPLES: usize = 6;

/// Axis and rotation along the beam; x from the section's x' by Simpson's rule between samples.
pub(super) fn shape(problem: &Problem, at: &Equilibrium) -> Shape {
    let mut shape = Shape::default();
    let mut x = 0.0;
    let sample = |e: usize, local: f64| {
        let (values, section) = problem.chain.sample(at.configuration(), e, local);
        (values[problem.driven] + 0.5 * problem.height, values[problem.rotation], section.horizontal_slope)
    };
    for e in 0..at.ends.len() - 1 {
        let step = (at.ends[e + 1] - at.ends[e]) / SAMPLES as f64;
        for k in 0..SAMPLES {
            let local = |t: f64| 2.0 * t / SAMPLES as f64 - 1.0;
            let (y, rotation, slope) = sample(e, local(k as f64));
            shape.push(x, y, rotation);
            let middle = sample(e, local(k as f64 + 0.5)).2;
            let next = sample(e, local(k as f64 + 1.0)).2;
            x += step * (slope + 4.0 * middle + next) / 6.0;
        }
    }
    let (y, rotation, _) = sample(at.ends.len() - 2, 1.0);
    shape.push(x, y, rotation);
    shape
}

impl Shape {
    fn push(&mut self, x: f64, y: f64, rotation: f64) {
        self.x.push(x);
        self.y.push(y);
        self.rotation.push(rotation);
    }
}
