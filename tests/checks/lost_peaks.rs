//! Peaks that were found at one accuracy and lost at another, and a bound that was too small.
//!
//! Reference: the same scene at another accuracy. What lies before the end of a path does not depend on how it ends, nor on the mesh; and two results
//! differ by no more than both bounds.
//!
//! Parameters: seven scenes that random sampling from outside found. Of three strips with the near face alone, whose energy W/cos θ has no lower bound at 90
//! degrees, a part hangs nearly upright from the grip: where tension and bending no longer hold it is the jump. Two of exponential laws are very slender;
//! of the spatula the neck had one element on the mesh that was judged and on the one that judged it; of a strip that is pulled back the first maximum and
//! minimum of the force lie on neighbouring steps. Expected: the same peak at every accuracy, within both bounds; of the laws and of the strips that hang,
//! the jump as well, and of the latter the same end.

use peelkit::study::{PathEnd, Peel, peel};
use peelkit_scene::Scene;

const JUMPS: &str = r#"
strip = { length = "8270.6 nm", height = "24.026 nm", width = "141 nm", youngs_modulus = "0.55388 GPa", poissons_ratio = 0.376, bending_stiffness_factor = 1.3130e-03 }
adhesion = { hamaker_constant = "3.1625e-20 J", equilibrium_distance = "0.23443 nm", far_face = false }
grip = { rotation = "free", horizontal = "free" }
"#;
const UPRIGHT: &str = r#"
strip = { length = "12033 nm", height = "16.321 nm", width = "5.801 nm", youngs_modulus = "21.255 GPa", poissons_ratio = 0.369, bending_stiffness_factor = 9.4020e-02 }
adhesion = { hamaker_constant = "4.8387e-20 J", equilibrium_distance = "0.65101 nm", far_face = false }
grip = { rotation = "free", horizontal = "free" }
"#;
const HANGS: &str = r#"
strip = { length = "232.2493 nm", height = "35.212 nm", youngs_modulus = "43.16591 GPa", bending_stiffness_factor = 3.378463e-4 }
adhesion = { hamaker_constant = "5.108559e-19 J", equilibrium_distance = "0.1448487 nm", far_face = false }
grip = { rotation = "fixed", horizontal = "free" }
"#;
const NARROW: &str = r#"
strip = { length = "14661 nm", height = "2.1798 nm", width = "1.514 nm", youngs_modulus = "0.45529 GPa", poissons_ratio = 0.014, bending_stiffness_factor = 1.0166e-03 }
adhesion = { hamaker_constant = "6.6382e-21 J", equilibrium_distance = "0.6291 nm", law = "exponential" }
grip = { rotation = "fixed", horizontal = "free" }
"#;
const SOFT: &str = r#"
strip = { length = "19816 nm", height = "3.6057 nm", width = "100 nm", youngs_modulus = "0.044677 GPa", poissons_ratio = 0.274, bending_stiffness_factor = 1.3608e-01 }
adhesion = { hamaker_constant = "1.1041e-20 J", equilibrium_distance = "0.22212 nm", law = "exponential" }
grip = { rotation = "fixed", horizontal = "free" }
"#;
const NECK: &str = r#"
spatula = { pad_length = "268.299 nm", neck_length = "97.033 nm", shaft_length = "959.26 nm", bend_length = "51.70 nm", tip_width = "243.82 nm", neck_width = "75.05 nm", shaft_diameter = "105.04 nm", pad_thickness = "6.553 nm", shaft_angle = "79.61 deg", youngs_modulus = "6.795 GPa" }
adhesion = { hamaker_constant = "1.8673e-19 J", equilibrium_distance = "0.4454 nm" }
grip = { rotation = "fixed" }
"#;

/// Its force rises to 0.01839 nN, falls by 7e-5 of that and rises on.
const DIP: &str = r#"
strip = { length = "2906.949 nm", height = "46.47203 nm", youngs_modulus = "1.903531 GPa", bending_stiffness_factor = 5.376735e-2 }
adhesion = { hamaker_constant = "2.026493e-20 J", equilibrium_distance = "1.784885 nm", far_face = false }
grip = { rotation = "fixed", horizontal = "fixed" }
drive = { angle = "109.769 deg" }
"#;

