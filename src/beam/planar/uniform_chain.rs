//! Elimination along a chain of elements of one order and one density, front by front.
//!
//! Elements come in bundles of four side by side: an operation on one number is the same operation on four, whatever the
//! order. A bundle is integrated and its interior nodes are eliminated; then, element by element, the left node, which nobody
//! else needs any more. What is left on the right node and on the border passes into the next element. The last row of a
//! front carries the path functional and the last column the residual, so that both are reduced along with the rest. The
//! sign of a pivot is the sign of an eigenvalue (Sylvester), so the sweep counts the negative ones as it goes.

use super::chain::{EDGE, EndRow};
use super::{
    Basis, Chain, ChainFactors, Configuration, Density, Element, ElementEnergy, Front, MOST_FIELDS, NodeState, PathRow,
    ROOT, Root, SectionState, WeightedPoints,
};
use crate::adhesion::Slip;
use crate::number::Four;
use crate::solve::{History, Place, SolveError};
use std::ops::Range;

/// Elements that are treated side by side.
pub const BUNDLE: usize = 4;
/// Pivots below this are zero to rounding.
const LEAST_PIVOT: f64 = f64::MIN_POSITIVE * 1e20;

/// One front a bundle.
type Fronts<const F: usize, const N: usize> = Vec<Front<Four, F, N>>;

/// [`Chain`] for one density and one order: N = p + 1 nodes an element, F fields a node.
pub struct UniformChain<D, const F: usize, const N: usize> {
    density: D,
    basis: Basis<N>,
    /// Whether the tangent is symmetric.
    symmetric: bool,
    /// Where the fields of the left end are held, as far as they are.
    pinned_left: [Option<f64>; F],
}

impl<D: Density<F>, const F: usize, const N: usize> UniformChain<D, F, N> {
    const ORDER: usize = N - 1;
    /// Pivots of the interior nodes of an element.
    const PIVOTS: usize = (N - 2) * F;
    /// Slots of the left and of the right end.
    const LEFT: usize = N - 2;
    const RIGHT: usize = N - 1;
    /// Places in the block of an element's ends: of the border, and of residual and path behind all unknowns.
    const BORDER: usize = 2 * F;
    const KNOWN: usize = 2 * F + D::BORDER as usize;

    /// A chain whose left end is free but for the fields that `pinned_left` holds at a value.
    pub fn new(density: D, pinned_left: [Option<f64>; F]) -> Self {
        Self { symmetric: density.is_symmetric(), density, basis: Basis::new(), pinned_left }
    }

    /// Values of element `e` in elimination order.
    #[inline(always)]
    fn gather(&self, state: &[f64], e: usize) -> [[f64; F]; N] {
        let at = &state[e * Self::ORDER * F..][..N * F];
        let mut values = [[0.0; F]; N];
        for rank in 0..N {
            values[Basis::<N>::slot(rank)].copy_from_slice(&at[rank * F..(rank + 1) * F]);
        }
        values
    }

    /// One element.
    fn element(&self, at: Configuration, e: usize) -> Element<f64, F, N> {
        let (from, to) = (at.ends[e], at.ends[e + 1]);
        let mut slips = [[0.0; 2]; N];
        if let (true, Some(known)) = (D::REMEMBERS, at.history) {
            for (slip, point) in slips.iter_mut().zip(self.basis.points) {
                *slip = known.at(from + 0.5 * (1.0 + point) * (to - from));
            }
        }
        Element { values: self.gather(at.state, e), from, length: to - from, slips, border: at.border }
    }

    /// Elements `first` to `first + 3`; behind the last one it is repeated.
    #[inline(always)]
    fn bundle(&self, at: Configuration, first: usize) -> Element<Four, F, N> {
        let zero = Four([0.0; BUNDLE]);
        let mut bundle =
            Element { values: [[zero; F]; N], from: zero, length: zero, slips: [[zero; 2]; N], border: at.border };
        for l in 0..BUNDLE {
            let e = (first + l).min(at.ends.len() - 2);
            bundle.from.0[l] = at.ends[e];
            bundle.length.0[l] = at.ends[e + 1] - at.ends[e];
        }
        if let (true, Some(known)) = (D::REMEMBERS, at.history) {
            for (slips, point) in bundle.slips.iter_mut().zip(self.basis.points) {
                for l in 0..BUNDLE {
                    let [place, share] = known.at(bundle.from.0[l] + 0.5 * (1.0 + point) * bundle.length.0[l]);
                    (slips[0].0[l], slips[1].0[l]) = (place, share);
                }
            }
        }
        bundle.values = self.gather_bundle(at.state, first, at.ends.len() - 1);
        bundle
    }

