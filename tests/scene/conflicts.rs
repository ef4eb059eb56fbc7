//! Keys that do not fit one another, and where the message about them points.
//!
//! Expected: what an override has brought about is said of the override, and no line of the file is underlined; of a key that is
//! missing the message names the key. Why: nothing is wrong with the file, and a search in it is in vain.

use crate::text::{MINIMAL, assert_says, complaint, set, with};
use peelkit::study::FollowedUntil;
use peelkit_scene::Scene;

/// The message as it stands on a terminal, with the text that is underlined.
fn shown(text: &str, overrides: &[(String, String)]) -> String {
    let error = Scene::parse("dir/a.toml", text, overrides).unwrap_err();
    let text = format!("{error} / {}", error.remedy());
    format!("{text} / {:?}", miette::Report::new(error))
}

#[test]
fn a_shape_that_is_set_names_what_it_requires() {
    let says = with("substrate.shape", "sphere").unwrap_err();
    assert_says(
        &says,
        &[
            "--set substrate.shape=sphere: `substrate.radius` is required by `shape` = \"sphere\", and is not given",
            "radius of the sphere or cylinder",
            "--set substrate.radius=\"200 nm\"",
        ],
    );
    assert!(!says.contains("lacks the table"), "{says}");
    let both = [set("substrate.shape", "sphere"), set("substrate.radius", "200 nm")].concat();
    assert!(Scene::parse("a.toml", MINIMAL, &both).is_ok());
}

#[test]
fn a_conflict_that_an_override_brings_about_is_said_of_it() {
    let fixed = format!("{MINIMAL}[grip]\nrotation = \"fixed\"\n[drive]\nturn = \"1 deg/nm\"\n");
    assert!(Scene::parse("a.toml", &fixed, &[]).is_ok());
    let message = shown(&fixed, &set("grip.rotation", "free"));
    assert_says(&message, &["--set grip.rotation=free: `drive.turn` is ", "`grip.rotation` is \"free\""]);
    assert!(!message.contains("line "), "{message}");
    // the key itself is set
    let message = shown(MINIMAL, &set("drive.turn", "1 deg/nm"));
    assert_says(&message, &["--set drive.turn=1 deg/nm: `drive.turn` is "]);
    // of several the guilty one
    let three = [set("strip.width", "2 nm"), set("grip.rotation", "free"), set("strip.height", "9 nm")].concat();
    assert_says(&shown(&fixed, &three), &["--set grip.rotation=free: `drive.turn`"]);
    let sphere = format!("{MINIMAL}[substrate]\nshape = \"sphere\"\nradius = \"200 nm\"\n");
    let message = shown(&sphere, &set("substrate.shape", "flat"));
    assert_says(&message, &["--set substrate.shape=flat: `substrate.radius` is a key of [substrate]"]);
    // what is wrong in the file is said of the file, whatever is set
    let wrong = fixed.replace("\"fixed\"", "\"free\"");
    assert_says(&shown(&wrong, &set("strip.width", "2 nm")), &["dir/a.toml, line ", "`drive.turn` is "]);
}

#[test]
fn a_second_body_without_keys_is_refused() {
    assert_says(&complaint(&format!("[profile]{MINIMAL}")), &["line 1: [profile] stands beside [strip]"]);
    assert_says(
        &complaint(&format!("{MINIMAL}[spatula]\n")),
        &["line 9: [spatula] stands beside [strip], and a scene peels one body", "Remove one of the tables"],
    );
}

#[test]
fn a_cohesive_law_with_work_and_strength_needs_no_hamaker_constant() {
    let without = MINIMAL.replace("hamaker_constant = \"1e-19 J\"\n", "");
    let law = |lines: &str| format!("{without}law = \"bilinear\"\n{lines}");
    let text = law("work = \"30 mJ/m2\"\nstrength = \"50 MPa\"\n");
    let model = Scene::parse("a.toml", &text, &[]).unwrap().model;
    assert!((model.adhesion.half_space().work_of_adhesion() / 0.03 - 1.0).abs() < 1e-14);
    let given = Scene::parse("a.toml", &text, &set("adhesion.hamaker_constant", "1e-19 J")).unwrap().model;
    assert_eq!((given.adhesion.hamaker_constant, given.line_law().law), (0.1, model.line_law().law));
    for (lines, lacks) in [("work = \"30 mJ/m2\"\n", "strength"), ("strength = \"50 MPa\"\n", "work"), ("", "work")] {
        assert_says(&complaint(&law(lines)), &[&format!("[adhesion] lacks `{lacks}`"), "of a cohesive law"]);
    }
}

