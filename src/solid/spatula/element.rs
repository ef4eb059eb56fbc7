//! The element: cubic along S, quadratic through the thickness and across.
//!
//! x and y of the body are interpolated as displacements are, so that a rotation about z is one of them and costs no energy; z is exact at the
//! Gauss points. With gradients G_i of the functions by the reference, g_i = F⁻ᵀ G_i and c = Λ ln J - μ the tangent is
//!
//!   K_ia,jb = ∫ δ_ab μ G_i·G_j + Λ g_ia g_jb - c g_ib g_ja dV,
//!
//! of which the first term never changes. The ground acts per area of the reference, as that is projected on its level: [`super::ground`].

use super::geometry::{InPlane, SolidGeometry};
use super::ground::{GroundResponse, SolidGround};
use super::layout::{ACROSS, ALONG, ELEMENT, FUNCTIONS, THROUGH};
use super::material::{NeoHookean, Vector};
use crate::number::gauss::gauss_legendre;
use std::num::NonZeroUsize;

/// Points of the volume along S, through the thickness and across.
const BULK: [usize; 3] = [4, 3, 3];
/// Points of the underside across.
const FACE_ACROSS: usize = 4;
/// Functions that do not vanish on the underside.
const ON_FACE: usize = ALONG * ACROSS;
/// Both halves of the body.
const HALVES: f64 = 2.0;

/// A point of the volume.
#[derive(Clone, Debug)]
struct BulkPoint {
    /// dV, nm³, of both halves
    volume: f64,
    /// ∂N/∂x, ∂N/∂y, ∂N/∂z of each function
    gradient: Box<[[f64; FUNCTIONS]; 3]>,
}

/// A point of the underside.
#[derive(Clone, Debug)]
pub(super) struct FacePoint {
    /// Projected area, nm², of both halves
    pub area: f64,
    /// x and y in the reference, nm
    pub place: [f64; 2],
    /// N of the functions that do not vanish there
    pub values: [f64; ON_FACE],
}

/// What never changes of an element.
#[derive(Clone, Debug)]
pub(super) struct Element {
    bulk: Vec<BulkPoint>,
    pub face: Vec<FacePoint>,
    /// μ ∫ G_i·G_j dV
    laplacian: Vec<f64>,
}

/// What an element adds.
#[derive(Clone, Debug)]
pub(super) struct ElementWork {
    pub energy: f64,
    pub residual: [f64; ELEMENT],
    /// Its upper triangle, function by function
    pub tangent: Vec<f64>,
    blocks: [Vec<f64>; 6],
    points: Vec<TangentPoint>,
}

impl Default for ElementWork {
    fn default() -> Self {
        Self {
            energy: 0.0,
            residual: [0.0; ELEMENT],
            tangent: Vec::new(),
            blocks: Default::default(),
            points: Vec::new(),
        }
    }
}

/// The blocks of xx, xy and yy.
const IN_PLANE: [usize; 3] = [0, 1, 3];
/// Which components a block couples.
const PAIRS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

/// Where an element lies.
pub(super) struct ElementPlace<'a> {
    /// S of its two stations, nm
    pub stations: [f64; 2],
    /// x and y of the axis there, nm
    pub axis: [[f64; 2]; 2],
    /// t of its two sides
    pub sides: [f64; 2],
    /// Points along S of its underside; none where nothing adheres
    pub face_points: usize,
    pub geometry: &'a SolidGeometry,
    pub material: &'a NeoHookean,
}

/// Values of a function and of its derivative.
pub(super) type Jet = [f64; 2];

