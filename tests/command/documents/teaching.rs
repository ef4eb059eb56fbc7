//! The answers of `docs/tutorials/exercises.md` are those of its commands, and each of its scenes has a picture; so have the tutorials.
//!
//! `PEELKIT_WRITE=1 cargo test --test command teaching` draws the pictures again.

use super::{place, text, writing};
use serde_json::Value;
use std::process::Command;

const PATH: &str = "docs/tutorials/exercises.md";

/// The picture of each scene, and what is said beside the scene to draw it.
const PICTURES: [(&str, &str, &str); 10] = [
    ("01-first-peel", "curve", ""),
    ("02-kendall", "curve", ""),
    ("03-bending-stiffness", "sweep", "--vary strip.bending_stiffness_factor --from 1e-3 --to 1e3 --points 13 --log"),
    ("04-angle", "sweep", "--vary drive.angle --from '20 deg' --to '160 deg' --points 15"),
    ("05-jumps", "observed", "--observed"),
    ("06-soft-machine", "observed", "--observed"),
    ("07-laws", "curve", ""),
    ("08-friction", "shapes", "--set 'drive.angle=30 deg'"),
    ("09-waves", "shapes", ""),
    ("10-spatula", "curve", ""),
];

/// The pictures of the tutorials on a tape and on a seta: where they stand, the scene, and what it draws.
const TUTORIALS: [(&str, &str, &str); 3] =
    [("material/curve", "tape", "curve"), ("seta/curve", "seta", "curve"), ("seta/seta", "seta", "seta")];

fn peel(words: &[String]) -> Vec<u8> {
    let output = Command::new(env!("CARGO_BIN_EXE_peel")).args(words).current_dir(super::ROOT).output().unwrap();
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// `rows[0].peak_force_nN` of an object.
fn number(json: &Value, path: &str) -> Option<f64> {
    let pointer = path.replace(['.', '['], "/").replace(']', "");
    json.pointer(&format!("/{pointer}"))?.as_f64()
}

/// Half a digit beyond the last one that is written; solvers agree to less than that, and their bounds may be wider.
pub fn last_digit(text: &str) -> f64 {
    let decimals = text.split_once('.').map_or(0, |(_, behind)| behind.len());
    1.5 * 10f64.powi(-(decimals as i32))
}

#[test]
fn the_answers_are_those_of_the_scenes() {
    let mut json = Value::Null;
    let (mut wrong, mut compared) = (Vec::new(), 0);
    for line in text(PATH).lines().filter(|line| line.starts_with("| `") || line.starts_with("| |")) {
        let cells: Vec<&str> = line.split('|').map(|cell| cell.trim().trim_matches('`')).collect();
        let [_, command, key, value, _] = cells[..] else { panic!("not three cells: {line}") };
        if let Some(command) = command.strip_prefix("peel ") {
            let words = [shlex::split(command).unwrap(), vec!["--json".into()]].concat();
            json = serde_json::from_slice(&peel(&words)).unwrap();
        }
        let (found, wanted) = (number(&json, key), value.parse::<f64>().unwrap());
        if !found.is_some_and(|found| (found - wanted).abs() <= last_digit(value)) {
            wrong.push(format!("{line}: {found:?}"));
        }
        compared += 1;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(compared > 30);
}

#[test]
fn every_scene_has_a_question_and_a_picture() {
    let chapter = text(PATH);
    for (scene, picture, arguments) in PICTURES {
        let path = format!("scenes/teaching/{scene}.toml");
        assert!(place(&path).is_file() && chapter.contains(&path), "{path}");
        let svg = place(&format!("docs/tutorials/exercises/{scene}.svg"));
        if writing() {
            let out = tempfile::tempdir().unwrap();
            let command = if picture == "sweep" { "sweep" } else { "run" };
            let mut words = vec![command.to_owned(), path, "--out".into(), out.path().to_str().unwrap().into()];
            words.extend(shlex::split(arguments).unwrap());
            peel(&words);
            std::fs::create_dir_all(svg.parent().unwrap()).unwrap();
            std::fs::copy(out.path().join(format!("{picture}.svg")), &svg).unwrap();
        }
        assert!(svg.is_file(), "{}", svg.display());
    }
    assert_eq!(chapter.matches("**Question.**").count(), PICTURES.len());
    assert_eq!(chapter.matches("**Answer.**").count(), PICTURES.len());
}

#[test]
fn every_tutorial_has_its_pictures() {
    for (name, scene, picture) in TUTORIALS {
        let path = place(&format!("docs/tutorials/{name}.png"));
        if writing() {
            let out = tempfile::tempdir().unwrap();
            peel(&["run".into(), format!("scenes/{scene}.toml"), "--out".into(), out.path().to_str().unwrap().into()]);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::copy(out.path().join(format!("{picture}.png")), &path).unwrap();
        }
        assert!(path.is_file(), "{}", path.display());
        let chapter = text(&format!("docs/tutorials/{}.md", name.split('/').next().unwrap()));
        assert!(chapter.contains(&format!("({name}.png)")), "no tutorial shows {name}.png");
    }
}
