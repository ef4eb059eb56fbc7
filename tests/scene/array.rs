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
