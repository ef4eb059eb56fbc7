//! The elimination, from the tips to the root.

use super::end_block::{BelowEnd, Carry, EndBlock, EndRow};
use super::forest::{Forest, Piece};
use super::frontal_matrix::FrontalMatrix;
use super::interior::{pack, pack_columns, packed_length};
use super::nodes::{Nodes, slot};
use crate::number::{F64x4, Real};
use crate::solve::error::{Place, Quantity, SolveError};
use crate::solve::system::{CondensedSystem, Evaluation, INTERFACE, NodalTerms};
use std::sync::Arc;

/// Pivots below this are zero to rounding.
const LEAST_PIVOT: f64 = f64::MIN_POSITIVE * 1e20;

/// A structure at a state, as its elimination sees it.
pub(crate) trait Fronts<const F: usize> {
    /// Room to integrate in.
    type Room;

    /// Whether its tangent is symmetric.
    fn is_symmetric(&self) -> bool;

    /// Writes the fronts of the elements of a bundle in the unknowns of their nodes, with the functional in the path row: nothing below the diagonal
    /// where they are symmetric. Their energies, and a second integral that is summed up with these.
    fn write(
        &self,
        nodes: impl Nodes,
        bundle: usize,
        room: &mut Self::Room,
        front: &mut FrontalMatrix<F64x4, F>,
    ) -> [F64x4; 2];

    /// By how much what is held of a joint is off.
    fn off(&self, joint: usize) -> [Option<f64>; F];

    /// Where an element is.
    fn place(&self, element: usize) -> Place;
}

/// What an elimination leaves for the way back, and room for it.
pub(crate) struct FrontalFactors<const F: usize> {
    pub(super) forest: Arc<Forest>,
    /// Bundle by bundle
    pub(super) inside: Vec<F64x4>,
    /// Likewise, what stood below the pivots; nothing where the tangent is symmetric
    pub(super) columns: Vec<F64x4>,
    /// Element by element
    pub(super) ends: Vec<[EndRow<F>; F]>,
    /// Likewise
    pub(super) below: Vec<BelowEnd<F>>,
    /// Of each joint, what of it is held
    pub(super) held: Vec<[bool; F]>,
    /// Of each joint. What it has of its own before an elimination; of the root what is left behind one.
    carries: Vec<Carry<F>>,
    front: Box<FrontalMatrix<F64x4, F>>,
}

/// What is left when all but the root is eliminated.
#[derive(Clone, Copy, Debug)]
pub struct Eliminated<const F: usize> {
    /// The equations of the root
    pub root: Carry<F>,
    /// Negative eigenvalues with the root held
    pub negative: usize,
    /// The smallest pivot without its sign
    pub least_pivot: f64,
    /// Of the elements, before the update: the energy, aJ, and the second integral
    pub integrals: [f64; 2],
}

impl<const F: usize> Default for FrontalFactors<F> {
    fn default() -> Self {
        Self {
            forest: Arc::default(),
            inside: Vec::new(),
            columns: Vec::new(),
            ends: Vec::new(),
            below: Vec::new(),
            held: Vec::new(),
            carries: Vec::new(),
            front: Box::new(FrontalMatrix::zero()),
        }
    }
}

impl<const F: usize> FrontalFactors<F> {
    /// Begins an elimination of a forest: what its joints have of their own, all zero, to be filled in.
    pub(crate) fn begin(&mut self, forest: Arc<Forest>) -> &mut [Carry<F>] {
        self.inside.resize(forest.bundles.len() * packed_length::<F>(forest.order), F64x4::splat(0.0));
        self.ends.resize(forest.pieces.len(), [EndRow::ZERO; F]);
        self.below.resize(forest.pieces.len(), [[0.0; F]; F]);
        self.held.clear();
        self.held.resize(forest.joints, [false; F]);
        self.carries.clear();
        self.carries.resize(forest.joints, Carry::ZERO);
        self.forest = forest;
        &mut self.carries
    }

    /// Eliminates all but the root, with terms added to the equations of nodes that are no joints.
    ///
    /// # Errors
    /// A pivot that is zero to rounding, a number that is not finite.
    pub(crate) fn eliminate<S: Fronts<F>, N: Nodes>(
        &mut self,
        structure: &S,
        added: NodalTerms,
        room: &mut S::Room,
    ) -> Result<Eliminated<F>, SolveError> {
        eliminate::<S, N, F>(self, structure, added, room)
    }

