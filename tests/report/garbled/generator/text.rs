//! Texts that may mean nothing.

use super::dice::Dice;
use peelkit_scene::{BODIES, KEYS, Key, Kind, Need};
use std::fmt::Write;

/// Values that somebody may write or that a program may have written.
pub const ODD_VALUES: &[&str] = &[
    "nan",
    "-nan",
    "inf",
    "-inf",
    "+inf",
    "1e400",
    "-1e400",
    "1e-400",
    "0",
    "-0.0",
    "+1",
    "0x10",
    "0o17",
    "0b1",
    "1_000",
    "1_000.5",
    "99999999999999999999999",
    "-9223372036854775808",
    "9223372036854775807",
    "1e",
    ".5",
    "5.",
    "1.5.2",
    "",
    "\"\"",
    "''",
    "\"\"\"\n\"\"\"",
    "true",
    "True",
    "[]",
    "[1, 2]",
    "{}",
    "{ nm = 1 }",
    "2026-01-01",
    "07:32:00",
    "1979-05-27T07:32:00Z",
    "\"1e400 nm\"",
    "\"-1e400 nm\"",
    "\"1e-400 nm\"",
    "\"-0 nm\"",
    "\"0x10 nm\"",
    "\"1e3\"",
    "\"nm\"",
    "\"nm 100\"",
    "\"∞ nm\"",
    "\"nan nm\"",
    "\"inf nm\"",
    "\"infinity GPa\"",
    "\"1 2 nm\"",
    "\"1,5 nm\"",
    "\"1.5.2 nm\"",
    "\"１００ nm\"",
    "\"100\\u00a0nm\"",
    "\"100\\u2009nm\"",
    "\"100 нм\"",
    "\"100 nm nm\"",
    "\"100 n m\"",
    "\"100 kN\"",
    "\"1 GPa\"",
    "\"1 aJ\"",
    "\"1 h\"",
    "\"1 d\"",
    "\"1e3eV\"",
    "\"1 ev\"",
    "\"5 Å\"",
    "\"1e-7m\"",
    "\"\\u0000\"",
    "\"free\"",
    "\"FREE\"",
    "\" full \"",
    "\"0.5\"",
    "0.5",
    "1",
    "-1",
    "3.0",
    "1e3",
    "2000",
    "1e10",
];

/// The keys of a scene that peels this body.
fn keys_of(body: &str) -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(move |key| key.table == body || !BODIES.contains(&key.table))
}

/// A good scene to which up to four things have happened.
pub fn garbled_text(dice: &mut Dice) -> String {
    let body = dice.pick(&BODIES);
    let shape = dice.pick(&["flat", "flat", "sphere", "cylinder", "sinusoid", "profile"]);
    let left_out = dice.pick(&["pieces", "table"]);
    // in space, most of what is of the plane alone is left out: else next to no such scene is taken
    let in_space = body == "strip" && dice.below(4) == 0;
    let of_plane =
        |key: &Key| key.table == "friction" || ["steps", "pretension", "law", "work", "strength"].contains(&key.name);
    let of_space = |key: &Key| key.is_of_space() || key.name == "space";
    let shape = if in_space { "flat" } else { shape };
    let mut entries: Vec<(&str, String, String)> = keys_of(body)
        .filter(|key| if in_space { !of_plane(key) } else { !of_space(key) })
        .filter(|key| key.table != "substrate" || key.shapes().contains(&shape))
        .filter(|key| key.alternative().is_none() || key.name != left_out)
        .filter(|key| !matches!(key.kind, Kind::Tractions(_)))
        .filter(|key| key.need == Need::Required || key.name == "shape" || dice.below(2) == 0)
        .map(|key| (key.table, key.name.to_owned(), key.example().to_owned()))
        .collect();
    entries.iter_mut().filter(|entry| entry.1 == "shape").for_each(|entry| entry.2 = format!("\"{shape}\""));
    for _ in 0..dice.below(4) {
        garble_entries(&mut entries, dice);
    }
    let mut text = write_entries(&entries, dice.below(8) == 0);
    for _ in 0..dice.below(3) {
        garble_characters(&mut text, dice);
    }
    text
}