/// The functions along S of an element of this length at ξ in [-1, 1]; those of slopes are of slopes by S.
fn hermite(xi: f64, length: f64) -> [Jet; ALONG] {
    let (x2, x3, half) = (xi * xi, xi * xi * xi, 0.5 * length);
    [
        [0.25 * (2.0 - 3.0 * xi + x3), 0.75 * (x2 - 1.0)],
        [0.25 * half * (1.0 - xi - x2 + x3), 0.25 * half * (3.0 * x2 - 2.0 * xi - 1.0)],
        [0.25 * (2.0 + 3.0 * xi - x3), 0.75 * (1.0 - x2)],
        [0.25 * half * (x3 + x2 - xi - 1.0), 0.25 * half * (3.0 * x2 + 2.0 * xi - 1.0)],
    ]
}

/// Quadratic functions of the nodes -1, 0 and 1.
pub(super) fn quadratic(eta: f64) -> [Jet; 3] {
    [[0.5 * eta * (eta - 1.0), eta - 0.5], [1.0 - eta * eta, -2.0 * eta], [0.5 * eta * (eta + 1.0), eta + 0.5]]
}

/// Each function of an element with its derivatives by ξ, ζ and η.
fn functions(xi: f64, zeta: f64, eta: f64, length: f64) -> [[f64; 4]; FUNCTIONS] {
    let (along, through, across) = (hermite(xi, length), quadratic(zeta), quadratic(eta));
    std::array::from_fn(|k| {
        let [a, a1] = along[k / (THROUGH * ACROSS)];
        let [b, b1] = through[k / ACROSS % THROUGH];
        let [c, c1] = across[k % ACROSS];
        [a * b * c, a1 * b * c, a * b1 * c, a * b * c1]
    })
}

fn gauss(points: usize) -> Vec<(f64, f64)> {
    gauss_legendre(NonZeroUsize::new(points).unwrap_or(NonZeroUsize::MIN))
}

impl ElementPlace<'_> {
    fn length(&self) -> f64 {
        self.stations[1] - self.stations[0]
    }

    fn t(&self, eta: f64) -> f64 {
        0.5 * (self.sides[0] * (1.0 - eta) + self.sides[1] * (1.0 + eta))
    }

    /// What x and y are interpolated by: of each function.
    pub(crate) fn coefficients(&self) -> [[f64; 2]; FUNCTIONS] {
        std::array::from_fn(|k| {
            let (along, zeta) = (k / (THROUGH * ACROSS), (k / ACROSS % THROUGH) as f64 - 1.0);
            let t = self.t((k % ACROSS) as f64 - 1.0);
            let end = along / 2;
            let InPlane { place, slope } = self.geometry.in_plane(self.stations[end], self.axis[end], zeta, t);
            if along.is_multiple_of(2) { place } else { slope }
        })
    }

    /// Derivatives of x, y and z by ξ, ζ and η, row by row of these, with x and y.
    fn jacobian(
        &self,
        coefficients: &[[f64; 2]; FUNCTIONS],
        functions: &[[f64; 4]; FUNCTIONS],
        [xi, zeta, eta]: Vector,
    ) -> ([Vector; 3], [f64; 2]) {
        let mut rows = [[0.0; 3]; 3];
        let mut at = [0.0; 2];
        for (own, of) in coefficients.iter().zip(functions) {
            at = [at[0] + own[0] * of[0], at[1] + own[1] * of[0]];
            for (row, derivative) in rows.iter_mut().zip(&of[1..]) {
                (row[0], row[1]) = (row[0] + own[0] * derivative, row[1] + own[1] * derivative);
            }
        }
        let place = self.stations[0] + 0.5 * self.length() * (1.0 + xi);
        let z = self.geometry.across(place, zeta, self.t(eta));
        (rows[0][2], rows[1][2]) = (0.5 * self.length() * z.along, z.through);
        rows[2][2] = 0.5 * (self.sides[1] - self.sides[0]) * z.across;
        (rows, at)
    }

    /// The determinant of these derivatives at (ξ, ζ, η), and ∂N/∂x, ∂N/∂y, ∂N/∂z of each function.
    pub(crate) fn gradients(&self, coefficients: &[[f64; 2]; FUNCTIONS], at: Vector) -> (f64, [[f64; FUNCTIONS]; 3]) {
        let [xi, zeta, eta] = at;
        let functions = functions(xi, zeta, eta, self.length());
        let (rows, _) = self.jacobian(coefficients, &functions, at);
        let [of_xi, of_zeta, of_eta] =
            [cross(&rows[1], &rows[2]), cross(&rows[2], &rows[0]), cross(&rows[0], &rows[1])];
        let determinant = dot(&rows[0], &of_xi);
        let mut gradients = [[0.0; FUNCTIONS]; 3];
        for (k, [_, a, b, c]) in functions.iter().enumerate() {
            for i in 0..3 {
                gradients[i][k] = (a * of_xi[i] + b * of_zeta[i] + c * of_eta[i]) / determinant;
            }
        }
        (determinant, gradients)
    }

    /// Values of the functions at (ξ, ζ, η).
    pub(crate) fn values(&self, [xi, zeta, eta]: Vector) -> [f64; FUNCTIONS] {
        functions(xi, zeta, eta, self.length()).map(|[value, ..]| value)
    }
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The same over the functions, in four sums side by side.
#[inline(always)]
fn dot_of_functions(a: &[f64; FUNCTIONS], b: &[f64; FUNCTIONS]) -> f64 {
    let mut sums = [0.0; 4];
    for (a, b) in a.as_chunks::<4>().0.iter().zip(b.as_chunks::<4>().0) {
        for l in 0..4 {
            sums[l] += a[l] * b[l];
        }
    }
    sums[0] + sums[1] + (sums[2] + sums[3])
}

