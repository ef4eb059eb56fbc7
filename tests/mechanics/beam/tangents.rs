//! Gradients and tangents of the beam, from one point of the axis to the whole chain.
//!
//! Reference: dual numbers (num-dual) through the stored energy as it is defined, ½EA Γ1² + ½GA_s Γ2² + ½EI κ², and through
//! Ψ = [W(r1) - W(r2)]/cos θ. For the two-field form the minimum over x' is taken in dual numbers as well: what it
//! minimises, ½EA Γ1² + ½GA_s Γ2² - H x', is a parabola in x'.
//!
//!     free end ___________________          y, θ at every node;
//!     S = 0   |___|___|___|__|_|_/ ^ u, P   H one number for the chain where the grip is held
//!             adhesion b Ψ(y, θ)  S = L
//!
//! Parameters: sections and states at random (a fixed seed), slender and stout, soft and stiff, tilts within ±1.4, with an axis that
//! rises from the underside and is curved when free of stress; chains of
//! the paper's strip, L = 40 nm, 6 elements.
//!
//! Expected: equal to 1e-9 of the entries' scale; symmetric where the load has a potential, and not where it has none; Newton's
//! updates fall like a square, for every order, form, load and path condition. Why: a wrong entry of a tangent costs
//! iterations everywhere and is seen nowhere else.

use crate::common::{LOADS, line_energy, paper_law, paper_strip, stored_energy, with_grip, with_load};
use nalgebra::{SMatrix, SVector};
use num_dual::{Dual2SVec64, DualNum, hessian};
use peelkit::adhesion::{LineLaw, LineLoad, TiltCount};
use peelkit::beam::{
    BeamGeometry, ChainFactors, ConstraintGradient, EnergyDensity, FRONT, Material, Point, PointResponse, Profile,
    ReducedBeam, ReissnerBeam, Section, SectionGeometry, StretchLaw, TIP_ROTATION, Varying, rectangle_second_moment,
};
use peelkit::model::{BeamProblem, Form, Hold};
use peelkit::solve::{NewtonOptions, Observables, PathConstraint, Problem, SolveError, State, Workspace, solve};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::sync::Arc;

/// The same random cases on every run.
fn runner() -> TestRunner {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    TestRunner::new_with_rng(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() }, rng)
}

/// A section, a law and a point's unknowns.
#[derive(Clone, Copy, Debug)]
struct Case {
    section: Section,
    law: LineLaw,
    width: f64,
    gap: f64,
    rotation: f64,
    /// x', η' and θ'
    slopes: [f64; 3],
    axial_multiplier: f64,
    /// h'/2 and κ0
    lie: [f64; 2],
}

/// A beam that is at its one place as a case says.
impl BeamGeometry for Case {
    fn length(&self) -> f64 {
        1.0
    }

    fn breaks(&self) -> Vec<f64> {
        Vec::new()
    }

    fn at(&self, _: f64) -> SectionGeometry {
        let [rise, curvature] = self.lie;
        let height = [self.law.height, 2.0 * rise, 0.0];
        SectionGeometry { width: self.width, height, roundness: 0.0, underside: [0.0, curvature] }
    }
}

impl Case {
    fn profile(self) -> Profile {
        self.stretched(StretchLaw::Linear)
    }

    fn stretched(self, stretch: StretchLaw) -> Profile {
        let (width, height) = (self.width, self.law.height);
        let Section { axial, shear, bending } = self.section;
        let youngs_modulus = axial / (width * height);
        let material = Material {
            shear_correction: 2.4 * shear / axial,
            bending_stiffness_factor: bending / (youngs_modulus * rectangle_second_moment(height, width)),
            stretch,
            ..Material::of(youngs_modulus, 0.2)
        };
        Profile::Varying(Varying::new(Arc::new(self), material))
    }
}

fn cases() -> impl Strategy<Value = Case> {
    let law = (0usize..3, any::<bool>()).prop_map(|(load, far_face)| paper_law(LOADS[load], far_face));
    // decimal exponents, so that EA, GA_s and EI come in every proportion
    let section = (0.0..3.0f64, 0.0..3.0f64, -2.0..4.0f64).prop_map(|(a, s, b)| Section {
        axial: 10f64.powf(a),
        shear: 10f64.powf(s),
        bending: 10f64.powf(b),
    });
    let slopes = (0.8..1.2f64, -1.0..1.0f64, -0.3..0.3f64).prop_map(|(x, y, t)| [x, y, t]);
    let lie = (-0.5..0.5f64, -0.2..0.2f64).prop_map(|(rise, curvature)| [rise, curvature]);
    (section, law, 0.5..3.0f64, 0.22..4.0f64, -1.4..1.4f64, slopes, -1.0..1.0f64, lie).prop_map(
        |(section, law, width, gap, rotation, slopes, axial_multiplier, lie)| Case {
            section,
            law,
            width,
            gap,
            rotation,
            slopes,
            axial_multiplier,
            lie,
        },
    )
}

