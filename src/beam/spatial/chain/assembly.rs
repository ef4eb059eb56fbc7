//! The tangent of four elements in the fields of their nodes, from what the density answers at the Gauss points.
//!
//! With the shape functions N and their slopes N', and second derivatives vv, vs, ss of the density times the weight of a point,
//!
//!   K_fg = Σ vv_fg N_a N_b + vs_fg N_a N'_b + vs_gf N'_a N_b + ss_fg N'_a N'_b = S + Z,   K_gf = S - Z,
//!   S = Σ vv N_a N_b + ss N'_a N'_b + (vs_fg + vs_gf) ½(N_a N'_b + N'_a N_b),   Z = Σ (vs_fg - vs_gf) ½(N_a N'_b - N'_a N_b).
//!
//! Nodes and points lie mirror-symmetrically, so that of two pairs of nodes that are each other's image the sum and the difference need half
//! of the points each: with the products T and T* of a pair and of its image at a point, and v, v* of a point and of its image,
//!
//!   Σ vT + v*T* = ½ (v + v*)(T + T*) + ½ (v - v*)(T - T*),   and of the image  ½ (v + v*)(T + T*) - ½ (v - v*)(T - T*).
//!
//! Products of a value and a slope change their sign in the mirror.

use super::projection::FieldFront;
use crate::beam::element::basis::{Basis, MOST_ORDER};
use crate::beam::element::energy_density::Coupling;
use crate::beam::element::integration::{Element, Responses};
use crate::beam::spatial::section::kinematics::SPATIAL_FIELDS;
use crate::number::{F64x4, Real};
use crate::solve::frontal::nodes::{MOST_NODES, Nodes};

/// Most points of half an element, with the one in the middle.
const HALF: usize = MOST_ORDER.div_ceil(2);

/// Numbers of half of the points.
type PerPoint<T> = [T; HALF];

/// Two nodes and their mirror image, and what their products are at the points of the left half.
#[derive(Clone, Copy, Debug)]
struct Pair {
    /// a ≤ b in elimination order
    nodes: [usize; 2],
    /// Likewise
    image: [usize; 2],
    /// Of Z in the image: -1 where the images of a and b stand in the other order
    sign: f64,
    /// ½(T + T*) of the values, the slopes and both
    sums: [PerPoint<f64>; 3],
    /// ½(T - T*), likewise
    differences: [PerPoint<f64>; 3],
    /// Of Z: ½(T - T*), which goes with sums of what is integrated, and ½(T + T*), which goes with differences
    turned: [PerPoint<f64>; 2],
}

/// The products of the shape functions of an element.
#[derive(Clone, Debug)]
pub(in crate::beam::spatial) struct Products {
    /// Pairs with an image of their own
    pairs: Vec<Pair>,
    /// Those that are their own image
    alone: Vec<Pair>,
}

impl Products {
    /// Of the elements of a basis.
    pub(crate) fn new(basis: &Basis) -> Self {
        let nodes = basis.order + 1;
        let (mut pairs, mut alone) = (Vec::new(), Vec::new());
        for a in 0..nodes {
            for b in a..nodes {
                let (c, d) = (mirrored(nodes, a), mirrored(nodes, b));
                let image = [c.min(d), c.max(d)];
                let pair = Pair::new(basis, [a, b], [c, d]);
                if image == [a, b] {
                    alone.push(pair);
                } else if image > [a, b] {
                    pairs.push(pair);
                }
            }
        }
        Self { pairs, alone }
    }

