//! Nearest points against brute force, their derivatives against differences, and what happens where two are equally near.

use super::Substrate;
use super::heights::Heights;
use super::ridge::Ridge;
use super::round::Round;
use super::sinusoid::Sinusoid;
use super::surface::ClosestPoint;
use crate::adhesion::levels::curved::BodyShape;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::section::law::Law;
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::adhesion::substrate_response::GroundLaw;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use std::sync::Arc;

const PAPER: Sinusoid = Sinusoid { height: 8.0, wavelength: 100.0, offset: 13.0 };

fn rough() -> Heights {
    let places: Vec<f64> = (0..=60).map(|k| 5.0 * f64::from(k)).collect();
    let heights = places.iter().map(|x| 3.0 * (0.11 * x).sin() + 2.0 * (0.031 * x * x).cos()).collect();
    Heights::new(places, heights).unwrap()
}

/// A substrate, and y = f(x) of it.
type Case = (Substrate, Box<dyn Fn(f64) -> f64>);

fn substrates() -> Vec<Case> {
    let heights = Arc::new(rough());
    let same = heights.clone();
    let steep = Sinusoid { height: 30.0, wavelength: 40.0, offset: -3.0 };
    let round = Round { shape: BodyShape::Cylinder, radius: 35.0, offset: 120.0 };
    vec![
        (Substrate::Sinusoid(PAPER), Box::new(|s| PAPER.at(s)[0])),
        (Substrate::Sinusoid(steep), Box::new(move |s| steep.at(s)[0])),
        (Substrate::Ridge(Ridge { radius: 35.0, offset: 120.0 }), Box::new(|s| -(s - 120.0).powi(2) / 70.0)),
        (Substrate::Profile(heights), Box::new(move |s| same.at(s)[0])),
        (
            Substrate::Round(round),
            Box::new(|s| {
                if (s - 120.0f64).abs() < 35.0 { (35f64.powi(2) - (s - 120.0).powi(2)).sqrt() - 35.0 } else { f64::NAN }
            }),
        ),
    ]
}

/// The nearest of the points of the curve on a fine grid, refined by ever finer grids around each of the best.
fn brute_force(curve: &dyn Fn(f64) -> f64, x: f64, y: f64) -> f64 {
    let distance = |s: f64| (s - x).hypot(curve(s) - y);
    let far = 150.0;
    let coarse: Vec<f64> = (0..=30_000).map(|k| x - far + 2.0 * far * f64::from(k) / 30_000.0).collect();
    let least = coarse.iter().map(|&s| distance(s)).filter(|d| d.is_finite()).fold(f64::INFINITY, f64::min);
    let mut best = f64::INFINITY;
    for &start in coarse.iter().filter(|&&s| distance(s) < least + 1e-3) {
        let (mut center, mut half) = (start, 2.0 * far / 30_000.0);
        for _ in 0..24 {
            let near = (-10..=10).map(|k| center + half * f64::from(k) / 10.0);
            center =
                near.filter(|&s| distance(s).is_finite()).min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap();
            half *= 0.25;
        }
        best = best.min(distance(center));
    }
    best
}

/// Distances to 1e-12 of them, near the ground and far from it, over crests and over valleys beyond their centres of curvature.
#[test]
fn nearest_points_are_those_of_brute_force() {
    for (substrate, curve) in substrates() {
        for k in 0..60 {
            let x = 95.0 + 50.0 * (f64::from(k) * 0.618_033_9).fract();
            for above in [0.3, 2.0, 5.2, 14.0, 41.0, 90.0] {
                let y = curve(x) + above;
                let foot = substrate.project(x, y);
                assert_relative_eq!(foot.distance, brute_force(&curve, x, y), max_relative = 1e-12);
                // the foot lies on the curve and the line to it is square to that
                let (fx, fy) = (x + foot.distance * foot.sin, y - foot.distance * foot.cos);
                assert_abs_diff_eq!(fx, foot.place, epsilon = 1e-9);
                assert_abs_diff_eq!(fy, curve(foot.place), epsilon = 1e-9);
                assert!(foot.second_distance >= foot.distance * (1.0 - 1e-14));
            }
        }
    }
}

