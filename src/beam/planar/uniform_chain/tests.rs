//! Right-hand sides through the factors against a dense matrix and its LU.
//!
//! The dense matrix is put together from the fronts as they are before anything is eliminated, with the damping and the rows of held
//! fields. Densities: one whose second derivatives are made up, well conditioned and different at each place, with and without
//! symmetry and border; the three-field beam on flat ground, held at its left end or by friction.
//!
//! Expected: x of K x = b and of Kᵀ x = b to 1e-10 of its size, for every order and for numbers of elements that fill the last
//! bundle and do not; for the residual what [`Chain::recover`] gives. Why: a multiplier of the wrong pivot would show in adjoints
//! and sensitivities alone.

use super::elements::UniformChain;
use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::section::law::Law;
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::adhesion::substrate::Substrate;
use crate::adhesion::substrate_response::GroundLaw;
use crate::beam::element::energy_density::{Coupling, EnergyDensity, Point, PointResponse, SectionState};
use crate::beam::element::integrand::PlanarIntegrand;
use crate::beam::element::integration::{Element, Responses};
use crate::beam::planar::chain::{Chain, ChainFactors, CondensedChain, Configuration, ConstraintGradient};
use crate::beam::planar::density::on_ground::BeamOnGround;
use crate::beam::section::Section;
use crate::beam::varying::Profile;
use crate::number::Real;
use crate::solve::frontal::frontal_matrix::FrontalMatrix;
use crate::solve::frontal::nodes::{BUNDLE, slot};
use crate::solve::state::History;
use crate::solve::system::NodalTerms;
use nalgebra::{DMatrix, DVector};

/// Numbers between -1 and 1, the same on every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn several(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next()).collect()
    }
}

/// Second derivatives by the fields, their slopes and the axial_multiplier, as made up.
struct MadeUp<const F: usize, const BORDER: bool> {
    derivatives: [[f64; 7]; 7],
    symmetric: bool,
}

impl<const F: usize, const BORDER: bool> MadeUp<F, BORDER> {
    fn new(symmetric: bool, numbers: &mut Numbers) -> Self {
        let mut derivatives = [[0.0; 7]; 7];
        for i in 0..7 {
            for j in 0..7 {
                derivatives[i][j] = if i == j { 2.0 } else { 0.35 * numbers.next() };
                if symmetric && j < i {
                    derivatives[i][j] = derivatives[j][i];
                }
            }
        }
        Self { derivatives, symmetric }
    }
}

impl<const F: usize, const BORDER: bool> EnergyDensity<F> for MadeUp<F, BORDER> {
    const COUPLING: Coupling<F> =
        Coupling { value_value: [[true; F]; F], value_slope: [[true; F]; F], slope_slope: [[true; F]; F] };
    const BORDER: bool = BORDER;

    fn response<T: Real>(&self, place: T, value: [T; F], slope: [T; F], _: f64) -> PointResponse<T, F> {
        let (uneven, d) = (place.sin_cos().0 * 0.3 + 1.0, &self.derivatives);
        let mut response = PointResponse::zero();
        for f in 0..F {
            (response.by_value[f], response.by_slope[f]) = (value[f] * d[f][f], slope[f] * 0.7 + value[f]);
            response.coverage_by_value[f] = value[f];
            for g in 0..F {
                response.value_value[f][g] = uneven * d[f][g];
                response.value_slope[f][g] = uneven * d[f][F + g];
                response.slope_value[f][g] = uneven * d[F + f][g];
                response.slope_slope[f][g] = uneven * d[F + f][F + g];
            }
            if BORDER {
                (response.border_value[f], response.border_slope[f]) = (uneven * d[6][f], uneven * d[6][3 + f]);
            }
        }
        if BORDER {
            (response.by_border, response.border_border) = (T::splat(0.3), uneven * 1.5);
        }
        response
    }

    fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    fn section_state(&self, _: &Point<f64, F>, _: f64) -> SectionState {
        SectionState::default()
    }

    fn section_state_from_forces(&self, _: f64, _: [f64; F], _: [f64; F], _: f64) -> SectionState {
        SectionState::default()
    }
}

