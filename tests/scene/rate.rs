//! The table of a pull at a rate.
//!
//! Reference: the numbers of the text in the units of the library, by hand.
//!
//! Expected: rate, density and times arrive in m/s, kg/m³ and ns; a material has its own numbers and no other's; what is not followed in time is
//! refused; a scene with [time] comes back to the last bit when it is written, and is refused where equilibria are followed. Why: a rate that is
//! silently left out gives a force that is too small.

use crate::text::{MINIMAL, SETA, set};
use peelkit::beam::Viscosity;
use peelkit::study::Until;
use peelkit_scene::{Flow, Scene};

/// Kelvin and Voigt's material.
pub const KELVIN_VOIGT: &str =
    "[time]\nrate = \"1 mm/s\"\ndensity = \"1.3 g/cm3\"\nmaterial = \"kelvin-voigt\"\nretardation_time = \"2 us\"\n";
/// A standard linear solid.
pub const SOLID: &str = "[time]\nrate = \"1 mm/s\"\ndensity = \"1300 kg/m3\"\nmaterial = \"standard-linear-solid\"\n\
     relaxation_time = \"1 us\"\nstiffness_ratio = 2\n";

fn parse(text: &str) -> Scene {
    Scene::parse_any("strip.toml", text, &[]).unwrap()
}

#[test]
fn numbers_arrive_in_the_units_of_the_library() {
    let scene = parse(&format!("{MINIMAL}{KELVIN_VOIGT}held = \"3 ns\"\n"));
    let table = scene.time.as_ref().unwrap();
    let material = table.moving_material();
    assert_eq!((table.rate, material.density, table.material), (1e-3, 1300.0, Flow::KelvinVoigt));
    let Viscosity::KelvinVoigt { retardation_time } = material.viscosity else { panic!("{material:?}") };
    approx::assert_relative_eq!(retardation_time, 2e3, max_relative = 1e-15);
    let pull = scene.pull_rate(table);
    assert_eq!((pull.rate, pull.from, pull.to, pull.accelerates), (1e-3, 0.0, scene.model.length(), None));
    let Until::Held(held) = pull.until else { panic!("{pull:?}") };
    approx::assert_relative_eq!(held, 3.0, max_relative = 1e-15);
    let solid = parse(&format!("{MINIMAL}{SOLID}displacement = \"1 nm\"\n"));
    let table = solid.time.as_ref().unwrap();
    let Viscosity::StandardLinearSolid { relaxation_time, stiffness_ratio } = table.moving_material().viscosity else {
        panic!("{table:?}")
    };
    approx::assert_relative_eq!(relaxation_time, 1e3, max_relative = 1e-15);
    assert_eq!(
        (stiffness_ratio, solid.pull_rate(table).to, solid.pull_rate(table).until),
        (2.0, 1.0, Until::ContactLost)
    );
}

#[test]
fn the_root_of_a_seta_is_pulled_at_the_angle_of_the_drive() {
    let text = format!("{SETA}{}displacement = \"3 um\"\n[drive]\nangle = \"30 deg\"\n", SOLID.replace("1300", "0"));
    let scene = parse(&text);
    let (table, seta) = (scene.time.as_ref().unwrap(), scene.seta.as_ref().unwrap());
    let pull = scene.seta_pull_rate(table, seta);
    assert_eq!((pull.rate, pull.most, pull.accelerates), (1e-3, 3000.0, 20.0));
    assert_eq!(pull.direction, scene.seta_loading(seta).steps[0].direction);
    approx::assert_relative_eq!(pull.direction[1], 0.5, max_relative = 1e-15);
    assert_eq!(scene.seta_time_accuracy(table).tolerance, 1e-5);
    let (fine, whole) = (
        parse(&text.replace("3 um\"", "3 um\"\ntolerance = 1e-6")),
        parse(&text.replace("displacement = \"3 um\"", "")),
    );
    assert_eq!(fine.seta_time_accuracy(fine.time.as_ref().unwrap()).tolerance, 1e-6);
    assert_eq!(whole.seta_pull_rate(whole.time.as_ref().unwrap(), whole.seta.as_ref().unwrap()).most, 98_000.0);
}