    #[inline(always)]
    fn gather_bundle(&self, state: &[f64], first: usize, elements: usize) -> [[Four; F]; N] {
        let mut values = [[Four([0.0; BUNDLE]); F]; N];
        for l in 0..BUNDLE {
            let one = self.gather(state, (first + l).min(elements - 1));
            for a in 0..N {
                for f in 0..F {
                    values[a][f].0[l] = one[a][f];
                }
            }
        }
        values
    }

    #[inline(always)]
    fn sweep(
        &self,
        at: Configuration,
        path: &PathRow,
        damping: &[f64],
        work: &mut ChainFactors,
    ) -> Result<Root, SolveError> {
        // the fronts of the last time, if it was a chain of this kind
        let mut fronts: Box<Fronts<F, N>> =
            work.fronts.take().and_then(|last| last.downcast().ok()).unwrap_or_default();
        let root = self.sweep_into(at, path, damping, &mut fronts, &mut work.ends);
        work.fronts = Some(fronts);
        root
    }

    #[inline(always)]
    fn sweep_into(
        &self,
        at: Configuration,
        path: &PathRow,
        damping: &[f64],
        fronts: &mut Fronts<F, N>,
        ends: &mut Vec<EndRow>,
    ) -> Result<Root, SolveError> {
        let elements = at.ends.len() - 1;
        fronts.resize_with(elements.div_ceil(BUNDLE), Front::zero);
        ends.clear();
        let mut points = WeightedPoints::zero();
        let mut energy = ElementEnergy::default();
        let mut negative = 0;
        let mut carry = [[0.0; ROOT]; ROOT];
        for (first, front) in (0..elements).step_by(BUNDLE).zip(fronts) {
            let bundle = self.bundle(at, first);
            let (total, adhesion) =
                bundle.integrate(&self.density, &self.basis, self.symmetric, path.adhesion, &mut points, front);
            if !damping.is_empty() {
                self.damp_inside(front, damping, first, elements);
            }
            let pivots = if D::BORDER {
                front.condense::<true>(self.symmetric)
            } else {
                front.condense::<false>(self.symmetric)
            };
            for e in first..elements.min(first + BUNDLE) {
                let l = e - first;
                energy.total += total.0[l];
                energy.adhesion += adhesion.0[l];
                let mut block = self.block(front, l);
                if !damping.is_empty() {
                    (0..F).for_each(|f| block[f][f] += damping[e * Self::ORDER * F + f]);
                }
                if e == 0 {
                    self.start(&mut block, path, &at.state[..F]);
                } else {
                    Self::unload(&carry, &mut block);
                }
                let (negative_end, least) = Self::eliminate_end(&mut block);
                negative += pivots.negative.0[l] as usize + negative_end;
                let least = least.min(pivots.least.0[l]);
                if least < LEAST_PIVOT {
                    return Err(SolveError::Singular {
                        pivot: least,
                        place: Place { element: e, position: at.ends[e] },
                    });
                }
                ends.extend_from_slice(&block[..F]);
                carry = Self::load(&block);
                if !carry[0][0].is_finite() || !energy.total.is_finite() {
                    let place = Place { element: e, position: at.ends[e] };
                    return Err(SolveError::NotFinite { quantity: "the tangent", place });
                }
            }
        }
        if !damping.is_empty() {
            (0..F).for_each(|f| carry[f][f] += damping[elements * Self::ORDER * F + f]);
        }
        Ok(Root { matrix: carry, negative, energy })
    }

    /// Adds to the diagonal of the interior nodes of a bundle; the ends of its elements are left to the chain.
    fn damp_inside(&self, front: &mut Front<Four, F, N>, damping: &[f64], first: usize, elements: usize) {
        let damping = self.gather_bundle(damping, first, elements);
        for (slot, rows) in front.rows[..N - 2].iter_mut().enumerate() {
            for f in 0..F {
                rows[f].fields[slot][f] = rows[f].fields[slot][f] + damping[slot][f];
            }
        }
    }

