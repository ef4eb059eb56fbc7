//! The polynomial through values and slopes.

use crate::number::root::Bracket;

/// How sharp a turning point is, over the way on which it is looked for: sixty halvings.
const SHARP: f64 = 1.3e-18;

/// Polynomial through values and slopes, in Newton's form.
#[derive(Clone, Debug)]
pub struct Hermite {
    nodes: Vec<f64>,
    coefficients: Vec<f64>,
}

impl Hermite {
    /// From (place, value, slope); places are distinct.
    pub fn new(data: &[(f64, f64, f64)]) -> Self {
        let twice = |pick: fn(&(f64, f64, f64)) -> f64| {
            let mut all = Vec::with_capacity(2 * data.len());
            data.iter().for_each(|d| all.extend([pick(d); 2]));
            all
        };
        let (nodes, mut table) = (twice(|d| d.0), twice(|d| d.1));
        let mut coefficients = Vec::with_capacity(nodes.len());
        coefficients.push(table[0]);
        for order in 1..nodes.len() {
            for i in 0..nodes.len() - order {
                table[i] = if order == 1 && i % 2 == 0 {
                    data[i / 2].2
                } else {
                    (table[i + 1] - table[i]) / (nodes[i + order] - nodes[i])
                };
            }
            coefficients.push(table[0]);
        }
        Self { nodes, coefficients }
    }

    /// Value, first and second derivative.
    pub fn at(&self, t: f64) -> (f64, f64, f64) {
        let (mut value, mut first, mut second) = (0.0, 0.0, 0.0);
        for (c, node) in self.coefficients.iter().zip(&self.nodes).rev() {
            second = second * (t - node) + 2.0 * first;
            first = first * (t - node) + value;
            value = value * (t - node) + c;
        }
        (value, first, second)
    }

    /// A zero of the first derivative between two places at which it differs in sign.
    pub(crate) fn turning_point(&self, from: f64, to: f64) -> f64 {
        let rising = self.at(from).1 < self.at(to).1;
        let is_before = |place: f64| (self.at(place).1 < 0.0) == rising;
        let narrow = SHARP * (to - from);
        Bracket { low: from, high: to }.bisected(is_before, |left| left.width() <= narrow).middle()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn hermite_is_exact_for_degree_seven() {
        let f = |t: f64| (t.powi(7) - 3.0 * t * t + 1.0, 7.0 * t.powi(6) - 6.0 * t, 42.0 * t.powi(5) - 6.0);
        let data: Vec<_> = [-1.0, 0.2, 0.9, 2.0].iter().map(|&t| (t, f(t).0, f(t).1)).collect();
        let (value, first, second) = Hermite::new(&data).at(0.5);
        assert_relative_eq!(value, f(0.5).0, epsilon = 1e-12);
        assert_relative_eq!(first, f(0.5).1, epsilon = 1e-12);
        assert_relative_eq!(second, f(0.5).2, epsilon = 1e-11);
        assert_relative_eq!(Hermite::new(&data).turning_point(0.5, 1.5), (6f64 / 7.0).powf(0.2), max_relative = 1e-12);
    }
}
