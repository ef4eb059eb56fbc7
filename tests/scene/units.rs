//! Units as a mechanics person writes them, and what is said of others and of commas.
//!
//! Expected: SI units with prefixes and powers in every usual spelling; nothing that is not metric; a comma in a number is named as
//! such. Why: a length of 1 mil is 25.4 µm, and "0,4 nm" has no wrong unit.

use crate::text::{MINIMAL, assert_says, complaint, with};
use peelkit_scene::{Dimension, Scene, find_key, parse_quantity};

#[test]
fn units_of_mechanics_are_read() {
    let cohesive = MINIMAL.to_owned() + "law = \"bilinear\"\n";
    for work in ["30 mN/m", "30 mJ/m²", "0.03 J/m^2", "0.03 J/m2", "0.03 N/m", "3e-20 J/nm²"] {
        let scene = Scene::parse("a.toml", &format!("{cohesive}work = \"{work}\""), &[]).expect(work);
        assert!((scene.model.adhesion.work.unwrap() / 0.03 - 1.0).abs() < 1e-15, "{work}");
    }
    for modulus in ["2 GPa", "2000 MPa", "2e9 N/m²", "2e9 N/m2", "2000 N/mm^2", "2 nN/nm2", "2e9 Pa"] {
        assert_eq!(
            with("strip.youngs_modulus", modulus).unwrap().model.strip().unwrap().material.youngs_modulus,
            2.0,
            "{modulus}"
        );
    }
    for length in ["100 nm", "0.1 µm", "0.1 μm", "0.1 um", "1e-4 mm", "1000 Å"] {
        assert_eq!(with("strip.length", length).unwrap().model.strip().unwrap().length, 100.0, "{length}");
    }
    for angle in ["60 deg", "60°", "60 °"] {
        assert_eq!(with("drive.angle", angle).unwrap().model.pull.angle, 60f64.to_radians(), "{angle}");
    }
}

#[test]
fn units_that_are_not_metric_are_refused_as_such() {
    for unit in ["mil", "mi", "in", "inch", "ft", "yd"] {
        let said = format!("`strip.length` is \"1 {unit}\": {unit} is no metric unit");
        assert_says(&with("strip.length", &format!("1 {unit}")).unwrap_err(), &[&said, "(nm, um, mm, m, pm)"]);
    }
    for unit in ["psi", "ksi", "lbf/in2"] {
        let said = format!("{unit} is no metric unit");
        assert_says(&with("strip.youngs_modulus", &format!("1 {unit}")).unwrap_err(), &[&said, "GPa, MPa"]);
    }
    assert_says(&with("grip.pretension", "1 lbf").unwrap_err(), &["lbf is no metric unit", "nN, uN"]);
}

/// Every unit that a message proposes is one that is read.
#[test]
fn proposed_units_are_read() {
    for dimension in [
        Dimension::Length,
        Dimension::Pressure,
        Dimension::Energy,
        Dimension::Time,
        Dimension::Stiffness,
        Dimension::Angle,
        Dimension::Work,
        Dimension::Force,
        Dimension::AnglePerLength,
    ] {
        for unit in dimension.units() {
            assert!(parse_quantity(&format!("1 {unit}"), dimension).is_ok(), "{unit}");
        }
        assert_eq!(parse_quantity(&format!("1 {}", dimension.unit()), dimension), Ok(1.0));
    }
}

#[test]
fn a_comma_in_a_number_is_named() {
    let length = MINIMAL.replace("0.4 nm", "0,4 nm");
    assert_says(
        &complaint(&length),
        &[
            "`adhesion.equilibrium_distance` is \"0,4 nm\", a number with a comma",
            "Write \"0.4 nm\", with a decimal point.",
        ],
    );
    assert_says(
        &with("strip.length", "1,000 nm").unwrap_err(),
        &["\"1.000 nm\" if the comma is a decimal one", "\"1000 nm\" if it separates thousands"],
    );
    assert_says(
        &with("strip.poissons_ratio", "0,3").unwrap_err(),
        &["`strip.poissons_ratio` is \"0,3\", a number with a comma", "Write 0.3, with a decimal point."],
    );
    assert_says(
        &complaint(&MINIMAL.replace("height", "poissons_ratio = 0,3\nheight")),
        &["line 4: `poissons_ratio` is not TOML", "A number has a decimal point: 0.3"],
    );
    assert_says(
        &with("drive.steps", "[\"press 0,1 nm\"]").unwrap_err(),
        &["\"press 0,1 nm\", whose number has a comma: write \"0.1 nm\""],
    );
    let error = find_key("strip.poissons_ratio").unwrap().parse_number("0,1").unwrap_err();
    assert_eq!(error.found, "is \"0,1\", a number with a comma");
}

#[test]
fn an_angle_without_a_unit_is_taken_for_degrees() {
    assert_says(&with("drive.angle", "60").unwrap_err(), &["Write \"60 deg\" if deg is meant", "from 0 to 180 deg"]);
    assert_says(&with("drive.turn", "1").unwrap_err(), &["Write \"1 deg/nm\" if deg/nm is meant"]);
    assert_says(&with("drive.angle", "200 deg").unwrap_err(), &["`drive.angle` is 200 deg, which is out of range"]);
}