fn peeled(text: &str, relative: &str) -> Peel {
    let scene = Scene::parse("lost.toml", text, &[("accuracy.relative".into(), relative.into())]).unwrap();
    peel(&scene.model, &scene.accuracy, &scene.bounds.from_now())
}

/// Force and displacement of the peak, each with its bound.
fn peak(peel: &Peel) -> [(f64, f64); 2] {
    let peak = peel.peak.unwrap_or_else(|| panic!("no peak; it ends {:?}", peel.end));
    [(peak.force, peak.force_error), (peak.displacement, peak.displacement_error)]
}

/// Force and displacement of the initiation peak, each with its bound.
fn initiation(peel: &Peel) -> [(f64, f64); 2] {
    let peak = peel.initiation_peak.unwrap_or_else(|| panic!("no initiation peak; it ends {:?}", peel.end));
    [(peak.force, peak.force_error), (peak.displacement, peak.displacement_error)]
}

/// Place and force of the first jump, each with its bound.
fn jump(peel: &Peel) -> [(f64, f64); 2] {
    let at = peel.snap_off.unwrap_or_else(|| panic!("no jump; it ends {:?}", peel.end));
    [(at.displacement, at.displacement_error), (at.force, at.force_error)]
}

#[track_caller]
fn agree(text: &str, accuracies: [&str; 2], numbers: fn(&Peel) -> [(f64, f64); 2]) {
    let [coarse, fine] = accuracies.map(|relative| numbers(&peeled(text, relative)));
    for ((one, error), (two, other)) in coarse.into_iter().zip(fine) {
        assert!((one - two).abs() <= error + other, "{one} ± {error:.1e}, {two} ± {other:.1e}");
    }
}

#[test]
fn a_peak_stays_where_a_section_stands_upright_behind_it() {
    agree(JUMPS, ["1e-4", "1e-5"], peak);
    agree(UPRIGHT, ["1e-4", "1e-6"], peak);
}

/// Elements that follow the front are too long to see where a part of the beam that hangs behind it is drawn upright: the paths ended there without a jump, or
/// came past it, as the mesh was.
#[test]
fn what_hangs_nearly_upright_jumps_at_the_same_place_at_each_accuracy() {
    for (scene, accuracies) in [(JUMPS, ["1e-4", "1e-6"]), (UPRIGHT, ["1e-8", "1e-9"]), (HANGS, ["1e-4", "1e-6"])] {
        agree(scene, accuracies, peak);
        agree(scene, accuracies, jump);
        for relative in accuracies {
            let end = peeled(scene, relative).end;
            let PathEnd::Upright(section) = &end else { panic!("{end:?}") };
            assert!(section.is_drawn(), "{end:?}");
        }
    }
}

#[test]
fn peaks_and_jumps_of_slender_strips_are_the_same_at_each_accuracy() {
    for scene in [NARROW, SOFT] {
        agree(scene, ["1e-4", "1e-6"], peak);
        agree(scene, ["1e-4", "1e-6"], jump);
    }
}

/// 27.72743081 nN with a bound of 1.3e-7 at 1e-6 and 27.7274313854 at 1e-8 were too far apart: a mesh that judges another is finer on every piece.
#[test]
fn a_piece_with_one_element_is_judged_by_more() {
    agree(NECK, ["1e-5", "1e-8"], peak);
    agree(NECK, ["1e-6", "1e-8"], peak);
}

/// With short steps the maximum and the minimum behind it lie on neighbouring ones, whose common end is nearest to both: there they are 0 apart. At 1e-8 and 1e-9
/// they were left out as ripple, and the initiation peak was 0.07078 nN.
#[test]
fn a_dip_between_two_steps_is_no_ripple() {
    agree(DIP, ["1e-6", "1e-8"], initiation);
    agree(DIP, ["1e-6", "1e-9"], initiation);
}
