//! The energy per length and its derivatives.
//!
//! Reference: dual numbers (num-dual) through the definition, with q made one of length one: Γ = Rᵀ r' - e1, K = 2
//! Im(q̄ ∘ q'), energy ½ (Γ, K - K0)·C (Γ, K - K0) + Ψ(y, b d2·e_y, h d3·e_y), Ψ of the rectangle from the four
//! corners as it is defined.
//!
//! Parameters: fields, slopes, stiffnesses and rest curvatures at random (a fixed seed), |q| between 0.5 and 1.5;
//! tilts that are not small, or the four corners cancel.
//!
//! Expected: energy, gradient and Hessian by all 14 numbers to 1e-11 of the largest; with adhesion to 1e-9, for what
//! the corners lose. Why: the derivatives were written by hand for q of any length.

use super::setup::Numbers;
use nalgebra::SVector;
use num_dual::{Dual2SVec64, DualNum, hessian};
use peelkit::adhesion::{HalfSpace, Law, LineLaw, LineLoad, SectionShape, SpatialSection};
use peelkit::beam::{SpatialDensity, SpatialProfile, Station};
use std::f64::consts::PI;

const HALF_SPACE: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
const SIZE: [f64; 2] = [6.0, 4.0];

type Dual = Dual2SVec64<14>;

fn definition(station: &Station, adheres: bool, v: &SVector<Dual, 14>) -> Dual {
    let length = (v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]).sqrt();
    let [w, x, y, z]: [Dual; 4] = std::array::from_fn(|k| v[3 + k] / length);
    // what changes the length of q does not turn it
    let [a, b, c, d]: [Dual; 4] = std::array::from_fn(|k| v[10 + k] / length);
    let two = |value: Dual| value * 2.0;
    let one = Dual::from_re(1.0);
    let d1 = [one - two(y * y + z * z), two(x * y + w * z), two(x * z - w * y)];
    let d2 = [two(x * y - w * z), one - two(x * x + z * z), two(y * z + w * x)];
    let d3 = [two(x * z + w * y), two(y * z - w * x), one - two(x * x + y * y)];
    let along = |d: [Dual; 3]| d[0] * v[7] + d[1] * v[8] + d[2] * v[9];
    let strains = [
        along(d1) - 1.0,
        along(d2),
        along(d3),
        two(w * b - x * a - y * d + z * c) - station.rest_curvature[0],
        two(w * c + x * d - y * a - z * b) - station.rest_curvature[1],
        two(w * d - x * c + y * b - z * a) - station.rest_curvature[2],
    ];
    let mut energy = Dual::from_re(0.0);
    for i in 0..6 {
        for j in 0..6 {
            energy += strains[i] * strains[j] * (0.5 * station.stiffness[i][j]);
        }
    }
    if adheres {
        let HalfSpace { hamaker_constant, equilibrium_distance: r0 } = HALF_SPACE;
        let corner = |r: Dual| {
            let ratio = r.recip() * r0;
            (ratio.powi(7) / 2520.0 - ratio / 6.0) * (hamaker_constant / (2.0 * PI * r0))
        };
        let (a, c) = (d2[1] * station.width, d3[1] * station.height);
        let (u, d) = ((a + c) * 0.5, (a - c) * 0.5);
        let sum = corner(v[1] - u) - corner(v[1] - d) - corner(v[1] + d) + corner(v[1] + u);
        energy += sum / (a * c) * (station.width * station.height);
    }
    energy
}

fn agrees(adheres: bool, most: f64) {
    let mut numbers = Numbers(if adheres { 31 } else { 13 });
    let law = LineLaw {
        half_space: HALF_SPACE,
        height: SIZE[1],
        law: Law::BodyForce,
        line_load: LineLoad::Full,
        far_face: true,
    };
    let section = SpatialSection::new(SectionShape::Rectangle, SIZE[0], law).unwrap();
    for case in 0..200 {
        let rest = numbers.several(3);
        let station = Station {
            stiffness: numbers.stiffness().0,
            rest_curvature: [rest[0], rest[1], rest[2]],
            width: SIZE[0],
            height: SIZE[1],
        };
        let mut v: [f64; 14] = std::array::from_fn(|_| numbers.next());
        // tilted by some 45 degrees both ways, and a little more or less
        let tilted = [0.8, 0.3, 0.3, 0.2];
        (0..4).for_each(|k| v[3 + k] = (1.0 + 0.4 * v[0]) * (tilted[k] + 0.1 * v[3 + k]));
        v[1] = 5.0 + 0.3 * v[1];
        let density = SpatialDensity {
            profile: SpatialProfile::Uniform(Box::new(station)),
            adhesion: adheres.then_some(section),
            held: None,
        };
        let (energy, gradient, tangent) = hessian(|v: SVector<Dual, 14>| definition(&station, adheres, &v), &v.into());
        let part = |from: usize| std::array::from_fn(|k| v[from + k]);
        let r = density.response(0.3, &part(0), &part(7));
        let size = tangent.amax().max(gradient.amax()).max(energy.abs());
        let close = |found: f64, wanted: f64, what: &str| {
            assert!((found - wanted).abs() <= most * size, "case {case}, {what}: {found} and {wanted} of {size}");
        };
        close(r.energy, energy, "energy");
        for i in 0..7 {
            close(r.by_value[i], gradient[i], "by a value");
            close(r.by_slope[i], gradient[7 + i], "by a slope");
            for j in 0..7 {
                close(r.value_value[i][j], tangent[(i, j)], "by two values");
                close(r.value_slope[i][j], tangent[(i, 7 + j)], "by a value and a slope");
                close(r.slope_value[i][j], tangent[(7 + i, j)], "by a slope and a value");
                close(r.slope_slope[i][j], tangent[(7 + i, 7 + j)], "by two slopes");
            }
        }
    }
}

#[test]
fn what_is_stored() {
    agrees(false, 1e-11);
}

#[test]
fn with_adhesion() {
    agrees(true, 1e-9);
}
