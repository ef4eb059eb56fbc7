//! Where the elements end: a mesh that moves with the peeling front.
//!
//! Element ends lie at equal steps of  F(S) = Σ_i w_i asinh((S - c_i)/ℓ_i):  as fine as ℓ_i at each focus, geometric away
//! from it. One focus follows the front; others stay at an end that has a layer of its own.

/// Whether element ends follow the front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mesh {
    /// They do.
    #[default]
    Moving,
    /// They stay, small where the peel begins and ends.
    Graded,
    /// They stay, equally far apart.
    Uniform,
}

/// One place where elements are small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Focus {
    /// c, nm
    pub center: f64,
    /// ℓ, nm
    pub length: f64,
    /// w, relative to the others
    pub weight: f64,
}

impl Focus {
    /// Value and slope of its part of F.
    fn value(&self, s: f64) -> (f64, f64) {
        // asinh, to the absolute accuracy that a mesh needs, without the library's care for tiny arguments
        let x = (s - self.center) / self.length;
        let root = (x * x + 1.0).sqrt();
        (self.weight * (x.abs() + root).ln().copysign(x), self.weight / (self.length * root))
    }
}

/// F and its slope.
fn total(foci: &[Focus], s: f64) -> (f64, f64) {
    foci.iter().map(|focus| focus.value(s)).fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1))
}

/// Ends of `elements` elements on [0, length], graded towards `foci`, equally long without any; one more than there are
/// elements. `near` are the ends of a similar mesh, if there is one: where to start looking.
pub fn graded_ends(length: f64, foci: &[Focus], elements: usize, near: &[f64]) -> Vec<f64> {
    if foci.is_empty() {
        return (0..=elements).map(|k| length * k as f64 / elements as f64).collect();
    }
    let ((from, first_slope), (to, _)) = (total(foci, 0.0), total(foci, length));
    let mut ends = Vec::with_capacity(elements + 1);
    ends.push(0.0);
    let mut s = 0.0;
    for k in 1..elements {
        let target = from + (to - from) * k as f64 / elements as f64;
        let start = near.get(k).copied().filter(|_| near.len() == elements + 1);
        let start = start.unwrap_or(s + (to - from) / elements as f64 / first_slope);
        s = invert(foci, target, (s, length), start);
        ends.push(s);
    }
    ends.push(length);
    ends
}

/// Where a mesh may differ from its map, relative to how far apart its ends are.
const SLACK: f64 = 1e-11;

/// Root of F(s) = target in a bracket, by Newton kept inside the shrinking bracket.
fn invert(foci: &[Focus], target: f64, (mut low, mut high): (f64, f64), start: f64) -> f64 {
    let mut s = if start > low && start < high { start } else { 0.5 * (low + high) };
    for _ in 0..100 {
        let (value, slope) = total(foci, s);
        let miss = value - target;
        if miss < 0.0 {
            low = s
        } else {
            high = s
        }
        let newton = s - miss / slope;
        let inside = newton > low && newton < high;
        s = if inside { newton } else { 0.5 * (low + high) };
        // Newton's method leaves about the square of its step, in units of 1/F'
        if (inside && miss * miss <= SLACK) || high - low <= SLACK * high {
            return s;
        }
    }
    s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_ascend_and_crowd_at_the_focus() {
        for center in [0.0, 30.0, 100.0, 1e4] {
            let length = 1e4;
            let foci = [Focus { center, length: 1.0, weight: 1.0 }, Focus { center: 0.0, length: 1.0, weight: 0.8 }];
            let ends = graded_ends(length, &foci, 24, &[]);
            assert_eq!((ends.len(), ends[0], ends[24]), (25, 0.0, length));
            let smallest = ends.windows(2).map(|e| e[1] - e[0]).fold(f64::INFINITY, f64::min);
            assert!(smallest > 0.0 && smallest < 3.0, "{smallest}");
        }
    }
}
