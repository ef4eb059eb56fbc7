//! The scenes that come with the program, and the examples that its messages give.

use crate::text::{MINIMAL, PIECES, PROFILE, SETA, SPATULA, set};
use peelkit::model::Spatula;
use peelkit_scene::{Described, KEYS, Key, Need, Scene};

/// A strip on ground of this shape, with an example for each of its keys.
fn on_ground(shape: &str) -> String {
    let keys =
        KEYS.iter().filter(|key| key.table == "substrate" && key.name != "shape" && key.shapes().contains(&shape));
    let lines: String = keys.map(|key| format!("{} = {}\n", key.name, key.example())).collect();
    format!("{MINIMAL}[substrate]\nshape = \"{shape}\"\n{lines}")
}

/// A table that fits every example of its keys.
const OPTIMISED: &str = r#"
[optimise]
objective = "peak.force_nN"
parameters = [{ key = "strip.poissons_ratio", from = 0.1, to = 0.3 }]
holding_angle = "40 deg"
release_angle = "100 deg"
"#;

/// A pull at a rate, of a material that has this key.
fn timed(key: &str) -> &'static str {
    match key {
        "material" => "[time]\nrate = \"1 mm/s\"\ndensity = \"1300 kg/m3\"\n",
        "retardation_time" => crate::rate::KELVIN_VOIGT,
        _ => crate::rate::SOLID,
    }
}

#[test]
fn every_example_that_messages_give_is_right() {
    // of a law there has to be a folder, or a scene: tests/command/seta_law.rs reads them
    for key in KEYS.iter().filter(|key| !["setae.law", "setae.seta"].contains(&key.path().as_str())) {
        let text = match key.table {
            "spatula" => SPATULA.to_owned(),
            "profile" if key.name == "pieces" => PIECES.to_owned(),
            "strip" if key.name == "layers" => {
                let bare = MINIMAL.replace("height = \"10 nm\"\n", "").replace("youngs_modulus = \"2 GPa\"\n", "");
                bare.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\n")
            }
            "profile" => PROFILE.to_owned(),
            "substrate" => on_ground(key.shapes()[0]),
            "optimise" => MINIMAL.replace("height = \"10 nm\"", "height = \"5 nm\"\nwidth = \"10 nm\"") + OPTIMISED,
            "seta" if ["tip_table", "tip_tolerance", "resolve_within"].contains(&key.name) => {
                SETA.replace("[seta]", "[seta]\ntip_law = \"table\"")
            }
            "seta" if ["fork_heights", "diameters"].contains(&key.name) => {
                SETA.replace("[seta]", "[seta]\nbranches = [2, 2, 2]")
            }
            "seta" => SETA.to_owned(),
            "setae" if key.name == "last_reach" => "[setae]\nreach = \"5 um\"\n[lamella]\n".to_owned(),
            "setae" | "lamella" => "[setae]\n[lamella]\n".to_owned(),
            "patch" => "[setae]\n[patch]\npress = \"3 mm\"\n".to_owned(),
            "toe" => "[setae]\n[lamella]\n[toe]\n".to_owned(),
            "solid" if key.name == "across" => {
                include_str!("../../scenes/spatula.toml").replace("# far_face = true", "far_face = false")
                    + "\n[solid]\n"
            }
            "solid" => format!("{MINIMAL}[solid]\n"),
            "time" if ["opening_rate", "rate_exponent"].contains(&key.name) => {
                let law = MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\n");
                format!("{law}{}opening_rate = \"2 mm/s\"\n", timed("material"))
            }
            "time" => format!("{MINIMAL}{}", timed(key.name)),
            "friction" => format!("{MINIMAL}[friction]\nstrength = \"50 MPa\"\n"),
            "adhesion" if key.name == "table" => MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"table\"\n"),
            _ if key.name == "shear_work" => {
                MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\nshear_strength = \"0.1 GPa\"\n")
            }
            _ if key.name == "mixing_exponent" => {
                let law = "law = \"bilinear\"\nshear_strength = \"0.1 GPa\"\nshear_work = \"0.1 J/m2\"\n";
                MINIMAL.replace("[adhesion]\n", &format!("[adhesion]\n{law}"))
            }
            _ if key.name == "tangent_modulus" => {
                let film = MINIMAL.replace("[strip]\n", "[strip]\nyield_strength = \"50 MPa\"\n");
                film.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\n")
            }
            _ if ["work", "strength", "shear_strength", "yield_strength"].contains(&key.name) => {
                MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"bilinear\"\n")
            }
            _ if ["turn", "steps"].contains(&key.name) => format!("{MINIMAL}[grip]\nrotation = \"fixed\"\n"),
            _ if key.name == "pretension" => format!("{MINIMAL}[grip]\nhorizontal = \"fixed\"\n"),
            "fit" => format!("{MINIMAL}[fit]\nparameters = [\"strip.youngs_modulus\"]\n"),
            "uncertainty" => {
                let input =
                    |key| format!("{{ key = \"strip.{key}\", distribution = \"lognormal\", log_deviation = 0.1 }}");
                format!("{MINIMAL}[uncertainty]\ninputs = [{}, {}]\n", input("height"), input("width"))
            }
            _ => MINIMAL.to_owned(),
        };
        Scene::parse_any("a.toml", &text, &set(&key.path(), key.example())).unwrap();
    }
}

#[test]
fn the_ready_scenes_are_right() {
    let mut read = 0;
    for folder in ["scenes", "scenes/teaching"] {
        let folder = format!("{}/../../{folder}", env!("CARGO_MANIFEST_DIR"));
        for file in std::fs::read_dir(folder).unwrap() {
            let path = file.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                let text = std::fs::read_to_string(&path).unwrap();
                let name = path.to_str().unwrap();
                let scene = Scene::parse_any(name, &text, &[]).unwrap();
                assert_eq!(Scene::parse(name, &text, &[]).is_err(), !matches!(scene.describes(), Described::Peel));
                read += 1;
            }
        }
    }
    assert!(read >= 20, "{read}");
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
    let of_a_strip = |key: &Key| {
        !["pretension", "shear_strength", "shear_work", "mixing_exponent", "healing"].contains(&key.name)
            || plain.model.strip().is_some()
    };
    let shown = |key: &&Key| key.need == Need::Optional && key.belongs_to(&plain) && of_a_strip(key);
    for key in KEYS.iter().filter(shown) {
        assert!(text.contains(&format!("{} = ", key.name)), "{} is not shown", key.path());
    }
}
