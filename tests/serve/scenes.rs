//! What is wrong with a scene is said in the sentences of the command, and no scene of a page reads a file.

use crate::client::{Running, STRIP};
use serde_json::{Value, json};

fn refused(server: &Running, scene: &str, set: Value) -> (String, String) {
    let reply = server.post("/api/peel", &json!({"name": "s.toml", "scene": scene, "set": set}));
    assert_eq!(reply.status, 422, "{}", reply.body);
    let text = |key: &str| reply.json()[key].as_str().unwrap().to_owned();
    (text("error"), text("remedy"))
}

#[test]
fn a_wrong_value_is_named_with_its_key_and_what_would_be_right() {
    let server = Running::usual();
    let (error, remedy) = refused(&server, STRIP, json!([["strip.height", "10"]]));
    assert_eq!(error, "`strip.height` is \"10\", a number without a unit");
    assert!(!remedy.is_empty());
    let (error, _) = refused(&server, &STRIP.replace("10 nm", "-1 nm"), json!([]));
    assert!(error.starts_with("s.toml, line 7: `strip.height` is"), "{error}");
    let (error, _) = refused(&server, "no toml", json!([]));
    assert!(error.contains("is not TOML"), "{error}");
}

/// Both tables that may be files, in the text and as a key that is set.
#[test]
fn no_file_is_read() {
    let server = Running::usual();
    let ground = format!("{STRIP}\n[substrate]\nshape = \"profile\"\ntable = \"/etc/passwd\"\n");
    let beam = "[profile]\ntable = \"/etc/passwd\"\nyoungs_modulus = \"2 GPa\"\n[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";
    let inline = format!(
        "{STRIP}\n[substrate]\nshape = \"profile\"\ntable = \"\"\"\nx_nm,height_nm\n0,0\n50,-1\n100,0\n\"\"\"\n"
    );
    for (scene, set, key) in [
        (ground.as_str(), json!([]), "substrate.table"),
        (beam, json!([]), "profile.table"),
        (inline.as_str(), json!([["substrate.table", "/etc/passwd"]]), "substrate.table"),
    ] {
        let (error, _) = refused(&server, scene, set);
        assert!(error.ends_with(&format!("`{key}` names a file, and this scene is read without files")), "{error}");
    }
    let seta = include_str!("../../scenes/seta.toml");
    let (error, remedy) = refused(&server, seta, json!([["seta.tip_law", "table"], ["seta.tip_table", "/etc"]]));
    assert!(error.ends_with("`seta.tip_table` names a folder, and this scene is read without files"), "{error}");
    assert_eq!(remedy, "Remove `tip_table`: the run computes the table.");
    let reply = server.post("/api/peel", &json!({"name": "s", "scene": inline}));
    assert_eq!(reply.status, 200, "a table in the text is none: {}", reply.body);
}

/// A strip that no stable state at rest has ends as refused, with the reason, and is an answer.
#[test]
fn a_model_that_is_refused_is_an_answer_with_a_reason() {
    let server = Running::usual();
    let set = json!([["adhesion.far_face", "false"], ["strip.height", "0.05 nm"]]);
    let reply =
        server.post("/api/peel", &json!({"name": "s", "scene": STRIP, "set": set, "parts": ["curve", "poses"]}));
    assert!(matches!(reply.status, 200 | 422), "{}", reply.body);
}