    /// What condensation left of element `l` of a bundle: rows and columns of the left end, the right end and the border, then
    /// the residual and the path.
    #[inline(always)]
    fn block(&self, front: &Front<Four, F, N>, l: usize) -> [EndRow; EDGE] {
        let mut block = [[0.0; EDGE]; EDGE];
        let ends = [Self::LEFT, Self::RIGHT];
        for i in 0..2 * F {
            let row = &front.rows[ends[i / F]][i % F];
            for j in 0..2 * F {
                let below = self.symmetric && j < i;
                let (row, node, field) = if below {
                    (&front.rows[ends[j / F]][j % F], ends[i / F], i % F)
                } else {
                    (row, ends[j / F], j % F)
                };
                block[i][j] = row.fields[node][field].0[l];
            }
            if D::BORDER {
                block[i][Self::BORDER] = row.border.0[l];
                block[Self::BORDER][i] = front.border.fields[ends[i / F]][i % F].0[l];
            }
            block[i][Self::KNOWN] = row.residual.0[l];
            block[Self::KNOWN][i] = front.path.fields[ends[i / F]][i % F].0[l];
        }
        if D::BORDER {
            block[Self::BORDER][Self::BORDER] = front.border.border.0[l];
            block[Self::BORDER][Self::KNOWN] = front.border.residual.0[l];
            block[Self::KNOWN][Self::BORDER] = front.path.border.0[l];
        }
        block[Self::KNOWN][Self::KNOWN] = front.path.residual.0[l];
        block
    }

    /// The left end of the chain: its part of the path functional, and the fields that are held.
    #[inline(always)]
    fn start(&self, block: &mut [EndRow; EDGE], path: &PathRow, left_values: &[f64]) {
        for f in 0..F {
            block[Self::KNOWN][f] += path.left[f];
        }
        for f in 0..F {
            let Some(held) = self.pinned_left[f] else { continue };
            block[f] = [0.0; EDGE];
            block[f][f] = 1.0;
            block[f][Self::KNOWN] = left_values[f] - held;
        }
    }

    /// Eliminates the left end; each pivot is replaced by one over it. Returns how many pivots were negative, and the least
    /// without its sign.
    #[inline(always)]
    fn eliminate_end(block: &mut [EndRow; EDGE]) -> (usize, f64) {
        let (mut negative, mut least) = (0, f64::INFINITY);
        for k in 0..F {
            let row = block[k];
            negative += usize::from(row[k] < 0.0);
            least = least.min(row[k].abs());
            let inverse = 1.0 / row[k];
            for i in k + 1..=Self::KNOWN {
                let factor = block[i][k] * inverse;
                for j in k + 1..=Self::KNOWN {
                    block[i][j] -= factor * row[j];
                }
            }
            block[k][k] = inverse;
        }
        (negative, least)
    }

    /// What is left on the right end, the border and the path.
    #[inline(always)]
    fn load(block: &[EndRow; EDGE]) -> [[f64; ROOT]; ROOT] {
        let mut carry = [[0.0; ROOT]; ROOT];
        for i in 0..=Self::KNOWN - F {
            for j in 0..=Self::KNOWN - F {
                carry[i][j] = block[F + i][F + j];
            }
        }
        carry
    }

    /// Adds what the element before left to the left end.
    #[inline(always)]
    fn unload(carry: &[[f64; ROOT]; ROOT], block: &mut [EndRow; EDGE]) {
        let place = |i: usize| if i < F { i } else { F + i };
        for i in 0..=Self::KNOWN - F {
            for j in 0..=Self::KNOWN - F {
                block[place(i)][place(j)] += carry[i][j];
            }
        }
    }