    #[inline(always)]
    fn sweep<S: Fronts<F>>(
        &mut self,
        nodes: impl Nodes,
        structure: &S,
        added: NodalTerms,
        room: &mut S::Room,
    ) -> Result<Eliminated<F>, SolveError> {
        let Self { forest, inside, columns, ends, below, held, carries, front } = self;
        let symmetric = structure.is_symmetric();
        columns.resize(if symmetric { 0 } else { inside.len() }, F64x4::splat(0.0));
        let (order, packed, mut block) = (nodes.count() - 1, packed_length::<F>(forest.order), EndBlock::zero());
        let (mut integrals, mut negative, mut least_pivot) = ([0.0; 2], 0, f64::INFINITY);
        for (b, own) in forest.bundles.iter().enumerate() {
            let parts = structure.write(nodes, b, room, front);
            add_inside(nodes, front, added, &own.lanes.map(|e| &forest.pieces[e]));
            let pivots = if symmetric {
                front.condense_by_nodes::<true>(nodes)
            } else {
                front.condense_by_nodes::<false>(nodes)
            };
            pack(order, front, &mut inside[b * packed..][..packed]);
            if !symmetric {
                pack_columns(order, front, &mut columns[b * packed..][..packed]);
            }
            for (l, &e) in own.lanes.iter().enumerate().take(own.count) {
                let piece = &forest.pieces[e];
                block.take(nodes, front, l, piece.near, symmetric);
                block.unload(&carries[piece.from]);
                if piece.is_first {
                    let off = structure.off(piece.from);
                    held[piece.from] = off.map(|off| off.is_some());
                    block.hold(&off);
                } else {
                    for (f, row) in block.rows[0].iter_mut().enumerate() {
                        let (stiffness, force) = added.at(piece.ends[0] * F + f);
                        row.ends[0][f] += stiffness;
                        row.residual += force;
                    }
                }
                let (negative_end, least_end) = block.eliminate();
                negative += pivots.negative.0[l] as usize + negative_end;
                let smallest = least_end.min(pivots.least.0[l]);
                if smallest < LEAST_PIVOT {
                    return Err(SolveError::Singular { pivot: smallest, place: structure.place(e) });
                }
                least_pivot = least_pivot.min(smallest);
                integrals = [integrals[0] + parts[0].0[l], integrals[1] + parts[1].0[l]];
                (ends[e], below[e]) = (block.rows[0], block.below());
                let carry = block.load();
                if !(carry.tangent[0][0].is_finite() && integrals[0].is_finite()) {
                    return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place: structure.place(e) });
                }
                if piece.onto == piece.from {
                    carries[piece.from] = carry;
                } else {
                    carries[piece.onto].add(&carry);
                }
            }
        }
        Ok(Eliminated { root: carries[forest.root[0]], negative, least_pivot, integrals })
    }
}

/// [`FrontalFactors::sweep`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn eliminate<S: Fronts<F>, N: Nodes, const F: usize>(
    factors: &mut FrontalFactors<F>,
    structure: &S,
    added: NodalTerms,
    room: &mut S::Room,
) -> Result<Eliminated<F>, SolveError> {
    let nodes = N::of_order(factors.forest.order);
    factors.sweep(nodes, structure, added, room)
}

/// Adds to the interior nodes of four elements.
#[inline(always)]
fn add_inside<const F: usize>(
    nodes: impl Nodes,
    front: &mut FrontalMatrix<F64x4, F>,
    added: NodalTerms,
    pieces: &[&Piece],
) {
    if added.stiffness.is_empty() && added.force.is_empty() {
        return;
    }
    let order = nodes.count() - 1;
    for (l, piece) in pieces.iter().enumerate() {
        for rank in 1..order {
            let (row, node) = (slot(order + 1, rank), piece.inside + rank - 1);
            for f in 0..F {
                let (stiffness, force) = added.at(node * F + f);
                let own = &mut front.rows[row][f];
                own.fields[row][f].0[l] += stiffness;
                own.residual.0[l] += force;
            }
        }
    }
}

impl Eliminated<INTERFACE> {
    /// The system on its interface, the root.
    pub(crate) fn condensed(&self, evaluation: Evaluation) -> CondensedSystem {
        CondensedSystem {
            matrix: self.root.tangent,
            residual: self.root.residual,
            gradient: self.root.path,
            gradient_residual: self.root.path_residual,
            negative: self.negative,
            least_pivot: self.least_pivot,
            evaluation,
        }
    }
}
