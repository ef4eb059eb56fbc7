//! Garbled scenes: whatever a text holds, it is taken as it stands there or refused with a message.
//!
//! Reference: the text itself, read a second time by a plain reader of TOML (`generator/check_parse.rs`), and the scene written
//! anew from the `parameters` that outputs print. Expected: no panic, however deep or long; every key of a text that is
//! taken holds the value of the text, and every other key its default; what is printed comes back as the same scene; a
//! refusal names the file, the line, the key and what would be right. Why: a number that is not the user's makes every
//! figure wrong that rests on it, and nobody notices.

use super::corpus;
use super::generator::{Dice, ODD_VALUES, check_parse, garbled_text, misspell, printed};
use peelkit::model::{Friction, Pull};
use peelkit_scene::{BODIES, KEYS, Key, Kind, Need, Range, Scene};
use proptest::prelude::*;

/// Tables of what is asked of a scene besides its peel.
const QUESTIONS: [&str; 3] = ["uncertainty", "fit", "optimise"];

/// The keys of a scene of one beam; those of a seta, of an array, of a solid and of a rate stand in tests/scene/seta.rs, array.rs, solid.rs and rate.rs.
fn keys() -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(|key| !["lamella", "patch", "seta", "setae", "solid", "time", "toe"].contains(&key.table))
}

fn any_key() -> impl Strategy<Value = &'static Key> {
    prop::sample::select(keys().collect::<Vec<_>>())
}

/// A scene with every key that may stand beside one of them, whose value is replaced.
fn with_value(key: &Key, value: &str) -> String {
    let body = if BODIES.contains(&key.table) { key.table } else { BODIES[0] };
    let fits = |other: &&Key| other.table == body || !BODIES.contains(&other.table);
    // a substrate of a shape that has the key, of those of its keys alone
    let shape = if key.name == "shape" { None } else { key.shapes().first().copied() };
    let fits =
        |other: &&Key| fits(other) && (other.table != "substrate" || other.shapes().contains(&shape.unwrap_or("flat")));
    // a strip on flat ground alone is stretched
    let stretched = body == BODIES[0] && key.table != "substrate";
    // and without a crack, which is refused beside much else
    let cracked = key.name == "crack";
    let fits = |other: &&Key| fits(other) && (stretched && !cracked || other.name != "pretension");
    let fits = |other: &&Key| fits(other) && (cracked || other.name != "crack");
    // layers stand in place of what they give, and a law of stretch is that of a strip in the plane
    let layered = key.name == "layers";
    const GIVEN: [&str; 5] =
        ["height", "youngs_modulus", "poissons_ratio", "shear_correction", "bending_stiffness_factor"];
    let given = |other: &Key| other.table == BODIES[0] && GIVEN.contains(&other.name);
    let fits = |other: &&Key| fits(other) && if layered { !given(other) } else { other.name != "layers" };
    let fits = |other: &&Key| fits(other) && (other.name != "stretch" || key.name == "stretch");
    // a shear strength is refused beside much else
    let held = ["shear_strength", "shear_work", "mixing_exponent"].contains(&key.name);
    let fits = |other: &&Key| {
        fits(other)
            && match held {
                true => !["pretension", "line_load", "turn"].contains(&other.name),
                false => !["shear_strength", "shear_work", "mixing_exponent"].contains(&other.name),
            }
    };
    // nor does a film that yields
    let yields = ["yield_strength", "tangent_modulus"].contains(&key.name);
    let fits = |other: &&Key| {
        fits(other)
            && match yields {
                true => !["pretension", "line_load", "turn", "steps"].contains(&other.name),
                false => !["yield_strength", "tangent_modulus"].contains(&other.name),
            }
    };
    // nor does what does not heal go with that
    let fits = |other: &&Key| fits(other) && (other.name != "healing" || key.name == "healing");
    // friction goes with the half space on flat ground alone
    let rubs = key.table == "friction";
    let apart =
        |other: &Key| other.table == "substrate" || ["law", "work", "strength", "pretension"].contains(&other.name);
    let fits = |other: &&Key| {
        fits(other) && if rubs { other.table == "friction" || !apart(other) } else { other.table != "friction" }
    };
    // in space there are no steps and no pretension, and an ellipse under the half space's law alone
    let in_space = key.is_of_space() || key.name == "space";
    let of_plane = |other: &Key| apart(other) && other.name != "shape" || ["steps", "start"].contains(&other.name);
    let fits = |other: &&Key| {
        let is_of_space = other.is_of_space() || other.name == "space";
        fits(other) && if in_space { !of_plane(other) } else { !is_of_space }
    };
    // a law of a table takes its rows, and neither work nor strength
    let of_table = matches!(key.kind, Kind::Tractions(_));
    let fits = |other: &&Key| {
        let rows = matches!(other.kind, Kind::Tractions(_));
        fits(other) && if of_table { other.table != "adhesion" || rows || other.name == "law" } else { !rows }
    };
    // a profile takes a table or pieces
    let outline = if key.alternative().is_some() { key.name } else { "table" };
    let fits = |other: &&Key| fits(other) && (other.alternative().is_none() || other.name == outline);
    // what is asked of a scene besides has keys of strips in it
    let fits = |other: &&Key| fits(other) && (other.table == key.table || !QUESTIONS.contains(&other.table));
    let line = |other: &Key| match shape {
        _ if other.path() == key.path() => format!("{} = {value}\n", other.path()),
        _ if of_table && other.name == "law" => format!("{} = \"table\"\n", other.path()),
        Some(shape) if other.name == "shape" => format!("{} = \"{shape}\"\n", other.path()),
        _ => format!("{} = {}\n", other.path(), other.example()),
    };
    keys().filter(fits).map(line).collect()
}

