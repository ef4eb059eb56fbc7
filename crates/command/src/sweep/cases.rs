//! The cases of a sweep: the scene with each value, or each pair of values, in its place.

use super::varied::{Parameter, TypedValues};
use crate::stop::Stop;
use peelkit_report::SweptKeys;
use peelkit_scene::{KEYS, Key, Scene, ValueError, find_key};

/// Most cases of a sweep.
const MOST: usize = 1_000_000;

/// One case: its values, in the units of the library, and its scene.
#[derive(Clone, Debug)]
pub struct Case {
    pub value: f64,
    /// Of the second key, where two are varied.
    pub second: Option<f64>,
    pub scene: Scene,
}

/// What is varied, and the cases: of two keys every value of the second with each of the first.
pub struct Cases {
    pub keys: SweptKeys<'static>,
    /// Whether the axis of each key is logarithmic; of a single key the second is not.
    pub log: [bool; 2],
    pub all: Vec<Case>,
}

impl Cases {
    pub fn of(scene: &Scene, parameters: &[Parameter]) -> Result<Self, Stop> {
        let [first, rest @ ..] = parameters else {
            return Err(Stop::other("a sweep varies no key"));
        };
        let second = rest.first();
        let keys =
            SweptKeys { first: key_to_vary(&first.path)?, second: second.map(|of| key_to_vary(&of.path)).transpose()? };
        if let Some(other) = keys.second.filter(|other| other.path() == keys.first.path()) {
            return Err(Stop::bad_input(
                format!("--vary {} is given twice", other.path()),
                "Give two different keys, or all its values behind one --vary.",
            ));
        }
        let firsts = values(scene, keys.first, first)?;
        let seconds = keys.second.zip(second).map(|(key, of)| values(scene, key, of)).transpose()?;
        let count = firsts.len().saturating_mul(seconds.as_ref().map_or(1, Vec::len));
        if count > MOST {
            return Err(Stop::bad_input(
                format!("a sweep over {} has {count} pairs of values, more than {MOST}", keys.names()),
                "Give fewer --points.",
            ));
        }
        let mut all = Vec::new();
        for &value in &firsts {
            for second in
                seconds.as_ref().map_or_else(|| vec![None], |values| values.iter().copied().map(Some).collect())
            {
                all.push(Case { value, second, scene: with_values(scene, keys, parameters, value, second)? });
            }
        }
        Ok(Self { keys, log: [first.log, second.is_some_and(|of| of.log)], all })
    }
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

/// The scene with one value, or two, in their places.
fn with_values(
    scene: &Scene,
    keys: SweptKeys,
    parameters: &[Parameter],
    value: f64,
    second: Option<f64>,
) -> Result<Scene, Stop> {
    let mut scene = scene.clone();
    let both = [Some(keys.first), keys.second].into_iter().flatten().zip(parameters).zip([Some(value), second]);
    for ((key, parameter), value) in both {
        let stop = |problem: ValueError| Stop::bad_argument(among(key, parameter), &problem);
        key.store_number(&mut scene, value.unwrap_or(f64::NAN)).map_err(stop)?;
        // of two keys the first value may be right only with the second
        if keys.second.is_none_or(|second| second.path() == key.path()) {
            scene.check().map_err(|error| stop(error.into()))?;
        }
    }
    Ok(scene)
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
    if !key.is_of_space() && !key.belongs_to(scene) {
        return Err(Stop::bad_argument(format!("--vary {}", key.path()), &key.foreign(scene)));
    }
    match &parameter.values {
        TypedValues::Range { from, to, points } => {
            Ok(grid(read("from", from)?, read("to", to)?, *points, parameter.log))
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