/// ∇d = n, ∇φ = μ t and the change of μ, by differences of fourth order.
#[test]
fn distance_and_angle_change_as_derived() {
    for (substrate, curve) in substrates() {
        for k in 0..40 {
            let x = 96.3 + 48.0 * (f64::from(k) * 0.754_877_7).fract();
            for above in [0.3, 3.0, 6.0] {
                let y = curve(x) + above;
                let foot = substrate.project(x, y);
                let step = 1e-3;
                let slope = |pick: &dyn Fn(&ClosestPoint) -> f64, dx: f64, dy: f64| {
                    let at = |k: f64| pick(&substrate.project(x + k * step * dx, y + k * step * dy));
                    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step)
                };
                let angle = |foot: &ClosestPoint| foot.sin.atan2(foot.cos);
                let widened = 1.0 / (1.0 - foot.curvature * foot.distance);
                let (s, c) = (foot.sin, foot.cos);
                let (along, across) = ((c, s), (-s, c));
                assert_abs_diff_eq!(slope(&|f| f.distance, along.0, along.1), 0.0, epsilon = 1e-9);
                assert_abs_diff_eq!(slope(&|f| f.distance, across.0, across.1), 1.0, epsilon = 1e-9);
                let turn = foot.curvature * widened;
                assert_abs_diff_eq!(slope(&angle, along.0, along.1), turn, epsilon = 2e-7);
                assert_abs_diff_eq!(slope(&angle, across.0, across.1), 0.0, epsilon = 2e-7);
                if !matches!(substrate, Substrate::Profile(_)) {
                    let changes = foot.curvature_slope * widened;
                    assert_abs_diff_eq!(
                        slope(&|f| f.curvature, along.0, along.1),
                        changes,
                        epsilon = 1e-7 + 1e-6 * changes.abs()
                    );
                }
            }
        }
    }
}

/// Above a valley, farther than its centre of curvature, two points of the flanks are equally near. The distance is continuous
/// there; the force of a section jumps by no more than what is stated at [`ClosestPoint::second_distance`].
#[test]
fn above_the_centre_of_a_valley_two_points_are_equally_near() {
    let substrate = Substrate::Sinusoid(PAPER);
    let valley = PAPER.offset + 50.0;
    let radius = PAPER.radius();
    assert_relative_eq!(radius, 63.3257, max_relative = 1e-6);
    // below the centre of curvature there is one, at the bottom
    let below = substrate.project(valley, -8.0 + 0.99 * radius);
    assert_abs_diff_eq!(below.distance, 0.99 * radius, epsilon = 1e-12);
    let law = LineLaw {
        half_space: HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 },
        height: 10.0,
        law: Law::BodyForce,
        line_load: LineLoad::Full,
        far_face: true,
    };
    let strongest = law.half_space.traction(law.half_space.strongest_gap()).abs();
    let ground = GroundLaw { law, substrate: substrate.clone() };
    let mut largest = 0.0f64;
    for above in [1.001, 1.01, 1.1, 1.3, 2.0, 4.0] {
        let y = -8.0 + above * radius;
        let feet = [-1e-9, 1e-9].map(|aside| substrate.project(valley + aside, y));
        assert!(feet[0].place < valley && feet[1].place > valley);
        assert_relative_eq!(feet[0].distance, feet[1].distance, max_relative = 1e-9);
        assert_relative_eq!(feet[0].second_distance, feet[0].distance, max_relative = 1e-8);
        let [left, right] = [-1e-9, 1e-9].map(|aside| ground.response(10.0, [valley + aside, y - 5.0], [0.0, 1.0]));
        assert_relative_eq!(left.energy, right.energy, max_relative = 1e-8);
        assert_abs_diff_eq!(left.gradient[1], right.gradient[1], epsilon = 1e-8 * strongest);
        largest = largest.max((left.gradient[0] - right.gradient[0]).hypot(left.gradient[2] - right.gradient[2]));
    }
    println!("largest jump over the largest attraction {:.2e}", largest / strongest);
    let bound = 2.0 * law.half_space.traction(radius - 5.0).abs();
    println!("bound {:.2e}", bound / strongest);
    assert!(largest < 6e-7 * strongest, "{largest}");
}

