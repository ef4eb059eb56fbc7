//! Garbled scenes drawn from bytes, and what holds for each of them: shared by the tests and by `fuzz/`.
//!
//! Everything is a function of the bytes, so that a fuzzer may search among them and a test may draw them.

// every user takes a part of this
#![allow(dead_code)]

use peelkit::study::{PathEnd, Peak, Peel, peel};
use peelkit_report::{PeelSummary, SweepSummary, end_reason};
use peelkit_scene::{BODIES, Dimension, KEYS, Key, Kind, Need, Scene, Value, find_key};
use std::fmt::Write;

/// Choices taken from bytes; behind their end everything is zero.
pub struct Dice<'a>(std::slice::Iter<'a, u8>);

impl<'a> Dice<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes.iter())
    }

    /// One of 65536 values.
    fn number(&mut self) -> u16 {
        let mut byte = || self.0.next().copied().unwrap_or(0);
        u16::from_le_bytes([byte(), byte()])
    }

    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.number()) % count.max(1)
    }

    fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * f64::from(self.number()) / 65535.0
    }

    /// At equal ratios.
    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(self.between(from.log10(), to.log10()))
    }
}

/// Steele, Lea and Flood's SplitMix64, from a seed.
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// As many as a scene takes.
    pub fn bytes(&mut self) -> Vec<u8> {
        (0..32).flat_map(|_| self.next().to_le_bytes()).collect()
    }
}

// ---------------------------------------------------------------------------------------------------------------
// Scenes that mean something, with absurd numbers
// ---------------------------------------------------------------------------------------------------------------

/// A scene whose every number lies anywhere in a range that no strip has seen, for a run of at most 60 points and 0.2 s.
pub fn absurd_scene(dice: &mut Dice) -> String {
    let body = dice.pick(&["strip", "strip", "strip", "spatula"]);
    absurd_scene_of(body, dice)
}

/// Four pieces: lengths over six decades, widths over twelve, heights as far apart, bends of either sign, and as round as
/// may be.
fn absurd_pieces(dice: &mut Dice) -> String {
    let size = dice.decades(1e-3, 1e9);
    let mut height = dice.decades(1e-3, 1e9);
    let mut piece = |_| {
        let begins = std::mem::replace(&mut height, dice.decades(1e-3, 1e9));
        let length = size * dice.decades(1e-6, 1.0);
        let [width, next] = [0; 2].map(|_| dice.decades(1e-3, 1e9));
        let (bend, course) = (dice.between(-44.9, 44.9), dice.pick(&["linear", "smooth"]));
        let [round, rounder] = [0; 2].map(|_| dice.between(0.0, 1.0));
        format!(
            "{{ length = \"{length:e} nm\", width = [\"{width:e} nm\", \"{next:e} nm\"], \
             height = [\"{begins:e} nm\", \"{height:e} nm\"], roundness = [{round}, {rounder}], bend = \"{bend} deg\", \
             course = \"{course}\" }}"
        )
    };
    (0..4).map(&mut piece).collect::<Vec<_>>().join(", ")
}