fn complaint(text: &str) -> String {
    let error = Scene::parse("garbled.toml", text, &[]).expect_err(text);
    format!("{error} / {}", error.remedy())
}

/// Whether a value is right by itself: one that makes the beam too many process zones long is.
fn is_taken(text: &str) -> bool {
    check_parse(text) == Ok(true)
        || Scene::parse("garbled.toml", text, &[]).is_err_and(|error| error.to_string().contains("process zones long"))
}

#[track_caller]
fn holds(text: &str) {
    if let Err(fault) = check_parse(text) {
        panic!("{fault}\nin\n{text}");
    }
}

#[test]
fn every_odd_value_of_every_key_is_taken_as_it_stands_or_refused() {
    for key in keys() {
        for value in ODD_VALUES {
            holds(&with_value(key, value));
        }
    }
}

/// Below, at and above the ends of what each key takes.
#[test]
fn what_is_out_of_range_is_refused_with_the_range() {
    for key in keys() {
        let (right, wrong): (&[&str], &[&str]) = match key.kind {
            Kind::Number(Range::Positive, _) => {
                (&["1e-30", "1e30"], &["0", "-0.0", "-1e-300", "inf", "nan", "1e400", "1e31", "0.99e-30", "1e300"])
            }
            Kind::Number(Range::Between(..), _) => (&["-0.999", "0.499"], &["-1", "0.5", "0.5000001", "-2", "1e400"]),
            Kind::Number(Range::From(0.0, _), _) => (&["0", "1000"], &["-1e-300", "1000.1", "nan"]),
            Kind::Number(Range::From(..), _) => (&["1e-11", "1e-2"], &["0.99e-11", "1.01e-2", "0", "-1e-6", "nan"]),
            Kind::Share(Range::MIXING_EXPONENT, _) => (&["1", "8"], &["0.99", "8.01", "0", "-1", "nan"]),
            Kind::Share(..) => (&["1e-6", "0.5"], &["0.99e-6", "0.51", "0", "-0.1", "inf"]),
            Kind::Count(..) => (&["1", "12"], &["0", "-1", "1000000001", "1.5", "1e10", "nan"]),
            Kind::Fixed(8, _) => (&["1", "8"], &["0", "9", "-1", "1.5"]),
            Kind::Fixed(..) => (&["1", "2000"], &["0", "2001", "-1", "1.5"]),
            Kind::Quantity(..) | Kind::Bound(..) => {
                let unit = key.unit();
                for (number, is_right) in
                    [("1e-30", true), ("1e30", true), ("0", false), ("-1", false), ("1e300", false), ("nan", false)]
                {
                    let text = with_value(key, &format!("\"{number} {unit}\""));
                    // the lengths of a spatula, of a substrate and its strip, of a crack, and two moduli have to fit one another besides
                    let bounded = ["crack", "tangent_modulus"].contains(&key.name);
                    if !["spatula", "substrate"].contains(&key.table) && !bounded || !is_right {
                        assert_eq!(is_taken(&text), is_right, "{text}");
                    }
                    if !is_right {
                        let said = complaint(&text);
                        assert!(said.contains(&format!("`{}`", key.path())) && said.contains("above zero"), "{said}");
                    }
                }
                continue;
            }
            _ => continue,
        };
        for value in right {
            assert!(is_taken(&with_value(key, value)), "{} = {value}", key.path());
        }
        for value in wrong {
            let said = complaint(&with_value(key, value));
            assert!(said.contains(&format!("`{}`", key.path())) && said.contains(&key.takes()), "{said}");
        }
    }
}

