//! From the seven fields of a node to its six unknowns: the place and the turn φ in the axes of its directors, q(φ) = q ∘ exp(φ/2).
//!
//! With ∂q/∂φ = T and ∂²q/∂φ² = -q I/4, the gradient g and the tangent H by the fields become Tᵀg and TᵀHT - (g·q) I/4.

use crate::beam::spatial::density::SPATIAL_FIELDS;
use crate::beam::spatial::rotation::{Matrix3, apply_transposed, inner};
use crate::beam::{FrontalMatrix, MOST_NODES, Nodes};
use crate::number::{F64x4, Real};

/// Unknowns of a node.
pub const SPATIAL_UNKNOWNS: usize = 6;
/// The front of four elements in the unknowns of their nodes.
pub type SpatialFront = FrontalMatrix<F64x4, SPATIAL_UNKNOWNS>;
/// The same in the fields.
pub type FieldFront = FrontalMatrix<F64x4, SPATIAL_FIELDS>;

/// T at a quaternion of length one, by rows.
#[inline(always)]
pub fn turn_to_quaternion<T: Real>([w, x, y, z]: [T; 4]) -> [[T; 3]; 4] {
    let [w, x, y, z] = [w * 0.5, x * 0.5, y * 0.5, z * 0.5];
    [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
}

/// The quaternion of the fields of a node.
#[inline(always)]
fn quaternion_of<T: Real>(fields: &[T; SPATIAL_FIELDS]) -> [T; 4] {
    [fields[3], fields[4], fields[5], fields[6]]
}

/// Writes the front of the fields of four elements, whose nodes have the `values`, as that of their unknowns. No node below the diagonal is
/// read or written.
#[inline(always)]
pub(in crate::beam::spatial) fn project(
    nodes: impl Nodes,
    fields: &FieldFront,
    values: &[[F64x4; SPATIAL_FIELDS]; MOST_NODES],
    front: &mut SpatialFront,
) {
    let mut turns = [[[F64x4::splat(0.0); 3]; 4]; MOST_NODES];
    for a in 0..nodes.count() {
        turns[a] = turn_to_quaternion(quaternion_of(&values[a]));
    }
    for a in 0..nodes.count() {
        let (rows, turned) = (&fields.rows[a], &turns[a]);
        let by_quaternion = [rows[3].residual, rows[4].residual, rows[5].residual, rows[6].residual];
        let on_turn = apply_transposed(turned, &by_quaternion);
        for f in 0..3 {
            front.rows[a][f].residual = rows[f].residual;
            front.rows[a][3 + f].residual = on_turn[f];
        }
        for b in a..nodes.count() {
            // the columns of node b, then the rows of node a
            let next = &turns[b];
            for i in 0..3 {
                front.rows[a][i].fields[b] = projected(&rows[i].fields[b], next);
            }
            let mut half = [[F64x4::splat(0.0); 3]; 4];
            for k in 0..4 {
                half[k] = apply_transposed(next, &quaternion_of(&rows[3 + k].fields[b]));
            }
            for g in 0..3 {
                let mut of_place = [F64x4::splat(0.0); 4];
                let mut of_turn = of_place;
                for k in 0..4 {
                    (of_place[k], of_turn[k]) = (rows[3 + k].fields[b][g], half[k][g]);
                }
                let (of_place, of_turn) = (apply_transposed(turned, &of_place), apply_transposed(turned, &of_turn));
                for i in 0..3 {
                    (front.rows[a][3 + i].fields[b][g], front.rows[a][3 + i].fields[b][3 + g]) =
                        (of_place[i], of_turn[i]);
                }
            }
        }
        let bent = inner(by_quaternion, quaternion_of(&values[a])) * 0.25;
        for f in 3..SPATIAL_UNKNOWNS {
            front.rows[a][f].fields[a][f] = front.rows[a][f].fields[a][f] - bent;
        }
        front.path.fields[a] = projected(&fields.path.fields[a], turned);
    }
    front.path.residual = fields.path.residual;
}

/// A row of a node's fields in its unknowns.
#[inline(always)]
pub(in crate::beam::spatial) fn projected<T: Real>(
    row: &[T; SPATIAL_FIELDS],
    turned: &[[T; 3]; 4],
) -> [T; SPATIAL_UNKNOWNS] {
    let own = apply_transposed(turned, &quaternion_of(row));
    [row[0], row[1], row[2], own[0], own[1], own[2]]
}

/// From the unknowns of an end of the chain to those of its last node: of its place and of its turn, and how that is bent,
/// Σ g ∂²φ/∂c².
#[derive(Clone, Copy, Debug)]
pub struct EndMap {
    /// Columns: the axes along which the end is moved.
    pub place: Matrix3,
    /// ∂φ/∂c
    pub turn: Matrix3,
}

impl EndMap {
    /// A direction of the end as one of its node.
    pub fn forward(&self, end: &[f64]) -> [f64; SPATIAL_UNKNOWNS] {
        self.both(|map, k| (0..3).map(|j| map[k % 3][j] * end[3 * (k / 3) + j]).sum())
    }

    /// A gradient by the unknowns of the node as one by those of the end.
    pub fn back(&self, node: &[f64]) -> [f64; SPATIAL_UNKNOWNS] {
        self.both(|map, k| (0..3).map(|j| map[j][k % 3] * node[3 * (k / 3) + j]).sum())
    }

    fn both(&self, sum: impl Fn(&Matrix3, usize) -> f64) -> [f64; SPATIAL_UNKNOWNS] {
        std::array::from_fn(|k| sum(if k < 3 { &self.place } else { &self.turn }, k))
    }

    /// Takes element `l` of a front from the unknowns of node `at` to those of the end; `bent` is added to the block of its turn.
    pub(in crate::beam::spatial) fn apply(
        &self,
        nodes: impl Nodes,
        at: usize,
        l: usize,
        bent: &Matrix3,
        front: &mut SpatialFront,
    ) {
        for a in 0..=at {
            for f in 0..SPATIAL_UNKNOWNS {
                let row = &mut front.rows[a][f].fields[at];
                let taken = self.back(&row.map(|entry| entry.0[l]));
                (0..SPATIAL_UNKNOWNS).for_each(|g| row[g].0[l] = taken[g]);
            }
        }
        for b in at..nodes.count() {
            for g in 0..SPATIAL_UNKNOWNS {
                let column: [f64; SPATIAL_UNKNOWNS] = std::array::from_fn(|f| front.rows[at][f].fields[b][g].0[l]);
                let taken = self.back(&column);
                (0..SPATIAL_UNKNOWNS).for_each(|f| front.rows[at][f].fields[b][g].0[l] = taken[f]);
            }
        }
        for i in 0..3 {
            for j in 0..3 {
                front.rows[at][3 + i].fields[at][3 + j].0[l] += bent[i][j];
            }
        }
        let residual = self.back(&std::array::from_fn::<_, SPATIAL_UNKNOWNS, _>(|f| front.rows[at][f].residual.0[l]));
        let path = self.back(&front.path.fields[at].map(|entry| entry.0[l]));
        for f in 0..SPATIAL_UNKNOWNS {
            front.rows[at][f].residual.0[l] = residual[f];
            front.path.fields[at][f].0[l] = path[f];
        }
    }
}
