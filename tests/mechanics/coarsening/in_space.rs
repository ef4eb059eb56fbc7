//! A tip in space: its plane stands on the substrate, in any azimuth.
//!
//!        y  |  / e turned with the end
//!           | /
//!           |/____ e = (cos β, 0, sin β)
//!
//! Reference: differences of the energy and of its gradient, with turns as exponentials; the planar table.
//! Expected: gradient and second derivatives are those of the energy at any rotation, out of the plane too; a turn about the normal of the plane
//! is θ; what turns with the azimuth changes nothing.

use super::spatula;
use peelkit::beam::rotation::{Quaternion, exponential, product};
use peelkit::study::coarsening::{CoarseningOptions, OutOfPlane, PadEnd, SpatulaTip, TipRange, TipSheet, coarsen};
use std::sync::Arc;

fn tip(azimuth: f64, directors: Quaternion) -> SpatulaTip {
    let range = TipRange { press: 5.0, rotation: [-0.05, 0.05], ..TipRange::SLIDING };
    let options = CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) };
    let table = Arc::new(coarsen(&spatula(), &options).unwrap());
    SpatulaTip { table, azimuth, directors, out_of_plane: OutOfPlane { displacement: 0.02, rotation: 50.0 } }
}

#[test]
fn derivatives_are_those_of_the_energy_in_space() {
    let first = exponential([0.3, -0.2, 0.5]);
    let tip = tip(0.7, first);
    let at = |delta: [f64; 3], turn: [f64; 3]| {
        let place = [12.0 + delta[0], 180.0 + delta[1], -7.0 + delta[2]];
        let directors = product(product(exponential([0.03, 0.06, -0.02]), first), exponential(turn));
        tip.response(TipSheet::Attached, place, directors)
    };
    let here = at([0.0; 3], [0.0; 3]);
    for i in 0..6 {
        let step = if i < 3 { 1e-3 } else { 1e-5 };
        let moved = |step: f64| {
            let mut way = [0.0; 6];
            way[i] = step;
            at([way[0], way[1], way[2]], [way[3], way[4], way[5]])
        };
        let (ahead, behind) = (moved(step), moved(-step));
        let slope = (ahead.energy - behind.energy) / (2.0 * step);
        assert!((slope - here.gradient[i]).abs() < 1e-5 * (1.0 + slope.abs()), "{i}: {slope} {}", here.gradient[i]);
        let bend = (ahead.energy + behind.energy - 2.0 * here.energy) / (step * step);
        let own = here.hessian[i][i];
        assert!((bend - own).abs() < 1e-2 * (1.0 + own.abs()), "{i}: {bend} {own}");
        for j in 0..6 {
            assert!((here.hessian[i][j] - here.hessian[j][i]).abs() < 1e-9 * (1.0 + own.abs()));
            if i < 3 {
                // the gradient by turns is one in the axes at the state, which places leave alone
                let slope = (ahead.gradient[j] - behind.gradient[j]) / (2.0 * step);
                let known = here.hessian[i][j];
                assert!((slope - known).abs() < 1e-5 * (1.0 + known.abs()), "{i} {j}: {slope} {known}");
            }
        }
    }
}

#[test]
fn a_turn_about_the_normal_of_its_plane_is_its_rotation() {
    for azimuth in [0.0, 1.1, -2.5] {
        let tip = tip(azimuth, exponential([0.0, -azimuth, 0.0]));
        let [axis, _, across] = tip.turned_axes(tip.directors);
        let turned = product(exponential(across.map(|part| 0.04 * part)), tip.directors);
        let place = [5.0 * axis[0], 200.0, 5.0 * axis[2]];
        let found = tip.in_plane(place, turned);
        assert!((found.rotation - 0.04).abs() < 1e-12 && (found.lateral - 5.0).abs() < 1e-12);
        assert_eq!(found.normal, 200.0);
        let response = tip.response(TipSheet::Attached, place, turned);
        let planar = tip.table.response(TipSheet::Attached, found);
        assert!((response.energy - planar.energy).abs() < 1e-9);
        let moment: f64 = response.gradient[3..].iter().map(|part| part * part).sum::<f64>().sqrt();
        assert!((moment - planar.force[2].abs()).abs() < 1e-9 * moment);
        assert_eq!(tip.branch(TipSheet::Attached, [0.0, 500.0, 0.0], turned), TipSheet::Detached);
    }
}
