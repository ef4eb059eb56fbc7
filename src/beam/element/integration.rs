//! The element: integrates a density into its front, the matrix that elimination works on.

use super::basis::{Basis, PerNode};
use super::energy_density::{Coupling, FACE, MEMORY, Point, PointResponse};
use super::integrand::Integrand;
use crate::beam::material::yielding::{PROFILE, between, plastic_strain};
use crate::number::{F64x4, Real};
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{MOST_NODES, Nodes};
use crate::solve::state::History;
use serde::{Deserialize, Serialize};

/// Energy of one element, nN·nm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ElementEnergy {
    /// Stored and adhesion energy.
    pub total: f64,
    /// [`PointResponse::coverage`] alone.
    pub coverage: f64,
}

/// One element, or four side by side.
#[derive(Clone, Copy, Debug)]
pub struct Element<T, const F: usize> {
    /// `values[a][f]`: field f at node a, nodes in the elimination order of `Basis`.
    pub values: [[T; F]; MOST_NODES],
    /// S of the left end, nm
    pub from: T,
    /// Reference length, nm
    pub length: T,
    /// [`Point::memory`] at each Gauss point.
    pub memories: [[T; MEMORY]; MOST_NODES],
    /// The number that the whole chain shares.
    pub axial_multiplier: f64,
}

/// How the elements of a chain are integrated.
pub struct Integration<'a, N: Nodes, const F: usize> {
    /// Number of nodes of an element
    pub nodes: N,
    /// Shape functions and Gauss points
    pub basis: &'a Basis,
    /// What is integrated
    pub density: &'a dyn Integrand<F>,
    /// Of the density
    pub coupling: Coupling<F>,
    /// Whether its second derivatives are symmetric.
    pub symmetric: bool,
    /// What its material points remember of the face from step to step.
    pub history: Option<&'a History>,
    /// Whether elements are cut where the pieces of a law join. Cuts come and go as a state moves, and what comes to rest by gradient flow then creeps.
    pub in_pieces: bool,
}

impl<N: Nodes, const F: usize> Integration<'_, N, F> {
    /// The openings at which elements are cut.
    pub(crate) fn knots(&self) -> &'static [f64] {
        if self.in_pieces { self.density.knots() } else { &[] }
    }
}

/// [`Point::memory`] at S of what is remembered from step to step.
pub(in crate::beam) fn memory_of(history: Option<&History>, place: f64) -> [f64; MEMORY] {
    let Some(known) = history else { return [0.0; MEMORY] };
    let mut memory = known.at(place);
    mend(known, place, &mut memory);
    memory
}

/// Puts the plastic strain at S, which numbers that are interpolated one by one are not, in its place behind those of the face.
pub(in crate::beam) fn mend(known: &History, place: f64, numbers: &mut [f64]) {
    if let ([one, other], share) = known.around(place)
        && one.len() > FACE
    {
        let plastic = [one, other].map(|row| plastic_strain(&row[FACE..]));
        numbers[FACE..FACE + PROFILE].copy_from_slice(&between([&plastic[0], &plastic[1]], share));
    }
}

impl<T: Real, const F: usize> Element<T, F> {
    /// All zero.
    pub fn zero() -> Self {
        let zero = T::splat(0.0);
        let (values, memories) = ([[zero; F]; MOST_NODES], [[zero; MEMORY]; MOST_NODES]);
        Self { values, from: zero, length: zero, memories, axial_multiplier: 0.0 }
    }

    /// What its density is asked at Gauss point `q`.
    #[inline(always)]
    pub fn point(&self, nodes: impl Nodes, basis: &Basis, q: usize) -> Point<T, F> {
        let mut point = Point::zero();
        self.ask(nodes, basis, q, true, &mut point);
        point
    }

