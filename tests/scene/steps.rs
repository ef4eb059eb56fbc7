//! What a scene says of the steps before the pull.

use peelkit::model::{PeelModel, Step};
use peelkit::study::{Accuracy, Effort, StopCriteria, peel};
use peelkit_scene::Scene;

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");

fn record(what: &str, effort: &Effort) {
    println!("{what}: {} points, {} Newton iterations", effort.points, effort.newton_iterations);
}

#[track_caller]
fn assert_near(what: &str, a: f64, b: f64, bound: f64) {
    assert!((a - b).abs() <= bound, "{what}: {a} and {b}, apart by {:.1e}, bound {bound:.1e}", a - b);
}

/// From where the strip lies on wavy ground, and pressed a little from there.
#[test]
fn steps_begin_where_a_strip_lies_on_wavy_ground() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-rough.toml");
    let scene = Scene::parse(path, &std::fs::read_to_string(path).unwrap(), &[]).unwrap();
    let bounds = StopCriteria { displacement: Some(2.0), ..BOUNDS };
    let peak = |steps: &[Step]| {
        let peel = peel(&PeelModel { steps: steps.to_vec(), ..scene.model.clone() }, &Accuracy::to(1e-6), &bounds);
        record("wavy ground", &peel.effort);
        peel.initiation_peak.unwrap()
    };
    let (whole, part) = (peak(&[]), peak(&[Step::Press(0.05)]));
    assert_near("peak", whole.force, part.force, whole.force_error + part.force_error);
    let bound = whole.displacement_error + part.displacement_error;
    assert_near("its place", whole.displacement + 0.05, part.displacement, bound);
}

#[test]
fn steps_that_are_none_are_named() {
    for (list, parts) in [
        ("[\"press\"]", "has as step 1 \"press\", whose word is not followed by a length"),
        ("[\"hold\", \"press 2\"]", "has as step 2 \"press 2\", whose amount has no unit (nm, um"),
        ("[\"press 2 deg\"]", "whose unit is none of a length"),
        ("[\"turn 2 nm\"]", "whose unit is none of an angle (rad, deg)"),
        ("[\"lift -2 nm\"]", "whose amount is not above zero"),
        ("[\"turn 0 deg\"]", "which is no rotation"),
        ("[\"hold 2 s\"]", "hold takes no amount"),
        ("[\"release 2 nm\"]", "release takes no amount"),
        ("[\"roll 2 nm\"]", "whose unit is none of an angle (rad, deg)"),
        ("[\"shift 2 deg\"]", "whose unit is none of a length"),
        ("[\"shift 0 nm\"]", "which is no displacement: write \"hold\""),
        (
            "[\"wait\"]",
            "has as step 1 \"wait\", which does not begin with press, lift, drag, push, shift, turn, roll, yaw, release or hold",
        ),
        ("[\"drag nan nm\"]", "whose amount is not a finite number"),
        ("[1, 2]", "is a list"),
        ("\"press 2 nm\"", "is \"press 2 nm\""),
    ] {
        let text = std::fs::read_to_string(SCENE).unwrap() + &format!("\n[drive]\nsteps = {list}\n");
        let error = Scene::parse("a.toml", &text, &[]).unwrap_err();
        let said = format!("{error} / {}", error.remedy());
        assert!(said.contains("`drive.steps`") && said.contains(parts) && said.contains("\"drag 2 nm\""), "{said}");
    }
}
