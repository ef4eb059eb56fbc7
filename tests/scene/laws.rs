//! What a scene says of the law of adhesion.

use crate::text::MINIMAL;
use approx::assert_relative_eq;
use peelkit::adhesion::{CohesiveShape, Law};
use peelkit_scene::Scene;

#[test]
fn a_scene_says_which_law() {
    let with = |more: &str| Scene::parse("law.toml", &format!("{MINIMAL}{more}"), &[]);
    let law = |more: &str| with(more).unwrap().model.line_law().law;
    assert_eq!(law(""), Law::BodyForce);
    assert_eq!(law("law = \"surface-traction\""), Law::SurfaceTraction);
    let Law::Cohesive(bilinear) = law("law = \"bilinear\"\nwork = \"20 mJ/m2\"\nstrength = \"50 MPa\"") else {
        panic!("a bilinear law is a cohesive one")
    };
    assert_eq!((bilinear.shape, bilinear.strength), (CohesiveShape::Bilinear, 0.05));
    assert_relative_eq!(-bilinear.levels(bilinear.closed)[0], 0.02, max_relative = 1e-14);
    let error = with("work = \"0.02 J/m2\"").unwrap_err().to_string();
    assert!(error.contains("adhesion.work") && error.contains("cohesive"), "{error}");
    let error = with("law = \"bilinar\"").unwrap_err();
    assert!(format!("{error:?}").contains("bilinear"), "{error:?}");
}

const ROWS: &str = "law = \"table\"\ntable = \"\"\"\nopening_um,traction_MPa\n0,0\n20,0.8\n150,0\n\"\"\"\n";

/// Its work and strength are those of the rows, and it needs nothing of the half space. It is written with its rows and read again.
#[test]
fn a_law_of_a_table_is_complete_with_its_rows() {
    let strip = MINIMAL.split("[adhesion]").next().unwrap();
    let scene = Scene::parse("law.toml", &format!("{strip}[adhesion]\n{ROWS}"), &[]).unwrap();
    let adhesion = scene.model.adhesion;
    let table = adhesion.attraction.table().unwrap();
    assert_eq!((table.strength(), table.range()), (0.8e-3, 150e3));
    let derived = scene.model.derived();
    assert_eq!((derived.work_of_adhesion, derived.strength), (table.work(), Some(table.strength())));
    assert_relative_eq!(adhesion.equilibrium_distance, 0.1 * table.work() / 0.8e-3, max_relative = 1e-14);
    let again = Scene::parse("law.toml", &scene.to_toml(), &[]).unwrap();
    assert_eq!((again.model, again.table_texts), (scene.model, scene.table_texts));
}

#[test]
fn a_table_goes_with_its_law_and_no_work() {
    let says = |more: &str, parts: [&str; 2]| {
        let error = Scene::parse("law.toml", &format!("{MINIMAL}{more}"), &[]).unwrap_err();
        let said = format!("{error} / {}", error.remedy());
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
    };
    says("law = \"table\"", ["lacks `table`", "opening_um,traction_MPa"]);
    says(
        &ROWS.replace("law = \"table\"\n", ""),
        ["`adhesion.table` is a key of [adhesion] for `law` = \"table\"", "body-force"],
    );
    says(&ROWS.replace("law = \"table\"", "law = \"bilinear\""), ["for `law` = \"table\"", "\"bilinear\""]);
    says(&format!("{ROWS}work = \"1 J/m2\""), ["`adhesion.work` is given beside `law` = \"table\"", "Remove `work`"]);
    says(
        &ROWS.replace("20,0.8", "20,-0.8"),
        ["`adhesion.table` has in line 3 `traction_MPa` = -0.8", "not above zero"],
    );
    says("law = \"table\"\ntable = \"no.csv\"", ["names the file no.csv", "cannot be read"]);
}