fn garble_entries(entries: &mut Vec<(&'static str, String, String)>, dice: &mut Dice) {
    if entries.is_empty() {
        return;
    }
    let at = dice.below(entries.len());
    match dice.below(9) {
        0 => drop(entries.remove(at)),
        1 => entries.insert(at, entries[at].clone()),
        2 => misspell(&mut entries[at].1, dice),
        3 => {
            entries[at].0 = dice.pick(&[
                "",
                "strip",
                "spatula",
                "adhesion",
                "grip",
                "drive",
                "accuracy",
                "bounds",
                "Strip",
                "spring",
                "substrate",
                "\"\"",
            ])
        }
        4 => entries[at].1 = KEYS[dice.below(KEYS.len())].name.to_owned(),
        5 => {
            let number = f64::from_bits((0..4).fold(0, |bits, _| bits << 16 | u64::from(dice.number())));
            let unit = dice
                .pick(&["nm", "um", "µm", "μm", "m", "pm", "GPa", "Pa", "J", "eV", "zJ", "s", "min", "nN", "deg", ""]);
            entries[at].2 = if dice.below(2) == 0 { format!("\"{number} {unit}\"") } else { format!("{number:e}") };
        }
        6 => entries[at].2 = format!("\"{}\"", "9".repeat(dice.below(600))),
        7 => entries[at].2 = format!("{}1{}", "[".repeat(dice.below(300)), "]".repeat(dice.below(300))),
        _ => entries[at].2 = dice.pick(ODD_VALUES).to_owned(),
    }
}

/// Another word than it was.
pub fn misspell(word: &mut String, dice: &mut Dice) {
    let mut letters: Vec<char> = word.chars().collect();
    let at = dice.below(letters.len());
    match dice.below(4) {
        0 if letters.len() > 1 => drop(letters.remove(at)),
        1 if at + 1 < letters.len() && letters[at] != letters[at + 1] => letters.swap(at, at + 1),
        2 => letters.insert(at, dice.pick(&['a', 'Z', '_', '7', '-'])),
        _ => letters[at] = if letters[at] == 'q' { 'x' } else { 'q' },
    }
    *word = letters.into_iter().collect();
}

/// As tables, or as dotted keys.
fn write_entries(entries: &[(&str, String, String)], dotted: bool) -> String {
    let mut text = String::new();
    let mut open = "";
    for (table, key, value) in entries {
        let place = if dotted && !table.is_empty() { format!("{table}.") } else { String::new() };
        if !dotted && *table != open {
            let _ = writeln!(text, "[{table}]");
            open = table;
        }
        let _ = writeln!(text, "{place}{key} = {value}");
    }
    text
}

fn garble_characters(text: &mut String, dice: &mut Dice) {
    let mut letters: Vec<char> = text.chars().collect();
    let at = dice.below(letters.len());
    let to = (at + dice.below(20)).min(letters.len());
    match dice.below(6) {
        0 => drop(letters.drain(at..to)),
        1 => letters.truncate(at),
        2 => letters.splice(at..at, letters[at..to].to_vec()).for_each(drop),
        3 => {
            let odd = [
                '\0', '\t', '\r', '\n', '"', '\'', '\\', '[', ']', '{', '}', '=', '.', '#', 'é', 'µ', '😀', '\u{feff}',
                '\u{202e}',
            ];
            letters.insert(at, dice.pick(&odd));
        }
        4 => {
            let long = dice.pick(&['a', '1', ' ', '[', '{', '"', '.', '#', 'é']).to_string().repeat(dice.below(3000));
            letters.splice(at..at, long.chars()).for_each(drop);
        }
        _ => letters.splice(at..to, char::from_u32(u32::from(dice.number()))).for_each(drop),
    }
    *text = letters.into_iter().collect();
}