    /// Puts that into a point, with what is remembered where its density `remembers`.
    #[inline(always)]
    fn ask(&self, nodes: impl Nodes, basis: &Basis, q: usize, remembers: bool, point: &mut Point<T, F>) {
        let stretch = self.stretch();
        point.place = self.from + self.length * (0.5 * (1.0 + basis.points[q]));
        point.value = at_point(nodes, &self.values, &basis.value[q]);
        point.slope = at_point(nodes, &self.values, &basis.slope[q]).map(|s| s * stretch);
        if remembers {
            point.memory = self.memories[q];
        }
    }

    /// Factor of a derivative with respect to S over one with respect to the local coordinate.
    #[inline(always)]
    pub(in crate::beam) fn stretch(&self) -> T {
        self.length.recip() * 2.0
    }

    /// Weight of Gauss point `q`.
    #[inline(always)]
    pub(in crate::beam) fn weight(&self, basis: &Basis, q: usize) -> T {
        self.length * (0.5 * basis.weights[q])
    }
}

/// Room for `Element::integrate`: what the density is asked and what it answers at each Gauss point, and of one of its blocks
/// of second derivatives what the responses are times their weights.
#[derive(Clone, Debug)]
pub struct Responses<const F: usize> {
    points: [Point<F64x4, F>; MOST_NODES],
    responses: [PointResponse<F64x4, F>; MOST_NODES],
    weighted: Weighted,
}

/// Second derivatives by two fields at each Gauss point: of values by values, values by slopes, slopes by values, slopes by slopes.
type Weighted = [[F64x4; MOST_NODES]; 4];

impl<const F: usize> Default for Responses<F> {
    fn default() -> Self {
        let weighted = [[F64x4::splat(0.0); MOST_NODES]; 4];
        Self { points: [Point::zero(); MOST_NODES], responses: [PointResponse::zero(); MOST_NODES], weighted }
    }
}

impl<const F: usize> Responses<F> {
    /// What the density has answered at each Gauss point.
    #[inline(always)]
    pub(in crate::beam) fn responses(&self) -> &[PointResponse<F64x4, F>; MOST_NODES] {
        &self.responses
    }
}

impl<const F: usize> Element<F64x4, F> {
    /// Integrates into a front; returns the energy and its share from adhesion.
    ///
    /// The path row becomes `path_weight` times the gradient of the adhesion energy. Everything in the front is overwritten,
    /// but where the tangent is `symmetric` not what lies below its diagonal.
    // a struct of what it needs would be made for this one call
    #[allow(clippy::too_many_arguments)]
    #[inline(always)]
    pub(crate) fn integrate<const BORDER: bool>(
        &self,
        by: &Integration<impl Nodes, F>,
        path_weight: f64,
        room: &mut Responses<F>,
        front: &mut FrontalMatrix<F64x4, F>,
    ) -> (F64x4, F64x4) {
        let energies = self.integrate_gradient::<BORDER>(by, path_weight, room, front);
        self.assemble(by, room, front);
        energies
    }

    /// The same without the tangent, for which the room keeps the responses.
    #[inline(always)]
    pub(crate) fn integrate_gradient<const BORDER: bool>(
        &self,
        by: &Integration<impl Nodes, F>,
        path_weight: f64,
        room: &mut Responses<F>,
        front: &mut FrontalMatrix<F64x4, F>,
    ) -> (F64x4, F64x4) {
        let &Integration { nodes, basis, density, .. } = by;
        let zero = F64x4::splat(0.0);
        let stretch = self.stretch();
        let (mut energy, mut coverage) = (zero, zero);
        let Responses { points, responses, .. } = room;
        let remembers = density.remembers();
        for q in 0..nodes.count() - 1 {
            self.ask(nodes, basis, q, remembers, &mut points[q]);
        }
        density.respond(&points[..nodes.count() - 1], self.axial_multiplier, responses);
        front.clear_gradient::<BORDER>(nodes);
        for q in 0..nodes.count() - 1 {
            let (r, once) = (&responses[q], self.weight(basis, q));
            // a slope carries the factor 2/length once as a column and once as a row
            let twice = once * stretch;
            energy = energy + r.energy * once;
            coverage = coverage + r.coverage * once;
            add_gradient::<BORDER, F>(front, by, (r, q), (once, twice), path_weight);
        }
        (energy, coverage)
    }