    /// Writes the tangent of four elements into their front, on and above its diagonal of nodes.
    #[inline(always)]
    pub(crate) fn assemble(
        &self,
        nodes: impl Nodes,
        basis: &Basis,
        coupling: &Coupling<SPATIAL_FIELDS>,
        bundle: &Element<F64x4, SPATIAL_FIELDS>,
        room: &Responses<SPATIAL_FIELDS>,
        front: &mut FieldFront,
    ) {
        let zero = [[F64x4::splat(0.0); HALF]; 2];
        let (mut value, mut slope, mut mixed, mut turned) = (zero, zero, zero, zero);
        let (points, responses, stretch) = (nodes.count() - 1, room.responses(), bundle.stretch());
        for f in 0..SPATIAL_FIELDS {
            for g in f..SPATIAL_FIELDS {
                let by_values = coupling.value_value[f][g];
                let by_both = coupling.value_slope[f][g] || coupling.value_slope[g][f];
                for q in 0..points.div_ceil(2) {
                    let image = points - 1 - q;
                    let once = [bundle.weight(basis, q), bundle.weight(basis, image)];
                    let twice = [once[0] * stretch, once[1] * stretch];
                    let [near, far] = [&responses[q], &responses[image]];
                    let ss = [near.slope_slope[f][g] * twice[0], far.slope_slope[f][g] * twice[1]];
                    halves(&mut slope, q, image, [ss[0] * stretch, ss[1] * stretch]);
                    if by_values {
                        halves(
                            &mut value,
                            q,
                            image,
                            [near.value_value[f][g] * once[0], far.value_value[f][g] * once[1]],
                        );
                    }
                    if by_both {
                        let fg = [near.value_slope[f][g] * twice[0], far.value_slope[f][g] * twice[1]];
                        let gf = [near.value_slope[g][f] * twice[0], far.value_slope[g][f] * twice[1]];
                        halves(&mut mixed, q, image, [fg[0] + gf[0], fg[1] + gf[1]]);
                        halves(&mut turned, q, image, [fg[0] - gf[0], fg[1] - gf[1]]);
                    }
                }
                let of = Integrands { value, slope, mixed, turned };
                match (by_values, by_both, f == g) {
                    (false, false, _) => self.write::<false, false, false>(nodes, &of, (f, g), front),
                    (true, false, _) => self.write::<true, false, false>(nodes, &of, (f, g), front),
                    (false, true, _) => self.write::<false, true, true>(nodes, &of, (f, g), front),
                    (true, true, false) => self.write::<true, true, true>(nodes, &of, (f, g), front),
                    (true, true, true) => self.write::<true, true, false>(nodes, &of, (f, g), front),
                }
            }
        }
    }

    /// The blocks of two fields, with or without vv, vs, and Z.
    #[inline(always)]
    fn write<const VALUE: bool, const MIXED: bool, const TURNED: bool>(
        &self,
        nodes: impl Nodes,
        of: &Integrands,
        (f, g): (usize, usize),
        front: &mut FieldFront,
    ) {
        let (half, whole) = (nodes.count() / 2, (nodes.count() - 1) / 2);
        for pair in &self.pairs {
            let even = of.sum::<VALUE, MIXED>(&pair.sums, [0, 1], half, whole);
            let odd = of.sum::<VALUE, MIXED>(&pair.differences, [1, 0], whole, half);
            let ([own, image], mut turn) = ([even + odd, even - odd], [F64x4::splat(0.0); 2]);
            if TURNED {
                let (even, odd) =
                    (weighted(&of.turned[1], &pair.turned[1], whole), weighted(&of.turned[0], &pair.turned[0], half));
                turn = [even + odd, (even - odd) * pair.sign];
            }
            put::<TURNED>(front, pair.nodes, (f, g), own, turn[0]);
            put::<TURNED>(front, pair.image, (f, g), image, turn[1]);
        }
        for pair in &self.alone {
            let own = of.sum::<VALUE, MIXED>(&pair.sums, [0, 1], half, whole);
            let mut turn = F64x4::splat(0.0);
            if TURNED {
                turn = weighted(&of.turned[1], &pair.turned[1], whole) + weighted(&of.turned[0], &pair.turned[0], half);
            }
            put::<TURNED>(front, pair.nodes, (f, g), own, turn);
        }
    }
}

