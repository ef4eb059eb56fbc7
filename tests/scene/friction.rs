//! What a scene says of friction.

use peelkit::model::{Friction, PeelModel, Pull, StripModel};
use peelkit::study::{Accuracy, NoTest, StopCriteria, observed};
use peelkit_scene::Scene;

const BOUNDS: StopCriteria = StopCriteria::after_points(5000);

fn rubbing(length: f64, degrees: f64, strength: f64) -> PeelModel {
    PeelModel {
        pull: Pull { angle: degrees.to_radians(), ..Pull::UP },
        friction: Friction { strength: Some(strength), ..Friction::NONE },
        ..StripModel::of_the_paper(length, 1.0).into()
    }
}

/// What friction does not go with is refused by name.
#[test]
fn what_does_not_go_with_friction_is_refused() {
    let scene = |more: &str| {
        let text =
            std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml")).unwrap();
        Scene::parse("friction.toml", &format!("{text}\n{more}"), &[])
    };
    assert!(scene("[friction]\nstrength = \"50 MPa\"\n").unwrap().model.friction_law().is_some());
    for (more, found) in [
        ("[friction]\ncoefficient = 0.3\n", "friction.coefficient"),
        ("[friction]\npresliding = \"0.01 nm\"\n", "friction.presliding"),
        ("[friction]\nstrength = \"50 MPa\"\n[substrate]\nshape = \"cylinder\"\nradius = \"1 um\"\n", "not flat"),
        (
            "[friction]\nstrength = \"50 MPa\"\n[grip]\nhorizontal = \"fixed\"\npretension = \"1 nN\"\n",
            "grip.pretension",
        ),
    ] {
        let error = scene(more).unwrap_err().to_string();
        assert!(error.contains(found), "{error}");
    }
    let error = Scene::parse(
        "friction.toml",
        include_str!("../../scenes/strip-100nm.toml"),
        &[("adhesion.law".into(), "bilinear".into()), ("friction.strength".into(), "50 MPa".into())],
    );
    assert!(error.unwrap_err().to_string().contains("cohesive"));
    assert_eq!(observed(&rubbing(100.0, 60.0, 0.05), &Accuracy::to(1e-6), &BOUNDS).err(), Some(NoTest::Friction));
}
