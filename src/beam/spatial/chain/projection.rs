//! From the seven fields of a node to its six unknowns: the place and the turn φ in the axes of its directors, q(φ) = q ∘ exp(φ/2).
//!
//! With ∂q/∂φ = T and ∂²q/∂φ² = -q I/4, the gradient g and the tangent H by the fields become Tᵀg and TᵀHT - (g·q) I/4.
use crate::beam::spatial::end_rotation::EndMap;
use crate::beam::spatial::rotation::{Matrix3, apply_transposed, inner};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::number::{F64x4, Real};
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{MOST_NODES, Nodes};

/// The front of four elements in the unknowns of their nodes.
pub(crate) type SpatialFront = FrontalMatrix<F64x4, SPATIAL_UNKNOWNS>;
/// The same in the fields.
pub(crate) type FieldFront = FrontalMatrix<F64x4, SPATIAL_FIELDS>;

/// T at a quaternion of length one, by rows.
#[inline(always)]
pub(crate) fn turn_to_quaternion<T: Real>([w, x, y, z]: [T; 4]) -> [[T; 3]; 4] {
    let [w, x, y, z] = [w * 0.5, x * 0.5, y * 0.5, z * 0.5];
    [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
}

/// The quaternion of the fields of a node.
#[inline(always)]
fn quaternion_of<T: Real>(fields: &[T; SPATIAL_FIELDS]) -> [T; 4] {
    [fields[3], fields[4], fields[5], fields[6]]
}

/// Writes the front of the fields of four elements, whose nodes have the `values`, as that of their unknowns. Of a `symmetric` one no node below the
/// diagonal is read or written.
#[inline(always)]
pub(in crate::beam::spatial) fn project(
    nodes: impl Nodes,
    symmetric: bool,
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
        for b in if symmetric { a } else { 0 }..nodes.count() {
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

/// [`EndMap`]s of four elements side by side, at the same node of each.
#[derive(Clone, Copy, Debug)]
pub(in crate::beam::spatial) struct EndMaps {
    /// None where all of them are moved along x, y and z
    place: Option<Matrix3<F64x4>>,
    turn: Matrix3<F64x4>,
    bent: Matrix3<F64x4>,
}

/// The same axes, or the same turn.
pub(in crate::beam::spatial) const SAME: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl EndMaps {
    /// That change nothing.
    #[inline(always)]
    pub(crate) fn same() -> Self {
        let turn = SAME.map(|row| row.map(F64x4::splat));
        Self { place: None, turn, bent: [[F64x4::splat(0.0); 3]; 3] }
    }

    /// Sets that of element `l`, and how it is bent.
    #[inline(always)]
    pub(crate) fn set(&mut self, l: usize, map: &EndMap, bent: &Matrix3) {
        set_lane(&mut self.turn, l, &map.turn);
        set_lane(&mut self.bent, l, bent);
        if self.place.is_some() || map.place != SAME {
            let place = self.place.get_or_insert(SAME.map(|row| row.map(F64x4::splat)));
            set_lane(place, l, &map.place);
        }
    }

    /// Takes a front from the unknowns of node `at` to those of the ends; what is bent is added to the blocks of their turns. Of a `symmetric` one no
    /// node below the diagonal is read or written.
    #[inline(always)]
    pub(crate) fn apply(&self, nodes: impl Nodes, at: usize, symmetric: bool, front: &mut SpatialFront) {
        for a in 0..if symmetric { at + 1 } else { nodes.count() } {
            for f in 0..SPATIAL_UNKNOWNS {
                self.back(&mut front.rows[a][f].fields[at]);
            }
        }
        for b in if symmetric { at } else { 0 }..nodes.count() {
            for g in 0..SPATIAL_UNKNOWNS {
                let mut column = [F64x4::splat(0.0); SPATIAL_UNKNOWNS];
                for f in 0..SPATIAL_UNKNOWNS {
                    column[f] = front.rows[at][f].fields[b][g];
                }
                self.back(&mut column);
                for f in 0..SPATIAL_UNKNOWNS {
                    front.rows[at][f].fields[b][g] = column[f];
                }
            }
        }
        for i in 0..3 {
            for j in 0..3 {
                let entry = &mut front.rows[at][3 + i].fields[at][3 + j];
                *entry = *entry + self.bent[i][j];
            }
        }
        let mut residual = [F64x4::splat(0.0); SPATIAL_UNKNOWNS];
        for f in 0..SPATIAL_UNKNOWNS {
            residual[f] = front.rows[at][f].residual;
        }
        self.back(&mut residual);
        for f in 0..SPATIAL_UNKNOWNS {
            front.rows[at][f].residual = residual[f];
        }
        self.back(&mut front.path.fields[at]);
    }

    /// Gradients by the unknowns of the nodes as ones by those of the ends.
    #[inline(always)]
    fn back(&self, node: &mut [F64x4; SPATIAL_UNKNOWNS]) {
        let [x, y, z, a, b, c] = *node;
        if let Some(place) = &self.place {
            let [x, y, z] = apply_transposed(place, &[x, y, z]);
            (node[0], node[1], node[2]) = (x, y, z);
        }
        let [a, b, c] = apply_transposed(&self.turn, &[a, b, c]);
        (node[3], node[4], node[5]) = (a, b, c);
    }
}

#[inline(always)]
fn set_lane(out: &mut Matrix3<F64x4>, l: usize, own: &Matrix3) {
    for i in 0..3 {
        for j in 0..3 {
            out[i][j].0[l] = own[i][j];
        }
    }
}
