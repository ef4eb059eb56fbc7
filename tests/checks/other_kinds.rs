//! Scenes of other kinds that failed: displacement-controlled tests, friction, ground that is not flat.
//!
//! Reference: what a scene can end in at all; for the wave the numbers of the mesh that missed its bounds, for a whole cycle the work that it loses. Parameters:
//! scenes of the sample of `peel verify`, seed 77, each named by its kind and number, and the strip on waves of `scenes/`. Expected: each ends by a rule with
//! a name; before, all failed at 1e-6.

use super::followed_again::ends_of;
use peelkit::study::{Accuracy, PathEnd, StopCriteria, TestEnd, observed, peel};
use peelkit_checks::sampled::{SampleKind, scene_text};
use peelkit_scene::Scene;

const SEED: u64 = 77;

/// Where the edge of a face lets go the force has a corner: each half of a step begins at the solutions that were found on it, so that work and energy
/// balance to 1e-6. They missed that by factors of 1.1 and 3.8.
#[test]
fn work_and_energy_balance_across_a_corner_of_the_force() {
    ends_of(SampleKind::Observed, SEED, 11, "returned");
    ends_of(SampleKind::Observed, SEED, 24, "returned");
}

/// Stability is lost on a step of 2e-6 nm, where the displacement is 57 nm.
#[test]
fn stability_that_is_lost_on_a_very_short_step_is_located() {
    ends_of(SampleKind::Observed, SEED, 8, "closed");
}

/// On its way back the grip comes down to 0.6 nm above the ground and adheres there, where elements were 39 nm long and longer.
#[test]
fn a_grip_that_comes_down_to_the_ground_has_small_elements() {
    ends_of(SampleKind::Observed, SEED, 36, "returned");
}

/// Shorter steps miss the bounds of the mesh: they are taken on a finer one.
#[test]
fn shorter_steps_are_taken_on_a_finer_mesh() {
    ends_of(SampleKind::Friction, SEED, 9, "snapped");
}

/// A strip on a wave, 580 process zones long. The mesh follows its front; on 400 elements that stay numbers were known to 7e-5.
#[test]
fn on_a_wave_the_mesh_follows_the_front() {
    let scene = Scene::parse("wave.toml", &scene_text(SampleKind::Rough, SEED, 21), &[]).unwrap();
    let found = peel(&scene.model, &Accuracy::to(1e-6), &StopCriteria::default());
    assert_eq!(found.end, PathEnd::Pivoting);
    assert!(found.effort.elements <= 200, "{} elements", found.effort.elements);
    let (peak, jump) = (found.initiation_peak.unwrap(), found.snap_off.unwrap());
    let numbers = [
        ("P of the peak", (peak.force, peak.force_error), (2.024221024, 4e-9)),
        ("u of the first jump", (jump.displacement, jump.displacement_error), (17.89501772, 2e-8)),
    ];
    for (name, (value, bound), (expected, error)) in numbers {
        let off = (value - expected).abs();
        assert!(
            bound <= 1e-6 * value && off <= error + bound,
            "{name}: {value} ± {bound}, expected {expected} ± {error}"
        );
    }
}

/// Next to a limit point that the strip is pushed beyond by a ten millionth, its way past it is so slow that it seems to rest there: it is pushed farther.
/// What is released is known by the work that is lost on the whole cycle.
#[test]
fn a_strip_on_its_slow_way_past_a_limit_point_jumps() {
    let set = [("grip.rotation".to_owned(), "fixed".to_owned())];
    let scene = Scene::parse("rough.toml", include_str!("../../scenes/strip-rough.toml"), &set).unwrap();
    let test = observed(&scene.model, &scene.accuracy, &StopCriteria::default()).unwrap();
    assert_eq!(test.end, TestEnd::Closed);
    assert_eq!(test.jumps.len(), 6);
    let released: f64 = test.jumps.iter().map(|jump| jump.released).sum();
    let lost = test.hysteresis.unwrap();
    assert!((released / lost - 1.0).abs() <= 1e-6, "{released} of {lost} aJ");
}
