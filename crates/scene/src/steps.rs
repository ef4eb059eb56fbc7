//! The steps of the grip before the pull as a scene writes them, and where drive and grip contradict each other.

use super::quantity::{Dimension, QuantityError, parse_quantity};
use peelkit::model::{Hold, Moved, PeelModel, Step};

/// A word for a step that takes a length.
type Word = (&'static str, fn(f64) -> Step);
const WORDS: [Word; 4] = [("press", Step::Press), ("lift", Step::Lift), ("drag", Step::Drag), ("push", Step::Push)];

/// Most steps of a scene.
const MOST: usize = 1000;

/// What a list of steps takes.
pub(super) const TAKES: &str = "a list of steps, each a text: \"press 2 nm\", \"lift 2 nm\", \"drag 2 nm\", \"push 2 nm\", \"turn 20 deg\" or \"hold\"";

/// Reads the steps of a list; what was found where one is none.
pub(super) fn read(texts: &[String]) -> Result<Vec<Step>, String> {
    if texts.len() > MOST {
        return Err(format!("has {} steps, more than {MOST}", texts.len()));
    }
    let named = |(index, text): (usize, &String)| {
        one(text).map_err(|why| format!("has as step {} \"{}\", {why}", index + 1, super::error::one_line(text)))
    };
    texts.iter().enumerate().map(named).collect()
}

fn one(text: &str) -> Result<Step, String> {
    let (word, amount) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
    let length = WORDS.iter().find(|(name, _)| *name == word);
    match (word, length) {
        ("hold", _) if amount.is_empty() => Ok(Step::Hold),
        ("hold", _) => Err("and hold takes no amount".into()),
        ("turn", _) => match quantity(amount, Dimension::Angle, "whose word is not followed by an angle")? {
            angle if angle != 0.0 => Ok(Step::Turn(angle)),
            _ => Err("which is no rotation: write \"hold\"".into()),
        },
        (_, Some((_, step))) => match quantity(amount, Dimension::Length, "whose word is not followed by a length")? {
            length if length > 0.0 => Ok(step(length)),
            _ => Err("whose amount is not above zero: lift reverses press, push reverses drag".into()),
        },
        _ => Err("which does not begin with press, lift, drag, push, turn or hold".into()),
    }
}

/// Reads a finite quantity; else what the amount is that is none, which `no_number` says of one without a number.
pub(super) fn quantity(text: &str, dimension: Dimension, no_number: &str) -> Result<f64, String> {
    let units = dimension.units().join(", ");
    match parse_quantity(text, dimension) {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err("whose amount is not a finite number".into()),
        Err(QuantityError::NoNumber) => Err(no_number.into()),
        Err(QuantityError::NoUnit) => Err(format!("whose amount has no unit ({units})")),
        Err(QuantityError::UnknownUnit { .. } | QuantityError::WrongDimension { .. }) => {
            Err(format!("whose unit is none of {dimension} ({units})"))
        }
    }
}

/// What of the drive does not fit the rest of a model: the key, what was found, and what would be right.
pub(super) fn misfit(model: &PeelModel) -> Option<(&'static str, String, &'static str)> {
    let free = model.grip.rotation == Hold::Free;
    let turn = model.pull.turn;
    if turn != 0.0 && free {
        let found = format!("is {turn} rad/nm, and `grip.rotation` is \"free\": such a grip cannot rotate the end");
        return Some(("drive.turn", found, "Give `rotation = \"fixed\"` under [grip], or remove `turn`."));
    }
    if turn != 0.0 && !model.line_law().has_potential() {
        let found = "rotates the grip under a load without a potential: the work of force and moment is computed as a change of energy";
        return Some(("drive.turn", found.into(), "Use another law or line_load under [adhesion], or remove `turn`."));
    }
    if let Some(step) = model.steps.iter().find(|step| step.moves(Moved::Rotation)).filter(|_| free) {
        let found =
            format!("has the step \"{step}\", and `grip.rotation` is \"free\": such a grip cannot rotate the end");
        return Some(("drive.steps", found, "Give `rotation = \"fixed\"` under [grip], or remove the step."));
    }
    None
}