impl Element {
    pub(crate) fn new(place: &ElementPlace) -> Self {
        let coefficients = place.coefficients();
        let [along, through, across] = BULK.map(gauss);
        let mut element = Self { bulk: Vec::new(), face: Vec::new(), laplacian: vec![0.0; FUNCTIONS * FUNCTIONS] };
        for &(xi, w) in &along {
            for &(zeta, v) in &through {
                for &(eta, u) in &across {
                    let (determinant, gradient) = place.gradients(&coefficients, [xi, zeta, eta]);
                    let gradient = Box::new(gradient);
                    element.bulk.push(BulkPoint { volume: HALVES * w * v * u * determinant, gradient });
                }
            }
        }
        for point in &element.bulk {
            let factor = place.material.shear * point.volume;
            for i in 0..FUNCTIONS {
                for j in 0..FUNCTIONS {
                    let product: f64 = point.gradient.iter().map(|gradient| gradient[i] * gradient[j]).sum();
                    element.laplacian[i * FUNCTIONS + j] += factor * product;
                }
            }
        }
        if place.face_points > 0 {
            for (xi, w) in gauss(place.face_points) {
                for (eta, u) in gauss(FACE_ACROSS) {
                    let functions = functions(xi, -1.0, eta, place.length());
                    let (rows, at) = place.jacobian(&coefficients, &functions, [xi, -1.0, eta]);
                    // the normal off the body points down where the ground is seen
                    let projected = rows[0][0] * rows[2][2] - rows[0][2] * rows[2][0];
                    let values = std::array::from_fn(|k| functions[Self::on_face(k)][0]);
                    element.face.push(FacePoint { area: HALVES * w * u * projected.max(0.0), place: at, values });
                }
            }
        }
        element
    }

    /// The function of one of the underside.
    pub(crate) fn on_face(index: usize) -> usize {
        index / ACROSS * THROUGH * ACROSS + index % ACROSS
    }

    /// Values of the functions along S and their derivatives by ξ, in an element of this length.
    pub(crate) fn along(xi: f64, length: f64) -> [Jet; ALONG] {
        hermite(xi, length)
    }

    /// Volume of both halves, nm³.
    pub(crate) fn volume(&self) -> f64 {
        self.bulk.iter().map(|point| point.volume).sum()
    }

