//! Where the elements end: a mesh that moves with the peeling front.
//!
//! Element ends lie at equal steps of  F(S) = Σ_i w_i asinh((S - c_i)/ℓ_i):  as fine as ℓ_i at each focus, geometric away
//! from it. One focus follows the front; others stay at an end that has a layer of its own.

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
    fn value(&self, s: f64) -> f64 {
        // asinh, to the absolute accuracy that a mesh needs, without the library's care for tiny arguments
        let x = (s - self.center) / self.length;
        self.weight * (x.abs() + (x * x + 1.0).sqrt()).ln().copysign(x)
    }

    fn slope(&self, s: f64) -> f64 {
        let away = s - self.center;
        self.weight / (away * away + self.length * self.length).sqrt()
    }
}

/// Ends of `elements` elements on [0, length], graded towards `foci`, equally long without any; one more than there are
/// elements. `near` are the ends of a similar mesh, if there is one: where to start looking.
pub fn graded_ends(length: f64, foci: &[Focus], elements: usize, near: &[f64]) -> Vec<f64> {
    if foci.is_empty() {
        return (0..=elements).map(|k| length * k as f64 / elements as f64).collect();
    }
    let value = |s: f64| foci.iter().map(|f| f.value(s)).sum::<f64>();
    let slope = |s: f64| foci.iter().map(|f| f.slope(s)).sum::<f64>();
    let (from, to) = (value(0.0), value(length));
    let mut ends = Vec::with_capacity(elements + 1);
    ends.push(0.0);
    let mut s = 0.0;
    for k in 1..elements {
        let target = from + (to - from) * k as f64 / elements as f64;
        let start = near.get(k).copied().filter(|_| near.len() == elements + 1);
        s = invert(&value, &slope, target, (s, length), start);
        ends.push(s);
    }
    ends.push(length);
    ends
}

/// Root of value(s) = target in a bracket for an increasing function, by Newton kept inside the shrinking bracket.
fn invert(
    value: &impl Fn(f64) -> f64,
    slope: &impl Fn(f64) -> f64,
    target: f64,
    (mut low, mut high): (f64, f64),
    start: Option<f64>,
) -> f64 {
    let start = start.unwrap_or_else(|| low + (target - value(low)) / slope(low));
    let mut s = if start > low && start < high { start } else { 0.5 * (low + high) };
    for _ in 0..100 {
        let miss = value(s) - target;
        if miss < 0.0 {
            low = s
        } else {
            high = s
        }
        let newton = s - miss / slope(s);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - s).abs() <= 1e-9 * (high.abs() + f64::MIN_POSITIVE) {
            return next;
        }
        s = next;
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
