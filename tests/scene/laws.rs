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
