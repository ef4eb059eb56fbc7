//! What a scene says of ground that is not flat.

use peelkit_scene::Scene;

/// A size is refused by what lies on the ground, and not by the shaft.
#[test]
fn a_long_shaft_lies_on_no_waves() {
    let scene = |pad: &str, shaft: &str| {
        let text = format!(
            "[spatula]\npad_length = \"{pad}\"\nshaft_length = \"{shaft}\"\nyoungs_modulus = \"2 GPa\"\n[adhesion]\n\
             hamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n[substrate]\nshape = \"sinusoid\"\n\
             height = \"2 nm\"\nwavelength = \"20 nm\"\n"
        );
        Scene::parse("a.toml", &text, &[])
    };
    assert!(scene("240 nm", "10 um").is_ok());
    assert!(scene("10 um", "600 nm").unwrap_err().to_string().contains("`substrate.shape`"));
}
