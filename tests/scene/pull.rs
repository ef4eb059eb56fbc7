//! What a scene says of the pull.

use peelkit_scene::Scene;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/strip-100nm.toml");

#[test]
fn pretension_needs_something_to_hold_it() {
    let held = std::fs::read_to_string(SCENE).unwrap() + "\n[grip]\nhorizontal = \"fixed\"\npretension = \"200 pN\"\n";
    assert_eq!(Scene::parse("held.toml", &held, &[]).unwrap().model.grip.pretension, Some(0.2));
    for more in ["", "horizontal = \"free\""] {
        let text = std::fs::read_to_string(SCENE).unwrap() + &format!("\n[grip]\npretension = \"1 nN\"\n{more}\n");
        let error = Scene::parse("loose.toml", &text, &[]).unwrap_err().to_string();
        assert!(
            error.contains("grip.pretension") && error.contains("constrained normal to the pull direction"),
            "{error}"
        );
    }
}