    /// Of displacements, three numbers a function: energy and residual, and the tangent where it is asked for.
    pub(crate) fn at(
        &self,
        moved: &[f64; ELEMENT],
        material: &NeoHookean,
        ground: &SolidGround,
        tangent: bool,
        work: &mut ElementWork,
    ) {
        let own: [[f64; FUNCTIONS]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| moved[3 * k + i]));
        let mut residual = [[0.0; FUNCTIONS]; 3];
        work.energy = 0.0;
        if tangent {
            work.points.clear();
            for (block, (a, b)) in work.blocks.iter_mut().zip(PAIRS) {
                block.clear();
                if a == b { block.extend_from_slice(&self.laplacian) } else { block.resize(FUNCTIONS * FUNCTIONS, 0.0) }
            }
        }
        work.energy += add_stresses(&self.bulk, &own, material, &mut residual, tangent.then_some(&mut work.points));
        if tangent {
            add_points(&work.points, &mut work.blocks);
        }
        for point in &self.face {
            let GroundResponse { energy, gradient, hessian } = ground.at(Self::place(point, moved));
            work.energy += point.area * energy;
            for i in 0..ON_FACE {
                let value = point.area * point.values[i];
                (0..2).for_each(|axis| residual[axis][Self::on_face(i)] += gradient[axis] * value);
                if tangent {
                    for (block, by) in IN_PLANE.into_iter().zip(hessian).filter(|(_, by)| *by != 0.0) {
                        let row = &mut work.blocks[block][Self::on_face(i) * FUNCTIONS..][..FUNCTIONS];
                        (0..ON_FACE).for_each(|j| row[Self::on_face(j)] += by * value * point.values[j]);
                    }
                }
            }
        }
        for k in 0..FUNCTIONS {
            for i in 0..3 {
                work.residual[3 * k + i] = residual[i][k];
            }
        }
        if tangent {
            work.gather();
        }
    }

    /// Where a point of the underside is at these displacements, x and y, nm.
    pub(crate) fn place(point: &FacePoint, moved: &[f64; ELEMENT]) -> [f64; 2] {
        let of = |axis: usize| {
            let all = (0..ON_FACE).map(|k| moved[3 * Self::on_face(k) + axis] * point.values[k]);
            point.place[axis] + all.sum::<f64>()
        };
        [of(0), of(1)]
    }
}

/// What a point of the volume adds to the tangent: w (Λ g_ia g_jb - c g_ib g_ja).
#[derive(Clone, Debug)]
struct TangentPoint {
    /// g, by component
    spatial: [[f64; FUNCTIONS]; 3],
    /// w Λ and w c
    factors: [f64; 2],
}

impl TangentPoint {
    #[inline(always)]
    fn new(point: &BulkPoint, inverse: &[Vector; 3], first: f64, pressure: f64) -> Self {
        let [gx, gy, gz] = &*point.gradient;
        let mut spatial = [[0.0; FUNCTIONS]; 3];
        // loops and not closures: these are not compiled for the vector units that the rest is compiled for
        for a in 0..3 {
            let [x, y, z] = inverse[a];
            for k in 0..FUNCTIONS {
                spatial[a][k] = x * gx[k] + y * gy[k] + z * gz[k];
            }
        }
        Self { spatial, factors: [point.volume * first, point.volume * pressure] }
    }
}

/// Adds the forces of the stresses of all points, and keeps what they add to the tangent where that is asked for; returns their energy.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx512f+fma", "x86_64+avx2+fma"))
)]
fn add_stresses(
    bulk: &[BulkPoint],
    moved: &[[f64; FUNCTIONS]; 3],
    material: &NeoHookean,
    residual: &mut [[f64; FUNCTIONS]; 3],
    mut points: Option<&mut Vec<TangentPoint>>,
) -> f64 {
    let mut energy = 0.0;
    for point in bulk {
        let mut h = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                h[i][j] = dot_of_functions(&moved[i], &point.gradient[j]);
            }
        }
        let response = material.at(&h);
        let stress = material.stress(&h, &response);
        energy += point.volume * response.energy;
        let [gx, gy, gz] = &*point.gradient;
        for i in 0..3 {
            let [x, y, z] = [0, 1, 2].map(|j| point.volume * stress[i][j]);
            for k in 0..FUNCTIONS {
                residual[i][k] += x * gx[k] + y * gy[k] + z * gz[k];
            }
        }
        if let Some(points) = &mut points {
            points.push(TangentPoint::new(point, &response.inverse, material.first, response.pressure));
        }
    }
    energy
}

