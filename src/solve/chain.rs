//! Elimination along a chain of elements, front by front.
//!
//! Each element's front is eliminated in one sweep: its interior nodes, then its left node, which nobody else needs any
//! more. What is left on its right node and on the border passes into the next front. The last row of a front carries
//! the path functional and the last column the residual, so that both are reduced along with the rest. The sign of a
//! pivot is the sign of an eigenvalue (Sylvester), so the sweep counts the negative ones as it goes.

use super::SolveError;
use crate::beam::{Basis, Density, ElementEnergy, SectionState, Spread, integrate, places, side_by_side};
use crate::number::Lanes;
use std::ops::Range;

/// The most fields a node can have.
pub const MOST_FIELDS: usize = 3;
/// Size of the root block: fields of the last node, border, residual and path.
pub const ROOT: usize = MOST_FIELDS + 2;

/// A configuration of the chain: where its elements end, and its unknowns.
#[derive(Clone, Copy, Debug)]
pub struct Configuration<'a> {
    /// Reference coordinates S of the ends of the elements, nm; one more than there are elements.
    pub ends: &'a [f64],
    /// Fields node by node from left to right.
    pub state: &'a [f64],
    pub border: f64,
}

/// What the path condition wants of the chain: a linear functional of adhesion energy and of the left end's fields.
#[derive(Clone, Copy, Debug, Default)]
pub struct PathRow {
    pub adhesion: f64,
    pub left: [f64; MOST_FIELDS],
}

/// What is left of the chain when all nodes but the last are eliminated.
#[derive(Clone, Copy, Debug)]
pub struct Root {
    /// Leading block: fields of the last node, then the border; then the residual column and the path row.
    pub matrix: [[f64; ROOT]; ROOT],
    /// Negative eigenvalues of the chain with its last node held.
    pub negative: usize,
    /// Energy before the update.
    pub energy: ElementEnergy,
}

/// Pivot rows kept for the way back; reused from solve to solve.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    rows: Vec<f64>,
}

/// State of one node between elements, from nodal forces.
#[derive(Clone, Copy, Debug)]
pub struct NodeState {
    /// S, nm
    pub position: f64,
    /// Fields at the node.
    pub values: [f64; MOST_FIELDS],
    /// Section forces and stretch there.
    pub section: SectionState,
    /// Adhesion energy per length there, nN
    pub adhesion: f64,
}

impl NodeState {
    /// The first integral H x' + V y' + M θ' - stored - bΨ, nN.
    pub fn first_integral(&self) -> f64 {
        self.section.eshelby() - self.adhesion
    }
}

/// A chain of elements of one order and one density.
pub trait Chain: Send + Sync {
    /// Fields a node.
    fn fields(&self) -> usize;
    /// Order p of the elements.
    fn order(&self) -> usize;
    /// Place of the node of rank `rank` (0 to p) within its element, as a fraction of its length.
    fn node_fraction(&self, rank: usize) -> f64;
    /// Whether one unknown is shared by the whole chain.
    fn has_border(&self) -> bool;
    /// Integrates and eliminates; what is needed to go back stays in `work`.
    fn eliminate(&self, at: Configuration, path: &PathRow, work: &mut Workspace) -> Result<Root, SolveError>;
    /// Goes back from the root's solution `root` (last node's fields, border): x = scale × residual part - U⁻¹ root part.
    fn recover(&self, work: &Workspace, root: &[f64], scale: f64, out: &mut [f64]);
    /// Energy of a configuration, and how its adhesion energy changes along `direction`, a change of the fields.
    fn energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64);
    /// Section state at every end of the elements of a range.
    fn node_states(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState>;
    /// Fields at the local coordinate `local` in [-1, 1] of element `element`, and the section state there.
    fn sample(&self, at: Configuration, element: usize, local: f64) -> ([f64; MOST_FIELDS], SectionState);
    /// The state on element ends that lie a little beside its own: each node's value moved along its element's polynomial,
    /// to second order in the move.
    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64>;
    /// The state on other ends of elements, each new node read off the element it falls in.
    fn resampled(&self, at: Configuration, ends: &[f64]) -> Vec<f64>;
}

/// [`Chain`] for one density and one order: N = p + 1 nodes an element, fronts of size M = F N + border + 1.
pub struct UniformChain<D, const F: usize, const N: usize, const M: usize> {
    density: D,
    basis: Basis<N>,
    spread: Spread<F, N, M>,
    /// Where the fields of the left end are held, as far as they are.
    pinned_left: [Option<f64>; F],
}