/// Value, gradient and Hessian of an energy of fields, slopes and the axial multiplier, in this order.
type Expansion<const K: usize> = (f64, SVector<f64, K>, SMatrix<f64, K, K>);

/// The gradient and tangent of a response in the same order.
fn assembled<const F: usize, const K: usize>(r: &PointResponse<f64, F>) -> (SVector<f64, K>, SMatrix<f64, K, K>) {
    let (mut gradient, mut tangent) = (SVector::zeros(), SMatrix::zeros());
    for i in 0..F {
        gradient[i] = r.by_value[i];
        gradient[F + i] = r.by_slope[i];
        for j in 0..F {
            tangent[(i, j)] = r.value_value[i][j];
            tangent[(i, F + j)] = r.value_slope[i][j];
            tangent[(F + i, j)] = r.slope_value[i][j];
            tangent[(F + i, F + j)] = r.slope_slope[i][j];
        }
        if K > 2 * F {
            tangent[(i, 2 * F)] = r.border_value[i];
            tangent[(2 * F, i)] = r.border_value[i];
            tangent[(F + i, 2 * F)] = r.border_slope[i];
            tangent[(2 * F, F + i)] = r.border_slope[i];
        }
    }
    if K > 2 * F {
        gradient[2 * F] = r.by_border;
        tangent[(2 * F, 2 * F)] = r.border_border;
    }
    (gradient, tangent)
}

/// Compares a density with stored plus adhesion energy. `lead` is the place of the gap among the fields. A load without a
/// potential keeps the gap's equation and loses the rotation's.
fn compare<const F: usize, const K: usize>(
    response: &PointResponse<f64, F>,
    stored: Expansion<K>,
    [adhesion, coverage]: [Expansion<K>; 2],
    lead: usize,
    potential: bool,
) -> Result<(), TestCaseError> {
    let (gradient, tangent) = assembled::<F, K>(response);
    let (mut load, mut load_tangent) = (adhesion.1, adhesion.2);
    if !potential {
        load[lead + 1] = 0.0;
        load_tangent.row_mut(lead + 1).fill(0.0);
    }
    let (wanted, wanted_tangent) = (stored.1 + load, stored.2 + load_tangent);
    let close = |what: &str, computed: f64, expected: f64, size: f64| {
        let fine = (computed - expected).abs() <= 1e-9 * (size + expected.abs());
        if fine { Ok(()) } else { Err(TestCaseError::fail(format!("{what}: {computed:e}, expected {expected:e}"))) }
    };
    close("energy", response.energy, stored.0 + adhesion.0, stored.0.abs())?;
    close("adhesion", response.adhesion, adhesion.0, 0.0)?;
    close("coverage", response.coverage, coverage.0, 0.0)?;
    for i in 0..K {
        close(&format!("gradient {i}"), gradient[i], wanted[i], stored.1.amax())?;
        for j in 0..K {
            close(&format!("tangent {i} {j}"), tangent[(i, j)], wanted_tangent[(i, j)], stored.2.amax())?;
        }
    }
    for f in 0..F {
        close(&format!("coverage gradient {f}"), response.coverage_by_value[f], coverage.1[f], coverage.1.amax())?;
    }
    let symmetric = (tangent - tangent.transpose()).amax() <= 1e-14 * tangent.amax();
    prop_assert!(symmetric || !potential, "a potential's tangent is not symmetric: {}", tangent);
    if !potential {
        let moment = adhesion.2[(lead + 1, lead)];
        let skew = tangent[(lead, lead + 1)] - tangent[(lead + 1, lead)];
        close("what keeps the tangent from symmetry", skew, moment, stored.2.amax())?;
    }
    Ok(())
}

/// min over x' of ½EA Γ1² + ½GA_s Γ2² - H x', plus ½EI κ².
fn reduced_energy<D: DualNum<f64> + Copy>(section: &Section, rotation: D, dy: D, curvature: D, force: D) -> D {
    let (sin, cos) = rotation.sin_cos();
    let (axial, shear) = (section.axial, section.shear);
    let stiffness = cos * cos * axial + sin * sin * shear;
    let dx = (force + cos * (-dy * sin + 1.0) * axial + sin * cos * dy * shear) / stiffness;
    stored_energy(section, rotation, dx, dy, curvature) - force * dx
}

