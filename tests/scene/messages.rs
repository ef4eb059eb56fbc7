//! Scenes: what is read from one, and what is said about one that cannot be used.
//!
//! Expected: a scene of three required lengths and constants gives the defaults of the handbook for everything else;
//! prefixes of units change nothing; and of every mistake the message names the file, the line, the key with its table
//! and what was found, and the remedy says what would be right. Why: a person who peels strips, not one who writes
//! parsers, has to mend the file.

use peelkit::adhesion::{CohesiveShape, LineLoad, Round, Shape, Sinusoid, Substrate};
use peelkit::beam::Material;
use peelkit::model::{
    Attraction, Body, Course, Ground, Hold, Piece, ProfileForm, ProfilePieces, Pull, Spatula, Start, Step,
};
use peelkit::study::Terms;
use peelkit_scene::{KEYS, Key, Need, Scene};
use proptest::prelude::*;

const MINIMAL: &str = r#"
[strip]
length = "100 nm"
height = "10 nm"
youngs_modulus = "2 GPa"
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

const SPATULA: &str = r#"
[spatula]
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

const PROFILE: &str = r#"
[profile]
table = """
s_nm, width_nm, height_nm, angle_deg
# the pad
0, 20, 5, 0
40, 20, 5, 0
100, 10, 10, 30
"""
youngs_modulus = "2 GPa"
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

/// Every key of a piece, and the least that one needs.
const PIECES: &str = r#"
[profile]
youngs_modulus = "2 GPa"
[[profile.pieces]]
length = "0.25 um"
width = ["200 nm", "150 nm"]
height = "5 nm"
[[profile.pieces]]
length = "150 nm"
width = ["150 nm", "50 nm"]
height = ["5 nm", "50 nm"]
roundness = [0, 1]
bend = "30 deg"
course = "smooth"
height_course = "smooth"
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

fn set(key: &str, value: &str) -> Vec<(String, String)> {
    vec![(key.to_owned(), value.to_owned())]
}

fn with(key: &str, value: &str) -> Result<Scene, String> {
    Scene::parse("a.toml", MINIMAL, &set(key, value)).map_err(|error| format!("{error} / {}", error.remedy()))
}

/// The message about a text, its remedy behind it.
fn complaint(text: &str) -> String {
    let error = Scene::parse("dir/a.toml", text, &[]).expect_err(text);
    format!("{error} / {}", error.remedy())
}

fn assert_says(complaint: &str, parts: &[&str]) {
    for part in parts {
        assert!(complaint.contains(part), "{part:?} is not in {complaint:?}");
    }
}

#[test]
fn what_a_scene_leaves_out_has_its_default() {
    let scene = Scene::parse("dir/first.toml", MINIMAL, &[]).unwrap();
    let (strip, adhesion, grip) = (*scene.model.strip().unwrap(), scene.model.adhesion, scene.model.grip);
    assert_eq!((strip.length, strip.height, strip.width), (100.0, 10.0, 1.0));
    assert_eq!((strip.youngs_modulus, strip.poissons_ratio), (2.0, 0.2));
    assert_eq!((strip.shear_correction, strip.bending_stiffness_factor), (5.0 / 6.0, 1.0));
    assert_eq!((adhesion.hamaker_constant, adhesion.equilibrium_distance), (0.1, 0.4));
    assert_eq!((adhesion.line_load, adhesion.far_face), (LineLoad::Full, true));
    assert_eq!((adhesion.attraction, adhesion.work, adhesion.strength), (Attraction::BodyForce, None, None));
    assert_eq!((grip.rotation, grip.horizontal), (Hold::Free, Hold::Free));
    assert_eq!((grip.stiffness, grip.pretension), (None, None));
    assert_eq!((scene.model.pull, scene.model.steps), (Pull::UP, Vec::new()));
    assert_eq!(scene.accuracy.relative, 1e-6);
    assert_eq!((scene.bounds.points, scene.bounds.time_s, scene.bounds.displacement), (20_000, Some(60.0), None));
    assert_eq!(scene.title, "first", "the stem of the file");
}

