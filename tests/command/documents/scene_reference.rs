//! The tables of `docs/reference/scene-reference.md` are made of the list of keys.

use super::{hold, row, text, with_part};
use peelkit_scene::{Dimension, KEYS, Key, Kind, Need, Value};

const PATH: &str = "docs/reference/scene-reference.md";

#[test]
fn the_scene_reference_is_that_of_the_keys() {
    let mut reference = text(PATH);
    for keys in KEYS.chunk_by(|a, b| a.table == b.table) {
        let name = if keys[0].table.is_empty() { "top of the file" } else { keys[0].table };
        let mut part = row(&["key", "takes", "default", "range", "meaning"]) + "|---|---|---|---|---|\n";
        part.extend(keys.iter().map(line));
        reference = with_part(&reference, &format!("keys of {name}"), &part);
    }
    let mut units = row(&["quantity", "units"]) + "|---|---|\n";
    for dimension in dimensions() {
        let name = dimension.to_string();
        let name = name.trim_start_matches("an ").trim_start_matches("a ");
        units += &row(&[name, &dimension.units().join(", ")]);
    }
    hold(PATH, &with_part(&reference, "units", &units));
}

fn line(key: &Key) -> String {
    let [takes, range] = takes(key);
    row(&[&format!("`{}`", key.name), &takes, &default(key), &range, key.about])
}

/// What the key takes, and in which range.
fn takes(key: &Key) -> [String; 2] {
    let name = |dimension: &Dimension| dimension.to_string();
    match &key.kind {
        Kind::Number(range, _) | Kind::Share(range, _) => ["a number".into(), short(&range.to_string())],
        Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => [name(dimension), "above zero".into()],
        Kind::Measure(dimension, range, _) => [name(dimension), measure(key, &range.to_string())],
        Kind::Count(1_000_000_000, _) => ["a whole number".into(), "1 to 1e9".into()],
        Kind::Count(most, _) | Kind::Fixed(most, _) => ["a whole number".into(), format!("1 to {most}")],
        Kind::Flag(_) | Kind::InSpace => ["`true` or `false`".into(), String::new()],
        Kind::Table(_) | Kind::Heights(_) | Kind::Tractions(_) => {
            ["a CSV in quotes, or the name of a file beside the scene".into(), String::new()]
        }
        Kind::Pieces(_) => ["a list of pieces".into(), String::new()],
        Kind::Steps(_) => ["a list of steps, each a text".into(), String::new()],
        _ => [key.takes().replace('"', "`"), String::new()],
    }
}

fn short(range: &str) -> String {
    range.trim_start_matches("a number ").trim_start_matches("from ").replace("0e0", "0")
}

/// A range of angles in degrees, as angles are written.
fn measure(key: &Key, range: &str) -> String {
    match key.unit() {
        "rad" => {
            let ends = short(range);
            let ends = ends.split(" to ").map(|end| format!("{:.0}", end.parse::<f64>().unwrap().to_degrees()));
            format!("{} deg", ends.collect::<Vec<_>>().join(" to ")).replace("-0 ", "0 ")
        }
        unit => format!("{} {unit}", short(range)),
    }
}

fn default(key: &Key) -> String {
    let stands = |value: Value| match value {
        Value::Number(number) if key.unit() == "rad" => Some(format!("{} deg", trimmed(number.to_degrees()))),
        Value::Number(number) if key.name == "shear_correction" && number == 5.0 / 6.0 => Some("5/6".into()),
        Value::Number(number) if key.name == "relative" => Some(format!("{number:e}")),
        Value::Number(number) => Some(format!("{} {}", trimmed(number), key.unit()).trim().to_owned()),
        Value::Text(text) if !text.is_empty() => Some(format!("`{text}`")),
        Value::Flag(flag) => Some(format!("`{flag}`")),
        Value::List(items) if !items.is_empty() => Some(format!("`{}`", key.default_text())),
        _ => None,
    };
    match (key.need, key.default_value().and_then(stands), &key.kind) {
        (Need::Required, ..) if !key.shapes().is_empty() => {
            format!("required for {}", key.shapes().join(", "))
        }
        (Need::Required, ..) => key.alternative().map_or(key.default_text(), |other| format!("required, or `{other}`")),
        (_, Some(default), _) => default,
        (_, None, Kind::Fixed(..) | Kind::Share(..)) if key.table == "accuracy" => "from `relative`".into(),
        (_, None, Kind::Text(_)) => "name of the file".into(),
        _ => "none".into(),
    }
}

/// At most ten digits.
fn trimmed(number: f64) -> String {
    format!("{}", (number * 1e10).round() / 1e10)
}

fn dimensions() -> Vec<Dimension> {
    use Dimension::*;
    vec![Length, Pressure, Energy, Work, Force, Stiffness, Angle, AnglePerLength, Time, Velocity, Density]
}