/// The same of a body of this table.
pub fn absurd_scene_of(body: &str, dice: &mut Dice) -> String {
    let mut text = String::new();
    let mut line = |line: String| text += &(line + "\n");
    if dice.below(4) == 0 {
        line("terms = \"auto\"".into());
    }
    line(format!("[{body}]"));
    let keys = KEYS.iter().filter(|key| key.table == body && matches!(key.kind, Kind::Quantity(Dimension::Length, _)));
    let lengths: Vec<(&str, f64)> = keys.map(|key| (key.name, dice.decades(1e-3, 1e9))).collect();
    let behind: f64 = lengths.iter().filter(|l| ["neck_length", "shaft_length"].contains(&l.0)).map(|l| l.1).sum();
    for (name, length) in lengths {
        // a bend ends on the shaft
        let length = if name == "bend_length" { length.min(behind) } else { length };
        line(format!("{name} = \"{length:e} nm\""));
    }
    if body == "profile" {
        line(format!("pieces = [{}]", absurd_pieces(dice)));
    }
    if body == "spatula" {
        line(format!("shaft_angle = \"{} deg\"", dice.between(-179.9, 179.9)));
    }
    line(format!("youngs_modulus = \"{:e} GPa\"", dice.decades(1e-9, 1e9)));
    line(format!("poissons_ratio = {}", dice.between(-0.999_999, 0.499_999)));
    line(format!("shear_correction = {:e}", dice.decades(1e-6, 1e6)));
    line(format!("bending_stiffness_factor = {:e}", dice.decades(1e-9, 1e9)));
    line("[adhesion]".into());
    line(format!("hamaker_constant = \"{:e} J\"", dice.decades(1e-30, 1e-10)));
    line(format!("equilibrium_distance = \"{:e} nm\"", dice.decades(1e-4, 1e4)));
    let law = dice.pick(&["body-force", "body-force", "surface-traction", "bilinear", "exponential", "dugdale"]);
    line(format!("law = \"{law}\""));
    if !law.contains("-") && dice.below(2) == 0 {
        line(format!(
            "work = \"{:e} J/m2\"\nstrength = \"{:e} GPa\"",
            dice.decades(1e-9, 1e6),
            dice.decades(1e-9, 1e6)
        ));
    }
    let line_load = dice.pick(&["full", "force-only", "axis-gap"]);
    line(format!("line_load = \"{line_load}\""));
    line(format!("far_face = {}", dice.pick(&[true, false])));
    let rubs = law.contains("-") && dice.below(4) == 0;
    if rubs {
        line("[friction]".into());
        line(format!("strength = \"{:e} GPa\"", dice.decades(1e-9, 1e6)));
        line(format!("coefficient = {:e}", dice.decades(1e-6, 1e3)));
    }
    line("[grip]".into());
    let rotation = dice.pick(&["free", "fixed"]);
    line(format!("rotation = \"{rotation}\""));
    let horizontal = dice.pick(&["free", "fixed"]);
    line(format!("horizontal = \"{horizontal}\""));
    if body == "strip" && horizontal == "fixed" && !rubs && dice.below(3) == 0 {
        line(format!("pretension = \"{:e} nN\"", dice.decades(1e-9, 1e9)));
    }
    line("[bounds]\npoints = 60\ntime = \"0.2 s\"".into());
    if dice.below(4) == 0 {
        line(format!("displacement = \"{:e} nm\"", dice.decades(1e-3, 1e9)));
    }
    line("[accuracy]".into());
    line(format!("relative = {:e}", dice.decades(1.000_001e-11, 0.999_999e-2)));
    if dice.below(4) == 0 {
        line(format!("order = {}", 1 + dice.below(8)));
    }
    if dice.below(4) == 0 {
        line(format!("elements = {}", dice.decades(1.0, 2000.0).floor()));
    }
    if dice.below(4) == 0 {
        line(format!("step = {:e}", dice.decades(1.000_001e-6, 0.499_999)));
    }
    if dice.below(3) == 0 {
        line(format!("[drive]\nangle = \"{} deg\"", dice.between(0.001, 179.999)));
        if rotation == "fixed" && law != "surface-traction" && line_load != "force-only" && dice.below(2) == 0 {
            line(format!("turn = \"{:e} deg/nm\"", dice.between(-500.0, 500.0)));
        }
        if dice.below(2) == 0 {
            let turn = format!("\"turn {} deg\"", dice.between(-180.0, 180.0));
            let turn = if rotation == "fixed" { turn } else { "\"hold\"".into() };
            let step = |word: &str, amount: f64| format!("\"{word} {amount:e} nm\"");
            let first = step(dice.pick(&["press", "lift"]), dice.decades(1e-6, 1e6));
            let second = step(dice.pick(&["drag", "push"]), dice.decades(1e-6, 1e6));
            line(format!("steps = [{first}, {second}, {turn}]"));
        }
    }
    text
}

/// Peels a scene and says what is wrong with what came out: a number that is not finite, a peak without an error bound, a
/// failure without a reason.
pub fn check_run(text: &str) -> Result<(Scene, Peel), String> {
    let scene = Scene::parse("absurd.toml", text, &[]).map_err(|error| format!("refused: {error}"))?;
    let peel = peel(&scene.model, &scene.accuracy, &scene.bounds.from_now());
    PeelSummary::new(&scene, &peel, 0.0).to_json().map_err(|error| format!("summary.json: {error}"))?;
    for (index, point) in peel.points.iter().enumerate() {
        let numbers = [point.displacement, point.force, point.end_rotation, point.work, point.front];
        if numbers.iter().any(|number| !number.is_finite()) {
            return Err(format!("point {index} of the path is {point:?}"));
        }
    }
    let bounded =
        |peak: &Peak| [peak.force_error, peak.displacement_error].iter().all(|&error| error.is_finite() && error > 0.0);
    for (name, peak) in [("peak", &peel.peak), ("initiation peak", &peel.initiation_peak)] {
        if let Some(peak) = peak.as_ref().filter(|peak| !bounded(peak)) {
            return Err(format!("{name} without a bound: {peak:?}"));
        }
    }
    if let Some(point) = peel.limit_points.iter().find(|at| !(at.force_error > 0.0 && at.displacement_error > 0.0)) {
        return Err(format!("limit point without a bound: {point:?}"));
    }
    match &peel.end {
        end @ (PathEnd::Failed(_) | PathEnd::Bound(_))
            if end_reason(end).is_none_or(|reason| reason.trim().is_empty()) =>
        {
            Err(format!("{:?}", peel.end))
        }
        PathEnd::Failed(failure) if !failure.to_string().contains("Try ") => {
            Err(format!("says not what to try: {failure}"))
        }
        _ => Ok((scene, peel)),
    }
}