#[test]
fn a_rate_is_written_and_read_to_the_last_bit() {
    let seta = format!("{SETA}{}", SOLID.replace("1300", "0"));
    for text in [format!("{MINIMAL}{KELVIN_VOIGT}"), format!("{MINIMAL}{SOLID}"), seta] {
        let scene = parse(&text);
        assert_eq!(parse(&scene.to_toml()), scene);
    }
    let of_overrides = [set("time.rate", "0.3 mm/s"), set("time.density", "0 kg/m3")].concat();
    let scene = Scene::parse_any("strip.toml", MINIMAL, &of_overrides).unwrap();
    assert_eq!(scene.time.unwrap().rate, 3e-4);
}

/// An adhesive that resists its opening: 1 is the exponent where none is given. What is printed comes back.
#[test]
fn a_rate_of_opening_is_read() {
    let tape = MINIMAL.replace("[adhesion]\n", "[adhesion]\nlaw = \"exponential\"\n") + KELVIN_VOIGT;
    for (exponent, expected) in [("", 1.0), ("rate_exponent = 0.4\n", 0.4)] {
        let text = format!("{tape}opening_rate = \"10 um/s\"\n{exponent}");
        let scene = Scene::parse_any("strip.toml", &text, &[]).unwrap();
        let opening = scene.time.as_ref().unwrap().moving_material().opening.unwrap();
        approx::assert_relative_eq!(opening.reference, 1e-5, max_relative = 1e-15);
        assert_eq!(opening.exponent, expected);
        assert_eq!(Scene::parse_any("strip.toml", &scene.to_toml(), &[]).unwrap(), scene);
    }
}

#[test]
fn what_does_not_fit_is_refused_with_its_place() {
    let refused = |text: &str, overrides: &[(String, String)], words: &[&str]| {
        let error = Scene::parse_any("strip.toml", text, overrides).unwrap_err();
        let all = format!("{error} {}", error.remedy());
        for word in words {
            assert!(all.contains(word), "{all} lacks {word}");
        }
    };
    let plain = format!("{MINIMAL}[time]\nrate = \"1 mm/s\"\n");
    refused(&plain, &[], &["[time] lacks `density`", "1300 kg/m3"]);
    let elastic = format!("{plain}density = \"1300 kg/m3\"\n");
    refused(&elastic, &set("time.retardation_time", "1 us"), &["`time.retardation_time` is given", "kelvin-voigt"]);
    refused(&elastic, &set("time.material", "kelvin-voigt"), &["`time.material` is", "with a `retardation_time`"]);
    refused(&elastic, &set("time.material", "maxwell"), &["none of its values", "standard-linear-solid"]);
    refused(&elastic, &set("time.rate", "1 s"), &["s measures a time, not a velocity", "m/s"]);
    refused(&elastic, &set("time.density", "-1 kg/m3"), &["out of range"]);
    refused(&elastic, &set("drive.steps", "[\"press 0.1 nm\"]"), &["steps before the pull", "not followed in time"]);
    refused(&elastic, &set("friction.strength", "50 MPa"), &["has friction", "not followed in time"]);
    refused(&elastic, &set("drive.turn", "0.1 deg/nm"), &["drive.turn", "not followed in time"]);
    refused(&elastic, &set("grip.pretension", "1 nN"), &["grip.pretension", "not followed in time"]);
    refused(&elastic, &set("time.opening_rate", "1 mm/s"), &["no beam under a cohesive law", "exponential"]);
    refused(&elastic, &set("time.rate_exponent", "0.4"), &["the adhesive has no `opening_rate`"]);
    let tape = elastic.replace("[adhesion]\n", "[adhesion]\nlaw = \"exponential\"\n");
    refused(&tape, &set("time.opening_rate", "0 m/s"), &["out of range"]);
    refused(&tape, &set("time.rate_exponent", "3"), &["out of range"]);
    refused(&elastic, &set("terms", "auto"), &["terms = \"auto\"", "not followed in time"]);
    refused(&elastic, &set("space", "true"), &["is in space", "not followed in time"]);
    let seta = format!("{SETA}{}", SOLID.replace("1300", "0"));
    refused(&format!("{SETA}{SOLID}"), &[], &["`time.density` is above zero, and the mass of a seta", "0 kg/m3"]);
    refused(&seta, &set("seta.preload", "1 nN"), &["`seta.preload`", "not followed in time"]);
    refused(&seta, &set("drive.steps", "[\"drag 1 nm\"]"), &["`drive.steps`", "not followed in time"]);
    refused(&seta, &set("time.held", "1 ns"), &["`time.held` is given", "[time] without `held`"]);
    let error = Scene::parse("strip.toml", &elastic, &[]).unwrap_err();
    assert_eq!(error.key(), Some("time"));
    assert!(error.to_string().contains("here equilibria are followed"), "{error}");
}