/// Adds what all points add to the blocks, a row at a time, so that it is written once.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx512f+fma", "x86_64+avx2+fma"))
)]
fn add_points(points: &[TangentPoint], blocks: &mut [Vec<f64>; 6]) {
    for (block, (a, b)) in blocks.iter_mut().zip(PAIRS) {
        for (i, row) in block.as_chunks_mut::<FUNCTIONS>().0.iter_mut().enumerate() {
            let mut sum = *row;
            for TangentPoint { spatial, factors: [first, pressure] } in points {
                let (ga, gb) = (&spatial[a], &spatial[b]);
                let (one, other) = (first * ga[i], -pressure * gb[i]);
                for j in 0..FUNCTIONS {
                    sum[j] += one * gb[j] + other * ga[j];
                }
            }
            *row = sum;
        }
    }
}

impl ElementWork {
    /// The upper triangle of the tangent, from its blocks.
    fn gather(&mut self) {
        self.tangent.resize(ELEMENT * ELEMENT, 0.0);
        for (block, (a, b)) in self.blocks.iter().zip(PAIRS) {
            for i in 0..FUNCTIONS {
                for j in 0..FUNCTIONS {
                    let (row, column) = (3 * i + a, 3 * j + b);
                    let value = if a == b && i > j { continue } else { block[i * FUNCTIONS + j] };
                    let (row, column) = (row.min(column), row.max(column));
                    self.tangent[row * ELEMENT + column] = value;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::levels::half_space::HalfSpace;
    use crate::adhesion::substrate::Substrate;
    use crate::beam::varying::{BeamGeometry, SectionGeometry};
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use std::sync::Arc;

    /// Widens, thickens, gets round and turns up, over 40 nm.
    #[derive(Clone, Debug)]
    struct Neck;

    impl BeamGeometry for Neck {
        fn length(&self) -> f64 {
            40.0
        }
        fn breaks(&self) -> Vec<f64> {
            Vec::new()
        }
        fn at(&self, place: f64) -> SectionGeometry {
            let t = place / 40.0;
            SectionGeometry {
                width: 20.0 + 5.0 * t * t,
                height: [10.0 + 4.0 * t * t, 8.0 * t / 40.0, 8.0 / 1600.0],
                roundness: 0.7 * t * t,
                underside: [0.5 * t * t, t / 40.0],
            }
        }
    }

    const HALF_SPACE: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    fn level() -> SolidGround {
        SolidGround { half_space: HALF_SPACE, substrate: Substrate::Flat }
    }

    const STATIONS: [f64; 2] = [10.0, 22.0];

    fn with(face_points: usize, of: impl FnOnce(&ElementPlace, &Element, &NeoHookean)) {
        let material = NeoHookean::new(2.0, 0.2);
        let geometry = SolidGeometry::new(Arc::new(Neck), HALF_SPACE.equilibrium_gap());
        let axis = geometry.axis(&[0.0, STATIONS[0], STATIONS[1]]);
        let place = ElementPlace {
            stations: STATIONS,
            axis: [axis[1], axis[2]],
            sides: [0.4, 1.0],
            face_points,
            geometry: &geometry,
            material: &material,
        };
        of(&place, &Element::new(&place), &material);
    }

    #[test]
    fn rigid_motions_cost_nothing_at_any_angle() {
        with(0, |place, element, material| {
            let coefficients = place.coefficients();
            for angle in [0.01, 0.8, 2.6f64] {
                let (sin, cos) = angle.sin_cos();
                let moved = std::array::from_fn(|k| {
                    let [x, y] = coefficients[k / 3];
                    // a translation moves values, not slopes
                    let shift = if k / 3 / 9 % 2 == 0 { [7.0, -3.0] } else { [0.0; 2] };
                    match k % 3 {
                        0 => (cos - 1.0) * x - sin * y + shift[0],
                        1 => sin * x + (cos - 1.0) * y + shift[1],
                        _ => 0.0,
                    }
                });
                let mut work = ElementWork::default();
                element.at(&moved, material, &level(), false, &mut work);
                assert!(work.energy.abs() < 1e-12 * element.volume(), "{}", work.energy);
                assert!(work.residual.iter().all(|force| force.abs() < 1e-11), "{:?}", work.residual);
            }
        });
    }

    /// Waves of 8 nm, 50 nm long, 4 nm below.
    fn wavy() -> SolidGround {
        let mut substrate = Substrate::all().into_iter().find(|(name, _)| *name == "sinusoid").unwrap().1;
        for (key, value) in [("height", 8.0), ("wavelength", 50.0), ("offset", 3.0)] {
            *substrate.number(key).unwrap() = value;
        }
        SolidGround { half_space: HALF_SPACE, substrate }
    }

    #[test]
    fn the_residual_is_the_slope_of_the_energy_and_the_tangent_that_of_the_residual() {
        [level(), wavy()].into_iter().for_each(slopes_are_differences);
    }

    fn slopes_are_differences(ground: SolidGround) {
        with(6, |_, element, material| {
            let moved: [f64; ELEMENT] = std::array::from_fn(|k| {
                let size = if k / 27 % 2 == 0 { 0.2 } else { 0.01 };
                let lifted = if k % 3 == 1 && k / 27 % 2 == 0 { 0.5 } else { 0.0 };
                lifted + size * ((k * k) as f64).sin()
            });
            let at = |moved: &[f64; ELEMENT], tangent: bool| {
                let mut work = ElementWork::default();
                element.at(moved, material, &ground, tangent, &mut work);
                work
            };
            let own = at(&moved, true);
            let largest = own.tangent.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            for column in (0..ELEMENT).step_by(7) {
                let works = [-2e-4, -1e-4, 1e-4, 2e-4].map(|step| {
                    let mut moved = moved;
                    moved[column] += step;
                    at(&moved, false)
                });
                let slope = |of: &dyn Fn(&ElementWork) -> f64| {
                    let [a, b, c, d] = works.each_ref().map(of);
                    (8.0 * (c - b) - (d - a)) / 12e-4
                };
                assert_relative_eq!(
                    slope(&|work| work.energy),
                    own.residual[column],
                    epsilon = 1e-8,
                    max_relative = 1e-8
                );
                for row in 0..ELEMENT {
                    let (low, high) = (row.min(column), row.max(column));
                    let entry = own.tangent[low * ELEMENT + high];
                    assert_abs_diff_eq!(slope(&|work| work.residual[row]), entry, epsilon = 1e-8 * largest);
                }
            }
        });
    }

    #[test]
    fn the_underside_is_seen_from_below() {
        with(8, |place, element, _| {
            let area: f64 = element.face.iter().map(|point| point.area).sum();
            assert!(area > 0.0);
            // the same by many more points
            let mut expected = 0.0;
            for (xi, w) in gauss(20) {
                for (eta, u) in gauss(20) {
                    let functions = functions(xi, -1.0, eta, place.length());
                    let (rows, at) = place.jacobian(&place.coefficients(), &functions, [xi, -1.0, eta]);
                    assert!(at[1] > 0.0);
                    expected += HALVES * w * u * (rows[0][0] * rows[2][2] - rows[0][2] * rows[2][0]);
                }
            }
            assert_relative_eq!(area, expected, max_relative = 1e-9);
        });
    }
}