// ---------------------------------------------------------------------------------------------------------------
// Texts that may mean nothing
// ---------------------------------------------------------------------------------------------------------------

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
    let mut entries: Vec<(&str, String, String)> = keys_of(body)
        .filter(|key| key.table != "substrate" || key.shapes().contains(&shape))
        .filter(|key| key.alternative().is_none() || key.name != left_out)
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

/// Parses a text and says what is wrong with the answer: a key that was not taken as it stands there, a default in place of
/// what was given, a refusal that names no place, a scene that does not come back from what is printed of it. Whether it
/// was taken.
pub fn check_parse(text: &str) -> Result<bool, String> {
    match Scene::parse("garbled.toml", text, &[]) {
        Ok(scene) => {
            holds_what_was_given(text, &scene)?;
            comes_back(&scene)?;
            Ok(true)
        }
        Err(error) => {
            let (message, remedy) = (error.to_string(), error.remedy());
            let named = message.starts_with("garbled.toml, line ") && !remedy.is_empty() && message.len() < 1000;
            if named && remedy.len() < 2000 { Ok(false) } else { Err(format!("refused with {message} / {remedy}")) }
        }
    }
}

/// The text read a second time, by a plain reader of TOML.
fn holds_what_was_given(text: &str, scene: &Scene) -> Result<(), String> {
    let document: toml::Table = text.parse().map_err(|error| format!("taken, but not TOML: {error}"))?;
    let mut given = Vec::new();
    for (name, value) in &document {
        match value {
            toml::Value::Table(table) => {
                given.extend(table.iter().map(|(key, value)| (format!("{name}.{key}"), value)))
            }
            value => given.push((name.clone(), value)),
        }
    }
    for (path, value) in &given {
        let key = find_key(path).map_err(|_| format!("`{path}` was taken in silence"))?;
        let stored = key.value(scene).ok_or_else(|| format!("`{path}` was given and is not there"))?;
        let same = match (value, &stored) {
            (toml::Value::String(text), Value::Text(word)) => text == word,
            (toml::Value::Boolean(flag), Value::Flag(stored)) => flag == stored,
            (toml::Value::Array(_), Value::List(_)) => same_item(value, &stored),
            (toml::Value::Integer(number), Value::Number(stored)) => *number as f64 == *stored,
            (toml::Value::Float(number), Value::Number(stored)) => number == stored,
            (toml::Value::String(text), &Value::Number(stored)) => quantity(text, key.unit()).is_none_or(|number| {
                (number - stored).abs() <= 1e-12 * stored.abs() || (stored.abs() < 1e-290 && number.abs() < 1e-290)
            }),
            _ => false,
        };
        if !same {
            return Err(format!("`{path}` is {value} in the text and {stored} in the scene"));
        }
    }
    let absent = |key: &&Key| key.belongs_to(scene) && given.iter().all(|(path, _)| *path != key.path());
    for key in KEYS.iter().filter(absent) {
        if key.need == Need::Required {
            return Err(format!("taken without `{}`", key.path()));
        }
        let file_name = Some(Value::Text("garbled".into())).filter(|_| key.name == "title");
        if key.value(scene) != file_name.or_else(|| key.default_value()) {
            return Err(format!("`{}` was not given and has not its default", key.path()));
        }
    }
    Ok(())
}

