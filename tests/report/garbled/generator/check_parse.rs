//! What holds for the reading of any text.

use peelkit_report::SweepSummary;
use peelkit_scene::{KEYS, Key, Need, Scene, Value, find_key};

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
            (toml::Value::String(text), Value::Text(word)) => text == word || same_item(value, &stored),
            (toml::Value::Boolean(flag), Value::Flag(stored)) => flag == stored,
            (toml::Value::Array(_), Value::List(_)) | (toml::Value::Table(_), Value::Table(_)) => {
                same_item(value, &stored)
            }
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
    // beside a cohesive law with work and strength both constants of the half space follow from these
    let of_half_space = ["adhesion.hamaker_constant", "adhesion.equilibrium_distance"];
    let follows =
        |key: &Key| of_half_space.contains(&key.path().as_str()) && scene.model.adhesion.needs_no_hamaker_constant();
    // each of its keys implies a scene in space
    let is_of_space = |path: &String| find_key(path).is_ok_and(Key::is_of_space);
    let follows = |key: &Key| follows(key) || key.path() == "space" && given.iter().any(|(path, _)| is_of_space(path));
    let absent =
        |key: &&Key| key.belongs_to(scene) && !follows(key) && given.iter().all(|(path, _)| *path != key.path());
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
        "nm" => {
            &[("nm", 1.0), ("um", 1e3), ("µm", 1e3), ("μm", 1e3), ("mm", 1e6), ("pm", 1e-3), ("Å", 0.1), ("m", 1e9)]
        }
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

/// The scene written anew, from the `parameters` that outputs print and as a text of its own, and read again.
fn comes_back(scene: &Scene) -> Result<(), String> {
    for written in [printed(scene)?, scene.to_toml()] {
        match Scene::parse(&scene.name, &written, &[]) {
            // a mean that the scene is to give is NaN, which equals nothing
            Ok(again) if again == *scene || format!("{again:?}") == format!("{scene:?}") => {}
            Ok(again) => return Err(format!("{scene:?} came back as {again:?} from\n{written}")),
            Err(error) => return Err(format!("{scene:?} is printed as\n{written}\nwhich is refused: {error}")),
        }
    }
    Ok(())
}

/// A scene as its `parameters` report it, in TOML.
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
            value @ (serde_json::Value::Array(_) | serde_json::Value::Object(_)) => {
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
