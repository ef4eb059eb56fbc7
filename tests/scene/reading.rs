//! What is read from a scene.
//!
//! Expected: a scene of three required lengths and constants gives the defaults of the handbook for everything else, and
//! prefixes of units change nothing.

use crate::text::{MINIMAL, PIECES, PROFILE, SPATULA, set};
use peelkit::adhesion::{BodyShape, CohesiveShape, LineLoad, Round, Sinusoid, Substrate};
use peelkit::beam::{Material, StretchLaw};
use peelkit::model::{
    Attraction, Body, Ground, Hold, Laminate, Layer, Piece, ProfileForm, ProfilePieces, Pull, Spatula, Start, Step,
    Transition,
};
use peelkit::study::{EventAction, EventAt, EventQuantity, FollowedUntil, Passing, StationAt, StationQuantity, Terms};
use peelkit_scene::{KEYS, Key, Scene};

#[test]
fn what_a_scene_leaves_out_has_its_default() {
    let scene = Scene::parse("dir/first.toml", MINIMAL, &[]).unwrap();
    let (strip, adhesion, grip) = (*scene.model.strip().unwrap(), scene.model.adhesion, scene.model.grip);
    assert_eq!((strip.length, strip.height, strip.width), (100.0, 10.0, 1.0));
    assert_eq!((strip.material.youngs_modulus, strip.material.poissons_ratio), (2.0, 0.2));
    assert_eq!((strip.material.shear_correction, strip.material.bending_stiffness_factor), (5.0 / 6.0, 1.0));
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
space = false
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
[path]
until = "detachment"
[output]
stations = { displacement = ["10 nm", "0.02 um"], end_rotation = "30 deg" }
events = [{ name = "half off", when = "front < 50 nm", action = "stop" }, { when = "P>0.04 nN" }]
units = "mm, uN"
[bounds]
points = 50
time = "2 min"
displacement = "0.5 um"
"#;
    let scene = Scene::parse("a.toml", text, &[]).unwrap();
    let (strip, adhesion, grip) = (*scene.model.strip().unwrap(), scene.model.adhesion, scene.model.grip);
    assert_eq!((strip.length, strip.height, strip.width), (200.0, 10.0, 2.0));
    assert_eq!((strip.material.youngs_modulus, strip.material.poissons_ratio), (3.0, -0.5));
    assert_eq!((strip.material.shear_correction, strip.material.bending_stiffness_factor), (1.0, 1e-4));
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
    assert_eq!(scene.bounds.until, FollowedUntil::Detachment);
    let at = |quantity, value| StationAt { quantity, value };
    let moved = [10.0, 20.0].map(|value| at(StationQuantity::Displacement, value));
    let turned = at(StationQuantity::EndRotation, 30f64.to_radians());
    assert_eq!(scene.stations, [&moved[..], &[turned]].concat());
    let units: Vec<&str> = scene.units.given().map(|unit| unit.name).collect();
    assert_eq!(units, ["µN", "mm"]);
    let event = |name: &str, quantity, passing, value, action| EventAt {
        name: name.to_owned(),
        quantity: EventQuantity::Named(quantity),
        value,
        passing,
        action,
    };
    let half_off = event("half off", StationQuantity::Front, Passing::Falling, 50.0, EventAction::Stop);
    let by_condition = event("P > 0.04 nN", StationQuantity::Force, Passing::Rising, 0.04, EventAction::Record);
    assert_eq!(scene.events, [half_off, by_condition]);
    assert_eq!((scene.title.as_str(), scene.accuracy.terms), ("All", Terms::Auto));
    let wave = Substrate::Sinusoid(Sinusoid { height: 8.0, wavelength: 100.0, offset: -25.0 });
    assert_eq!(scene.model.ground, Ground { substrate: wave, start: Start::Crests });
    // pretension, friction, a shear strength, a crack, layers, a law of stretch and yielding stand elsewhere: pull.rs, friction.rs, conflicts.rs, and below
    let elsewhere = |key: &Key| {
        ["pretension", "shear_strength", "shear_work", "mixing_exponent", "healing", "crack", "stretch", "layers"]
            .contains(&key.name)
            || ["yield_strength", "tangent_modulus"].contains(&key.name)
            || key.table == "friction"
    };
    for key in KEYS.iter().filter(|key| key.belongs_to(&scene) && !elsewhere(key)) {
        assert!(text.contains(&format!("{} = ", key.name)), "{} is not in this test", key.path());
    }
}

#[test]
fn a_crack_is_read_and_has_to_leave_something() {
    let with_crack = |crack: &str| Scene::parse("a.toml", MINIMAL, &[("strip.crack".into(), crack.into())]);
    assert_eq!(with_crack("0.02 um").unwrap().model.strip().unwrap().crack, Some(20.0));
    assert_eq!(Scene::parse("a.toml", MINIMAL, &[]).unwrap().model.strip().unwrap().crack, None);
    let error = with_crack("1 um").unwrap_err().to_string();
    assert!(error.contains("`strip.crack` is 1000 nm") && error.contains("nothing adheres"), "{error}");
}