    /// The tangent: sums over the points of  N vv Nᵀ + N vs N'ᵀ + N' sv Nᵀ + N' ss N'ᵀ  with the shape functions N and their
    /// slopes N', of what the responses that the room keeps are times their weights.
    #[inline(always)]
    pub(in crate::beam) fn assemble(
        &self,
        by: &Integration<impl Nodes, F>,
        room: &mut Responses<F>,
        front: &mut FrontalMatrix<F64x4, F>,
    ) {
        let Responses { responses, weighted, .. } = room;
        let (Integration { nodes, basis, coupling, .. }, stretch) = (by, self.stretch());
        for f in 0..F {
            for g in 0..F {
                let [value_value, value_slope, slope_value, slope_slope] = &mut *weighted;
                let coupled = [
                    coupling.value_value[f][g],
                    coupling.value_slope[f][g],
                    coupling.value_slope[g][f],
                    coupling.slope_slope[f][g],
                ];
                for q in 0..nodes.count() - 1 {
                    let (r, once) = (&responses[q], self.weight(basis, q));
                    let twice = once * stretch;
                    if coupled[0] {
                        value_value[q] = r.value_value[f][g] * once;
                    }
                    if coupled[1] {
                        value_slope[q] = r.value_slope[f][g] * twice;
                    }
                    if coupled[2] {
                        slope_value[q] = r.slope_value[f][g] * twice;
                    }
                    if coupled[3] {
                        slope_slope[q] = r.slope_slope[f][g] * twice * stretch;
                    }
                }
                let block = Block {
                    value_value: coupled[0].then_some(&*value_value),
                    value_slope: coupled[1].then_some(&*value_slope),
                    slope_value: coupled[2].then_some(&*slope_value),
                    slope_slope: coupled[3].then_some(&*slope_slope),
                };
                block.assemble(by, (f, g), front);
            }
        }
    }

    /// Energy, its share from adhesion, and how that changes along `direction`, a change of the fields.
    #[inline(always)]
    pub fn energy(&self, by: &Integration<impl Nodes, F>, direction: &[[F64x4; F]; MOST_NODES]) -> [F64x4; 3] {
        let &Integration { nodes, basis, density, .. } = by;
        let (mut sums, mut point, remembers) = ([F64x4::splat(0.0); 3], Point::zero(), density.remembers());
        for q in 0..nodes.count() - 1 {
            self.ask(nodes, basis, q, remembers, &mut point);
            let (r, weight) = (density.energy_at(&point, self.axial_multiplier), self.weight(basis, q));
            let change = at_point(nodes, direction, &basis.value[q]);
            sums[0] = sums[0] + r.energy * weight;
            sums[1] = sums[1] + r.coverage * weight;
            for f in 0..F {
                sums[2] = sums[2] + r.coverage_by_value[f] * change[f] * weight;
            }
        }
        sums
    }
}

impl<const F: usize> Element<f64, F> {
    /// What its density is asked at each Gauss point, and the length that this stands for, nm.
    pub fn points(&self, nodes: impl Nodes, basis: &Basis) -> impl Iterator<Item = (Point<f64, F>, f64)> {
        (0..nodes.count() - 1).map(move |q| (self.point(nodes, basis, q), self.weight(basis, q)))
    }

    /// The gradient of the energy, node by node: the forces that hold the element in place.
    #[inline(always)]
    pub(crate) fn forces(&self, by: &Integration<impl Nodes, F>) -> [[f64; F]; MOST_NODES] {
        let &Integration { nodes, basis, density, .. } = by;
        let mut forces = [[0.0; F]; MOST_NODES];
        for q in 0..nodes.count() - 1 {
            let (g, weight) =
                (density.gradient_at(&self.point(nodes, basis, q), self.axial_multiplier), self.weight(basis, q));
            for f in 0..F {
                let (on_value, on_slope) = (g.by_value[f] * weight, g.by_slope[f] * weight * self.stretch());
                for a in 0..nodes.count() {
                    forces[a][f] = forces[a][f] + on_value * basis.value[q][a] + on_slope * basis.slope[q][a];
                }
            }
        }
        self.piecewise(by, |point| add_piece(nodes, &point.response.by_value, point, &mut forces));
        forces
    }

