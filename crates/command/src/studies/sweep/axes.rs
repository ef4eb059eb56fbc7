//! The keys that a sweep varies and their values, read from what was typed.

use super::varied::{Parameter, TypedValues};
use crate::terminal::stop::Stop;
use peelkit_analyses::Axis;
use peelkit_scene::{KEYS, Key, Scene, ValueError, find_key};

/// The axis of a parameter that was typed; each value is right by itself.
pub fn read(scene: &Scene, parameter: &Parameter) -> Result<Axis, Stop> {
    let key = key_to_vary(&parameter.path)?;
    let values = values(scene, key, parameter)?;
    Ok(Axis { key, values, log: parameter.log, origin: among(key, parameter) })
}

fn key_to_vary(path: &str) -> Result<&'static Key, Stop> {
    let key = find_key(path).map_err(|problem| Stop::bad_argument(format!("--vary {path}"), &problem))?;
    if key.is_numeric() {
        return Ok(key);
    }
    let numeric: Vec<String> = KEYS.iter().filter(|key| key.is_numeric()).map(Key::path).collect();
    let remedy = format!("Keys that can be varied are {}.", numeric.join(", "));
    Err(Stop::bad_input(format!("--vary {path} is not a number: it takes {}", key.takes()), remedy))
}

/// Which values of a parameter a message is about.
fn among(key: &Key, parameter: &Parameter) -> String {
    match parameter.values {
        TypedValues::Range { .. } => format!("{} between --from and --to", key.path()),
        TypedValues::List(_) => format!("{} among --values", key.path()),
    }
}

/// The values of one parameter, each right by itself.
fn values(scene: &Scene, key: &Key, parameter: &Parameter) -> Result<Vec<f64>, Stop> {
    let read = |name: &str, text: &str| {
        let stop = |problem: ValueError| Stop::bad_argument(format!("--{name} for {}", key.path()), &problem);
        let value = key.parse_number(text).map_err(stop)?;
        if parameter.log && value <= 0.0 {
            return Err(Stop::bad_input(
                format!("--{name} {text} is not above zero, which --log needs"),
                "Give two ends above zero, or omit --log.",
            ));
        }
        key.store_number(&mut scene.clone(), value).map_err(stop)?;
        Ok(value)
    };
    // one of space puts every case there
    if (scene.seta.is_some() || !key.is_of_space()) && !key.belongs_to(scene) {
        return Err(Stop::bad_argument(format!("--vary {}", key.path()), &key.foreign(scene)));
    }
    match &parameter.values {
        TypedValues::Range { from, to, points } => {
            let (first, last) = (read("from", from)?, read("to", to)?);
            if *points == 1 && first != last {
                return Err(Stop::bad_input(
                    format!("--points 1 for {} is one value, and --from {from} and --to {to} are two", key.path()),
                    format!("Give --points 2 or more, or --values \"{from}\"."),
                ));
            }
            Ok(grid(first, last, *points, parameter.log))
        }
        TypedValues::List(texts) => with_common_unit(texts).iter().map(|text| read("values", text)).collect(),
    }
}

/// Values without a unit have that of the last one: "1,2,5 nm".
fn with_common_unit(texts: &[String]) -> Vec<String> {
    let last = texts.last().map_or("", String::as_str);
    let unit = last.find(|c: char| c.is_alphabetic() && !"eE".contains(c)).map_or("", |at| &last[at..]);
    let complete = |text: &String| match text.parse::<f64>() {
        Ok(_) if !unit.is_empty() => format!("{text} {unit}"),
        _ => text.clone(),
    };
    texts.iter().map(complete).collect()
}

/// `points` values from `a` to `b`, both exactly among them; at equal ratios if `log`.
fn grid(a: f64, b: f64, points: usize, log: bool) -> Vec<f64> {
    let at = |i: usize| match i {
        0 => a,
        i if i + 1 == points => b,
        i => {
            let part = i as f64 / (points - 1) as f64;
            let between = |a: f64, b: f64| a + (b - a) * part;
            if log { 10f64.powf(between(a.log10(), b.log10())) } else { between(a, b) }
        }
    };
    (0..points).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_are_exact_and_decades_are_round() {
        assert_eq!(grid(1.0, 3.0, 3, false), [1.0, 2.0, 3.0]);
        assert_eq!(grid(0.3, 0.1, 1, false), [0.3]);
        assert_eq!(grid(1e-4, 1e4, 9, true), [1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4]);
        let falling = grid(0.7, 0.1, 4, true);
        assert_eq!((falling[0], falling[3]), (0.7, 0.1));
        assert!(falling.windows(2).all(|pair| pair[1] < pair[0]));
    }

    #[test]
    fn values_of_a_list_may_share_a_unit() {
        let texts = |list: &str| with_common_unit(&list.split(',').map(str::to_owned).collect::<Vec<_>>());
        assert_eq!(texts("1,2e1,5 nm"), ["1 nm", "2e1 nm", "5 nm"]);
        assert_eq!(texts("1 nm,2 um"), ["1 nm", "2 um"]);
        assert_eq!(texts("1,1e-3"), ["1", "1e-3"]);
        assert_eq!(texts("1e-3 nm,2"), ["1e-3 nm", "2"]);
    }
}