/// What a tilted section counts in the coverage: near to cos θ, and a quarter where it stands upright; all of it under a load that is blind
/// to the tilt.
fn share<D: DualNum<f64> + Copy>(law: &LineLaw, cos: D) -> D {
    let seen = cos * cos - (cos.powi(4) - 1.0) * 0.25;
    if law.line_load == LineLoad::AxisGap { D::one() } else { seen }
}

#[test]
fn two_field_density_held_and_free() {
    runner()
        .run(&cases(), |c| {
            let Case { section, law, width, lie: [rise, curved], .. } = c;
            let ([_, dy, curvature], value) = (c.slopes, [c.gap, c.rotation]);
            let potential = law.has_potential();

            let at = SVector::from([c.gap, c.rotation, dy, curvature, c.axial_multiplier]);
            let stored = hessian(
                |v: SVector<Dual2SVec64<5>, 5>| reduced_energy(&section, v[1], v[2] + rise, v[3] - curved, v[4]),
                &at,
            );
            let energy = |v: SVector<Dual2SVec64<5>, 5>| line_energy(&law, v[0], v[1]) * width;
            let covered =
                |v: SVector<Dual2SVec64<5>, 5>| line_energy(&law, v[0], v[1]) * share(&law, v[1].cos()) * width;
            let adhesion = [hessian(energy, &at), hessian(covered, &at)];
            let held = ReducedBeam::<true> { profile: c.profile(), law, count: TiltCount::Coarse };
            compare(&held.response(0.0, value, [dy, curvature], c.axial_multiplier), stored, adhesion, 0, potential)?;

            let at = SVector::from([c.gap, c.rotation, dy, curvature]);
            let stored = hessian(
                |v: SVector<Dual2SVec64<4>, 4>| reduced_energy(&section, v[1], v[2] + rise, v[3] - curved, v[3] * 0.0),
                &at,
            );
            let energy = |v: SVector<Dual2SVec64<4>, 4>| line_energy(&law, v[0], v[1]) * width;
            let covered =
                |v: SVector<Dual2SVec64<4>, 4>| line_energy(&law, v[0], v[1]) * share(&law, v[1].cos()) * width;
            let adhesion = [hessian(energy, &at), hessian(covered, &at)];
            let free = ReducedBeam::<false> { profile: c.profile(), law, count: TiltCount::Coarse };
            // a free grip knows no H, whatever stands in its place
            compare(&free.response(0.0, value, [dy, curvature], c.axial_multiplier), stored, adhesion, 0, potential)
        })
        .unwrap();
}

#[test]
fn three_field_density() {
    runner()
        .run(&cases(), |c| {
            let Case { section, law, width, lie: [rise, curved], .. } = c;
            let [dx, dy, curvature] = c.slopes;
            let at = SVector::from([17.0, c.gap, c.rotation, dx, dy, curvature]);
            let energy = |v: SVector<Dual2SVec64<6>, 6>| line_energy(&law, v[1], v[2]) * width;
            let covered =
                |v: SVector<Dual2SVec64<6>, 6>| line_energy(&law, v[1], v[2]) * share(&law, v[2].cos()) * width;
            let adhesion = [hessian(energy, &at), hessian(covered, &at)];
            let stretched = dx * c.rotation.cos() + (dy + rise) * c.rotation.sin();
            // a section that is turned inside out has no energy of rubber
            let all = if stretched > 0.1 { &STRETCHES[..] } else { &STRETCHES[..1] };
            for &stretch in all {
                let stored = hessian(
                    |v: SVector<Dual2SVec64<6>, 6>| {
                        let linear = stored_energy(&section, v[2], v[3], v[4] + rise, v[5] - curved);
                        linear + beyond_linear(&section, stretch, v[2], v[3], v[4] + rise)
                    },
                    &at,
                );
                let beam = ReissnerBeam { profile: c.stretched(stretch), law, count: TiltCount::Coarse };
                let response = beam.response(0.0, [17.0, c.gap, c.rotation], of_fields(c.slopes), 0.0);
                compare(&response, stored, adhesion, 1, law.has_potential())?;
                let state = beam.section_state(&section_at([0.0, c.gap, c.rotation], of_fields(c.slopes)), 0.0);
                let forces = [state.horizontal_force, state.vertical_force, state.moment];
                let back = beam.section_state_from_forces(0.0, [0.0, c.gap, c.rotation], forces, 0.0);
                let close = (back.stored - state.stored).abs() <= 1e-9 * state.stored.abs();
                prop_assert!(close, "{back:?} from the forces of {state:?}");
            }
            Ok(())
        })
        .unwrap();
}

