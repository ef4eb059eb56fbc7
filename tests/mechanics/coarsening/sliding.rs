//! The table of a spatula whose pad slides: a function of height and rotation of its end.
//!
//!        θ ⟲ /|P
//!          / |            P(u) at θ = 0 is the curve of scenes/spatula.toml
//!   _____/   u
//!   ////////////
//!
//! Reference: values of the pull of this spatula at a fixed rotation, converged to the digits printed by two methods.
//! Parameters: the default spatula, A_H = 1e-19 J, r0 = 0.4 nm; pressed by 10 nm, θ within ±0.1 rad, to 1e-3.
//! Expected: forces and moment within the bounds that the table states; forces are the gradient of its energy, and the work between two
//! places is the difference of their energies; it snaps off and on at its limits.

use super::{at, differences, spatula};
use peelkit::study::coarsening::{CoarseningOptions, PadEnd, TipRange, TipSheet, TipTable, coarsen};
use std::sync::OnceLock;

fn table() -> &'static TipTable {
    static TABLE: OnceLock<TipTable> = OnceLock::new();
    TABLE.get_or_init(|| {
        let range = TipRange { press: 10.0, rotation: [-0.1, 0.1], ..TipRange::SLIDING };
        coarsen(&spatula(), &CoarseningOptions { range, ..CoarseningOptions::of(PadEnd::Sliding) }).unwrap()
    })
}

const CURVE: [(f64, f64); 10] = [
    (0.0, 0.10137244),
    (25.0, 0.44211814),
    (50.0, 0.86200850),
    (100.0, 2.15096220),
    (150.0, 4.22128380),
    (200.0, 4.75625911),
    (250.0, 5.18794422),
    (300.0, 5.79432248),
    (350.0, 6.528724),
    (361.24302, 6.67038424),
];

#[test]
fn the_curve_at_a_fixed_rotation_is_that_of_a_pull() {
    let table = table();
    assert!(table.is_met());
    let bound = table.attached_errors.force;
    assert!(bound[0] <= 1e-3 * table.scales.force && bound[2] <= 1e-3 * table.scales.moment);
    for (normal, force) in CURVE {
        let found = table.response(TipSheet::Attached, at(normal, 0.0, 0.0));
        assert!((found.force[0] - force).abs() < bound[0], "{normal}: {} {force}", found.force[0]);
        assert_eq!(found.force[1], 0.0);
    }
    let peak = table.response(TipSheet::Attached, at(361.24302, 0.0, 0.0));
    assert!((peak.force[2] + 1521.33711).abs() < bound[2], "{}", peak.force[2]);
    let limit = table.attached.limit(at(0.0, 0.0, 0.0));
    assert!((limit.normal - 364.418953).abs() < 1e-6 + table.attached_errors.limit, "{limit:?}");
    assert!((limit.force[0] - 6.4704105).abs() < bound[0], "{limit:?}");
    let there = table.attached.response(at(limit.normal, 0.0, 0.0));
    assert!((there.force[0] - limit.force[0]).abs() < 1e-3 * 6.67, "{there:?}");
}

#[test]
fn forces_are_the_gradient_of_one_energy() {
    let table = table();
    for k in 1..40 {
        let share = |ratio: f64| (ratio * f64::from(k)).fract();
        let rotation = 0.2 * share(0.618034) - 0.1;
        for sheet in [&table.attached, &table.detached] {
            let [begin, end] = sheet.ends(at(0.0, 0.0, rotation));
            let place = at(begin + 0.99 * share(0.7548777) * (end - begin), 0.0, rotation);
            let [force, stiffness] = differences(sheet, place);
            assert!(force < 1e-5 && stiffness < 1e-4, "{place}: {force:.1e} {stiffness:.1e}");
        }
    }
}

/// Work by Simpson's rule, of the normal force on the way up and of the moment on the way round.
#[test]
fn work_is_the_difference_of_energies() {
    let sheet = &table().attached;
    let simpson = |from: f64, to: f64, f: &dyn Fn(f64) -> f64| {
        let (count, step) = (2000, (to - from) / 2000.0);
        let weight = |k: usize| if k == 0 || k == count { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
        (0..=count).map(|k| weight(k) * f(from + k as f64 * step)).sum::<f64>() * step / 3.0
    };
    let energy = |normal, rotation| sheet.response(at(normal, 0.0, rotation)).energy;
    let lifted = simpson(20.0, 340.0, &|u| sheet.response(at(u, 0.0, 0.0)).force[0]);
    assert!((lifted - (energy(340.0, 0.0) - energy(20.0, 0.0))).abs() < 1e-4, "{lifted}");
    let turned = simpson(-0.09, 0.09, &|t| sheet.response(at(200.0, 0.0, t)).force[2]);
    assert!((turned - (energy(200.0, 0.09) - energy(200.0, -0.09))).abs() < 1e-5, "{turned}");
}

#[test]
fn it_snaps_off_and_on_at_its_limits() {
    let table = table();
    let place = at(0.0, 0.0, 0.05);
    let ([_, off], [far, on]) = (table.attached.ends(place), table.detached.ends(place));
    assert!(on < far && far < off);
    let next = |before, normal| table.branch(before, at(normal, 0.0, 0.05));
    assert_eq!(next(TipSheet::Attached, off - 0.01), TipSheet::Attached);
    assert_eq!(next(TipSheet::Attached, off + 0.01), TipSheet::Detached);
    assert_eq!(next(TipSheet::Detached, on + 0.01), TipSheet::Detached);
    assert_eq!(next(TipSheet::Detached, on - 0.01), TipSheet::Attached);
    assert!(table.released(place) > 0.0);
    // farther away the force falls off to nothing, and what is neglected there is small
    let farther = table.response(TipSheet::Detached, at(far + 1.0, 0.0, 0.05)).force[0];
    assert!(farther > 0.0 && farther < table.neglected_force, "{farther}");
    assert_eq!(table.response(TipSheet::Detached, at(far + 300.0, 0.0, 0.05)).force, [0.0; 3]);
    let left = table.response(TipSheet::Detached, at(far - 1e-6, 0.0, 0.05)).force[0];
    assert!((left - table.neglected_force).abs() < 1e-6 && left < 1e-3 * table.scales.force, "{left}");
    // a little beyond its limit the branch goes on, with a force near to that at the limit
    let beyond = table.attached.response(at(off + 0.5, 0.0, 0.05));
    let limit = table.attached.response(at(off, 0.0, 0.05));
    assert!((beyond.force[0] - limit.force[0]).abs() < 0.2, "{} {}", beyond.force[0], limit.force[0]);
}

/// What is halved is what has the error. The moment is a derivative by θ: its error at the nodes once halved the branch in s up to 1041 nodes, at tolerances that met
/// few cells of θ.
#[test]
fn nodes_are_laid_where_the_error_is() {
    let range = TipRange { press: 100.0, rotation: [-0.4, 0.65], ..TipRange::SLIDING };
    for (tolerance, most) in [(1e-1, 300), (3e-2, 400), (2e-2, 450), (1.5e-2, 450), (1e-2, 500), (1e-3, 1100)] {
        let options = CoarseningOptions { range, tolerance, ..CoarseningOptions::of(PadEnd::Sliding) };
        let table = coarsen(&spatula(), &options).unwrap();
        let nodes = [&table.attached, &table.detached].map(|sheet| sheet.table().nodes.len());
        assert!(table.is_met(), "{tolerance}: {:?}", table.attached_errors);
        assert!(nodes[0] + nodes[1] <= most, "{tolerance}: {nodes:?}");
    }
}
