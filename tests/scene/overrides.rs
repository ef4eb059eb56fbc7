//! What `--set KEY=VALUE` changes in a scene.

use crate::text::{MINIMAL, assert_says, set, with};
use peelkit::adhesion::LineLoad;
use peelkit::model::Hold;
use peelkit_scene::Scene;

#[test]
fn an_override_replaces_a_key_with_or_without_quotes() {
    for value in ["50 nm", "50nm", "\"50 nm\"", "'50 nm'", " 0.05 um "] {
        assert_eq!(with("strip.length", value).unwrap().model.strip().unwrap().length, 50.0, "{value}");
    }
    assert_eq!(with("strip.poissons_ratio", "0.3").unwrap().model.strip().unwrap().material.poissons_ratio, 0.3);
    assert!(!with("adhesion.far_face", "false").unwrap().model.adhesion.far_face);
    assert_eq!(with("adhesion.line_load", "axis-gap").unwrap().model.adhesion.line_load, LineLoad::AxisGap);
    assert_eq!(with("grip.rotation", "\"fixed\"").unwrap().model.grip.rotation, Hold::Fixed);
    assert_eq!(with("bounds.points", "7").unwrap().bounds.points, 7);
    assert_eq!(with("title", "2026").unwrap().title, "2026");
    let twice = [set("strip.length", "1 nm"), set("strip.length", "2 nm")].concat();
    assert_eq!(
        Scene::parse("a.toml", MINIMAL, &twice).unwrap().model.strip().unwrap().length,
        2.0,
        "the last one holds"
    );
}

#[test]
fn an_override_gives_what_the_text_lacks() {
    let text = MINIMAL.replace("height = \"10 nm\"", "");
    assert_eq!(Scene::parse("a.toml", &text, &set("strip.height", "5 nm")).unwrap().model.strip().unwrap().height, 5.0);
}

#[test]
fn a_mistake_in_an_override_names_it() {
    let says = |key, value, parts: &[&str]| assert_says(&with(key, value).unwrap_err(), parts);
    says("strip.length", "100", &["--set strip.length=100: `strip.length` is \"100\", a number without a unit"]);
    says("strip.lenght", "1 nm", &["--set strip.lenght=1 nm", "is not a key", "Did you mean `strip.length`?"]);
    says("length", "1 nm", &["--set length=1 nm", "Did you mean `strip.length`?"]);
    says("strip", "1 nm", &["--set strip=1 nm", "is not a key", "A key is written table.key, such as strip.height;"]);
    says(
        "strip.colour",
        "1",
        &["--set strip.colour=1", "is not a key", "The keys of [strip] are length, height, width"],
    );
    says("", "1 nm", &["is not a key"]);
    says("grip.rotation", "fix", &["--set grip.rotation=fix", "\"free\" or \"fixed\""]);
    says("strip.poissons_ratio", "many", &["`strip.poissons_ratio` is \"many\"", "a number between"]);
    says("strip.length", "1 nm\n[grip]", &["--set strip.length=1 nm\\n[grip]: `strip.length` is \"1 nm\\n[grip]\""]);
    says("strip.length", &"1".repeat(5000), &["1111…"]);
}