#[test]
fn every_key_is_read() {
    let text = r#"
title = "All"
terms = "auto"
[strip]
length = "0.2 um"
height = "1e-8 m"
width = "2nm"
youngs_modulus = "3000 MPa"
poissons_ratio = -0.5
shear_correction = 1
bending_stiffness_factor = 1e-4
[adhesion]
hamaker_constant = "100 zJ"
equilibrium_distance = "400 pm"
law = "bilinear"
work = "20 mJ/m2"
strength = "100 MPa"
line_load = "axis-gap"
far_face = false
[substrate]
shape = "sinusoid"
height = "8 nm"
wavelength = "0.1 um"
offset = "-25 nm"
start = "flat"
[grip]
rotation = "fixed"
horizontal = "fixed"
stiffness = "20 mN/m"
[drive]
angle = "60 deg"
turn = "-0.5 deg/nm"
steps = ["press 2 nm", " lift 0.001um", "drag 10 nm", "push 3nm", "turn -20 deg", "turn 0.2 rad", "hold"]
[accuracy]
relative = 1e-9
order = 5
elements = 30
step = 0.05
[bounds]
points = 50
time = "2 min"
displacement = "0.5 um"
"#;
    let scene = Scene::parse("a.toml", text, &[]).unwrap();
    let (strip, adhesion, grip) = (*scene.model.strip().unwrap(), scene.model.adhesion, scene.model.grip);
    assert_eq!((strip.length, strip.height, strip.width), (200.0, 10.0, 2.0));
    assert_eq!((strip.youngs_modulus, strip.poissons_ratio), (3.0, -0.5));
    assert_eq!((strip.shear_correction, strip.bending_stiffness_factor), (1.0, 1e-4));
    assert_eq!((adhesion.hamaker_constant, adhesion.equilibrium_distance), (0.1, 0.4));
    assert_eq!((adhesion.line_load, adhesion.far_face), (LineLoad::AxisGap, false));
    assert_eq!(adhesion.attraction, Attraction::Cohesive(CohesiveShape::Bilinear));
    assert_eq!((adhesion.work, adhesion.strength), (Some(0.02), Some(0.1)));
    assert_eq!((grip.rotation, grip.horizontal), (Hold::Fixed, Hold::Fixed));
    assert_eq!(grip.stiffness, Some(0.02));
    assert_eq!(scene.model.pull, Pull { angle: 60f64.to_radians(), turn: -0.5f64.to_radians() });
    let turned = [-20.0 * 1f64.to_radians(), 0.2].map(Step::Turn);
    let moved = [Step::Press(2.0), Step::Lift(1.0), Step::Drag(10.0), Step::Push(3.0)];
    assert_eq!(scene.model.steps, [&moved[..], &turned[..], &[Step::Hold]].concat());
    assert_eq!(scene.accuracy.relative, 1e-9);
    let choice = scene.accuracy.choice;
    assert_eq!((choice.order, choice.elements, choice.step), (Some(5), Some(30), Some(0.05)));
    assert_eq!((scene.bounds.points, scene.bounds.time_s, scene.bounds.displacement), (50, Some(120.0), Some(500.0)));
    assert_eq!((scene.title.as_str(), scene.accuracy.terms), ("All", Terms::Auto));
    let wave = Substrate::Sinusoid(Sinusoid { height: 8.0, wavelength: 100.0, offset: -25.0 });
    assert_eq!(scene.model.ground, Ground { substrate: wave, start: Start::Crests });
    // pretension and friction are those of flat ground: pull.rs, friction.rs
    let elsewhere = |key: &Key| key.name == "pretension" || key.table == "friction";
    for key in KEYS.iter().filter(|key| key.belongs_to(&scene) && !elsewhere(key)) {
        assert!(text.contains(&format!("{} = ", key.name)), "{} is not in this test", key.path());
    }
}