    /// The gradient of the adhesion energy, node by node.
    pub(crate) fn coverage_forces(&self, by: &Integration<impl Nodes, F>) -> [[f64; F]; MOST_NODES] {
        let &Integration { nodes, basis, density, .. } = by;
        let mut forces = [[0.0; F]; MOST_NODES];
        for q in 0..nodes.count() - 1 {
            let (r, weight) =
                (density.gradient_at(&self.point(nodes, basis, q), self.axial_multiplier), self.weight(basis, q));
            for f in 0..F {
                for a in 0..nodes.count() {
                    forces[a][f] += r.coverage_by_value[f] * weight * basis.value[q][a];
                }
            }
        }
        self.piecewise(by, |point| add_piece(nodes, &point.response.coverage_by_value, point, &mut forces));
        forces
    }

    /// The derivative of the energy by the border.
    pub(crate) fn border_force(&self, nodes: impl Nodes, density: &dyn Integrand<F>, basis: &Basis) -> f64 {
        let force = |q: usize| {
            density.gradient_at(&self.point(nodes, basis, q), self.axial_multiplier).by_border * self.weight(basis, q)
        };
        (0..nodes.count() - 1).map(force).sum()
    }
}

/// Adds what a derivative by the fields at a point of a piece gives to the nodes.
#[inline(always)]
fn add_piece<const F: usize>(
    nodes: impl Nodes,
    by_value: &[f64; F],
    point: &PiecePoint<F>,
    forces: &mut [[f64; F]; MOST_NODES],
) {
    for a in 0..nodes.count() {
        let share = point.weight * point.shape[a];
        (0..F).for_each(|f| forces[a][f] += by_value[f] * share);
    }
}

/// Fields at a point, from nodal values and the shape functions there.
#[inline(always)]
fn at_point<T: Real, const F: usize>(nodes: impl Nodes, values: &[[T; F]; MOST_NODES], shape: &PerNode) -> [T; F] {
    let mut sum = [T::splat(0.0); F];
    for a in 0..nodes.count() {
        for f in 0..F {
            sum[f] = sum[f] + values[a][f] * shape[a];
        }
    }
    sum
}

/// At each Gauss point, shape function `a` times one weight and its slope times another, as far as there are any.
#[inline(always)]
fn mixed(
    nodes: impl Nodes,
    basis: &Basis,
    a: usize,
    by_value: Option<&[F64x4; MOST_NODES]>,
    by_slope: Option<&[F64x4; MOST_NODES]>,
) -> [F64x4; MOST_NODES] {
    let mut sum = [F64x4::splat(0.0); MOST_NODES];
    let (points, value, slope) = (nodes.count() - 1, &basis.four_values_of[a], &basis.four_slopes_of[a]);
    // loops and not closures: these are not compiled for the vector units that the rest is compiled for
    match (by_value, by_slope) {
        (Some(v), Some(s)) => {
            for q in 0..points {
                sum[q] = v[q] * value[q] + s[q] * slope[q];
            }
        }
        (Some(v), None) => {
            for q in 0..points {
                sum[q] = v[q] * value[q];
            }
        }
        (None, Some(s)) => {
            for q in 0..points {
                sum[q] = s[q] * slope[q];
            }
        }
        (None, None) => {}
    }
    sum
}

/// What is weighted of the second derivatives by two fields, as far as there are any.
struct Block<'a> {
    value_value: Option<&'a [F64x4; MOST_NODES]>,
    value_slope: Option<&'a [F64x4; MOST_NODES]>,
    slope_value: Option<&'a [F64x4; MOST_NODES]>,
    slope_slope: Option<&'a [F64x4; MOST_NODES]>,
}