impl<D: Density<F>, const F: usize, const N: usize, const M: usize> UniformChain<D, F, N, M> {
    const ORDER: usize = N - 1;
    const PIVOTS: usize = (N - 1) * F;
    const BORDER: usize = M - F * N - 1;

    /// A chain whose left end is free but for the fields that `pinned_left` holds at a value.
    pub fn new(density: D, pinned_left: [Option<f64>; F]) -> Self {
        const { assert!(M == F * N + 1 || M == F * N + 2) };
        let basis = Basis::new();
        Self { density, spread: Spread::new(&basis), basis, pinned_left }
    }

    /// Values of element `e` in elimination order.
    #[inline(always)]
    fn gather(&self, state: &[f64], e: usize) -> [[f64; F]; N] {
        let at = &state[e * Self::ORDER * F..][..N * F];
        let mut values = [[0.0; F]; N];
        for rank in 0..N {
            let slot = Basis::<N>::slot(rank);
            for f in 0..F {
                values[slot][f] = at[rank * F + f];
            }
        }
        values
    }

    #[inline(always)]
    fn sweep(&self, at: Configuration, path: &PathRow, work: &mut Workspace) -> Result<Root, SolveError> {
        let elements = at.ends.len() - 1;
        work.rows.resize(elements * Self::PIVOTS * M, 0.0);
        let mut carry = [[0.0; ROOT]; ROOT];
        let mut energy = ElementEnergy::default();
        let mut negative = 0;
        let left = Self::PIVOTS - F;
        let mut front = [[0.0; M]; M];
        for e in 0..elements {
            let length = at.ends[e + 1] - at.ends[e];
            let values = self.gather(at.state, e);
            let element = integrate(
                &self.density,
                &self.basis,
                &self.spread,
                &values,
                (at.ends[e], length),
                at.border,
                path.adhesion,
                &mut front,
            );
            energy.total += element.total;
            energy.adhesion += element.adhesion;
            if e == 0 {
                self.start(&mut front, path, &values[N - 2]);
            } else {
                unload(&carry, &mut front, |i| if i < F { left + i } else { Self::PIVOTS + i });
            }
            negative += eliminate_front::<M>(&mut front, Self::PIVOTS).map_err(|pivot| SolveError::Singular {
                pivot,
                element: e,
                position_nm: at.ends[e],
            })?;
            let rows = &mut work.rows[e * Self::PIVOTS * M..][..Self::PIVOTS * M];
            for (k, row) in rows.chunks_exact_mut(M).enumerate() {
                row.copy_from_slice(&front[k]);
            }
            for i in 0..F + Self::BORDER + 1 {
                for j in 0..F + Self::BORDER + 1 {
                    carry[i][j] = front[Self::PIVOTS + i][Self::PIVOTS + j];
                }
            }
            if !carry[0][0].is_finite() || !energy.total.is_finite() {
                return Err(SolveError::NotFinite { quantity: "the tangent", element: e, position_nm: at.ends[e] });
            }
        }
        Ok(Root { matrix: carry, negative, energy })
    }

    /// The left end of the chain: its part of the path functional, and the fields that are held.
    #[inline(always)]
    fn start(&self, front: &mut [[f64; M]; M], path: &PathRow, left_values: &[f64; F]) {
        let left = Self::PIVOTS - F;
        for f in 0..F {
            front[M - 1][left + f] += path.left[f];
        }
        for f in 0..F {
            let Some(held) = self.pinned_left[f] else { continue };
            let k = left + f;
            for i in 0..M {
                front[k][i] = 0.0;
                front[i][k] = 0.0;
            }
            front[k][k] = 1.0;
            front[k][M - 1] = left_values[f] - held;
        }
    }

    #[inline(always)]
    fn back(&self, work: &Workspace, root: &[f64], scale: f64, out: &mut [f64]) {
        let elements = work.rows.len() / (Self::PIVOTS * M);
        let nodes = elements * Self::ORDER;
        out[nodes * F..(nodes + 1) * F].copy_from_slice(&root[..F]);
        let mut x = [0.0; M];
        x[Self::PIVOTS..Self::PIVOTS + F + Self::BORDER].copy_from_slice(&root[..F + Self::BORDER]);
        x[M - 1] = -scale;
        for e in (0..elements).rev() {
            let rows = work.rows[e * Self::PIVOTS * M..][..Self::PIVOTS * M].as_chunks::<M>().0;
            // what is known first; then each unknown, as soon as it is found, is taken off all those above it
            for (k, row) in rows.iter().enumerate() {
                x[k] = 0.0;
                for j in Self::PIVOTS..M {
                    x[k] -= row[j] * x[j];
                }
            }
            for k in (0..Self::PIVOTS).rev() {
                x[k] *= rows[k][k];
                let found = x[k];
                for i in 0..k {
                    x[i] -= rows[i][k] * found;
                }
            }
            for rank in 0..Self::ORDER {
                for f in 0..F {
                    out[(e * Self::ORDER + rank) * F + f] = x[Basis::<N>::slot(rank) * F + f];
                }
            }
            for f in 0..F {
                x[Self::PIVOTS + f] = x[Self::PIVOTS - F + f];
            }
        }
    }
}