impl Pair {
    /// Of two nodes and their images one by one.
    fn new(basis: &Basis, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> Self {
        let zero = [0.0; HALF];
        let (mut sums, mut differences, mut turned) = ([zero; 3], [zero; 3], [zero; 2]);
        for q in 0..basis.order.div_ceil(2) {
            let (value, slope) = (&basis.value[q], &basis.slope[q]);
            let products = |a: usize, b: usize| {
                let (mixed, other) = (value[a] * slope[b], slope[a] * value[b]);
                [value[a] * value[b], slope[a] * slope[b], 0.5 * (mixed + other), 0.5 * (mixed - other)]
            };
            let (own, image) = (products(a, b), products(c, d));
            for k in 0..3 {
                sums[k][q] = 0.5 * (own[k] + image[k]);
                differences[k][q] = 0.5 * (own[k] - image[k]);
            }
            turned[0][q] = 0.5 * (own[3] - image[3]);
            turned[1][q] = 0.5 * (own[3] + image[3]);
        }
        let sign = if c > d { -1.0 } else { 1.0 };
        Self { nodes: [a, b], image: [c.min(d), c.max(d)], sign, sums, differences, turned }
    }
}

/// What is integrated: of each the sums over a point and its image, and the differences.
struct Integrands {
    value: [PerPoint<F64x4>; 2],
    slope: [PerPoint<F64x4>; 2],
    /// vs_fg + vs_gf
    mixed: [PerPoint<F64x4>; 2],
    /// vs_fg - vs_gf
    turned: [PerPoint<F64x4>; 2],
}

impl Integrands {
    /// Σ over half of the points, of what does not change its sign in the mirror as the first of `which` says, of what does as the second.
    #[inline(always)]
    fn sum<const VALUE: bool, const MIXED: bool>(
        &self,
        products: &[PerPoint<f64>; 3],
        which: [usize; 2],
        straight: usize,
        reversed: usize,
    ) -> F64x4 {
        let mut sum = weighted(&self.slope[which[0]], &products[1], straight);
        if VALUE {
            sum = sum + weighted(&self.value[which[0]], &products[0], straight);
        }
        if MIXED {
            sum = sum + weighted(&self.mixed[which[1]], &products[2], reversed);
        }
        sum
    }
}

#[inline(always)]
fn weighted(numbers: &PerPoint<F64x4>, products: &PerPoint<f64>, points: usize) -> F64x4 {
    let mut sum = numbers[0] * products[0];
    for q in 1..points {
        sum = sum + numbers[q] * products[q];
    }
    sum
}

/// Sum and difference of a number at a point and at its image; in the middle they are one.
#[inline(always)]
fn halves(out: &mut [PerPoint<F64x4>; 2], q: usize, image: usize, [near, far]: [F64x4; 2]) {
    if q == image {
        (out[0][q], out[1][q]) = (near, F64x4::splat(0.0));
    } else {
        (out[0][q], out[1][q]) = (near + far, near - far);
    }
}

/// Writes K_fg and K_gf of two nodes.
#[inline(always)]
fn put<const TURNED: bool>(
    front: &mut FieldFront,
    [a, b]: [usize; 2],
    (f, g): (usize, usize),
    sum: F64x4,
    turn: F64x4,
) {
    let rows = &mut front.rows[a];
    if TURNED {
        rows[f].fields[b][g] = sum + turn;
        rows[g].fields[b][f] = sum - turn;
    } else {
        rows[f].fields[b][g] = sum;
        rows[g].fields[b][f] = sum;
    }
}

/// The image of a node in elimination order: the interior ones from left to right, then the left end, then the right end.
fn mirrored(nodes: usize, node: usize) -> usize {
    debug_assert!(nodes <= MOST_NODES);
    if node < nodes - 2 { nodes - 3 - node } else { 2 * nodes - 3 - node }
}