/// Numbers that are all different, so that none can stand in another's place.
#[test]
fn every_key_of_a_spatula_is_read() {
    let text = r#"
[spatula]
pad_length = "201 nm"
neck_length = "102 nm"
shaft_length = "0.503 um"
bend_length = "54 nm"
tip_width = "205 nm"
neck_width = "56 nm"
shaft_diameter = "57 nm"
pad_thickness = "8 nm"
shaft_angle = "30 deg"
tip_rounding_length = "59 nm"
tip_rounding_width = "60 nm"
youngs_modulus = "3 GPa"
poissons_ratio = 0.3
shear_correction = 0.9
bending_stiffness_factor = 1.5
[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;
    let scene = Scene::parse("a.toml", text, &[]).unwrap();
    let Body::Spatula(spatula) = &scene.model.body else { panic!("{:?} is no spatula", scene.model.body) };
    let expected = Spatula {
        pad_length: 201.0,
        neck_length: 102.0,
        shaft_length: 503.0,
        bend_length: 54.0,
        tip_width: 205.0,
        neck_width: 56.0,
        shaft_diameter: 57.0,
        pad_thickness: 8.0,
        shaft_angle: 30f64.to_radians(),
        tip_rounding_length: 59.0,
        tip_rounding_width: 60.0,
        material: Material {
            youngs_modulus: 3.0,
            poissons_ratio: 0.3,
            shear_correction: 0.9,
            bending_stiffness_factor: 1.5,
        },
    };
    assert_eq!(*spatula, expected);
    assert_eq!(scene.model.length(), 806.0);
    for key in KEYS.iter().filter(|key| key.table == "spatula") {
        assert!(text.contains(&format!("{} = ", key.name)), "{} is not in this test", key.path());
    }
    assert_eq!(Scene::parse("a.toml", SPATULA, &[]).unwrap().model.body, Body::Spatula(Spatula::default()));
}

#[test]
fn every_shape_of_a_substrate_is_read() {
    let ground =
        |keys: &str| Scene::parse("a.toml", &format!("{MINIMAL}[substrate]\n{keys}"), &[]).unwrap().model.ground;
    assert_eq!(ground("shape = \"flat\""), Ground::default());
    for (word, shape) in [("sphere", Shape::Sphere), ("cylinder", Shape::Cylinder)] {
        // in any order
        let found = ground(&format!("offset = \"-3 nm\"\nradius = \"0.2 um\"\nshape = \"{word}\""));
        let substrate = Substrate::Round(Round { shape, radius: 200.0, offset: -3.0 });
        assert_eq!(found, Ground { substrate, start: Start::Conformed });
    }
    let found = ground("shape = \"profile\"\ntable = \"\"\"\nx_nm,height_nm\n0,0\n50,-8\n100,0\n\"\"\"\n");
    let Substrate::Profile(heights) = found.substrate else { panic!("{found:?}") };
    assert_eq!((heights.span(), heights.at(50.0)[0]), ((0.0, 100.0), -8.0));
}

#[test]
fn what_does_not_belong_to_a_substrate_is_named() {
    let on = |keys: &str| complaint(&format!("{MINIMAL}[substrate]\n{keys}"));
    assert_says(
        &on("shape = \"sphere\"\nradius = \"9 nm\"\nheight = \"8 nm\""),
        &[
            "line 12: `substrate.height` is a key of [substrate] for another `shape` than \"sphere\"",
            "shape \"sinusoid\"",
            "radius, offset, start",
        ],
    );
    assert_says(
        &on("radius = \"9 nm\""),
        &["`substrate.radius`", "than \"flat\"", "\"sphere\" or \"cylinder\"", "no other keys"],
    );
    assert_says(&on("shape = \"cylinder\""), &["[substrate] lacks `radius`", "radius = \"200 nm\""]);
    assert_says(&on("shape = \"wave\""), &["`substrate.shape` is \"wave\"", "\"flat\", \"sphere\", "]);
    assert_says(
        &on("shape = \"profile\"\ntable = \"no.csv\""),
        &["`substrate.table` names the file dir/no.csv, which cannot be read"],
    );
    assert_says(
        &on("shape = \"sphere\"\nradius = \"9 nm\"\noffset = \"9 nm\""),
        &["`substrate.offset` is 9 nm, and the strip begins beside the body", "less than `radius`"],
    );
    let forced = MINIMAL.replace("[adhesion]", "[adhesion]\nline_load = \"force-only\"");
    assert_says(
        &complaint(&format!("{forced}[substrate]\nshape = \"sphere\"\nradius = \"9 nm\"")),
        &["`adhesion.line_load` is \"force-only\"", "no potential"],
    );
    assert_says(
        &complaint(&format!("{SPATULA}[substrate]\nshape = \"sphere\"\nradius = \"1 nm\"")),
        &["`substrate.shape` lets the beam lie on", "at most 100", "a shorter strip or pad"],
    );
}

#[test]
fn a_scene_peels_one_body() {
    let both = MINIMAL.to_owned() + "[spatula]\ntip_width = \"100 nm\"\n";
    assert_says(
        &complaint(&both),
        &["dir/a.toml, line 10: `spatula.tip_width`", "a [strip]", "[strip], [spatula], [profile]"],
    );
    let error = with("spatula.tip_width", "100 nm").unwrap_err();
    assert_says(&error, &["--set spatula.tip_width=100 nm", "the scene peels a [strip]"]);
}

/// In the scene, or in a file beside it: the same beam.
#[test]
fn a_table_stands_in_the_scene_or_beside_it() {
    let scene = Scene::parse("a.toml", PROFILE, &[]).unwrap();
    let (inside, table) = (scene.model, scene.table_texts);
    let Body::Profile(profile) = &inside.body else { panic!("{:?} is no profile", inside.body) };
    assert!(matches!(profile.form, ProfileForm::Table(_)), "{profile:?} is no table");
    assert_eq!((inside.length(), inside.free_end(), inside.breaks()), (100.0, (20.0, 5.0), vec![40.0]));
    let folder = std::env::temp_dir().join(format!("peelkit-profile-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("beam.csv"), &table.profile).unwrap();
    let name = folder.join("a.toml").display().to_string();
    let text = PROFILE.split("\"\"\"").collect::<Vec<_>>();
    let beside = Scene::parse(&name, &format!("{}\"beam.csv\"{}", text[0], text[2]), &[]).unwrap();
    std::fs::remove_dir_all(folder).unwrap();
    assert_eq!((inside, table), (beside.model, beside.table_texts));
}

#[test]
fn what_is_wrong_with_a_table_is_named() {
    for (cell, wrong, parts) in [
        ("40, 20", "40, 0", ["line 3: `profile.table` has in row 2 `width_nm` = 0", "not above zero"]),
        ("100, 10", "30, 10", ["`profile.table` has in row 3 `s_nm` = 30", "does not ascend"]),
        ("angle_deg", "angle", ["`profile.table` has a column `angle`", "angle_deg, roundness"]),
        ("100, 10, 10, 30", "100, 10, 10", ["`profile.table` is no CSV", "s_nm, width_nm, height_nm and, optionally"]),
    ] {
        assert_says(&complaint(&PROFILE.replace(cell, wrong)), &parts);
    }
    let text = PROFILE.split("\"\"\"").collect::<Vec<_>>();
    let parts = ["dir/a.toml, line 3: `profile.table` names the file dir/no.csv, which cannot be read"];
    assert_says(&complaint(&format!("{}\"no.csv\"{}", text[0], text[2])), &parts);
}

/// In tables of their own or in one list: the same beam.
#[test]
fn pieces_are_read() {
    let read = |text: &str| Scene::parse("a.toml", text, &[]).unwrap().model;
    let beam = read(PIECES);
    let Body::Profile(profile) = &beam.body else { panic!("{:?} is no profile", beam.body) };
    let pad = Piece { width: [200.0, 150.0], ..Piece::straight(250.0, 200.0, 5.0) };
    let neck = Piece {
        length: 150.0,
        width: [150.0, 50.0],
        height: [5.0, 50.0],
        roundness: [0.0, 1.0],
        bend: 30f64.to_radians(),
        course: Course::Smooth,
        height_course: Course::Smooth,
    };
    assert_eq!(profile.form, ProfileForm::Pieces(ProfilePieces::new(vec![pad, neck]).unwrap()));
    assert_eq!((beam.length(), beam.free_end(), beam.breaks()), (400.0, (200.0, 5.0), vec![250.0]));
    let [before, first, second] = PIECES.split("[[profile.pieces]]\n").collect::<Vec<_>>()[..] else { panic!() };
    let (second, behind) = second.split_once("[adhesion]").unwrap();
    let inline = |lines: &str| format!("{{ {} }}", lines.trim().replace('\n', ", "));
    let list = format!("pieces = [{}, {}]", inline(first), inline(second));
    assert_eq!(read(&format!("{before}{list}\n[adhesion]{behind}")), beam);
    let (_, list) = list.split_once('=').unwrap();
    let over = Scene::parse("a.toml", &format!("{before}[adhesion]{behind}"), &set("profile.pieces", list));
    assert_eq!(over.unwrap().model, beam);
}

#[test]
fn what_is_wrong_with_pieces_is_named() {
    for (good, wrong, parts) in [
        (
            "length = \"150",
            "lenght = \"150",
            ["line 8: `profile.pieces` has in piece 2 the key `lenght`", "did you mean `length`?"],
        ),
        (
            "length = \"150 nm\"\n",
            "",
            ["line 8: `profile.pieces` has in piece 2 no `length`", "each with length, width"],
        ),
        (
            "length = \"150 nm\"",
            "length = 150",
            ["has in piece 2 `length` = 150, a number without a unit", "\"150 nm\""],
        ),
        ("\"0.25 um\"", "\"um\"", ["line 4: `profile.pieces` has in piece 1 `length` = \"um\"", "begin with a number"]),
        (
            "\"0.25 um\"",
            "\"0.25\"",
            ["piece 1 `length` = \"0.25\", whose amount has no unit (nm", "length = \"90 nm\""],
        ),
        ("\"0.25 um\"", "\"0 um\"", ["piece 1 `length` = 0 nm", "not above zero"]),
        ("\"0.25 um\"", "[\"1 nm\"]", ["piece 1 `length` = a list", "not a length with its unit"]),
        ("\"30 deg\"", "\"30 nm\"", ["piece 2 `bend` = \"30 nm\"", "none of an angle (rad, deg)"]),
        ("\"30 deg\"", "\"181 deg\"", ["rotates the underside by 181 deg up to the end of piece 2", "-180 to 180"]),
        ("[\"5 nm\", \"50 nm\"]", "[\"5 nm\"]", ["piece 2 `height` = a list, which has 1 values", "or two"]),
        (
            "[\"5 nm\", \"50 nm\"]",
            "\"6 nm\"",
            ["ends piece 1 with a height of 5 nm and begins the next with 6 nm", "the same"],
        ),
        (
            "height_course = \"smooth\"",
            "height_course = \"linear\"",
            ["has a kink between piece 1", "omit height_course from both"],
        ),
        ("[0, 1]", "[0, 1.5]", ["piece 2 `roundness` = 1.5", "from 0 to 1"]),
        ("[0, 1]", "\"round\"", ["piece 2 `roundness` = \"round\"", "not a number"]),
        ("course = \"smooth\"", "course = \"s5\"", ["piece 2 `course` = \"s5\"", "neither \"linear\" nor \"smooth\""]),
        ("[profile]", "[profile]\npieces = []", ["line ", "duplicate key"]),
        ("youngs", "table = \"a.csv\"\nyoungs", ["names the file dir/a.csv", "which cannot be read"]),
    ] {
        assert!(PIECES.contains(good), "{good}");
        assert_says(&complaint(&PIECES.replacen(good, wrong, 1)), &parts);
    }
    let without = PIECES.split("[[").next().unwrap();
    for (list, said) in [
        ("[]", "`profile.pieces` has 0 pieces; it takes 1 to 200"),
        ("[1]", "`profile.pieces` has as piece 1 1, no table of its keys"),
        ("{ length = \"1 nm\" }", "`profile.pieces` is a table"),
        ("\"pad\"", "`profile.pieces` is \"pad\""),
        (
            "[{ length = \"1 nm\", width = \"1 nm\", height = \"1 nm\" }]\ntable = \"s_nm\\n\"",
            "`profile.table` is given beside `profile.pieces`",
        ),
    ] {
        assert_says(&complaint(&format!("{without}pieces = {list}\n")), &["dir/a.toml, line ", said]);
    }
    let table = "[{ length = \"1 nm\", width = \"1 nm\", height = \"1 nm\" }]";
    let error = Scene::parse("a.toml", PROFILE, &set("profile.pieces", table)).unwrap_err();
    assert_says(
        &error.to_string(),
        &["--set profile.pieces=", "is given beside `profile.table`, and the beam has one geometry"],
    );
    assert_says(error.remedy(), &["Remove one of `pieces` and `table`."]);
}

#[test]
fn lengths_of_a_spatula_that_do_not_fit_are_named() {
    for (line, parts) in [
        ("tip_rounding_length = \"241 nm\"", ["`spatula.tip_rounding_length` is 241 nm", "(240 nm)"]),
        ("tip_rounding_length = \"9 nm\"\ntip_rounding_width = \"201 nm\"", ["_width` is 201 nm", "(200 nm)"]),
        ("bend_length = \"751 nm\"", ["`spatula.bend_length` is 751 nm", "(750 nm)"]),
        ("shaft_angle = \"200 deg\"", ["`spatula.shaft_angle` is 3.49", "e0 in rad"]),
        ("shaft_angle = \"4 nm\"", ["nm measures a length, not an angle", "45 deg"]),
        ("shaft_angle = 45", ["is 45, a number without a unit", "Write \"45 rad\""]),
    ] {
        let text = SPATULA.replace("[spatula]\n", &format!("[spatula]\n{line}\n"));
        assert_says(&complaint(&text), &parts);
    }
}

/// A strip on ground of this shape, with an example for each of its keys.
fn on_ground(shape: &str) -> String {
    let keys =
        KEYS.iter().filter(|key| key.table == "substrate" && key.name != "shape" && key.shapes().contains(&shape));
    let lines: String = keys.map(|key| format!("{} = {}\n", key.name, key.example())).collect();
    format!("{MINIMAL}[substrate]\nshape = \"{shape}\"\n{lines}")
}

#[test]
fn every_example_that_messages_give_is_right() {
    for key in KEYS {
        let text = match key.table {
            "spatula" => SPATULA.to_owned(),
            "profile" if key.name == "pieces" => PIECES.to_owned(),
            "profile" => PROFILE.to_owned(),
            "substrate" => on_ground(key.shapes()[0]),
            "friction" => format!("{MINIMAL}[friction]\nstrength = \"50 MPa\"\n"),
            _ if ["work", "strength"].contains(&key.name) => {
                MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\n")
            }
            _ if ["turn", "steps"].contains(&key.name) => format!("{MINIMAL}[grip]\nrotation = \"fixed\"\n"),
            _ if key.name == "pretension" => format!("{MINIMAL}[grip]\nhorizontal = \"fixed\"\n"),
            _ => MINIMAL.to_owned(),
        };
        Scene::parse("a.toml", &text, &set(&key.path(), key.example())).unwrap();
    }
}

#[test]
fn the_ready_scenes_are_right() {
    let strips = ["strip", "strip-100nm", "strip-soft", "strip-rough", "strip-friction", "strip-auto"];
    for name in strips.into_iter().chain(["spatula", "spatula-rough", "profile"]) {
        let path = format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        Scene::parse(&path, &std::fs::read_to_string(&path).unwrap(), &[]).unwrap();
    }
}

#[test]
fn the_ready_spatula_is_the_default() {
    let text = include_str!("../../scenes/spatula.toml");
    assert_eq!(Scene::parse("spatula.toml", text, &[]).unwrap().model, Spatula::default().model());
}

#[test]
fn the_remarks_of_the_ready_scene_show_the_defaults() {
    ["strip", "spatula", "profile"].into_iter().for_each(assert_remarks_show_defaults);
}

fn assert_remarks_show_defaults(name: &str) {
    let path = format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    // Every remark that is a line of a scene, but for what has no default.
    let is_line = |line: &str| {
        let rest = line.strip_prefix("# ").unwrap_or_default();
        let name = rest.split(" =").next().unwrap_or_default();
        (rest.starts_with('[') || KEYS.iter().any(|key| key.name == name)) && !rest.contains("unless given")
    };
    let uncommented: Vec<&str> = text.lines().map(|line| if is_line(line) { &line[2..] } else { line }).collect();
    let plain = Scene::parse(&path, &text, &[]).unwrap();
    assert_eq!(Scene::parse(&path, &uncommented.join("\n"), &[]).unwrap(), plain);
    let of_a_strip = |key: &Key| key.name != "pretension" || plain.model.strip().is_some();
    let shown = |key: &&Key| key.need == Need::Optional && key.belongs_to(&plain) && of_a_strip(key);
    for key in KEYS.iter().filter(shown) {
        assert!(text.contains(&format!("{} = ", key.name)), "{} is not shown", key.path());
    }
}

#[test]
fn every_mistake_in_a_value_is_named_with_its_line_and_remedy() {
    let lines = [
        ("length = 100", r#"`strip.length` is 100, a number without a unit"#, r#""100 nm""#),
        (r#"length = "100""#, r#"`strip.length` is "100", a number without a unit"#, r#""100 nm""#),
        (r#"length = "nm""#, "does not begin with a number", r#"length = "100 nm""#),
        (r#"length = "100 NM""#, r#"unit "NM" is not known"#, r#"Did you mean "nm"?"#),
        (r#"length = "100 GPa""#, "GPa measures a pressure, not a length", "nm, um, mm, m"),
        (r#"length = "100 nN""#, "nN measures a force, not a length", "nm, um, mm, m"),
        (r#"length = "-1 nm""#, "is -1 nm, which is out of range", "above zero"),
        (r#"length = "0 nm""#, "is 0 nm, which is out of range", "above zero"),
        (r#"length = "nan nm""#, "not a finite number", "above zero"),
        (r#"length = "inf nm""#, "not a finite number", "above zero"),
        (r#"length = "1e999 nm""#, "not a finite number", "above zero"),
        (r#"length = "1e-999 nm""#, "is 0 nm", "above zero"),
        ("length = nan", "a number without a unit", "nm"),
        ("length = true", "`strip.length` is true", "a length above zero"),
        ("length = [100]", "`strip.length` is a list", "a length above zero"),
        ("length = 2026-01-01", "`strip.length` is a date", "a length above zero"),
        ("length.nm = 100", "`strip.length` is a table", "a length above zero"),
        ("poissons_ratio = 0.5", "`strip.poissons_ratio` is 0.5", "between -1 and 0.5, both excluded"),
        ("poissons_ratio = -1", "`strip.poissons_ratio` is -1", "between -1 and 0.5, both excluded"),
        ("poissons_ratio = nan", "not a finite number", "between -1 and 0.5"),
        (r#"poissons_ratio = "0.2""#, "a number in quotes", "poissons_ratio = 0.2"),
        (r#"poissons_ratio = "0.2 nm""#, r#"is "0.2 nm""#, "a number between"),
        ("shear_correction = 0", "`strip.shear_correction` is 0", "a number above zero"),
        ("bending_stiffness_factor = -1", "`strip.bending_stiffness_factor` is -1", "a number above zero"),
        ("bending_stiffness_factor = inf", "not a finite number", "a number above zero"),
        ("lenght = 1", "`strip.lenght` is not a key", "Did you mean `length`?"),
        ("rotation = 1", "`strip.rotation` is not a key", "`rotation` stands in the table [grip]"),
        (
            "horizontl = 1",
            "`strip.horizontl` is not a key",
            "Did you mean `horizontal`, which stands in the table [grip]",
        ),
        ("colour = 1", "`strip.colour` is not a key", "length, height, width"),
    ];
    for (line, found, remedy) in lines {
        let complaint = complaint(&format!("title = \"x\"\n[strip]\n{line}\n"));
        assert_says(&complaint, &["dir/a.toml, line 3: ", found, remedy]);
    }
}

#[test]
fn every_mistake_in_a_choice_or_another_table_is_named() {
    let lines = [
        ("[adhesion]", r#"line_load = "fulll""#, r#"`adhesion.line_load` is "fulll""#, r#"Did you mean "full"?"#),
        ("[adhesion]", r#"line_load = "none""#, r#"`adhesion.line_load` is "none""#, r#""force-only" or "axis-gap""#),
        ("[adhesion]", r#"far_face = "true""#, "`adhesion.far_face`", "Remove the quotes"),
        ("[adhesion]", "far_face = 1", "`adhesion.far_face` is 1", "true or false"),
        ("[adhesion]", r#"hamaker_constant = "1e-19 nm""#, "nm measures a length, not an energy", "J"),
        ("[adhesion]", r#"equilibrium_distance = "0""#, "a number without a unit", "nm"),
        ("[grip]", r#"rotation = "Fixed""#, r#"is "Fixed""#, r#"Did you mean "fixed"?"#),
        ("[grip]", "horizontal = false", "`grip.horizontal` is false", r#""free" or "fixed""#),
        ("[accuracy]", "relative = 1e-12", "`accuracy.relative` is 1e-12", "from 1e-11 to 1e-2"),
        ("[accuracy]", "relative = 0.1", "`accuracy.relative` is 0.1", "from 1e-11 to 1e-2"),
        ("[bounds]", "points = 0", "`bounds.points` is 0", "a whole number from 1"),
        ("[bounds]", "points = 2.5", "which is not whole", "a whole number from 1"),
        ("[bounds]", "points = 99999999999999999999", "`bounds.points`", "a whole number from 1"),
        ("[bounds]", "time = 60", "a number without a unit", r#""60 s""#),
        ("[grip]", "stiffness = 0.5", "a number without a unit", r#""0.5 N/m""#),
        ("[bounds]", r#"displacement = "1 s""#, "s measures a time, not a length", "nm"),
        ("[girp]", "rotation = 1", "[girp] is not a table", "Did you mean [grip]?"),
        (
            "[spring]",
            "rotation = 1",
            "[spring] is not a table",
            "[strip], [spatula], [profile], [adhesion], [substrate], [friction], [grip]",
        ),
        ("[[strip]]", "length = 1", "`strip` is a list", "write [strip]"),
    ];
    for (table, line, found, remedy) in lines {
        let complaint = complaint(&format!("{table}\n{line}\n"));
        assert_says(&complaint, &["dir/a.toml, line ", found, remedy]);
    }
}

#[test]
fn a_key_in_no_table_and_a_table_that_is_none_are_named() {
    assert_says(&complaint("length = \"1 nm\""), &["line 1: `length`", "in the table [strip]"]);
    assert_says(&complaint("titel = \"x\""), &["line 1: `titel`", "Did you mean `title`?"]);
    assert_says(&complaint("title = 3"), &["line 1: `title` is 3", "a text in quotes"]);
    assert_says(&complaint("\nstrip = 3"), &["line 2: `strip` is 3", "write [strip]"]);
    assert_says(&complaint("[strip]\ntitle = \"x\""), &["line 2: `strip.title`", "at the top of the file"]);
}

#[test]
fn what_is_missing_is_named_with_an_example() {
    assert_says(&complaint(""), &["line 1: the scene lacks the table [strip]", r#"length = "100 nm""#]);
    let no_adhesion = MINIMAL.split("[adhesion]").next().unwrap();
    assert_says(&complaint(no_adhesion), &["the scene lacks the table [adhesion]", r#"hamaker_constant = "1e-19 J""#]);
    let no_table = PROFILE.split("table").next().unwrap();
    assert_says(
        &complaint(no_table),
        &["line 2: [profile] lacks `table` or `pieces` instead", "s_nm,width_nm,height_nm\\n0,20,5"],
    );
    for key in KEYS.iter().filter(|key| key.need == Need::Required && !["profile", "substrate"].contains(&key.table)) {
        let without: Vec<&str> = MINIMAL.lines().filter(|line| !line.starts_with(key.name)).collect();
        let example = format!("{} = ", key.name);
        let lacks = format!("[{}] lacks `{}`", key.table, key.name);
        assert_says(&complaint(&without.join("\n")), &["line ", &lacks, &example]);
    }
}

#[test]
fn what_is_not_toml_is_named_with_its_line() {
    assert_says(&complaint("[strip]\nlength = 100 nm"), &["line 2: `length` is not TOML", r#"length = "100 nm""#]);
    assert_says(&complaint("[strip\n"), &["line 1: this is not TOML", "peel new"]);
    assert_says(&complaint("[strip]\nlength = \"1 nm\"\nlength = \"2 nm\""), &["line 3: `length`", "duplicate"]);
    assert_says(&complaint("{\"strip\": 1}"), &["line 1: ", "is not TOML"]);
    assert_says(&complaint("[strip]\nlength = \"1 nm"), &["line 2: `length` is not TOML"]);
}

#[test]
fn an_override_replaces_a_key_with_or_without_quotes() {
    for value in ["50 nm", "50nm", "\"50 nm\"", "'50 nm'", " 0.05 um "] {
        assert_eq!(with("strip.length", value).unwrap().model.strip().unwrap().length, 50.0, "{value}");
    }
    assert_eq!(with("strip.poissons_ratio", "0.3").unwrap().model.strip().unwrap().poissons_ratio, 0.3);
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
    says("strip", "1 nm", &["--set strip=1 nm", "is not a key"]);
    says("", "1 nm", &["is not a key"]);
    says("grip.rotation", "fix", &["--set grip.rotation=fix", "\"free\" or \"fixed\""]);
    says("strip.poissons_ratio", "many", &["`strip.poissons_ratio` is \"many\"", "a number between"]);
    says("strip.length", "1 nm\n[grip]", &["--set strip.length=1 nm\\n[grip]: `strip.length` is \"1 nm\\n[grip]\""]);
    says("strip.length", &"1".repeat(5000), &["1111…"]);
}

proptest! {
    #[test]
    fn no_text_makes_the_parser_panic(text in "\\PC*") {
        let _ = Scene::parse("a.toml", &text, &[]);
    }

    #[test]
    fn no_override_makes_the_parser_panic(key in "\\PC*", value in "\\PC*") {
        let _ = with(&key, &value);
    }

    #[test]
    fn no_value_makes_the_parser_panic(index in 0..KEYS.len(), value in "[-+0-9.eE]{0,8}[ ]?[\\PC\n]{0,6}") {
        let _ = with(&KEYS[index].path(), &value);
    }

    /// A scene with some of its characters put out of place: read or refused with a message, and what is read is whole.
    #[test]
    fn no_garbled_scene_makes_the_parser_panic(edits in prop::collection::vec((0..MINIMAL.len(), any::<char>()), 1..6)) {
        let mut text: Vec<char> = MINIMAL.chars().collect();
        for (at, character) in edits {
            text[at] = character;
        }
        if let Ok(scene) = Scene::parse("a.toml", &text.into_iter().collect::<String>(), &[]) {
            let strip = *scene.model.strip().unwrap();
            prop_assert!(strip.length.is_finite() && strip.height.is_finite() && strip.youngs_modulus.is_finite());
        }
    }
}
