//! Scenes in space: what puts a scene there, and what is refused there.
//!
//! Expected: a key of space implies `space = true`; a scene that says `space = false` beside one is refused at that key;
//! what is not computed in space is refused by its own key. Why: a pull sideways that is computed in the plane would be
//! a wrong number without a message.

use crate::text::{MINIMAL, SPATULA, assert_says, complaint, set, with};
use peelkit::adhesion::SectionShape;
use peelkit::model::{Hold, Space};
use peelkit_scene::{Scene, find_key};
use std::f64::consts::FRAC_PI_3;

const SIDEWAYS: &str = "[grip]\nroll = \"fixed\"\n[drive]\nangle = \"60 deg\"\nazimuth = \"60 deg\"\n";

#[test]
fn a_key_of_space_puts_the_scene_there() {
    let plane = Scene::parse("a.toml", MINIMAL, &[]).unwrap();
    assert_eq!(plane.model.space, None);
    let scene = Scene::parse("a.toml", &format!("{MINIMAL}{SIDEWAYS}"), &[]).unwrap();
    let space = scene.model.space.unwrap();
    assert!((space.azimuth - FRAC_PI_3).abs() < 1e-15);
    assert_eq!((space.roll, space.yaw, space.lateral), (Hold::Fixed, Hold::Free, Hold::Free));
    for (key, value, expected) in [
        ("drive.azimuth", "1 rad", Space { azimuth: 1.0, ..Space::default() }),
        ("grip.lateral", "fixed", Space { lateral: Hold::Fixed, ..Space::default() }),
        ("grip.roll", "fixed", Space { roll: Hold::Fixed, ..Space::default() }),
        ("grip.yaw", "fixed", Space { yaw: Hold::Fixed, ..Space::default() }),
        ("strip.section", "ellipse", Space { section: SectionShape::Ellipse, ..Space::default() }),
        ("space", "true", Space::default()),
    ] {
        assert_eq!(with(key, value).unwrap().model.space, Some(expected), "{key}");
    }
    assert_eq!(
        Scene::parse("a.toml", &format!("space = true\n{MINIMAL}"), &[]).unwrap().model.space,
        Some(Space::default())
    );
}

#[test]
fn a_scene_in_the_plane_has_no_key_of_space() {
    let text = format!("space = false\n{MINIMAL}{SIDEWAYS}");
    let parts = [
        "line 11: `grip.roll` is a key of a scene in space, and this scene has `space` = false",
        "Write `space = true`",
    ];
    assert_says(&complaint(&text), &parts);
    // what is set on the command line comes last
    assert!(
        Scene::parse("a.toml", &format!("space = false\n{MINIMAL}"), &set("grip.yaw", "fixed"))
            .unwrap()
            .model
            .space
            .is_some()
    );
    let error = Scene::parse("a.toml", &format!("{MINIMAL}{SIDEWAYS}"), &set("space", "false")).unwrap_err();
    assert_says(&error.to_string(), &["--set space=false: `grip.roll` is a key of a scene in space"]);
}

#[test]
fn values_out_of_range_and_slips_are_told() {
    assert_says(&with("drive.azimuth", "181 deg").unwrap_err(), &["`drive.azimuth` is ", "from -180 to 180 deg"]);
    assert!(with("drive.azimuth", "-180 deg").is_ok() && with("drive.azimuth", "180 deg").is_ok());
    assert_says(&with("drive.azimuth", "90").unwrap_err(), &["without a unit", "90 deg"]);
    assert_says(&with("strip.section", "elipse").unwrap_err(), &["Did you mean \"ellipse\"?"]);
    assert_says(&with("grip.roll", "held").unwrap_err(), &["\"free\" or \"fixed\""]);
    assert_says(&with("drive.azimut", "9 deg").unwrap_err(), &["Did you mean `drive.azimuth`?"]);
    assert_says(&complaint(&format!("{MINIMAL}[drive]\nroll = \"fixed\"\n")), &["`roll` stands in the table [grip]"]);
    assert_says(&with("space", "\"true\"").unwrap_err(), &["in quotes", "space = true"]);
}

#[test]
fn the_keys_of_space_have_defaults_and_ranges() {
    let shown = |path: &str| find_key(path).map(|key| [key.default_text(), key.range_text()]).unwrap();
    assert_eq!(shown("drive.azimuth"), ["0 deg", "-180 to 180"]);
    assert_eq!(shown("grip.lateral"), ["free", "free, fixed"]);
    assert_eq!(shown("strip.section"), ["rectangle", "rectangle, ellipse"]);
    assert_eq!(shown("space"), ["false", "true, false"]);
}

#[test]
fn what_is_not_computed_in_space_is_refused_by_its_key() {
    for (lines, says) in [
        (
            "[friction]\nstrength = \"50 MPa\"\n",
            "`friction.strength` is given, and this scene is in space, where there is no friction",
        ),
        (
            "[substrate]\nshape = \"sphere\"\nradius = \"200 nm\"\n",
            "`substrate.shape` is given, and this scene is in space, where the substrate is flat",
        ),
    ] {
        assert_says(
            &complaint(&format!("{MINIMAL}{SIDEWAYS}{lines}")),
            &[says, "remove `space` and the keys of space"],
        );
    }
    let steps = SIDEWAYS.to_owned() + "steps = [\"yaw 3 deg\"]\n";
    let says =
        ["`drive.steps` has the step \"yaw 3 deg\"", "`grip.yaw` is \"free\"", "Give `yaw = \"fixed\"` under [grip]"];
    assert_says(&complaint(&format!("{MINIMAL}{steps}")), &says);
    let steps = "[drive]\nsteps = [\"shift 3 nm\"]\n";
    let says = ["`drive.steps` has the step \"shift 3 nm\", which leaves the plane", "Give `space = true`"];
    assert_says(&complaint(&format!("{MINIMAL}{steps}")), &says);
    Scene::parse("a.toml", &format!("space = true\n{MINIMAL}{steps}"), &[]).unwrap();
    // bodies of every kind are
    assert!(Scene::parse("a.toml", &format!("space = true\n{SPATULA}"), &[]).is_ok());
    let forces = |law: &str| complaint(&format!("{MINIMAL}{law}{SIDEWAYS}"));
    assert_says(
        &forces("line_load = \"force-only\"\n"),
        &["`adhesion.law` is not offered in space", "with a potential"],
    );
    let ellipse =
        complaint(&MINIMAL.replace("[adhesion]\n", "section = \"ellipse\"\n[adhesion]\nlaw = \"bilinear\"\n"));
    assert_says(&ellipse, &["is not offered in space", "requires a rectangle"]);
    let friction = format!("{MINIMAL}[friction]\nstrength = \"50 MPa\"\n");
    let error = Scene::parse("a.toml", &friction, &set("drive.azimuth", "9 deg")).unwrap_err();
    assert_says(&error.to_string(), &["--set drive.azimuth=9 deg: `friction.strength` is given"]);
}

#[test]
fn a_scene_in_space_comes_back_from_its_text() {
    let text = &format!("{MINIMAL}{SIDEWAYS}").replace("[drive]\n", "yaw = \"fixed\"\n[drive]\n");
    for scene in [Scene::parse("a.toml", text, &[]).unwrap(), Scene::parse("a.toml", MINIMAL, &[]).unwrap()] {
        let written = scene.to_toml();
        assert_eq!(written.contains("azimuth"), scene.model.space.is_some(), "{written}");
        assert_eq!(Scene::parse("a.toml", &written, &[]).unwrap(), scene, "{written}");
    }
}
