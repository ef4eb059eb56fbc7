//! The table of a seta, what stands beside it, and what its root is told to do.
//!
//! Reference: the defaults of the model, written out by hand below; directions from the angles by sine and cosine.
//!
//! Expected: a scene with [seta] has the default spatula at its tips where it names no body, comes back to the last bit when it is written, and
//! every key without a meaning for a seta is refused with its place. Why: a seta that is silently computed as one of its spatulae, or the other
//! way round, would be a wrong number without a message.

use crate::text::{MINIMAL, SETA, set};
use peelkit::model::{Body, Seta, Spatula};
use peelkit::study::{SetaLoading, SetaStart, SetaStep, StepEnd};
use peelkit_scene::{KEYS, Scene};

fn parse(text: &str) -> Scene {
    Scene::parse_any("seta.toml", text, &[]).unwrap()
}

#[track_caller]
fn refused(text: &str, overrides: &[(String, String)], message: &str) {
    let error = Scene::parse_any("seta.toml", text, overrides).unwrap_err();
    let whole = format!("{error}: {}", error.remedy());
    assert!(whole.contains(message), "{whole}");
}

#[test]
fn a_seta_has_the_defaults_of_the_model() {
    let scene = parse(SETA);
    let table = scene.seta.clone().unwrap();
    // "60 deg" is no multiple of π to the last bit
    approx::assert_relative_eq!(table.seta.shaft_angle, Seta::default().shaft_angle, max_relative = 1e-15);
    assert_eq!(Seta { shaft_angle: table.seta.shaft_angle, ..Seta::default() }, table.seta);
    assert_eq!((table.lateral_stiffness, table.preload, table.contact_height), (None, None, 0.0));
    assert_eq!(scene.tip_model(), Spatula::default().model());
    let strip = "[strip]\nlength = \"100 nm\"\nheight = \"10 nm\"\nyoungs_modulus = \"2 GPa\"\n";
    assert!(matches!(parse(&format!("{SETA}{strip}")).tip_model().body, Body::Strip(_)));
}

#[test]
fn the_ready_seta_shows_every_key_with_its_default() {
    let text = include_str!("../../scenes/seta.toml");
    let plain = parse(text);
    assert_eq!(plain.seta, parse(SETA).seta);
    let shows = |line: &str| line.starts_with("# ") && line.contains(" = ") && !line.contains("unless given");
    let uncommented: Vec<&str> = text.lines().map(|line| if shows(line) { &line[2..] } else { line }).collect();
    assert_eq!(parse(&uncommented.join("\n")), plain);
    for key in KEYS.iter().filter(|key| key.table == "seta") {
        assert!(text.contains(&format!("{} = ", key.name)), "{} is not shown", key.path());
    }
}

#[test]
fn spatulae_that_are_beams_take_no_key_of_a_law() {
    let with = |lines: &str| SETA.replace("[seta]", &format!("[seta]\ntip_law = \"beam\"\n{lines}"));
    let pressed = parse(&with("preload = \"1 nN\"\n"));
    let loading = pressed.seta_loading(pressed.seta.as_ref().unwrap());
    assert!(matches!(loading.start, SetaStart::Above(height) if height >= 100.0), "{loading:?}");
    for (line, message) in [
        ("tip_table = \"out/tip\"\n", "names a table, and the spatulae are beams"),
        ("tip_tolerance = 1e-2\n", "is that of a table, and the spatulae are beams"),
        ("resolve_within = \"20 nm\"\n", "no longer taken from a table, and the spatulae are beams"),
        ("lateral_stiffness = \"1 N/m\"\n", "spatulae that are beams slide freely"),
        ("contact_height = \"1 nm\"\n", "spatulae that are beams adhere again where the attraction pulls them down"),
    ] {
        refused(&with(line), &[], message);
    }
    let held = with("").replace("[adhesion]\n", "[adhesion]\nlaw = \"exponential\"\nshear_strength = \"20 MPa\"\n");
    let scene = parse(&held);
    assert_eq!(scene.tip_in_space().adhesion.shear_strength, Some(0.02));
    assert_eq!(scene.tip_model().adhesion.shear_strength, None);
    let pressed = held.replace("[seta]", "[seta]\npreload = \"1 nN\"");
    refused(&pressed, &[], "spatulae that are held along the ground adhere where they lie at the start");
    refused(&held.replace("law = \"exponential\"\n", ""), &[], "belongs to a cohesive law");
    let by_curve = held.replace("tip_law = \"beam\"", "tip_law = \"curve\"");
    refused(&by_curve, &[], "is given beside a body that is no strip, in the plane");
    let timed = format!("{}[time]\nrate = \"1 mm/s\"\ndensity = \"0 kg/m3\"\n", with(""));
    refused(&timed, &[], "a seta whose spatulae are beams is not followed in time");
}