/// The slopes ξ', η' and θ' of fields that have x', η' and θ': ξ = x - S.
fn of_fields([dx, dy, turn]: [f64; 3]) -> [f64; 3] {
    [dx - 1.0, dy, turn]
}

/// A section at the start of a beam that remembers nothing.
fn section_at<const F: usize>(value: [f64; F], slope: [f64; F]) -> Point<f64, F> {
    Point { value, slope, ..Point::zero() }
}

const STRETCHES: [StretchLaw; 3] = [StretchLaw::Linear, StretchLaw::NeoHookean, StretchLaw::NeoHookeanWide];

/// By how much the energy of a stretch is more than ½EA Γ1²: EA (λ² + 2/λ - 3)/6 or EA (λ² + λ⁻² - 2)/8 in place of that.
fn beyond_linear<D: DualNum<f64> + Copy>(section: &Section, law: StretchLaw, rotation: D, dx: D, dy: D) -> D {
    let (sin, cos) = rotation.sin_cos();
    let stretch = dx * cos + dy * sin;
    let linear = (stretch - 1.0) * (stretch - 1.0) * (0.5 * section.axial);
    let energy = match law {
        StretchLaw::Linear => return D::zero(),
        StretchLaw::NeoHookean => (stretch * stretch + stretch.recip() * 2.0 - 3.0) / 6.0,
        StretchLaw::NeoHookeanWide => (stretch * stretch + (stretch * stretch).recip() - 2.0) / 8.0,
    };
    energy * section.axial - linear
}

/// Section forces are the stored energy's derivatives by the slopes, in either form, from slopes and from forces.
#[test]
fn section_states_agree_with_the_density() {
    runner()
        .run(&cases(), |c| {
            let Case { section, law, lie: [rise, _], .. } = c;
            let close = |a: f64, b: f64, size: f64| {
                let fine = (a - b).abs() <= 1e-10 * size;
                if fine { Ok(()) } else { Err(TestCaseError::fail(format!("{a:e} and {b:e}"))) }
            };
            let beam = ReissnerBeam { profile: c.profile(), law, count: TiltCount::Coarse };
            let value = [0.0, c.gap, c.rotation];
            let state = beam.section_state(&section_at(value, of_fields(c.slopes)), 0.0);
            let response = beam.response(0.0, value, of_fields(c.slopes), 0.0);
            let forces = [state.horizontal_force, state.vertical_force, state.moment];
            let size = section.axial + section.shear + section.bending;
            for (force, by_slope) in forces.iter().zip(response.by_slope) {
                close(*force, by_slope, size)?;
            }
            close(state.stored, response.energy - response.adhesion, size)?;
            let back = beam.section_state_from_forces(0.0, value, forces, 0.0);
            close(back.horizontal_slope, c.slopes[0], size / section.axial.min(section.shear))?;
            close(back.vertical_slope, c.slopes[1] + rise, size / section.axial.min(section.shear))?;
            close(back.curvature, c.slopes[2], size / section.bending)?;

            // the two-field form, given the same H, has the same section
            let reduced = ReducedBeam::<true> { profile: c.profile(), law, count: TiltCount::Coarse };
            let same = reduced
                .section_state(&section_at([c.gap, c.rotation], [c.slopes[1], c.slopes[2]]), state.horizontal_force);
            close(same.horizontal_slope, c.slopes[0], size / section.axial.min(section.shear))?;
            close(same.vertical_force, state.vertical_force, size)?;
            close(same.stored, state.stored, size)?;
            close(same.eshelby(), state.eshelby(), size)
        })
        .unwrap();
}

/// A configuration with its right end lifted smoothly by `lift`: no equilibrium.
fn lifted(problem: &BeamProblem, mut at: State, lift: f64) -> State {
    let beam = problem.beam.planar().unwrap();
    let (fields, order) = (beam.fields(), beam.chain.order());
    let (nodes, ends) = (beam.nodes(&at.values).len(), &at.mesh.boundaries);
    for (node, values) in at.values[..nodes].chunks_exact_mut(fields).enumerate() {
        let (e, rank) = ((node / order).min(5), node - (node / order).min(5) * order);
        let s = ends[e] + (ends[e + 1] - ends[e]) * beam.chain.node_fraction(rank);
        let layer = ((s - problem.beam.length()) / 6.0).exp();
        values[problem.grip.driven] += lift * layer;
        values[beam.rotation] += lift / 6.0 * layer;
    }
    at
}