/// The matrix that [`Chain::reduce`] speaks of, and the residual, from the fronts.
fn dense<const F: usize, const BORDER: bool>(
    chain: &UniformChain<F>,
    at: Configuration,
    damping: &[f64],
) -> (DMatrix<f64>, DVector<f64>) {
    let (order, elements) = (chain.order(), at.ends.len() - 1);
    let fields = (elements * order + 1) * F;
    let unknowns = fields + usize::from(BORDER);
    let (mut matrix, mut residual) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
    let (mut bundle, mut room, mut front) = (Element::zero(), Responses::default(), FrontalMatrix::zero());
    for e in 0..elements {
        let (first, l) = (e - e % BUNDLE, e % BUNDLE);
        chain.gather_bundle(chain.nodes(), at, first, &mut bundle);
        bundle.integrate::<BORDER>(&chain.integration(chain.nodes(), None), 1.0, &mut room, &mut front);
        let known: Vec<_> = (0..=order)
            .flat_map(|rank| (0..F).map(move |f| ((e * order + rank) * F + f, slot(order + 1, rank), f)))
            .collect();
        for &(row, a, f) in &known {
            residual[row] += front.rows[a][f].residual.0[l];
            for &(column, b, g) in &known {
                let below = chain.symmetric && (b, g) < (a, f);
                let (row_of, (node, field)) =
                    if below { (&front.rows[b][g], (a, f)) } else { (&front.rows[a][f], (b, g)) };
                matrix[(row, column)] += row_of.fields[node][field].0[l];
            }
            if BORDER {
                matrix[(row, fields)] += front.rows[a][f].border.0[l];
                matrix[(fields, row)] += front.border.fields[a][f].0[l];
            }
        }
        if BORDER {
            matrix[(fields, fields)] += front.border.border.0[l];
            residual[fields] += front.border.residual.0[l];
        }
    }
    for (k, damping) in damping.iter().enumerate() {
        matrix[(k, k)] += damping;
    }
    for f in 0..F {
        let Some(held) = chain.pinned_left[f] else { continue };
        matrix.row_mut(f).fill(0.0);
        (matrix[(f, f)], residual[f]) = (1.0, at.state[f] - held);
    }
    (matrix, residual)
}

/// The solution by way of the root.
fn solved<const F: usize>(
    chain: &UniformChain<F>,
    root: &CondensedChain,
    eliminated: &ChainFactors,
    right: &[f64],
    transposed: bool,
) -> DVector<f64> {
    let mut x = right.to_vec();
    let left = chain.reduce(eliminated, &mut x, transposed);
    let size = F + usize::from(chain.has_border());
    let block = DMatrix::from_fn(size, size, |i, j| root.matrix[i][j]);
    let block = if transposed { block.transpose() } else { block };
    let last = block.lu().solve(&DVector::from_column_slice(&left[..size])).unwrap();
    chain.substitute(eliminated, last.as_slice(), &mut x, transposed);
    DVector::from_vec(x)
}

/// Where a chain is, and what it is damped with.
struct Place {
    ends: Vec<f64>,
    state: Vec<f64>,
    damping: Vec<f64>,
    history: Option<History>,
}

fn agrees<const F: usize, const BORDER: bool>(
    chain: &UniformChain<F>,
    Place { ends, state, damping, history }: &Place,
    numbers: &mut Numbers,
) {
    let at = Configuration { ends, state, axial_multiplier: 0.2, history: history.as_ref(), strains: None };
    let mut eliminated = ChainFactors::default();
    let added = NodalTerms { stiffness: damping, force: &[] };
    let root = chain.eliminate_with(at, &ConstraintGradient::default(), added, &mut eliminated).unwrap();
    let (matrix, residual) = dense::<F, BORDER>(chain, at, damping);
    let right = numbers.several(matrix.nrows());
    let close = |found: &DVector<f64>, wanted: &DVector<f64>| {
        let missed = (found - wanted).amax() / wanted.amax();
        assert!(missed < 1e-10, "order {}, {} elements: {missed:e}", chain.order(), ends.len() - 1);
    };
    for (transposed, matrix) in [(false, matrix.clone()), (true, matrix.transpose())] {
        let wanted = matrix.lu().solve(&DVector::from_column_slice(&right)).unwrap();
        close(&solved(chain, &root, &eliminated, &right, transposed), &wanted);
    }
    // the root solved for its residual, and the way back with what elimination took along
    let size = F + usize::from(BORDER);
    let last = DMatrix::from_fn(size, size, |i, j| root.matrix[i][j]).lu();
    let last = last.solve(&DVector::from_fn(size, |i, _| root.matrix[i][size])).unwrap();
    let mut update = vec![0.0; state.len()];
    chain.recover(&eliminated, last.as_slice(), 1.0, &mut update);
    close(&solved(chain, &root, &eliminated, residual.as_slice(), false), &extended(&update, &last, F));
    assert!(root.least_pivot.size > 0.0 && root.least_pivot.element < ends.len() - 1);
}

