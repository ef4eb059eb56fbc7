//! The point of a curve y = f(x) that is nearest to (x, y), eq. (8).
//!
//! At a nearest point s the line to (x, y) is square to the curve,
//!
//!   q(s) = s - x + (f(s) - y) f'(s) = 0,   q'(s) = 1 + f'² + (f - y) f'' > 0.
//!
//! Where |y - f| |f''| < 1 everywhere there is one such point, found by Newton's method. Otherwise q is sampled over all places
//! that can hold a nearer point than the best one known: such a place is no farther along x than √(D² - (y - top)²), D being
//! the best distance. Each change of the sign of q from - to + is a candidate; a root at which q' < 0 is a farthest point
//! between two candidates, and both are taken.

use super::surface::ClosestPoint;
use crate::number::root::{Bracket, Look};

/// What is known of a curve as a whole.
pub(super) struct Graph {
    /// No place near (x, y) is higher, nm.
    pub ceiling: f64,
    /// Highest and lowest y where it is curved, nm
    pub top: f64,
    pub bottom: f64,
    /// Largest f'' without its sign, 1/nm
    pub bend: f64,
    /// Between places so far apart q changes its sign no more than three times, nm.
    pub step: f64,
}

/// Most samples: a point farther away than that many steps is not told apart from its neighbours any better.
const MOST_SAMPLES: f64 = 4000.0;
/// Parts into which a step is divided that holds a candidate.
const PARTS: usize = 8;

/// The nearest point of y = f(x) to (x, y). `curve` gives f and its first three derivatives; `guesses` are places not far
/// from it, which bound how far away the nearest can be.
pub(super) fn closest(
    curve: impl Fn(f64) -> [f64; 4],
    graph: &Graph,
    guesses: [f64; 2],
    (x, y): (f64, f64),
) -> ClosestPoint {
    let search = Search { curve, x, y };
    if !(x.is_finite() && y.is_finite()) {
        return search.project(f64::NAN, f64::INFINITY);
    }
    let mut best = f64::INFINITY;
    for guess in guesses {
        best = best.min(search.square(guess));
    }
    let above = (y - graph.ceiling).max(0.0);
    let reach = (best - above * above).max(0.0).sqrt();
    let (from, to) = (x - reach, x + reach);
    if (y - graph.bottom).max(graph.top - y) * graph.bend < 1.0 {
        return search.project(search.root(from, to), f64::INFINITY);
    }
    search.among(from, to, (2.0 * reach / graph.step).clamp(1.0, MOST_SAMPLES).ceil())
}

struct Search<C> {
    curve: C,
    x: f64,
    y: f64,
}

/// The nearest candidate and the next, as place and square of the distance.
struct Nearest {
    place: f64,
    best: f64,
    next: f64,
}

impl Nearest {
    fn take(&mut self, place: f64, square: f64) {
        if square < self.best {
            (self.next, self.best, self.place) = (self.best, square, place);
        } else if square < self.next && place != self.place {
            self.next = square;
        }
    }
}

impl<C: Fn(f64) -> [f64; 4]> Search<C> {
    /// Square of the distance, nm².
    fn square(&self, s: f64) -> f64 {
        let f = (self.curve)(s)[0];
        (s - self.x).powi(2) + (f - self.y).powi(2)
    }

    /// q and q'.
    fn q(&self, s: f64) -> (f64, f64) {
        let [f, slope, bend, _] = (self.curve)(s);
        (s - self.x + (f - self.y) * slope, 1.0 + slope * slope + (f - self.y) * bend)
    }

    /// The best of all candidates between two places.
    fn among(&self, from: f64, to: f64, samples: f64) -> ClosestPoint {
        let mut nearest = Nearest { place: self.x, best: f64::INFINITY, next: f64::INFINITY };
        let place = |k: f64| from + (to - from) * k / samples;
        // the outermost places hold no nearer point, but may be one
        let mut before = (place(0.0), self.q(place(0.0)));
        let mut k = 1.0;
        while k <= samples {
            let here = (place(k), self.q(place(k)));
            let ((q0, slope0), (q1, slope1)) = (before.1, here.1);
            // two more roots may lie where q comes near zero and goes back
            let dips = (q0 > 0.0 && q1 > 0.0 && slope0 < 0.0 && slope1 > 0.0)
                || (q0 <= 0.0 && q1 <= 0.0 && slope0 > 0.0 && slope1 < 0.0);
            if (q0 <= 0.0 && q1 > 0.0) || dips {
                self.candidates(before.0, here.0, &mut nearest);
            }
            before = here;
            k += 1.0;
        }
        if nearest.best == f64::INFINITY {
            // no change of sign but by rounding: an end is the place
            nearest.take(from, self.square(from));
            nearest.take(to, self.square(to));
            nearest.next = f64::INFINITY;
        }
        self.project(nearest.place, nearest.next.sqrt())
    }

    /// The candidates between two places at which q goes from - to +: where two of them part, above a centre of curvature,
    /// they are near each other.
    fn candidates(&self, from: f64, to: f64, nearest: &mut Nearest) {
        let place = |k: usize| if k == PARTS { to } else { from + (to - from) * k as f64 / PARTS as f64 };
        let mut before = self.q(from).0;
        for k in 1..=PARTS {
            let here = self.q(place(k)).0;
            if before <= 0.0 && here > 0.0 {
                self.candidate(place(k - 1), place(k), nearest);
            }
            before = here;
        }
    }

    fn candidate(&self, from: f64, to: f64, nearest: &mut Nearest) {
        let root = self.root(from, to);
        if self.q(root).1 >= 0.0 || to - from <= f64::EPSILON * (from.abs() + to.abs()) {
            return nearest.take(root, self.square(root));
        }
        // a farthest point: a nearest one on each side
        let aside = 1e-6 * (to - from);
        for (from, to) in [(from, root - aside), (root + aside, to)] {
            let side = self.root(from, to);
            nearest.take(side, self.square(side));
        }
    }

    /// A root of q, which is not positive at `low` and not negative at `high`, to round-off.
    #[inline]
    fn root(&self, low: f64, high: f64) -> f64 {
        let settles = |look: &Look| {
            let is_near = |to: f64| (to - look.at).abs() <= f64::EPSILON * (look.at.abs() + self.y.abs());
            match look {
                Look { value: 0.0, .. } => Some(look.at),
                look if look.slope > 0.0 && is_near(look.newton) => Some(look.newton),
                look => is_near(look.next).then_some(look.next),
            }
        };
        let root = Bracket { low, high }.newton(self.x.clamp(low, high), |s| self.q(s), settles);
        root.unwrap_or_else(|left| left.next)
    }

    /// What is to be known of the place s.
    fn project(&self, s: f64, second_distance: f64) -> ClosestPoint {
        let [f, slope, bend, third] = (self.curve)(s);
        let stretch = (1.0 + slope * slope).sqrt();
        let (sin, cos) = (slope / stretch, stretch.recip());
        let cube = cos * cos * cos;
        ClosestPoint {
            distance: (self.y - f) * cos - (self.x - s) * sin,
            place: s,
            sin,
            cos,
            curvature: bend * cube,
            // dκ/dσ = cos φ dκ/dx
            curvature_slope: cos * cube * (third - 3.0 * slope * bend * bend * cos * cos),
            second_distance,
        }
    }
}
