//! Scenes of arrays of setae: what is read, and what is refused.
//!
//! Reference: the texts below. Expected: each table says what setae stand on; what does not fit is refused with its key and its numbers. Why: a
//! pitch below the diameter or a tension at which the band peels by itself gives forces that mean nothing.

use peelkit::toe::{Backing, SetaArray};
use peelkit_scene::{Described, Scene};

const LAMELLA: &str = "[setae]\nrows = 4\ncolumns = 3\n[lamella]\n";

fn array(text: &str) -> SetaArray {
    let scene = Scene::parse_any("a.toml", text, &[]).unwrap();
    let Described::Array(table) = scene.describes() else { panic!("{text}") };
    scene.seta_array(table).unwrap()
}

#[track_caller]
fn refused(text: &str, words: &[&str]) {
    let error = Scene::parse_any("a.toml", text, &[]).unwrap_err();
    let said = format!("{error} / {}", error.remedy());
    assert!(words.iter().all(|word| said.contains(word)), "{said}");
}

#[test]
fn what_setae_stand_on() {
    let SetaArray::Patch(patch) = array("[setae]\n[patch]\ndome_radius = \"2 mm\"\npress = \"3 mm\"\n") else {
        panic!()
    };
    assert_eq!((patch.backing, patch.press), (Backing::Dome { radius: 2e6 }, 3e6));
    let SetaArray::Lamella(band, _) = array(&format!("{LAMELLA}pulled_at = 2\n")) else { panic!() };
    assert_eq!((band.rows, band.columns, band.pulled_at), (4, 3, Some(1)));
    let SetaArray::Toe(toe, _) = array(&format!("{LAMELLA}[toe]\nlamellae = 5\njoined_at = 4\n")) else { panic!() };
    assert_eq!((toe.lamellae, toe.joined_at), (5, Some(3)));
    // as written anew
    let scene = Scene::parse_any("a.toml", LAMELLA, &[]).unwrap();
    assert_eq!(Scene::parse_any("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
}

#[test]
fn what_does_not_fit() {
    refused("[setae]\n", &["stand on nothing", "[patch]"]);
    refused(&format!("{LAMELLA}[patch]\npress = \"0 nm\"\n"), &["beside that of a band"]);
    refused("[setae]\npitch = \"4 um\"\ndiameter = \"4.2 um\"\n[patch]\n", &["`setae.pitch`", "4.2000 µm thick"]);
    let high = "[setae]\nrows = 10\ncolumns = 10\nreach = \"5 um\"\nheight_scatter = \"6 um\"\n[patch]\n";
    refused(high, &["of 100 setae do not adhere", "press by at least"]);
    refused(&format!("{LAMELLA}pretension = \"1 N\"\n"), &["peels by itself", "√(2 EA Γb)"]);
    refused(&format!("{LAMELLA}pulled_at = 5\n"), &["row 5, of 4"]);
    refused(&format!("{LAMELLA}[toe]\njoined_at = 5\n"), &["`toe.joined_at`", "row 5, of 4"]);
    refused(&format!("{LAMELLA}[strip]\nlength = \"1 nm\"\n"), &["an array, which has no such key"]);
    refused(
        &LAMELLA.replace("rows = 4", "rows = 4\nreach = \"5 um\"\nlast_reach = \"4 um\""),
        &["has to hold farther"],
    );
    assert!(Scene::parse("a.toml", LAMELLA, &[]).unwrap_err().to_string().contains("array of setae"));
}

/// A scene of a seta, in the text of another one.
const SETA_TEXT: &str =
    "[seta]\nforks = 2\n[adhesion]\nhamaker_constant = \"1e-19 J\"\nequilibrium_distance = \"0.4 nm\"\n";

#[test]
fn the_seta_of_a_law_in_the_text_of_an_array() {
    let with = |seta: &str| format!("[setae]\nlaw = \"none\"\nseta = '''\n{seta}'''\n[patch]\n");
    let scene = Scene::parse_any("a.toml", &with(SETA_TEXT), &[]).unwrap();
    let table = scene.array.as_ref().unwrap();
    let seta = table.seta.as_ref().unwrap();
    assert!(seta.lines.contains(&"seta.forks = 2.0".to_owned()), "{:?}", seta.lines);
    // its law is not there: no array can be computed of it, and none is of the numbers of the defaults
    assert!(table.law().is_none() && scene.seta_array(table).is_none());
    assert_eq!(Scene::parse_any("a.toml", &scene.to_toml(), &[]).unwrap(), scene);
    refused(&with("[setae]\n"), &["a scene in this one, which is not the scene of a seta"]);
    refused(
        &with(&SETA_TEXT.replace("forks = 2", "forks = 0")),
        &["and there the scene of `seta`, line", "`seta.forks`"],
    );
    // a text of somebody else reads no file, nor does one in it
    let without = |text: &str| Scene::parse_without_files("a.toml", text, &[]).unwrap_err().to_string();
    let named = "[setae]\nseta = \"/etc/passwd\"\n[patch]\n";
    assert!(without(named).ends_with("`setae.seta` names a file, and this scene is read without files"));
    let inside = with(&SETA_TEXT.replace("forks = 2", "tree = \"/etc/passwd\"")).replace("law = \"none\"\n", "");
    assert!(
        without(&inside).contains("`seta.tree` names a file, and this scene is read without files"),
        "{}",
        without(&inside)
    );
}