/// An update with the border behind it, where there is one.
fn extended(update: &[f64], root: &DVector<f64>, fields: usize) -> DVector<f64> {
    DVector::from_iterator(
        update.len() + root.len() - fields,
        update.iter().copied().chain(root.iter().skip(fields).copied()),
    )
}

fn made_up<const F: usize, const BORDER: bool>(pinned: [Option<f64>; F]) {
    let mut numbers = Numbers(7);
    for order in 1..=8 {
        for elements in [1, 2, 3, 4, 5, 7, 9] {
            for symmetric in [true, false] {
                let density: Box<dyn PlanarIntegrand<F>> = Box::new(MadeUp::<F, BORDER>::new(symmetric, &mut numbers));
                let chain = UniformChain::new::<BORDER>(density, order, pinned);
                let unknowns = (elements * order + 1) * F;
                let mut end = 0.0;
                let lengths: Vec<f64> = numbers.several(elements).iter().map(|n| 1.5 + 0.5 * n).collect();
                let ends = std::iter::once(0.0)
                    .chain(lengths.iter().map(|length| {
                        end += length;
                        end
                    }))
                    .collect();
                let state = numbers.several(unknowns);
                let damping = if elements % 2 == 0 {
                    numbers.several(unknowns).iter().map(|n| n.abs()).collect()
                } else {
                    vec![]
                };
                agrees::<F, BORDER>(&chain, &Place { ends, state, damping, history: None }, &mut numbers);
            }
        }
    }
}

#[test]
fn two_fields() {
    made_up::<2, false>([None; 2]);
    made_up::<2, false>([None, Some(0.1)]);
}

#[test]
fn two_fields_and_a_border() {
    made_up::<2, true>([None; 2]);
    made_up::<2, true>([Some(0.0), None]);
}

#[test]
fn three_fields() {
    made_up::<3, false>([None; 3]);
    made_up::<3, false>([Some(0.0), None, Some(0.2)]);
}

#[test]
fn three_fields_and_a_border() {
    made_up::<3, true>([None, Some(0.0), None]);
}

/// The paper's strip near the substrate, held at its left end or rubbing on it.
#[test]
fn a_beam() {
    let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
    let mut numbers = Numbers(11);
    for (line_load, rubs) in [(LineLoad::Full, false), (LineLoad::ForceOnly, false), (LineLoad::Full, true)] {
        let law = LineLaw { half_space, height: 10.0, law: Law::BodyForce, line_load, far_face: true };
        let beam = BeamOnGround {
            profile: Profile::uniform(Section { axial: 20.0, shear: 7.0, bending: 160.0 }, 1.0, 10.0),
            ground: GroundLaw { law, substrate: Substrate::Flat },
            friction: rubs.then(|| FrictionLaw::new(half_space, 0.05, 0.3, None)),
        };
        let end = if rubs { None } else { Some(0.0) };
        for order in 1..=8 {
            let chain = UniformChain::new::<false>(Box::new(beam.clone()), order, [end, None, None]);
            let ends: Vec<f64> = (0..=6).map(|e| 5.0 * f64::from(e)).collect();
            let mut state = Vec::new();
            for node in 0..=6 * order {
                let e = (node / order).min(5);
                let s = 5.0 * (e as f64 + chain.node_fraction(node - e * order));
                state.extend([1e-4 * numbers.next(), 0.255 + 1e-5 * s * s, 2e-5 * s]);
            }
            // it has stuck where it lay
            let history = rubs.then(|| History::even(30.0, 1.0, |s| [s, 0.0, 0.05]));
            agrees::<3, false>(&chain, &Place { ends, state, damping: vec![], history }, &mut numbers);
        }
    }
}
