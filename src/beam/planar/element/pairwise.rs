//! The tangent of elements whose fields couple by all their slopes, symmetric and without a border: the block of two fields is the
//! transpose of that of the same fields in turn, so that each pair of fields is integrated once.

use super::block::mixed;
use super::planar_element::{Element, Integration, Responses};
use crate::beam::{FrontalMatrix, MOST_NODES, Nodes, PointResponse};
use crate::number::{F64x4, Real};

/// Second derivatives by two fields times their weights at each Gauss point; none of what never couples.
struct Pair {
    value_value: Option<[F64x4; MOST_NODES]>,
    value_slope: Option<[F64x4; MOST_NODES]>,
    slope_value: Option<[F64x4; MOST_NODES]>,
    slope_slope: [F64x4; MOST_NODES],
}

impl<const F: usize> Element<F64x4, F> {
    /// [`Element::integrate`] of such fields. The later of two fields is the one whose values couple.
    #[inline(always)]
    pub fn integrate_pairwise(
        &self,
        by: &Integration<impl Nodes, F>,
        path_weight: f64,
        room: &mut Responses<F>,
        front: &mut FrontalMatrix<F64x4, F>,
    ) -> (F64x4, F64x4) {
        let energies = self.integrate_gradient::<false>(by, path_weight, room, front);
        for g in 0..F {
            for f in 0..=g {
                let pair = self.pair(by, &room.responses, (g, f));
                let on_value = pair.value_value.is_some() || pair.slope_value.is_some();
                let symmetric = f == g || (pair.value_value.is_none() && pair.value_slope.is_none());
                match (on_value, symmetric) {
                    (true, true) => pair.assemble::<true, true, F>(by, (g, f), front),
                    (true, false) => pair.assemble::<true, false, F>(by, (g, f), front),
                    (false, true) => pair.assemble::<false, true, F>(by, (g, f), front),
                    (false, false) => pair.assemble::<false, false, F>(by, (g, f), front),
                }
            }
        }
        energies
    }

    #[inline(always)]
    fn pair(
        &self,
        by: &Integration<impl Nodes, F>,
        responses: &[PointResponse<F64x4, F>; MOST_NODES],
        (g, f): (usize, usize),
    ) -> Pair {
        let (Integration { nodes, basis, coupling, .. }, stretch) = (by, self.stretch());
        let zero = [F64x4::splat(0.0); MOST_NODES];
        let mut pair = Pair {
            value_value: coupling.value_value[g][f].then_some(zero),
            value_slope: coupling.value_slope[g][f].then_some(zero),
            slope_value: coupling.value_slope[f][g].then_some(zero),
            slope_slope: zero,
        };
        for q in 0..nodes.count() - 1 {
            let (r, once) = (&responses[q], self.weight(basis, q));
            let twice = once * stretch;
            if let Some(weighted) = &mut pair.value_value {
                weighted[q] = r.value_value[g][f] * once;
            }
            if let Some(weighted) = &mut pair.value_slope {
                weighted[q] = r.value_slope[g][f] * twice;
            }
            if let Some(weighted) = &mut pair.slope_value {
                weighted[q] = r.slope_value[g][f] * twice;
            }
            pair.slope_slope[q] = r.slope_slope[g][f] * twice * stretch;
        }
        pair
    }
}

impl Pair {
    /// Writes the columns of field `f` into the rows of field `g`, and the transpose into the rows of field `f`, as far as they do not lie
    /// below the diagonal. Of a block that is `SYMMETRIC` itself what lies below its diagonal is not computed.
    #[inline(always)]
    fn assemble<const ON_VALUE: bool, const SYMMETRIC: bool, const F: usize>(
        &self,
        by: &Integration<impl Nodes, F>,
        (g, f): (usize, usize),
        front: &mut FrontalMatrix<F64x4, F>,
    ) {
        let &Integration { nodes, basis, .. } = by;
        for a in 0..nodes.count() {
            // what row a puts on the unknown's values and on its slopes
            let on_value = mixed(nodes, basis, a, self.value_value.as_ref(), self.slope_value.as_ref());
            let on_slope = mixed(nodes, basis, a, self.value_slope.as_ref(), Some(&self.slope_slope));
            let first = if SYMMETRIC { a } else { 0 };
            // one after the other, so that the weights of each stay in registers; into the front itself, because the compiler gathers the
            // sums of four nodes where these lie side by side
            if ON_VALUE {
                for b in first..nodes.count() {
                    front.rows[a][g].fields[b][f] = along(nodes, &on_value, &basis.four_values_of[b]);
                }
            }
            for b in first..nodes.count() {
                let by_slope = along(nodes, &on_slope, &basis.four_slopes_of[b]);
                let entry = &mut front.rows[a][g].fields[b][f];
                *entry = if ON_VALUE { *entry + by_slope } else { by_slope };
            }
            if SYMMETRIC {
                for b in a..nodes.count() {
                    front.rows[a][f].fields[b][g] = front.rows[a][g].fields[b][f];
                }
            } else {
                for b in 0..=a {
                    front.rows[b][f].fields[a][g] = front.rows[a][g].fields[b][f];
                }
            }
        }
    }
}

/// What a row puts on the points, summed with a shape function or its slope.
#[inline(always)]
fn along(nodes: impl Nodes, row: &[F64x4; MOST_NODES], shape: &[F64x4; MOST_NODES]) -> F64x4 {
    let mut sum = F64x4::splat(0.0);
    for q in 0..nodes.count() - 1 {
        sum = sum + row[q] * shape[q];
    }
    sum
}
