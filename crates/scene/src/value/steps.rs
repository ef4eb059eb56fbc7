//! The steps of the grip before the pull as a scene writes them.

use super::quantity::{Dimension, QuantityError, parse_quantity};
use peelkit::model::{MOST_STEPS, ModelErrorKind, Step};

/// A word for a step that takes a length.
type Word = (&'static str, fn(f64) -> Step);
const LENGTHS: [Word; 5] =
    [("press", Step::Press), ("lift", Step::Lift), ("drag", Step::Drag), ("push", Step::Push), ("shift", Step::Shift)];
/// For one that takes an angle.
const ANGLES: [Word; 3] = [("turn", Step::Turn), ("roll", Step::Roll), ("yaw", Step::Yaw)];
/// For one that takes neither.
const ALONE: [(&str, Step); 2] = [("release", Step::Release), ("hold", Step::Hold)];

/// The words that a step begins with.
pub(crate) const WORDS: &[&str] = &["press", "lift", "drag", "push", "shift", "turn", "roll", "yaw", "release", "hold"];

/// What a list of steps takes.
pub(crate) const TAKES: &str = "a list of steps, each a text: \"press 2 nm\", \"lift 2 nm\", \"drag 2 nm\", \"push 2 nm\", \"turn 20 deg\", \"release\" or \"hold\"; in space also \"shift 2 nm\", \"roll 20 deg\" or \"yaw 20 deg\"";

/// Reads the steps of a list; what was found where one is none.
pub(crate) fn read(texts: &[String]) -> Result<Vec<Step>, String> {
    if texts.len() > MOST_STEPS {
        return Err(ModelErrorKind::TooManySteps { found: texts.len(), most: MOST_STEPS }.to_string());
    }
    let named = |(index, text): (usize, &String)| {
        one(text).map_err(|why| format!("has as step {} \"{}\", {why}", index + 1, crate::error::one_line(text)))
    };
    texts.iter().enumerate().map(named).collect()
}

fn one(text: &str) -> Result<Step, String> {
    let (word, amount) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
    if let Some((name, step)) = ALONE.into_iter().find(|(name, _)| *name == word) {
        return if amount.is_empty() { Ok(step) } else { Err(format!("and {name} takes no amount")) };
    }
    let of = |words: &[Word]| words.iter().find(|(name, _)| *name == word).map(|(_, step)| *step);
    if let Some(step) = of(&ANGLES) {
        return checked(step(quantity(amount, Dimension::Angle, "whose word is not followed by an angle")?));
    }
    if let Some(step) = of(&LENGTHS) {
        return checked(step(quantity(amount, Dimension::Length, "whose word is not followed by a length")?));
    }
    let (last, others) = WORDS.split_last().expect("there are such words");
    Err(format!("which does not begin with {} or {last}", others.join(", ")))
}

/// The step, if it is one.
fn checked(step: Step) -> Result<Step, String> {
    step.check().map(|()| step).map_err(|wrong| wrong.to_string())
}

/// Reads a finite quantity; else what the amount is that is none, which `no_number` says of one without a number.
pub(crate) fn quantity(text: &str, dimension: Dimension, no_number: &str) -> Result<f64, String> {
    let units = dimension.units().join(", ");
    match parse_quantity(text, dimension) {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("whose amount is not a finite number".into()),
        Err(QuantityError::NoNumber) => Err(no_number.into()),
        Err(QuantityError::NoUnit) => Err(format!("whose amount has no unit ({units})")),
        Err(QuantityError::Comma(comma)) => {
            Err(format!("whose number has a comma: write \"{}\"", crate::error::one_line(&comma.decimal)))
        }
        Err(QuantityError::NotMetric { .. }) => Err(format!("whose unit is not metric ({units})")),
        Err(QuantityError::UnknownUnit { .. } | QuantityError::WrongDimension { .. }) => {
            Err(format!("whose unit is none of {dimension} ({units})"))
        }
    }
}