/// The distance is a tenth of work over strength; it is written with the scene, and one that is given stands.
#[test]
fn a_cohesive_law_with_work_and_strength_needs_no_distance() {
    let without =
        MINIMAL.replace("hamaker_constant = \"1e-19 J\"\n", "").replace("equilibrium_distance = \"0.4 nm\"\n", "");
    let text = format!("{without}law = \"exponential\"\nwork = \"100 J/m2\"\nstrength = \"1 MPa\"\n");
    let scene = Scene::parse("a.toml", &text, &[]).unwrap();
    assert!((scene.model.adhesion.equilibrium_distance / 1e4 - 1.0).abs() < 1e-14);
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    let given = Scene::parse("a.toml", &text, &set("adhesion.equilibrium_distance", "0.3 nm")).unwrap();
    assert_eq!(given.model.adhesion.equilibrium_distance, 0.3);
    assert_says(&complaint(&without), &["[adhesion] lacks `hamaker_constant`", "van der Waals forces"]);
    let foreign = complaint(&format!("{MINIMAL}work = \"0.2 J/m2\"\n"));
    assert_says(&foreign, &["without `law` the adhesion is that of van der Waals forces"]);
}

#[test]
fn a_path_is_followed_until_what_a_scene_says() {
    let scene = Scene::parse("a.toml", MINIMAL, &set("path.until", "first-jump")).unwrap();
    assert_eq!(scene.bounds.from_now().until, FollowedUntil::FirstJump);
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    assert_says(&shown(MINIMAL, &set("path.until", "jump")), &["none of its values", "first-jump"]);
    let rate = format!("{MINIMAL}[time]\nrate = \"1 mm/s\"\ndensity = \"1300 kg/m3\"\n");
    let error = Scene::parse_any("a.toml", &rate, &set("path.until", "detachment")).unwrap_err();
    assert_says(&error.to_string(), &["`path.until`, which is not followed in time"]);
    let error = Scene::parse_any("a.toml", crate::text::SETA, &set("path.until", "detachment")).unwrap_err();
    assert_says(&error.to_string(), &["`path.until` is given, and the scene has a [seta]"]);
}

#[test]
fn stations_are_refused_by_what_is_wrong_with_them() {
    let stations = |value: &str| shown(MINIMAL, &set("output.stations", value));
    assert_says(&stations("\"10 nm\""), &["is \"10 nm\", no table"]);
    assert_says(&stations("{ u = \"10 nm\" }"), &["has \"u\", which is none of `displacement`, `force`"]);
    assert_says(
        &stations("{ force = \"10 nm\" }"),
        &["`force` = \"10 nm\", which is not a force with its unit, as \"30 nN\""],
    );
    assert_says(&stations("{}"), &["`output.stations` has no values"]);
    assert_says(&stations("{ front = [] }"), &["has no values"]);
    assert_says(&stations("{ front = 10 }"), &["has `front` = 10, no text with a number and its unit"]);
    assert_says(&stations("{ end_rotation = [\"30\"] }"), &["not an angle with its unit, as \"30 deg\""]);
    assert_says(&stations("{ displacement = \"1e300 m\" }"), &["which is not a length"]);
    let many = format!("{{ displacement = [{}] }}", "\"1 nm\", ".repeat(1001));
    assert_says(&stations(&many), &["has 1001 values, and a path has at most 1000 stations"]);
    let asked = set("output.stations", "{ displacement = \"10 nm\" }");
    let rate = format!("{MINIMAL}[time]\nrate = \"1 mm/s\"\ndensity = \"1300 kg/m3\"\n");
    let error = Scene::parse_any("a.toml", &rate, &asked).unwrap_err();
    assert_says(&error.to_string(), &["the scene has `output.stations`, which is not followed in time"]);
    let error = Scene::parse_any("a.toml", crate::text::SETA, &asked).unwrap_err();
    assert_says(&error.to_string(), &["`output.stations` is given, and the scene has a [seta]"]);
}
