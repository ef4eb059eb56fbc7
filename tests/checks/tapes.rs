//! Tapes and films, micrometres to millimetres, under cohesive laws.
//!
//! Reference: what a cohesive law is. It gives a traction for an opening, so the height at which a face is closed, r_eq, is a choice: no force and no
//! displacement depends on it. And P + P²/(2EA) = w b for a long strip pulled straight up: Kendall.
//!
//! Parameters: PDMS of 20 um, a stiff film under Dugdale's law, and three tapes that random sampling found. Expected: each comes to its end within a
//! pinned number of Newton iterations. Before, all five were lost behind the first jump: a face that was pressed below the distance zero was taken for
//! one that steps into an obstacle, and steps were measured by r0, thousands of times shorter than what the law acts over.

use approx::assert_relative_eq;
use peelkit::study::{Peel, peel};
use peelkit_report::end_word;
use peelkit_scene::Scene;

const PDMS: &str = r#"
strip = { length = "1 mm", height = "20 um", width = "5 mm", youngs_modulus = "2 MPa", poissons_ratio = 0.49 }
adhesion = { law = "exponential", work = "0.2 J/m2", strength = "1 MPa", equilibrium_distance = "0.4 nm" }
accuracy = { relative = 1e-4 }
"#;
const STIFF: &str = r#"
strip = { length = "0.63317 mm", height = "15.42 um", width = "22.1 mm", youngs_modulus = "1387.1 MPa", poissons_ratio = 0.4 }
adhesion = { law = "dugdale", work = "0.02287 J/m2", strength = "0.2706 MPa", equilibrium_distance = "1.6901 nm" }
grip = { rotation = "fixed" }
drive = { angle = "83.74 deg" }
accuracy = { relative = 1e-4 }
"#;
const STICKY: &str = r#"
strip = { length = "6.4688 mm", height = "138.1 um", width = "13.4 mm", youngs_modulus = "84.481 MPa", poissons_ratio = 0.3 }
adhesion = { law = "exponential", work = "1.697 J/m2", strength = "2.056 MPa", equilibrium_distance = "16.511 nm" }
grip = { rotation = "fixed" }
drive = { angle = "33.96 deg" }
accuracy = { relative = 1e-4 }
"#;
/// Its law acts over ten times its thickness, so that sections turn over where they still adhere.
const TURNED: &str = r#"
strip = { length = "685.241 um", height = "12.5853 um", width = "18.71 mm", youngs_modulus = "362.32 MPa", poissons_ratio = 0.3 }
adhesion = { law = "exponential", work = "59.8439 J/m2", strength = "0.320509 MPa", equilibrium_distance = "8.532 nm" }
grip = { rotation = "fixed" }
drive = { angle = "96.353 deg" }
accuracy = { relative = 1e-4 }
"#;

fn peeled(text: &str, set: &[(String, String)]) -> Peel {
    let scene = Scene::parse("tape.toml", text, set).unwrap();
    peel(&scene.model, &scene.accuracy, &scene.bounds.from_now())
}

#[track_caller]
fn ends(text: &str, end: &str, most: usize) -> Peel {
    let peel = peeled(text, &[]);
    assert_eq!(end_word(&peel.end), end, "{:?}", peel.end);
    assert!(peel.effort.newton_iterations <= most, "{} Newton iterations", peel.effort.newton_iterations);
    peel
}

#[test]
fn tapes_come_to_their_end() {
    let peel = ends(PDMS, "detached", 1500);
    // P + P²/(2EA) = w b, EA = 0.2 N, w b = 1 mN
    let steady = 0.2 * ((1.0f64 + 2.0 * 1e-3 / 0.2).sqrt() - 1.0) * 1e9;
    assert_relative_eq!(peel.plateau.unwrap().force, steady, max_relative = peel.asked);
    ends(STIFF, "detached", 900);
    ends(STICKY, "detached", 1200);
}

/// A section that has turned over has no kink of its moment while it is open: the path goes on to where its pressed edge stands upright.
#[test]
fn a_film_whose_law_acts_over_ten_thicknesses_turns_over() {
    let peel = ends(TURNED, "upright-section", 900);
    assert!(peel.snap_off.is_some());
}

/// The height at which a face is closed changes nothing.
#[test]
fn the_equilibrium_distance_of_a_tape_is_a_choice() {
    let at = |r0: &str| peeled(PDMS, &[("adhesion.equilibrium_distance".into(), r0.into())]);
    let (near, far) = (at("0.4 nm"), at("40 nm"));
    let of =
        |peel: &Peel| [peel.peak.unwrap(), peel.initiation_peak.unwrap()].map(|peak| (peak.force, peak.force_error));
    for ((one, error), (two, other)) in of(&near).into_iter().zip(of(&far)) {
        assert!((one - two).abs() <= error + other, "{one} ± {error}, {two} ± {other}");
    }
    assert_eq!(near.limit_points.len(), far.limit_points.len());
}