/// Whether what is in a list is the same: a step, a piece, or a value of one, of which two that are the same are stored as one.
fn same_item(given: &toml::Value, stored: &Value) -> bool {
    match (given, stored) {
        (toml::Value::Array(given), Value::List(stored)) => {
            given.len() == stored.len() && given.iter().zip(stored).all(|(given, stored)| same_item(given, stored))
        }
        (toml::Value::Array(given), stored) => given.len() == 2 && given.iter().all(|given| same_item(given, stored)),
        (toml::Value::Table(given), Value::Table(stored)) => given.iter().all(|(name, given)| {
            stored.iter().find(|(known, _)| known == name).is_some_and(|(_, stored)| same_item(given, stored))
        }),
        (toml::Value::Integer(given), Value::Number(stored)) => *given as f64 == *stored,
        (toml::Value::Float(given), Value::Number(stored)) => given == stored,
        (toml::Value::String(given), Value::Text(stored)) => {
            let number = |text: &str| quantity(text, "nm").or_else(|| quantity(text, "rad"));
            let same = |(a, b): (f64, f64)| (a - b).abs() <= 1e-12 * b.abs() || (a.abs() < 1e-290 && b.abs() < 1e-290);
            number(given).zip(number(stored)).map_or_else(|| same_step(given, stored), same)
        }
        _ => false,
    }
}

/// Whether two texts are the same step: the word, and the amount in whatever unit.
fn same_step(given: &str, stored: &str) -> bool {
    let parts = |text: &str| {
        let (word, amount) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
        let amount = amount.trim().to_owned();
        let number = quantity(&amount, if word == "turn" { "rad" } else { "nm" });
        (word.to_owned(), amount.is_empty(), number)
    };
    let (given, stored) = (parts(given), parts(stored));
    let same = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs() || (a.abs() < 1e-290 && b.abs() < 1e-290);
    let amounts = given.2.zip(stored.2).is_none_or(|(a, b)| same(a, b));
    given.0 == stored.0 && given.1 == stored.1 && amounts
}

/// A quantity in a unit of this list, in the unit of the library; nothing where the unit is another one.
fn quantity(text: &str, library: &str) -> Option<f64> {
    let units: &[(&str, f64)] = match library {
        "nm" => &[("nm", 1.0), ("um", 1e3), ("µm", 1e3), ("μm", 1e3), ("mm", 1e6), ("pm", 1e-3), ("m", 1e9)],
        "GPa" => &[("GPa", 1.0), ("MPa", 1e-3), ("kPa", 1e-6), ("Pa", 1e-9)],
        "rad/nm" => &[("rad/nm", 1.0), ("deg/nm", std::f64::consts::PI / 180.0)],
        "rad" => &[("rad", 1.0), ("deg", std::f64::consts::PI / 180.0)],
        "aJ" => &[("aJ", 1.0), ("zJ", 1e-3), ("eV", 0.160_217_663_4), ("J", 1e18)],
        _ => &[("ms", 1e-3), ("min", 60.0), ("h", 3600.0), ("s", 1.0)],
    };
    units.iter().find_map(|(unit, factor)| {
        let number: f64 = text.trim().strip_suffix(unit)?.trim().parse().ok()?;
        Some(number * factor)
    })
}

/// The scene written anew from the `parameters` that outputs print, and read again.
fn comes_back(scene: &Scene) -> Result<(), String> {
    let printed = printed(scene)?;
    match Scene::parse(&scene.name, &printed, &[]) {
        Ok(again) if again == *scene => Ok(()),
        Ok(again) => Err(format!("{scene:?} came back as {again:?} from\n{printed}")),
        Err(error) => Err(format!("{scene:?} is printed as\n{printed}\nwhich is refused: {error}")),
    }
}

/// A scene as its `parameters` tell it, in TOML.
pub fn printed(scene: &Scene) -> Result<String, String> {
    let key = find_key("accuracy.relative").map_err(|problem| problem.found)?;
    let json = SweepSummary::new(scene, key, &[], &[]).to_json().map_err(|error| error.to_string())?;
    let json: serde_json::Value = serde_json::from_str(&json).map_err(|error| error.to_string())?;
    let mut text = format!("title = {}\n", toml::Value::from(scene.title.as_str()));
    for key in KEYS.iter().filter(|key| key.name != "title") {
        let (name, unit) = (key.name, key.unit());
        let column = if unit.is_empty() { name.to_owned() } else { format!("{name}_{}", unit.replace('/', "_per_")) };
        let parameters = &json["parameters"];
        let table = if key.table.is_empty() { parameters } else { &parameters[key.table] };
        let line = match &table[&column] {
            serde_json::Value::Null => continue,
            value @ serde_json::Value::Array(_) => {
                let value = toml::Value::try_from(value).map_err(|error| error.to_string())?;
                format!("{} = {value}\n", key.path())
            }
            value if unit.is_empty() => format!("{} = {value}\n", key.path()),
            value => format!("{} = \"{value} {unit}\"\n", key.path()),
        };
        text += &line;
    }
    Ok(text)
}