    #[inline(always)]
    fn back(&self, work: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]) {
        let elements = work.ends.len() / F;
        let border = if D::BORDER { root[F] } else { 0.0 };
        // the ends of the elements from right to left
        let mut x = [0.0; EDGE];
        x[F..F + F].copy_from_slice(&root[..F]);
        x[Self::BORDER] = border;
        out[elements * Self::ORDER * F..].copy_from_slice(&root[..F]);
        for e in (0..elements).rev() {
            for k in (0..F).rev() {
                let row = &work.ends[e * F + k];
                let mut sum = scale * row[Self::KNOWN];
                for j in k + 1..Self::KNOWN {
                    sum -= row[j] * x[j];
                }
                x[k] = sum * row[k];
            }
            out[e * Self::ORDER * F..][..F].copy_from_slice(&x[..F]);
            for f in 0..F {
                x[F + f] = x[f];
            }
        }
        let fronts = work.fronts.as_ref().and_then(|fronts| fronts.downcast_ref::<Fronts<F, N>>());
        for (bundle, front) in fronts.expect("work comes from an elimination of this chain").iter().enumerate() {
            self.back_inside(front, bundle * BUNDLE, elements, border, scale, out);
        }
    }

    /// The interior nodes of a bundle, whose ends are known.
    #[inline(always)]
    fn back_inside(
        &self,
        front: &Front<Four, F, N>,
        first: usize,
        elements: usize,
        border: f64,
        scale: f64,
        out: &mut [f64],
    ) {
        let mut values = self.gather_bundle(out, first, elements);
        let x = values.as_flattened_mut();
        // what is known first; then each unknown, as soon as it is found, is taken off all those above it
        let rows = front.rows.as_flattened();
        for k in 0..Self::PIVOTS {
            let columns = rows[k].fields.as_flattened();
            let mut sum = rows[k].residual * scale - rows[k].border * border;
            for j in Self::PIVOTS..N * F {
                sum = sum - columns[j] * x[j];
            }
            x[k] = sum;
        }
        for k in (0..Self::PIVOTS).rev() {
            let found = x[k] * rows[k].fields.as_flattened()[k];
            x[k] = found;
            for i in 0..k {
                x[i] = x[i] - rows[i].fields.as_flattened()[k] * found;
            }
        }
        for l in 0..BUNDLE.min(elements - first) {
            for rank in 1..Self::ORDER {
                for f in 0..F {
                    let at = ((first + l) * Self::ORDER + rank) * F + f;
                    out[at] = values[Basis::<N>::slot(rank)][f].0[l];
                }
            }
        }
    }

    #[inline(always)]
    fn sum_energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        let elements = at.ends.len() - 1;
        let mut sums = [0.0; 3];
        for first in (0..elements).step_by(BUNDLE) {
            let changes = self.gather_bundle(direction, first, elements);
            let parts = self.bundle(at, first).energy(&self.density, &self.basis, &changes);
            for (sum, part) in sums.iter_mut().zip(parts) {
                *sum += part.0[..BUNDLE.min(elements - first)].iter().sum::<f64>();
            }
        }
        (ElementEnergy { total: sums[0], adhesion: sums[1] }, sums[2])
    }

    #[inline(always)]
    fn shift(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        let mut state = at.state.to_vec();
        for e in 0..ends.len() - 1 {
            let values = self.gather(at.state, e);
            let (from, length) = (at.ends[e], at.ends[e + 1] - at.ends[e]);
            let (new_from, new_length) = (ends[e], ends[e + 1] - ends[e]);
            let first = self.basis.differentiate(&values);
            let second = self.basis.differentiate(&first);
            for rank in usize::from(e > 0)..N {
                let a = Basis::<N>::slot(rank);
                let place = 0.5 * (1.0 + self.basis.nodes[a]);
                let shift = 2.0 / length * (new_from - from + place * (new_length - length));
                for f in 0..F {
                    state[(e * Self::ORDER + rank) * F + f] += shift * (first[a][f] + 0.5 * shift * second[a][f]);
                }
            }
        }
        state
    }
}

/// [`UniformChain::sweep`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
fn sweep<D: Density<F>, const F: usize, const N: usize>(
    chain: &UniformChain<D, F, N>,
    at: Configuration,
    path: &PathRow,
    damping: &[f64],
    work: &mut ChainFactors,
) -> Result<Root, SolveError> {
    chain.sweep(at, path, damping, work)
}

/// [`UniformChain::back`], likewise.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
fn back<D: Density<F>, const F: usize, const N: usize>(
    chain: &UniformChain<D, F, N>,
    work: &ChainFactors,
    root: &[f64],
    scale: f64,
    out: &mut [f64],
) {
    chain.back(work, root, scale, out);
}

/// [`UniformChain::shift`], likewise.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
fn shifted<D: Density<F>, const F: usize, const N: usize>(
    chain: &UniformChain<D, F, N>,
    at: Configuration,
    ends: &[f64],
) -> Vec<f64> {
    chain.shift(at, ends)
}

/// [`UniformChain::sum_energy`], likewise.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
fn sum_energy<D: Density<F>, const F: usize, const N: usize>(
    chain: &UniformChain<D, F, N>,
    at: Configuration,
    direction: &[f64],
) -> (ElementEnergy, f64) {
    chain.sum_energy(at, direction)
}

impl<D: Density<F>, const F: usize, const N: usize> Chain for UniformChain<D, F, N> {
    fn fields(&self) -> usize {
        F
    }