/// Three branches, each with two tips.
const TREE: &str = "1 0 0 30 0 1 -1\n2 0 0 9 0 1 1\n3 0 -2 0 0 0.4 2\n4 0 2 0 0 0.4 2\n5 0 0 0.3 1 0.4 2\n";

#[test]
fn a_seta_branches_by_lists_or_as_a_tree() {
    let with = |lines: &str| SETA.replace("[seta]", &format!("[seta]\n{lines}"));
    let lists = "branches = [3, 2]\nfork_heights = [\"28 um\", \"1.2345678901 um\"]\ndiameters = [\"4 um\", \"2 um\", \"0.7 um\"]\n";
    let scene = parse(&with(lists));
    let seta = &scene.seta.as_ref().unwrap().seta;
    assert_eq!((&seta.branches[..], &seta.diameters[..]), (&[3, 2][..], &[4e3, 2e3, 700.0][..]));
    assert_eq!((seta.tips(), seta.joint_place(2)[1], seta.branch_diameter(5)), (6, 1234.5678901, 700.0));
    assert_eq!(parse(&scene.to_toml()), scene);
    let drawn = parse(&with(&format!("tree = \"\"\"\n{TREE}\"\"\"\n")));
    let seta = &drawn.seta.as_ref().unwrap().seta;
    assert_eq!((seta.tips(), seta.levels(), seta.spread()), (3, 1, 300.0));
    assert_eq!(parse(&drawn.to_toml()), drawn);
    // the pull ends where the root has moved by the longest way to a tip
    let SetaLoading { steps, .. } = drawn.seta_loading(drawn.seta.as_ref().unwrap());
    let longest = 21e3 + 2e3f64.hypot(9e3);
    assert!(
        matches!(steps[..], [SetaStep { until: StepEnd::Detached(most), .. }] if (most / longest - 1.0).abs() < 1e-12)
    );

    for (lines, said) in [
        ("forks = 2\nbranches = [2, 2]", "`seta.forks` is given beside `seta.branches`, and the seta has one geometry"),
        ("brush_height = \"9 um\"\nforks = 1\nfork_heights = [\"9 um\"]", "is given beside `seta.fork_heights`"),
        ("diameter_ratio = 0.5\nforks = 1\ndiameters = [\"4 um\", \"2 um\"]", "is given beside `seta.diameters`"),
        ("fork_heights = [\"9 um\"]", "has 1 numbers, and a way from the root to a tip of the seta 8 forks"),
        ("branches = [2, 2.5]", "has 2.5, no whole number from 1 to 64"),
        ("branches = 3", "is 3, no list"),
        ("branches = []", "is an empty list"),
        ("forks = 1\nfork_heights = [\"9 GPa\"]", "no positive length with its unit"),
        ("branches = [64, 64, 2]", "end in 8192 tips: give branches for at most 4096"),
    ] {
        refused(&with(lines), &[], said);
    }
    // by an override they take the place of what the text says
    let whole = "forks = 4\nshaft_diameter = \"3 um\"\ndiameter_ratio = 0.5\nbrush_height = \"20 um\"";
    for (path, value, tips) in [
        ("seta.branches", "[3, 2]", 6),
        ("seta.tree", TREE, 3),
        ("seta.diameters", "[\"2 um\", \"1 um\", \"1 um\", \"1 um\", \"1 um\"]", 16),
    ] {
        let scene = Scene::parse_any("seta.toml", &with(whole), &set(path, value)).unwrap();
        assert_eq!((scene.seta.as_ref().unwrap().seta.tips(), path), (tips, path));
        // the number of forks that says nothing is not written
        assert_eq!(parse(&scene.to_toml()).to_toml(), scene.to_toml());
    }
    let both = [set("seta.forks", "3"), set("seta.branches", "[3, 2]")].concat();
    refused(&with(whole), &both, "`seta.forks` is given beside `seta.branches`");
    let tree = |text: &str| with(&format!("tree = \"\"\"\n{text}\"\"\"\ntip_pitch = \"1 um\"\n"));
    refused(&tree(TREE), &[], "`seta.tip_pitch` is given beside `seta.tree`");
    refused(&tree(&TREE.replace("0 0.3 1", "0 x 1")), &[], "has in line 5 y = x, which is no number");
    refused(&with("tree = \"no.swc\""), &[], "names the file no.swc, which cannot be read");
    let error = Scene::parse_without_files("a", &with("tree = \"no.swc\""), &[]).unwrap_err().to_string();
    assert!(error.contains("names a file, and this scene is read without files"), "{error}");
}