/// [`UniformChain::sweep`] compiled for the vector units that the machine may have, chosen when it runs.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx2+fma", "x86_64+avx2+fma"))]
fn sweep<D: Density<F>, const F: usize, const N: usize, const M: usize>(
    chain: &UniformChain<D, F, N, M>,
    at: Configuration,
    path: &PathRow,
    work: &mut Workspace,
) -> Result<Root, SolveError> {
    chain.sweep(at, path, work)
}

/// Adds a carried block into a front, entry (i, j) at (place(i), place(j)).
#[inline(always)]
fn unload<const M: usize>(carry: &[[f64; ROOT]; ROOT], front: &mut [[f64; M]; M], place: impl Fn(usize) -> usize) {
    for (i, row) in carry.iter().enumerate() {
        for (j, &entry) in row.iter().enumerate() {
            if place(i) < M && place(j) < M {
                front[place(i)][place(j)] += entry;
            }
        }
    }
}

/// Eliminates the first `pivots` unknowns of a front without pivoting; returns how many pivots were negative, or the
/// pivot that is zero to rounding.
#[inline(always)]
fn eliminate_front<const M: usize>(front: &mut [[f64; M]; M], pivots: usize) -> Result<usize, f64> {
    let mut negative = 0;
    for k in 0..pivots {
        let row = front[k];
        let pivot = row[k];
        if pivot.abs() < f64::MIN_POSITIVE * 1e20 {
            return Err(pivot);
        }
        negative += usize::from(pivot < 0.0);
        let inverse = 1.0 / pivot;
        for other in &mut front[k + 1..] {
            let factor = other[k] * inverse;
            // columns up to k are done with; running over all of them keeps the loop's length known
            *other = std::array::from_fn(|j| other[j] - factor * row[j]);
        }
        // the way back multiplies
        front[k][k] = inverse;
    }
    Ok(negative)
}

impl<D: Density<F>, const F: usize, const N: usize, const M: usize> Chain for UniformChain<D, F, N, M> {
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
        Self::BORDER == 1
    }

    fn eliminate(&self, at: Configuration, path: &PathRow, work: &mut Workspace) -> Result<Root, SolveError> {
        sweep(self, at, path, work)
    }

    fn recover(&self, work: &Workspace, root: &[f64], scale: f64, out: &mut [f64]) {
        self.back(work, root, scale, out);
    }

    fn energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64) {
        let mut energy = ElementEnergy::default();
        let mut along = 0.0;
        for e in 0..at.ends.len() - 1 {
            let length = at.ends[e + 1] - at.ends[e];
            let (values, changes) = (self.gather(at.state, e), self.gather(direction, e));
            let (value, slope) = side_by_side(&self.basis, &values, length);
            let (change, _) = side_by_side(&self.basis, &changes, length);
            let r = self.density.response(places(&self.basis, at.ends[e], length), value, slope, at.border);
            let weights = Lanes(self.basis.weights) * (0.5 * length);
            energy.total += (weights * r.energy).0.iter().sum::<f64>();
            energy.adhesion += (weights * r.adhesion).0.iter().sum::<f64>();
            for f in 0..F {
                along += (weights * r.adhesion_by_value[f] * change[f]).0.iter().sum::<f64>();
            }
        }
        (energy, along)
    }

    fn node_states(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState> {
        let mut states = Vec::with_capacity(elements.len() + 1);
        for e in elements.clone() {
            let length = at.ends[e + 1] - at.ends[e];
            let values = self.gather(at.state, e);
            let mut front = [[0.0; M]; M];
            let place = (at.ends[e], length);
            integrate(&self.density, &self.basis, &self.spread, &values, place, at.border, 0.0, &mut front);
            let mut node = |slot: usize, position: f64, sign: f64| {
                let forces = std::array::from_fn(|f| sign * front[slot * F + f][M - 1]);
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

    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64> {
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
