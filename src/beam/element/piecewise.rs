//! The adhesion of an element in which the pieces of a law join, integrated piece by piece.
//!
//! The traction of a cohesive law is smooth between its knots, the openings at which its corners begin and end, and no
//! Gauss rule of an
//! element sees a corner that is shorter than the distance of its points. So the element is cut where its opening δ/δ_r
//! passes a knot, and
//! each piece has a Gauss rule of its own. The stored energy keeps the rule of the element, which is why elements do
//! not lock.
//!
//! The cuts move with the state. The energy density is continuous with four derivatives there, so that what a cut that
//! moves adds on one side it takes
//! from the other: gradient and tangent are the sums over the pieces of those at fixed cuts, and a cut that is wrong by
//! ε makes an error of
//! order ε⁵.

use super::basis::PerNode;
use super::integration::{Element, Integration, PiecePoint, memory_of};
use crate::number::F64x4;
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{BUNDLE, MOST_NODES, Nodes, slot};

/// Most cuts of an element; what is behind them is one piece.
const MOST_CUTS: usize = 32;
/// Most looks for a cut, and how near to its knot, in ranges of the law, it has to be.
const MOST_LOOKS: usize = 30;
const NEAR: f64 = 1e-9;

/// The ends of the pieces in local coordinates, ascending.
struct Cuts {
    places: [f64; MOST_CUTS + 2],
    count: usize,
}

impl Cuts {
    fn new() -> Self {
        let mut places = [1.0; MOST_CUTS + 2];
        places[0] = -1.0;
        Self { places, count: 1 }
    }

    fn add(&mut self, place: f64) {
        if self.count <= MOST_CUTS {
            self.places[self.count] = place;
            self.count += 1;
        }
    }

    /// The ends of the pieces.
    fn ends(&mut self) -> &[f64] {
        self.places[1..self.count].sort_by(f64::total_cmp);
        self.places[self.count] = 1.0;
        &self.places[..=self.count]
    }
}

impl<const F: usize> Element<f64, F> {
    /// Hands out the points whose sum is what the pieces differ by from the element's own rule: none where no knot is
    /// passed.
    #[inline(never)]
    pub(crate) fn piecewise<N: Nodes>(&self, by: &Integration<N, F>, mut add: impl FnMut(&PiecePoint<F>)) {
        let &Integration { nodes, basis, density, history, .. } = by;
        let knots = by.knots();
        if knots.is_empty() {
            return;
        }
        let mut cuts = Cuts::new();
        (0..density.edges()).for_each(|edge| self.cut(by, knots, edge, &mut cuts));
        if cuts.count == 1 {
            return;
        }
        let mut at = |local: f64, share: f64, shape: &PerNode| {
            let place = self.from + 0.5 * (1.0 + local) * self.length;
            let response = density.adhesion_response(place, self.fields(nodes, shape), memory_of(history, place));
            add(&PiecePoint { response, shape: *shape, weight: 0.5 * self.length * share });
        };
        for q in 0..nodes.count() - 1 {
            at(basis.points[q], -basis.weights[q], &basis.value[q]);
        }
        for piece in cuts.ends().windows(2) {
            let (middle, half) = (0.5 * (piece[0] + piece[1]), 0.5 * (piece[1] - piece[0]));
            for &(point, weight) in &basis.fine {
                let local = middle + half * point;
                at(local, half * weight, &basis.sample_values(local));
            }
        }
    }