/// A film that yields and hardens is read, and one that hardens without yielding is refused.
#[test]
fn a_film_that_yields_is_read() {
    let film = MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\n");
    let read = |keys: &[(&str, &str)]| {
        let set: Vec<_> = keys.iter().map(|(key, value)| (format!("strip.{key}"), (*value).to_owned())).collect();
        Scene::parse("a.toml", &film, &set)
    };
    let scene = read(&[("yield_strength", "60 MPa"), ("tangent_modulus", "0.2 GPa")]).unwrap();
    let material = scene.model.strip().unwrap().material;
    assert_eq!((material.yield_strength, material.tangent_modulus), (Some(0.06), Some(0.2)));
    let error = read(&[("tangent_modulus", "0.2 GPa")]).unwrap_err().to_string();
    assert!(error.contains("has no yield strength"), "{error}");
    let error = read(&[("yield_strength", "60 MPa"), ("tangent_modulus", "2 TPa")]).unwrap_err().to_string();
    assert!(error.contains("the strip would not yield"), "{error}");
}

/// Layers stand in place of height and material, which are refused beside them; the law of stretch stays, and the text that is written is read again.
#[test]
fn layers_and_a_law_of_stretch_are_read() {
    let layers = r#"[{ height = "30 um", youngs_modulus = "1 MPa", poissons_ratio = 0.49 }, { height = "50 um", youngs_modulus = "4 GPa" }]"#;
    let text = |rest: &str| {
        format!(
            "[strip]\nlength = \"5 mm\"\nlayers = {layers}\n{rest}\n[adhesion]\nlaw = \"exponential\"\nwork = \"50 J/m2\"\nstrength = \"1 MPa\"\n"
        )
    };
    let read = |rest: &str| Scene::parse("a.toml", &text(rest), &[]);
    let scene = read("stretch = \"neo-hookean\"").unwrap();
    let strip = *scene.model.strip().unwrap();
    let laminate = Laminate::new(&[
        Layer { height: 3e4, youngs_modulus: 1e-3, poissons_ratio: 0.49 },
        Layer { height: 5e4, youngs_modulus: 4.0, poissons_ratio: 0.2 },
    ]);
    assert_eq!(strip.layers, laminate.ok());
    assert_eq!((strip.material.stretch, strip.height), (StretchLaw::NeoHookean, strip.layers.unwrap().height()));
    let again = Scene::parse("b.toml", &scene.to_toml(), &[]).unwrap();
    assert_eq!(again.model, scene.model);
    let said = |rest: &str| read(rest).unwrap_err().to_string();
    for (key, value) in [("height", "\"50 um\""), ("youngs_modulus", "\"2 GPa\""), ("bending_stiffness_factor", "2.0")]
    {
        let said = said(&format!("{key} = {value}"));
        assert!(said.contains(&format!("`strip.{key}` is given beside `layers`, from which it follows")), "{said}");
    }
    let with = |layers: &str| {
        Scene::parse("a.toml", &text(""), &[("strip.layers".into(), layers.into())]).unwrap_err().to_string()
    };
    let thin = with("[{ height = \"30\", youngs_modulus = \"1 MPa\" }]");
    assert!(thin.contains("has in layer 1 `height` = \"30\", no number with its unit in quotes"), "{thin}");
    assert!(with("[]").contains("has 0 layers; it takes 1 to 8"));
    let wrong = with("[{ height = \"30 um\", youngs_modulus = \"1 MPa\", poissons_ratio = 0.5 }]");
    assert!(wrong.contains("has in layer 1 `poissons_ratio` = 0.5, which is out of range"), "{wrong}");
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
            stretch: StretchLaw::Linear,
            yield_strength: None,
            tangent_modulus: None,
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
    for (word, shape) in [("sphere", BodyShape::Sphere), ("cylinder", BodyShape::Cylinder)] {
        // in any order
        let found = ground(&format!("offset = \"-3 nm\"\nradius = \"0.2 um\"\nshape = \"{word}\""));
        let substrate = Substrate::Round(Round { shape, radius: 200.0, offset: -3.0 });
        assert_eq!(found, Ground { substrate, start: Start::Conformed });
    }
    let found = ground("shape = \"profile\"\ntable = \"\"\"\nx_nm,height_nm\n0,0\n50,-8\n100,0\n\"\"\"\n");
    let Substrate::Profile(heights) = found.substrate else { panic!("{found:?}") };
    assert_eq!((heights.span(), heights.at(50.0)[0]), ((0.0, 100.0), -8.0));
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
        course: Transition::Smooth,
        height_course: Transition::Smooth,
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
