//! Keys that do not fit one another, and where the message about them points.
//!
//! Expected: what an override has brought about is said of the override, and no line of the file is underlined; of a key that is
//! missing the message names the key. Why: nothing is wrong with the file, and a search in it is in vain.

use crate::text::{MINIMAL, SPATULA, assert_says, complaint, set, with};
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
fn what_does_not_heal_is_a_strip_under_a_cohesive_law() {
    let law = format!("{MINIMAL}law = \"bilinear\"\n");
    let unhealed = set("adhesion.healing", "false");
    let scene = Scene::parse("a.toml", &law, &unhealed).unwrap();
    assert!(!scene.model.adhesion.healing && Scene::parse("a.toml", &law, &[]).unwrap().model.adhesion.healing);
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    for (text, what) in [
        (MINIMAL.to_owned(), "a law of adhesion that is not cohesive"),
        (format!("{law}line_load = \"axis-gap\"\n"), "a `line_load` that is not"),
        (format!("{law}[substrate]\nshape = \"sphere\"\nradius = \"1 um\"\n"), "ground that is not flat"),
        (format!("{law}[time]\nrate = \"1 mm/s\"\ndensity = \"1000 kg/m3\"\n"), "an adhesion that does not heal"),
    ] {
        assert_says(&shown(&text, &unhealed), &[what]);
    }
}