    fn order(&self) -> usize {
        Self::ORDER
    }

    fn node_fraction(&self, rank: usize) -> f64 {
        0.5 * (1.0 + self.basis.nodes[Basis::<N>::slot(rank)])
    }

    fn has_border(&self) -> bool {
        D::BORDER
    }

    fn eliminate_damped(
        &self,
        at: Configuration,
        path: &PathRow,
        damping: &[f64],
        work: &mut ChainFactors,
    ) -> Result<Root, SolveError> {
        sweep(self, at, path, damping, work)
    }

    fn recover(&self, work: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]) {
        back(self, work, root, scale, out);
    }

    fn energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        sum_energy(self, at, direction)
    }

    fn node_states(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState> {
        let mut states = Vec::with_capacity(elements.len() + 1);
        for e in elements.clone() {
            let element = self.element(at, e);
            let (values, forces) = (element.values, element.forces(&self.density, &self.basis));
            let mut node = |slot: usize, position: f64, sign: f64| {
                let forces = forces[slot].map(|force| sign * force);
                let section = self.density.section_state_from_forces(position, values[slot], forces, at.border);
                let adhesion = self.density.response(position, values[slot], [0.0; F], at.border).adhesion;
                let mut all = [0.0; MOST_FIELDS];
                all[..F].copy_from_slice(&values[slot]);
                states.push(NodeState { position, values: all, section, adhesion });
            };
            if e == elements.start {
                node(N - 2, at.ends[e], -1.0);
            }
            node(N - 1, at.ends[e + 1], 1.0);
        }
        states
    }

    fn sample(&self, at: Configuration, element: usize, local: f64) -> ([f64; MOST_FIELDS], SectionState) {
        let length = at.ends[element + 1] - at.ends[element];
        let (shape, shape_slope) = self.basis.sample(local);
        let (value, slope) = combine(&self.gather(at.state, element), &shape, &shape_slope, length);
        let mut all = [0.0; MOST_FIELDS];
        all[..F].copy_from_slice(&value);
        let place = at.ends[element] + 0.5 * (1.0 + local) * length;
        (all, self.density.section_state(place, value, slope, at.border))
    }

    fn slid(&self, at: Configuration) -> Option<History> {
        let known = at.history.filter(|_| D::REMEMBERS)?;
        let (mut e, mut values) = (0, self.gather(at.state, 0));
        Some(known.updated(|s, [place, share, limit]| {
            while e + 2 < at.ends.len() && s > at.ends[e + 1] {
                e += 1;
                values = self.gather(at.state, e);
            }
            let local = 2.0 * (s - at.ends[e]) / (at.ends[e + 1] - at.ends[e]) - 1.0;
            let (shape, slope) = self.basis.sample(local);
            let before = Slip { place, share, limit };
            let (slip, lost) = self.density.remembered(s, combine(&values, &shape, &slope, 2.0).0, before);
            ([slip.place, slip.share, slip.limit], lost)
        }))
    }

    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        shifted(self, at, ends)
    }

    fn resampled(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
        let mut state = Vec::with_capacity(((ends.len() - 1) * Self::ORDER + 1) * F);
        let mut old = 0;
        for e in 0..ends.len() - 1 {
            let last = usize::from(e + 2 == ends.len());
            for rank in 0..Self::ORDER + last {
                let place = 0.5 * (1.0 + self.basis.nodes[Basis::<N>::slot(rank)]);
                let s = ends[e] + place * (ends[e + 1] - ends[e]);
                while old + 2 < at.ends.len() && s > at.ends[old + 1] {
                    old += 1;
                }
                let local = 2.0 * (s - at.ends[old]) / (at.ends[old + 1] - at.ends[old]) - 1.0;
                let (shape, slope) = self.basis.sample(local);
                state.extend_from_slice(&combine(&self.gather(at.state, old), &shape, &slope, 2.0).0);
            }
        }
        state
    }
}

/// Fields and slopes from nodal values.
#[inline(always)]
fn combine<const F: usize, const N: usize>(
    values: &[[f64; F]; N],
    shape: &[f64; N],
    shape_slope: &[f64; N],
    length: f64,
) -> ([f64; F], [f64; F]) {
    let (mut value, mut slope) = ([0.0; F], [0.0; F]);
    for a in 0..N {
        for f in 0..F {
            value[f] += shape[a] * values[a][f];
            slope[f] += shape_slope[a] * (2.0 / length) * values[a][f];
        }
    }
    (value, slope)
}