#[test]
fn what_is_deep_or_long_is_refused_and_told_shortly() {
    let many = 100_000;
    let repeat = |text: &str| text.repeat(many);
    let good = with_value(&KEYS[0], "\"x\"");
    for (what, text) in [
        ("lists", format!("strip.length = {}", repeat("["))),
        ("closed lists", format!("strip.length = {}{}", repeat("["), repeat("]"))),
        ("inline tables", format!("strip.length = {}1{}", repeat("{a="), repeat("}"))),
        ("dotted keys", format!("{}a = 1", repeat("a."))),
        ("dotted table", format!("[{}a]", repeat("a."))),
        ("dotted tables in a list", format!("[[{}a]]", repeat("a."))),
        ("dotted keys in a table", format!("[strip]\nlength.{}a = 1", repeat("a."))),
        ("brackets", repeat("[")),
        ("quotes", repeat("\"")),
        ("tables", repeat("[strip]\n")),
        ("a long key", format!("{} = 1", repeat("length"))),
        ("a long key of a table", format!("[strip]\n{} = 1", repeat("length"))),
        ("a long table", format!("[{}]\na = 1", repeat("strip"))),
        ("a long line", format!("[strip]\nlength = {} nm", repeat("1"))),
        ("a long number", format!("strip.length = \"{} nm\"", repeat("1"))),
        ("a long unit", format!("strip.length = \"1 {}\"", repeat("nm"))),
        ("a long word", format!("grip.rotation = \"{}\"", repeat("free"))),
        ("a long integer", format!("bounds.points = {}", repeat("1"))),
        ("long and wide letters", format!("strip.{} = 1", repeat("\\u0301"))),
        ("many keys", (0..many).map(|k| format!("a{k} = 1\n")).collect()),
        ("many keys behind a scene", good + &repeat("length = 1\n")),
    ] {
        assert_eq!(check_parse(&text), Ok(false), "{what}");
        let error = Scene::parse("garbled.toml", &text, &[]).unwrap_err();
        let shown = format!("{:?}", miette::Report::new(error));
        assert!(shown.len() < 4000, "{what}: a terminal is no place for {} bytes", shown.len());
    }
}

#[test]
fn what_broke_once_holds() {
    assert!(!corpus().is_empty());
    for (name, text) in corpus() {
        assert_eq!(check_parse(&text).err(), None, "{name}");
    }
}

#[test]
fn a_long_title_is_a_title() {
    let text = with_value(&KEYS[0], &format!("\"{}\"", "é\\u0007\\\"\\n".repeat(10_000)));
    assert_eq!(check_parse(&text), Ok(true));
}

