//! The keys of a scene as controls of the page: value, unit, range, words.

use peelkit::model::Range;
use peelkit_scene::{Dimension, KEYS, Key, Scene, Value, parse_quantity};
use serde::Serialize;

/// A slider of a quantity above zero goes from a tenth of its value to ten times that, one of a plain number over more.
const DECADES_OF_A_QUANTITY: f64 = 10.0;
const DECADES_OF_A_NUMBER: f64 = 1e4;
/// A range as wide as this is that of any number; a slider over it would say nothing.
const WIDE: f64 = 100.0;

/// A key of a scene as the page shows it.
#[derive(Debug, Serialize)]
pub(crate) struct Control {
    key: String,
    about: &'static str,
    /// In which the number is shown and sent; empty where there is none
    unit: &'static str,
    /// What holds where a scene does not give the key
    default: String,
    /// What it may be, in words
    range: String,
    #[serde(flatten)]
    kind: ControlKind,
}

/// What a control looks like.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum ControlKind {
    /// A number, with a slider where it has a value and a range that one can show
    Number { value: Option<f64>, slider: Option<Slider>, whole: bool },
    /// One of several words
    Choice { value: String, words: Vec<&'static str> },
}

/// A range that a slider goes over.
#[derive(Debug, Serialize)]
struct Slider {
    low: f64,
    high: f64,
    logarithmic: bool,
}

/// The keys of a scene that are one number or one of several words.
pub(crate) fn controls(scene: &Scene) -> Vec<Control> {
    let shown = |key: &&Key| !matches!(key.table, "fit" | "optimise" | "uncertainty" | "bounds" | "");
    KEYS.iter().filter(shown).filter(|key| key.belongs_to(scene)).filter_map(|key| control(key, scene)).collect()
}

fn control(key: &Key, scene: &Scene) -> Option<Control> {
    let kind = match key.value(scene) {
        Some(Value::Text(value)) if !key.choices().is_empty() => ControlKind::Choice { value, words: key.choices() },
        Some(Value::Flag(value)) => ControlKind::Choice { value: value.to_string(), words: vec!["true", "false"] },
        Some(Value::Number(number)) if key.is_numeric() => {
            let unit = size_of_unit(key.dimension(), key.usual_unit());
            ControlKind::Number { value: Some(number / unit), slider: slider(key, number, unit), whole: key.is_count() }
        }
        None if key.is_numeric() => ControlKind::Number { value: None, slider: None, whole: key.is_count() },
        _ => return None,
    };
    Some(Control {
        key: key.path(),
        about: key.about,
        unit: key.usual_unit(),
        default: key.default_text(),
        range: key.range_text(),
        kind,
    })
}

/// A unit in that of the library.
fn size_of_unit(dimension: Option<Dimension>, unit: &str) -> f64 {
    dimension.and_then(|dimension| parse_quantity(&format!("1 {unit}"), dimension).ok()).unwrap_or(1.0)
}

/// The range of the slider of a number, which is in the unit of the library.
fn slider(key: &Key, number: f64, unit: f64) -> Option<Slider> {
    if key.is_count() {
        return None;
    }
    match key.range() {
        Range::Positive if number > 0.0 => {
            let factor = if key.unit().is_empty() { DECADES_OF_A_NUMBER } else { DECADES_OF_A_QUANTITY };
            Some(Slider { low: number / factor / unit, high: number * factor / unit, logarithmic: true })
        }
        Range::From(low, high) if low > 0.0 && high < WIDE => {
            Some(Slider { low: low / unit, high: high / unit, logarithmic: true })
        }
        // half a turn is one as a user rounds it
        Range::From(low, high) if high - low < WIDE => {
            Some(Slider { low: (low / unit).round(), high: (high / unit).round(), logarithmic: false })
        }
        // the ends are not in it
        Range::Between(low, high) if high - low < WIDE => {
            let inset = 1e-3 * (high - low);
            Some(Slider { low: low + inset, high: high - inset, logarithmic: false })
        }
        _ => None,
    }
}