#[test]
fn root_of_the_chain_is_symmetric_where_there_is_a_potential() {
    for horizontal in [Hold::Free, Hold::Fixed] {
        for form in [Form::TwoField, Form::ThreeField] {
            for load in LOADS {
                let model = with_load(with_grip(paper_strip(40.0, 1.0), Hold::Free, horizontal), load);
                for order in 1..=8 {
                    let problem = model.problem(form, order).unwrap();
                    let at = lifted(&problem, problem.initial(6), 0.2);
                    let row = ConstraintGradient::default();
                    let beam = problem.beam.planar().unwrap();
                    let factors = &mut ChainFactors::default();
                    let root = beam.chain.eliminate(beam.configuration(&at), &row, factors).unwrap();
                    let n = beam.fields() + usize::from(beam.chain.has_border());
                    let (mut skew, mut size) = (0.0f64, 0.0f64);
                    for i in 0..n {
                        for j in 0..n {
                            skew = skew.max((root.matrix[i][j] - root.matrix[j][i]).abs());
                            size = size.max(root.matrix[i][j].abs());
                        }
                    }
                    let potential = load != LineLoad::ForceOnly;
                    let case = format!("{form:?}, {load:?}, {horizontal:?}, order {order}: {skew:e} of {size:e}");
                    assert_eq!(skew < 1e-12 * size, potential, "{case}");
                }
            }
        }
    }
}

/// An equilibrium with u = 0.1 nm, behind which the force still rises.
fn equilibrium(problem: &Problem) -> State {
    let weights = Observables::DISPLACEMENT;
    let options = NewtonOptions { tolerance: 1e-12, largest_update: 1.0, most_iterations: 20, exact_slope: false };
    let mut at = problem.initial(6);
    for k in 0..=10 {
        let condition = PathConstraint { weights, target: 0.01 * f64::from(k) };
        let solution = solve(problem, at, &condition, &options, &mut Workspace::default()).unwrap();
        at = solution.moved(problem, if k < 10 { 0.01 } else { 0.0 });
    }
    at
}

/// Newton's updates from one start, until they are round-off.
fn updates(problem: &Problem, start: &State, condition: &PathConstraint) -> Vec<f64> {
    let mut sizes = Vec::new();
    for most_iterations in 1..=12 {
        let options = NewtonOptions { tolerance: 0.0, largest_update: 10.0, most_iterations, exact_slope: false };
        match solve(problem, start.clone(), condition, &options, &mut Workspace::default()) {
            Err(SolveError::NotConverged { update, .. }) => sizes.push(update),
            Err(error) => panic!("{error}"),
            Ok(_) => break,
        }
        if sizes[sizes.len() - 1] < 1e-11 {
            break;
        }
    }
    sizes
}

/// Under displacement control and under a condition that weighs adhesion energy, rotation of the free end and force, as
/// path following and the search for limit points do.
#[test]
fn newtons_method_converges_quadratically() {
    let displacement = Observables::DISPLACEMENT;
    let mut mixed = Observables { displacement: 1.0, force: 0.3, ..Observables::default() };
    (mixed.monitors[FRONT], mixed.monitors[TIP_ROTATION]) = (-0.05, 0.5);
    let mut most = 0;
    for horizontal in [Hold::Free, Hold::Fixed] {
        for form in [Form::TwoField, Form::ThreeField] {
            for load in LOADS {
                let model = with_load(with_grip(paper_strip(40.0, 1.0), Hold::Free, horizontal), load);
                for order in 1..=8 {
                    let problem = model.problem(form, order).unwrap();
                    let start = lifted(&problem, equilibrium(&problem), 0.01);
                    let (evaluation, _) = problem.system.evaluate(&start, &start.values);
                    let here = problem.observables(&start, &evaluation);
                    for weights in [displacement, mixed] {
                        let condition = PathConstraint { weights, target: weights.dot(&here) };
                        let sizes = updates(&problem, &start, &condition);
                        let case = format!("{form:?}, {load:?}, {horizontal:?}, order {order}: {sizes:?}");
                        assert!(sizes[sizes.len() - 1] < 1e-9, "{case}");
                        for pair in sizes.windows(2).filter(|p| p[0] < 0.1) {
                            assert!(pair[1] <= 10.0 * pair[0] * pair[0] + 1e-10, "{case}");
                        }
                        most = most.max(sizes.len());
                    }
                }
            }
        }
    }
    // effort: from a start that far away, to round-off
    assert!(most <= 9, "{most} iterations");
}
