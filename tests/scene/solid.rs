//! The table of a strip or a spatula that is computed as a solid.
//!
//! Reference: the settings of the library, by hand.
//!
//! Expected: every word arrives as what it means, an element without a length is as long as the process zone; what a solid does not have is refused by
//! its own key; a scene with [solid] comes back to the last bit when it is written, and is refused where beams are computed. Why: a key of a beam
//! that is silently left out gives another strip than the user has described.

use crate::text::{MINIMAL, set};
use peelkit::model::SolidSettings;
use peelkit::solid::{Grading, Plane, SolidContact, SolidElement, SolidGrip, SolidMaterial};
use peelkit_scene::{Described, Scene};

const SOLID: &str = "[solid]\nelement = \"H1(2)\"\nmodes = false\nalong = \"2.5 nm\"\nthrough = 3\nplane = \"strain\"\n\
     material = \"st-venant-kirchhoff\"\ncontact = \"body-force\"\ngrip = \"parabolic\"\ngrading = \"grip\"\n";

const SPATULA: &str = "[spatula]\n[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\nfar_face = false\n\
     [grip]\nrotation = \"fixed\"\n";

fn parse(text: &str) -> Scene {
    Scene::parse_any("strip.toml", text, &[]).unwrap()
}

fn settings(scene: &Scene) -> SolidSettings {
    let Described::Solid(table) = scene.describes() else { panic!("{:?}", scene.describes()) };
    scene.solid_settings(table)
}

#[test]
fn words_arrive_as_what_they_mean() {
    let expected = SolidSettings {
        element: SolidElement::Hermite { through: 2 },
        modes: false,
        along: 2.5,
        through: 3,
        across: 2,
        plane: Plane::Strain,
        material: SolidMaterial::StVenantKirchhoff,
        contact: SolidContact::BodyForce,
        grip: SolidGrip::Parabolic,
        grading: Grading::OF_GRIP,
    };
    assert_eq!(settings(&parse(&format!("{MINIMAL}{SOLID}"))), expected);
    let scene = parse(&format!("{MINIMAL}[solid]\n"));
    let expected = SolidSettings { along: scene.model.process_length(), ..SolidSettings::default() };
    assert_eq!(settings(&scene), expected);
}

const PROFILE: &str = "[profile]\nyoungs_modulus = \"2 GPa\"\npieces = [{ length = \"60 nm\", width = \"40 nm\", height = \"10 nm\" }]\n\
     [adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\nfar_face = false\n";

/// A spatula and a profile have two keys of the table, and a strip all but one.
#[test]
fn each_body_has_its_own_keys() {
    for text in [SPATULA, PROFILE] {
        let scene = parse(&format!("{text}[solid]\nalong = \"3 nm\"\nacross = 4\n"));
        let found = settings(&scene);
        assert_eq!((found.along, found.across), (3.0, 4));
    }
    for (text, key) in [(SPATULA, "element"), (SPATULA, "plane"), (PROFILE, "through"), (MINIMAL, "across")] {
        let value = if ["across", "through"].contains(&key) { "2" } else { "\"Q1C1\"" };
        let error = Scene::parse_any("a.toml", &format!("{text}[solid]\n{key} = {value}\n"), &[]).unwrap_err();
        assert!(error.to_string().contains("is a key of [solid] for a"), "{error}");
    }
    let error =
        Scene::parse_any("a.toml", &format!("{SPATULA}[solid]\n").replace("far_face = false", ""), &[]).unwrap_err();
    assert!(error.to_string().contains("adheres by its underside alone"), "{error}");
}

#[test]
fn a_scene_comes_back_as_it_was() {
    let spatula = format!("{SPATULA}[solid]\nacross = 3\n");
    let profile = format!("{PROFILE}[solid]\nalong = \"2 nm\"\n");
    for text in [spatula, profile, format!("{MINIMAL}{SOLID}"), format!("{MINIMAL}[solid]\nelement = \"Q(4,5)\"\n")] {
        let scene = parse(&text);
        let written = scene.to_toml();
        assert_eq!(Scene::parse_any("strip.toml", &written, &[]).unwrap(), scene, "{written}");
    }
}

#[test]
fn what_a_solid_does_not_have_is_refused_by_its_own_key() {
    let refused = [
        ("", "solid.element=Q2", "solid.element", "none of its values"),
        ("", "solid.element=H1(9)", "solid.element", "none of its values"),
        ("", "solid.along=200 nm", "solid.along", "the strip is"),
        ("", "solid.grip=soft", "solid.grip", "none of its values"),
        ("[grip]\nrotation = \"fixed\"\n", "solid.grip=parabolic", "solid.grip", "leaves the end face free"),
        ("", "adhesion.law=bilinear", "adhesion.law", "half space"),
        ("", "strip.bending_stiffness_factor=2", "strip.bending_stiffness_factor", "as its material does"),
        ("", "friction.strength=50 MPa", "friction.strength", "slides freely"),
        ("grip = \"parabolic\"\n", "drive.angle=45 deg", "drive.angle", "straight up"),
        ("", "accuracy.order=4", "accuracy.order", "solid.element"),
        ("", "accuracy.elements=40", "accuracy.elements", "solid.along"),
        ("", "terms=auto", "terms", "all its terms"),
        ("", "path.until=detachment", "path.until", "to the end"),
        (
            "[output]\nstations = { time = \"1 us\" }\n",
            "solid.through=4",
            "output.stations",
            "has no `time` to look for",
        ),
    ];
    for (more, given, key, says) in refused {
        let (path, value) = given.split_once('=').unwrap();
        let text = format!("{MINIMAL}[solid]\n{more}");
        let error = Scene::parse_any("strip.toml", &text, &set(path, value)).unwrap_err();
        assert!(
            error.to_string().contains(&format!("`{key}`")) && error.to_string().contains(says),
            "{given}: {error}"
        );
        assert!(!error.remedy().is_empty(), "{given}");
    }
}

#[test]
fn a_beam_is_computed_where_the_scene_says_nothing_of_a_solid() {
    let error = Scene::parse("strip.toml", &format!("{MINIMAL}[solid]\n"), &[]).unwrap_err();
    assert!(error.to_string().contains("[solid]"), "{error}");
    assert!(matches!(parse(MINIMAL).describes(), Described::Peel));
}