#[test]
fn a_shear_strength_is_that_of_a_strip_under_a_cohesive_law() {
    let law = format!("{MINIMAL}law = \"exponential\"\n");
    let held = set("adhesion.shear_strength", "20 MPa");
    let scene = Scene::parse("a.toml", &law, &held).unwrap();
    assert_eq!(scene.model.adhesion.shear_strength, Some(0.02));
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    assert_says(&shown(MINIMAL, &held), &["belongs to a cohesive law"]);
    let tough = set("adhesion.shear_work", "0.1 J/m2");
    assert_says(&shown(&law, &tough), &["holds along the substrate, and this one has no shear strength", "Give"]);
    assert_says(&shown(MINIMAL, &tough), &["belongs to a cohesive law"]);
    let scene = Scene::parse("a.toml", &law, &[held.clone(), tough].concat()).unwrap();
    assert_eq!(scene.model.adhesion.shear_work, Some(0.1));
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    let mixed = |exponent: &str| {
        [&held[..], &set("adhesion.shear_work", "0.1 J/m2"), &set("adhesion.mixing_exponent", exponent)].concat()
    };
    let scene = Scene::parse("a.toml", &law, &mixed("2.3")).unwrap();
    assert_eq!(scene.model.adhesion.mixing_exponent, Some(2.3));
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    assert_says(
        &shown(&law, &set("adhesion.mixing_exponent", "2.3")),
        &["this adhesive has one work alone", "Give `shear_work"],
    );
    assert_says(&shown(&law, &mixed("0.9")), &["`adhesion.mixing_exponent`", "from 1e0 to 8e0"]);
    let beside = |lines: &str, what: &str| {
        assert_says(
            &shown(&format!("{law}{lines}"), &held),
            &[&format!("is given beside {what}, which is not computed")],
        );
    };
    beside("line_load = \"axis-gap\"\n", "a `line_load` that is not \"full\"");
    beside("[substrate]\nshape = \"sphere\"\nradius = \"900 nm\"\n", "ground that is not flat");
    beside("[grip]\nhorizontal = \"fixed\"\npretension = \"1 nN\"\n", "`grip.pretension`");
    // in space it is that of any body, and slip may take a work of its own there as well
    let space = format!("space = true\n{law}");
    assert!(Scene::parse("a.toml", &space, &held).is_ok());
    let scene = Scene::parse("a.toml", &space, &mixed("2.3")).unwrap();
    assert_eq!(Scene::parse("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    let spatula = SPATULA.replace("[adhesion]\n", "[adhesion]\nlaw = \"exponential\"\n");
    assert_says(&shown(&spatula, &held), &["is given beside a body that is no strip, in the plane"]);
    assert!(Scene::parse("a.toml", &format!("space = true\n{spatula}"), &held).is_ok());
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
    let asked = set("output.stations", "{ end_rotation = \"10 deg\" }");
    let rate = format!("{MINIMAL}[time]\nrate = \"1 mm/s\"\ndensity = \"1300 kg/m3\"\n");
    let error = Scene::parse_any("a.toml", &rate, &asked).unwrap_err();
    assert_says(
        &error.to_string(),
        &["`output.stations` is given, and a beam pulled at a rate has no `end_rotation` to look for"],
    );
    let error = Scene::parse_any("a.toml", crate::text::SETA, &asked).unwrap_err();
    assert_says(
        &error.to_string(),
        &["`output.stations` is given, and the pull-off of a seta has no `end_rotation` to look for"],
    );
    let error = Scene::parse_any("a.toml", MINIMAL, &set("output.stations", "{ time = \"1 us\" }")).unwrap_err();
    assert_says(&error.to_string(), &["the path of a beam has no `time` to look for"]);
    assert!(
        Scene::parse_any("a.toml", crate::text::SETA, &set("output.stations", "{ displacement = \"1 um\" }")).is_ok()
    );
}

#[test]
fn units_are_refused_that_results_are_not_written_in() {
    let units = |value: &str| shown(MINIMAL, &set("output.units", value));
    assert_says(
        &units("\"mm, lbf\""),
        &[
            "has \"lbf\", which is no unit of a force, a length, a work or a force over a width that results are written in",
            "\"mN, mm, nJ\"",
        ],
    );
    assert_says(&units("3"), &["is 3, no text of units"]);
    // of a strip, unless its width varies
    let over = set("output.units", "\"N/25mm\"");
    assert!(Scene::parse_any("a.toml", MINIMAL, &over).is_ok());
    let error = Scene::parse_any("a.toml", crate::text::SETA, &over).unwrap_err();
    assert_says(&error.to_string(), &["has N/25mm, a force over the width of a strip, and the scene has no strip"]);
    let sampled = [
        ("uncertainty.inputs", "[{ key = \"strip.width\", distribution = \"lognormal\", log_deviation = 0.1 }]"),
        ("output.units", "\"N/cm\""),
    ];
    let sampled = sampled.map(|(key, value)| (key.to_owned(), value.to_owned()));
    let error = Scene::parse_any("a.toml", MINIMAL, &sampled).unwrap_err();
    assert_says(&error.to_string(), &["and `strip.width` is varied"]);
}

#[test]
fn events_are_refused_by_what_is_wrong_with_them() {
    let events = |value: &str| shown(MINIMAL, &set("output.events", value));
    assert_says(&events("\"front < 50 nm\""), &["is \"front < 50 nm\", no list of tables"]);
    assert_says(&events("[]"), &["has 0 events; from 1 to 1000 are looked for"]);
    assert_says(&events("[\"front < 50 nm\"]"), &["no table with a `when`"]);
    assert_says(&events("[{ name = \"a\" }]"), &["has no `when`, a condition such as"]);
    assert_says(&events("[{ when = \"front\" }]"), &["has `when` = \"front\", which has no =, < or >"]);
    assert_says(&events("[{ when = \"x < 3 nm\" }]"), &["\"x\", which is none of `displacement`"]);
    assert_says(&events("[{ when = \"P > 3 nm\" }]"), &["`force` = \" 3 nm\", which is not a force with its unit"]);
    assert_says(&events("[{ when = 3 }]"), &["has `when` = 3, no text"]);
    assert_says(
        &events("[{ when = \"u > 3 nm\", at = \"x\" }]"),
        &["has \"at\", which is none of `when`, `name`, `action`"],
    );
    let halt = "[{ when = \"u > 3 nm\", action = \"halt\" }]";
    assert_says(&events(halt), &["has `action` = \"halt\", which is neither \"record\" nor \"stop\""]);
    let twice = "[{ when = \"u > 3 nm\" }, { when = \"u > 3 nm\" }]";
    assert_says(&events(twice), &["has the name \"u > 3 nm\" of an earlier one"]);
    let whole = "[{ when = \"attached = 3\" }]";
    assert_says(&events(whole), &["`attached` goes by whole numbers: write < or >"]);
    let tips = set("output.events", "[{ when = \"attached < 3\" }]");
    let error = Scene::parse_any("a.toml", MINIMAL, &tips).unwrap_err();
    assert_says(
        &error.to_string(),
        &["`output.events` is given, and the path of a beam has no `attached` to look for"],
    );
    assert!(Scene::parse_any("a.toml", crate::text::SETA, &tips).is_ok());
}