proptest! {
    #![proptest_config(ProptestConfig { max_shrink_iters: 4096, ..ProptestConfig::with_cases(3000) })]

    #[test]
    fn a_garbled_scene_is_taken_as_it_stands_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..160)) {
        let text = garbled_text(&mut Dice::new(&bytes));
        prop_assert_eq!(check_parse(&text).err(), None, "{}", text);
    }

    #[test]
    fn bytes_are_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let text = String::from_utf8_lossy(&bytes).into_owned();
        prop_assert_eq!(check_parse(&text), Ok(false));
    }

    /// One letter wrong in one key: the message names what was written.
    #[test]
    fn a_misspelt_key_is_named(key in any_key(), bytes in prop::collection::vec(any::<u8>(), 8)) {
        let mut name = key.name.to_owned();
        misspell(&mut name, &mut Dice::new(&bytes));
        let wrong = if key.table.is_empty() { name } else { format!("{}.{name}", key.table) };
        prop_assume!(KEYS.iter().all(|key| key.path() != wrong));
        let text = with_value(key, key.example());
        let text = text.replace(&format!("{} = ", key.path()), &format!("{wrong} = "));
        let said = complaint(&text);
        prop_assert!(said.contains(&format!("`{wrong}` is not a key of a scene")), "{}", said);
    }

    #[test]
    fn a_key_that_is_missing_doubled_or_elsewhere_is_named(key in any_key(), other in any_key()) {
        let text = with_value(key, key.example());
        let line = format!("{} = {}\n", key.path(), key.example());
        let doubled = complaint(&format!("{text}{line}"));
        prop_assert!(doubled.contains("duplicate") && doubled.contains(&format!("`{}`", key.path())), "{}", doubled);
        // the law of these scenes is cohesive, with work and strength, which needs neither constant of the half space
        if ["hamaker_constant", "equilibrium_distance"].contains(&key.name) {
            prop_assert_eq!(check_parse(&text.replace(&line, "")), Ok(true));
        } else if key.need == Need::Required {
            let missing = complaint(&text.replace(&line, ""));
            // of a table and pieces, one of which a profile takes, the table is named first
            let name = if key.alternative().is_some() { "table` or `pieces" } else { key.name };
            prop_assert!(missing.contains(&format!("[{}] lacks `{name}`", key.table)), "{}", missing);
        }
        let place = if other.table.is_empty() { String::new() } else { format!("{}.", other.table) };
        let is_one = KEYS.iter().any(|known| known.path() == format!("{place}{}", key.name));
        if other.table != key.table && !is_one {
            let moved = complaint(&text.replace(&line, &format!("{place}{} = {}\n", key.name, key.example())));
            let moved_to = format!("`{place}{}` is", key.name);
            let elsewhere = [" not a key of a scene", " a key of ["].map(|what| moved.contains(&format!("{moved_to}{what}")));
            // a key that takes a table is one at the top, and a key with the name of a table is none
            let table = moved.contains(&format!("[{}] is not a table of a scene", key.name))
                || moved.contains("It is a table: write");
            prop_assert!(elsewhere.contains(&true) || table, "{}", moved);
        }
    }

    /// Every number that a key takes, to its last digit.
    #[test]
    fn what_is_printed_comes_back(numbers in prop::collection::vec(any::<f64>(), KEYS.len())) {
        let mut scene = Scene::parse("garbled.toml", &with_value(&KEYS[0], "\"x\""), &[]).unwrap();
        for (key, number) in KEYS.iter().zip(numbers) {
            let unit_interval = (number.to_bits() >> 11) as f64 / (1u64 << 53) as f64;
            let number = match key.kind {
                Kind::Number(Range::Between(low, high) | Range::From(low, high), _) | Kind::Share(Range::From(low, high), _) => {
                    low + (high - low) * unit_interval
                }
                Kind::Count(most, _) => 1.0 + (most as f64 * unit_interval).floor(),
                Kind::Fixed(most, _) => 1.0 + (most as f64 * unit_interval).floor(),
                _ => number.abs(),
            };
            // what has no meaning is refused, and the example stays
            let _ = key.store_number(&mut scene, number);
        }
        if scene.check().is_err() {
            // an angle that has a meaning by itself, but not for a strip, and friction and a pull in space that do not go with the rest
            scene.model.pull = Pull::UP;
            scene.model.friction = Friction::NONE;
            scene.model.space = None;
        }
        if scene.check().is_err() {
            // too many process zones long
            let plain = Scene::parse("garbled.toml", &with_value(&KEYS[0], "\"x\""), &[]).unwrap().model;
            (scene.model.body, scene.model.adhesion) = (plain.body, plain.adhesion);
        }
        let text = printed(&scene).unwrap();
        prop_assert_eq!(Scene::parse("garbled.toml", &text, &[]).map_err(|error| error.to_string()), Ok(scene));
    }
}