#[test]
fn the_root_goes_where_the_scene_says() {
    let text = format!(
        "{SETA}[drive]\nangle = \"30 deg\"\nazimuth = \"90 deg\"\nsteps = [\"press 300 nm\", \"hold\", \"push 2 um\", \"shift -1 um\"]\n"
    );
    let scene = parse(&text.replace("[seta]", "[seta]\npreload = \"2 uN\"\ncontact_height = \"3 nm\""));
    let SetaLoading { start, steps } = scene.seta_loading(scene.seta.as_ref().unwrap());
    assert_eq!(start, SetaStart::Above(204.0));
    let step = |direction, until| SetaStep { direction, until };
    assert_eq!(
        steps[..4],
        [
            step([0.0, -1.0, 0.0], StepEnd::Preload(2000.0)),
            step([0.0, -1.0, 0.0], StepEnd::Travel(300.0)),
            step([-1.0, 0.0, 0.0], StepEnd::Travel(2000.0)),
            step([0.0, 0.0, -1.0], StepEnd::Travel(1000.0)),
        ]
    );
    let pull = steps[4];
    assert_eq!(pull.until, StepEnd::Detached(98_000.0));
    for (found, expected) in pull.direction.into_iter().zip([0.0, 0.5, 0.75f64.sqrt()]) {
        approx::assert_abs_diff_eq!(found, expected, epsilon = 1e-15);
    }
    let plain = parse(SETA);
    let loading = plain.seta_loading(plain.seta.as_ref().unwrap());
    assert_eq!(loading, SetaLoading::pull([0.0, 1.0, 0.0], 98_000.0));
}

#[test]
fn what_has_no_meaning_for_a_seta_is_refused() {
    for (line, key) in [
        ("[grip]\nrotation = \"fixed\"", "`grip.rotation`"),
        ("[friction]\nstrength = \"50 MPa\"", "`friction.strength`"),
        ("[substrate]\nshape = \"sphere\"\nradius = \"1 um\"", "`substrate.shape`"),
        ("[drive]\nturn = \"1 deg/nm\"", "`drive.turn`"),
        ("[accuracy]\nelements = 30", "`accuracy.elements`"),
    ] {
        refused(&format!("{SETA}{line}\n"), &[], &format!("{key} is given, and the scene has a [seta]"));
    }
    refused(&format!("space = true\n{SETA}"), &[], "`space` is given, and the scene has a [seta]");
    refused(MINIMAL, &set("seta.forks", "4"), "is a key of [seta], a table that the scene does not have");
    refused(SETA, &set("grip.rotation", "fixed"), "`grip.rotation` is given, and the scene has a [seta]");
    let steps = |steps: &str| format!("{SETA}[drive]\nsteps = [\"{steps}\"]\n");
    refused(&steps("turn 3 deg"), &[], "the root of a seta does not rotate and is never released");
    refused(&steps("release"), &[], "The steps of a seta are press, lift, drag, push, shift and hold");
    refused(&steps("press 0 nm"), &[], "has as step 1");
}

#[test]
fn numbers_out_of_range_and_near_misses_are_named() {
    let with = |line: &str| SETA.replace("[seta]", &format!("[seta]\n{line}"));
    refused(&with("forks = 13"), &[], "`forks` takes a whole number from 1 to 12");
    refused(&with("shaft_angle = \"90 deg\""), &[], "is 90 deg, which is out of range");
    refused(&with("diameter_ratio = 1.0"), &[], "is 1, which is out of range");
    refused(&with("shaft_lenght = \"70 um\""), &[], "Did you mean `shaft_length`?");
    refused(&with("height_scatter = \"900 nm\""), &[], "`seta.height_scatter` cannot be computed");
    refused("[sseta]\n", &[], "Did you mean [seta]?");
    let error = Scene::parse("seta.toml", SETA, &[]).unwrap_err();
    assert_eq!((error.place(), error.key()), (Some("seta.toml, line 2"), Some("seta")));
    assert!(
        error.problem().contains(
            "is a table of a scene that `peel run`, `sweep`, `coarsen`, `fit`, `optimise` and `uncertainty` alone compute"
        ),
        "{error}"
    );
}

/// The ranges of the keys are those of the model.
#[test]
fn the_model_takes_what_the_scene_takes() {
    let number = |key: &str| SETA.replace("[seta]", &format!("[seta]\n{key}"));
    for line in
        ["shaft_angle = \"-88 deg\"", "brush_angle = \"88 deg\"", "height_ratio = 0.01", "forks = 1", "forks = 12"]
    {
        let text = number(line).replace("[seta]\n", "[seta]\nheight_scatter = \"0 nm\"\n");
        parse(&text).seta.unwrap().seta.check().unwrap();
    }
}