/// On a sphere of 1e12 nm, a wave of 1e-9 nm and a table of zeros as on flat ground.
#[test]
fn nearly_flat_ground_is_flat() {
    let law = |substrate| GroundLaw {
        law: LineLaw {
            half_space: HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 },
            height: 10.0,
            law: Law::BodyForce,
            line_load: LineLoad::Full,
            far_face: true,
        },
        substrate,
    };
    let flat = law(Substrate::Flat);
    let nearly = [
        (Substrate::Round(Round { shape: BodyShape::Sphere, radius: 1e12, offset: 0.0 }), 1e-7),
        (Substrate::Sinusoid(Sinusoid { height: 1e-9, wavelength: 100.0, offset: 3.0 }), 1e-7),
        (Substrate::Profile(Arc::new(Heights::new(vec![0.0, 7.0, 100.0], vec![0.0; 3]).unwrap())), 1e-12),
    ];
    for (substrate, order) in nearly {
        let ground = law(substrate);
        for (gap, rotation) in [(0.26, 0.0), (0.3, 0.2), (2.0, -1.3f64)] {
            let sides = [rotation.sin(), rotation.cos()];
            let (found, wanted) = (ground.response(10.0, [40.0, gap], sides), flat.response(10.0, [40.0, gap], sides));
            assert_relative_eq!(found.energy, wanted.energy, max_relative = order);
            for f in 0..3 {
                assert_abs_diff_eq!(found.gradient[f], wanted.gradient[f], epsilon = order);
                for g in 0..3 {
                    assert_abs_diff_eq!(found.tangent[f][g], wanted.tangent[f][g], epsilon = 50.0 * order);
                }
            }
        }
    }
}

/// The line at a distance keeps it, and a ball that rolls does not enter a valley narrower than itself: there the line has a corner, across
/// which a chord is shorter.
#[test]
fn a_line_at_a_distance() {
    let places: Vec<f64> = (0..200).map(|k| f64::from(k) * 1.3).collect();
    for (substrate, distance) in [(Substrate::Sinusoid(PAPER), 5.25), (Substrate::Profile(Arc::new(rough())), 5.25)] {
        let line = substrate.along(distance, &places);
        assert_abs_diff_eq!(line[0][0], 0.0, epsilon = 1e-9);
        for (pair, [x, y, _]) in line.windows(2).zip(&line) {
            assert_abs_diff_eq!(substrate.project(*x, *y).distance, distance, epsilon = 1e-4);
            let chord = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
            assert!(chord < 1.3 + 1e-3 && chord > 0.65, "{chord}");
        }
    }
}

#[test]
fn a_table_that_is_none_is_refused() {
    let wrong =
        |places: &[f64], heights: &[f64]| Heights::new(places.to_vec(), heights.to_vec()).unwrap_err().to_string();
    assert_eq!(wrong(&[0.0, 1.0], &[0.0, 1.0]), "has 2 rows; it takes 3 to 20000");
    assert_eq!(wrong(&[0.0, 0.0], &[0.0, 1.0]), "has in row 2 `x_nm` = 0, which does not ascend");
    assert_eq!(wrong(&[0.0], &[f64::NAN]), "has in row 1 `height_nm` = NaN, which is not from -1e9 to 1e9");
    assert_eq!(wrong(&[0.0, 1.0, 2.0], &[0.0]), "has 3 places and 1 heights");
}