    /// Adds where the opening of an edge passes a knot, looked for between neighbouring nodes.
    fn cut(&self, by: &Integration<impl Nodes, F>, knots: &[f64], edge: usize, cuts: &mut Cuts) {
        let &Integration { nodes, basis, density, history, .. } = by;
        let count = nodes.count();
        let opening = |local: f64, fields: [f64; F]| {
            let place = self.from + 0.5 * (1.0 + local) * self.length;
            density.opening(place, fields, memory_of(history, place), edge)
        };
        let mut openings = [0.0; MOST_NODES];
        for rank in 0..count {
            let slot = slot(count, rank);
            openings[rank] = opening(basis.nodes[slot], self.values[slot]);
        }
        for rank in 1..count {
            let (from, to) = (openings[rank - 1], openings[rank]);
            for &knot in knots.iter().filter(|&&knot| (from < knot) != (to < knot)) {
                let place = |rank: usize| basis.nodes[slot(count, rank)];
                let beyond = |local: f64| opening(local, self.fields(nodes, &basis.sample_values(local))) - knot;
                cuts.add(crossing((place(rank - 1), from - knot), (place(rank), to - knot), beyond));
            }
        }
    }

    /// Fields at shape functions.
    #[inline(always)]
    fn fields(&self, nodes: impl Nodes, shape: &PerNode) -> [f64; F] {
        let mut sum = [0.0; F];
        for a in 0..nodes.count() {
            for f in 0..F {
                sum[f] += shape[a] * self.values[a][f];
            }
        }
        sum
    }
}

impl<const F: usize> Element<F64x4, F> {
    /// One of the four.
    pub(crate) fn lane(&self, l: usize) -> Element<f64, F> {
        Element {
            values: self.values.map(|node| node.map(|value| value.0[l])),
            from: self.from.0[l],
            length: self.length.0[l],
            memories: self.memories.map(|point| point.map(|value| value.0[l])),
            axial_multiplier: self.axial_multiplier,
        }
    }

    /// [`Element::energy`] with what the pieces of a law with knots differ by.
    #[inline(always)]
    pub(crate) fn energy_in_pieces(
        &self,
        by: &Integration<impl Nodes, F>,
        direction: &[[F64x4; F]; MOST_NODES],
    ) -> [F64x4; 3] {
        let mut sums = self.energy(by, direction);
        if !by.knots().is_empty() {
            for l in 0..BUNDLE {
                self.lane(l).piecewise(by, |PiecePoint { response: r, shape, weight }| {
                    let mut turned = 0.0;
                    for a in 0..by.nodes.count() {
                        for f in 0..F {
                            turned += r.coverage_by_value[f] * shape[a] * direction[a][f].0[l];
                        }
                    }
                    for (sum, part) in sums.iter_mut().zip([r.energy, r.coverage, turned]) {
                        sum.0[l] += weight * part;
                    }
                });
            }
        }
        sums
    }
}

/// Where a function passes zero between two places with values of different sign: the secant rule with both signs kept
/// (Illinois).
fn crossing((mut a, mut at_a): (f64, f64), (mut b, mut at_b): (f64, f64), function: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..MOST_LOOKS {
        let next = a - at_a * (b - a) / (at_b - at_a);
        let value = function(next);
        if value.abs() < NEAR {
            return next;
        }
        if (value < 0.0) == (at_b < 0.0) {
            // the other end stays: with half of its value it does not creep
            at_a *= 0.5;
        } else {
            (a, at_a) = (b, at_b);
        }
        (b, at_b) = (next, value);
    }
    b
}

impl<const F: usize> FrontalMatrix<F64x4, F> {
    /// Adds a point of a piece to element `l` of four, as [`Element::integrate`] adds its own.
    #[inline(always)]
    pub(crate) fn add_piece(
        &mut self,
        nodes: impl Nodes,
        l: usize,
        point: &PiecePoint<F>,
        path_weight: f64,
        symmetric: bool,
    ) {
        let PiecePoint { response: r, shape, weight } = point;
        for a in 0..nodes.count() {
            let share = shape[a] * weight;
            for f in 0..F {
                let row = &mut self.rows[a][f];
                row.residual.0[l] += r.by_value[f] * share;
                self.path.fields[a][f].0[l] += r.coverage_by_value[f] * share * path_weight;
                for b in if symmetric { a } else { 0 }..nodes.count() {
                    for g in 0..F {
                        row.fields[b][g].0[l] += r.value_value[f][g] * share * shape[b];
                    }
                }
            }
        }
    }
}
