//! Numbers that stand in lists of a scene as parameters: how each is called, and that results are differentiated by it.
//!
//!      h |  _____ pieces[1].height
//!        |       \
//!        |        \_____ pieces[2].height[2], of the third piece as well
//!        |____|____|____ S
//!
//! Reference: central differences of the fourth order of runs at 1e-10, with steps of 2e-3 and 4e-3 in the logarithm of the number, whose own
//! error is estimated by what the second order misses.
//! Parameters: a beam of 60 nm in three pieces; the paper's strip 50 nm long, held, moved and turned before the pull; a beam by a table.
//! Expected: every derivative within its bound and what differences leave of the reference, and within 1e-6 of it; a number that cannot change alone
//! is named with the reason.
//! Why: most of what a user may change of a spatula stands in a list.

use peelkit::study::{Accuracy, Peel, PeelQuantity, StopCriteria, peel, sensitivities};
use peelkit_scene::{Parameters, Scene};

const ADHESION: &str = "[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";
const PIECES: &str = r#"
[profile]
youngs_modulus = "2 GPa"
pieces = [
    { length = "20 nm", width = "3 nm", height = "8 nm" },
    { length = "15 nm", width = ["3 nm", "2 nm"], height = ["8 nm", "10 nm"], roundness = [0, 0.5], bend = "5 deg" },
    { length = "25 nm", width = "2 nm", height = "10 nm" },
]
"#;
const STEPS: &str = r#"
[strip]
length = "50 nm"
height = "10 nm"
youngs_modulus = "2 GPa"
[grip]
rotation = "fixed"
horizontal = "fixed"
[drive]
steps = ["press 0.02 nm", "drag 0.3 nm", "turn 0.5 deg", "hold"]
"#;
const TABLE: &str = "[profile]\nyoungs_modulus = \"2 GPa\"\ntable = \"\"\"\ns_nm,width_nm,height_nm,angle_deg,roundness\n\
                     0,1,8,0,0\n20,1.3,10,0,0.2\n50,1,12,4,0.4\n\"\"\"\n";

fn scene(text: &str) -> Scene {
    Scene::parse("a.toml", &format!("{text}{ADHESION}"), &[]).unwrap()
}

fn in_lists(found: &Parameters) -> Vec<&str> {
    found.variations.iter().map(|variation| variation.key.as_str()).filter(|key| key.contains('[')).collect()
}

fn peeled(model: &peelkit::model::PeelModel, relative: f64) -> Peel {
    peel(model, &Accuracy::to(relative), &StopCriteria::default())
}

/// Derivatives by these keys at 1e-7 against differences at 1e-10.
fn check(text: &str, keys: &[&str]) {
    let scene = scene(text);
    let own = peeled(&scene.model, 1e-7);
    let mut variations = scene.parameters().variations;
    variations.retain(|variation| keys.contains(&variation.key.as_str()));
    assert_eq!(variations.len(), keys.len());
    let found = sensitivities(&own, &PeelQuantity::OF_A_PEEL, &variations).unwrap();
    assert_eq!(found.refused, []);
    for (k, variation) in variations.iter().enumerate() {
        let step = 2e-3;
        let beside = [1.0, -1.0, 2.0, -2.0].map(|steps| peeled(&(variation.model)(steps * step), 1e-10));
        let mut compared = 0;
        for of in PeelQuantity::OF_A_PEEL {
            let Some(derivative) = found.of(of, k).filter(|_| of != PeelQuantity::PlateauForce) else { continue };
            let values = beside.each_ref().map(|peel| of.value(peel).unwrap());
            let [near, far] = [0, 2].map(|k| (values[k] - values[k + 1]) / ((k + 2) as f64 * step));
            let reference = (4.0 * near - far) / 3.0;
            let number = of.value(&own).unwrap().abs();
            let missed = 1e-2 * (near - far).abs() + 1e-9 * number / step;
            let difference = (derivative.value - reference).abs();
            let what = format!("{} by {}: {derivative:?} against {reference}", of.name(), variation.key);
            println!("{what}, {:.0e} of it", difference / number);
            assert!(difference <= derivative.error + missed && difference <= 1e-6 * number + missed, "{what}");
            compared += 1;
        }
        assert!(compared >= 3, "{}: {compared} numbers", variation.key);
    }
}

#[test]
fn numbers_of_pieces() {
    let found = scene(PIECES).parameters();
    let names = [
        "[1].length",
        "[1].width",
        "[2].length",
        "[2].bend",
        "[2].width[1]",
        "[2].width[2]",
        "[2].roundness[2]",
        "[3].length",
        "[3].width",
        "[1].height",
        "[2].height[2]",
    ];
    assert_eq!(in_lists(&found), names.map(|name| format!("profile.pieces{name}")));
    assert_eq!(found.fixed, []);
    let keys =
        ["[1].length", "[1].height", "[2].bend", "[2].width[2]", "[2].roundness[2]", "[2].height[2]", "[3].length"];
    let keys = keys.map(|name| format!("profile.pieces{name}"));
    check(PIECES, &keys.each_ref().map(String::as_str));
}

#[test]
fn amounts_of_steps() {
    assert_eq!(in_lists(&scene(STEPS).parameters()), ["drive.steps[1]", "drive.steps[2]", "drive.steps[3]"]);
    check(STEPS, &["drive.steps[1]", "drive.steps[2]", "drive.steps[3]"]);
}

#[test]
fn cells_of_a_table() {
    let found = scene(TABLE).parameters();
    let (names, fixed) = (in_lists(&found), found.fixed.len());
    assert!(names.len() == 2 + 3 + 3 + 1 + 2 && fixed == 0, "{names:?} {:?}", found.fixed);
    let keys = ["s_nm[2]", "s_nm[3]", "width_nm[2]", "height_nm[3]", "angle_deg[3]", "roundness[2]"];
    let keys = keys.map(|name| format!("profile.table.{name}"));
    check(TABLE, &keys.each_ref().map(String::as_str));
}

/// A height in the midst of a wedge makes a kink, and roundness ends at one.
#[test]
fn a_number_that_cannot_change_alone_has_its_reason() {
    let wedge = PIECES
        .replace("height = \"8 nm\"", "height = [\"8 nm\", \"12 nm\"], height_course = \"linear\"")
        .replace(
            "height = [\"8 nm\", \"10 nm\"], roundness = [0, 0.5]",
            "height = [\"12 nm\", \"15 nm\"], roundness = [0, 1], height_course = \"linear\"",
        )
        .replace("height = \"10 nm\"", "height = [\"15 nm\", \"20 nm\"], height_course = \"linear\"");
    let found = scene(&wedge).parameters();
    let why = |key: &str| {
        let fixed = found.fixed.iter().find(|(fixed, _)| fixed == key);
        fixed.unwrap_or_else(|| panic!("{key} is not in {:?}", found.fixed)).1.clone()
    };
    let kink = why("profile.pieces[1].height[2]");
    assert!(kink.starts_with("changed alone by 0.1 % it makes a list that has a kink between piece 1"), "{kink}");
    let round = why("profile.pieces[2].roundness[2]");
    assert!(round.contains("has in piece 2 `roundness` = 1.001") && round.contains("from 0 to 1"), "{round}");
    assert!(in_lists(&found).contains(&"profile.pieces[2].width[1]"));
}