impl Block<'_> {
    /// Writes the columns of field `g` into the rows of field `f`.
    #[inline(always)]
    fn assemble<const F: usize>(
        &self,
        by: &Integration<impl Nodes, F>,
        fields: (usize, usize),
        front: &mut FrontalMatrix<F64x4, F>,
    ) {
        let on_value = self.value_value.is_some() || self.slope_value.is_some();
        let on_slope = self.value_slope.is_some() || self.slope_slope.is_some();
        match (on_value, on_slope) {
            (true, true) => self.rows::<true, true, F>(by, fields, front),
            (true, false) => self.rows::<true, false, F>(by, fields, front),
            (false, true) => self.rows::<false, true, F>(by, fields, front),
            (false, false) => self.rows::<false, false, F>(by, fields, front),
        }
    }

    #[inline(always)]
    fn rows<const ON_VALUE: bool, const ON_SLOPE: bool, const F: usize>(
        &self,
        by: &Integration<impl Nodes, F>,
        (f, g): (usize, usize),
        front: &mut FrontalMatrix<F64x4, F>,
    ) {
        let &Integration { nodes, basis, symmetric, .. } = by;
        for a in 0..nodes.count() {
            // what row a puts on the unknown's values and on its slopes
            let on_value = mixed(nodes, basis, a, self.value_value, self.slope_value);
            let on_slope = mixed(nodes, basis, a, self.value_slope, self.slope_slope);
            for b in if symmetric { a } else { 0 }..nodes.count() {
                // two sums, so that one need not wait for the other
                let (mut by_value, mut by_slope) = (F64x4::splat(0.0), F64x4::splat(0.0));
                for q in 0..nodes.count() - 1 {
                    if ON_VALUE {
                        by_value = by_value + on_value[q] * basis.four_values_of[b][q];
                    }
                    if ON_SLOPE {
                        by_slope = by_slope + on_slope[q] * basis.four_slopes_of[b][q];
                    }
                }
                front.rows[a][f].fields[b][g] = by_value + by_slope;
            }
        }
    }
}

/// One point of a piece, or of the element's own rule, whose share is taken off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PiecePoint<const F: usize> {
    /// Adhesion there, per length; nothing of the stored energy
    pub response: PointResponse<f64, F>,
    /// Shape functions there
    pub shape: PerNode,
    /// Reference length that it stands for, nm; negative where it is taken off
    pub weight: f64,
}

/// Adds what Gauss point q gives, its response, to the gradient, the border and the path of a front; `once` weighs values and `twice` slopes.
#[inline(always)]
fn add_gradient<const BORDER: bool, const F: usize>(
    front: &mut FrontalMatrix<F64x4, F>,
    &Integration { nodes, basis, .. }: &Integration<impl Nodes, F>,
    (r, q): (&PointResponse<F64x4, F>, usize),
    (once, twice): (F64x4, F64x4),
    path_weight: f64,
) {
    for f in 0..F {
        let (on_value, on_slope) = (r.by_value[f] * once, r.by_slope[f] * twice);
        let on_path = r.coverage_by_value[f] * once * path_weight;
        for a in 0..nodes.count() {
            let (value, slope) = (basis.value[q][a], basis.slope[q][a]);
            let row = &mut front.rows[a][f];
            row.residual = row.residual + on_value * value + on_slope * slope;
            front.path.fields[a][f] = front.path.fields[a][f] + on_path * value;
            if BORDER {
                let mixed = r.border_value[f] * once * value + r.border_slope[f] * twice * slope;
                row.border = row.border + mixed;
                front.border.fields[a][f] = front.border.fields[a][f] + mixed;
            }
        }
    }
    if BORDER {
        front.border.border = front.border.border + r.border_border * once;
        front.border.residual = front.border.residual + r.by_border * once;
    }
}
