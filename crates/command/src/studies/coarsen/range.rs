//! Quantities and ranges of an option.

use crate::terminal::stop::Stop;
use peelkit_scene::{Dimension, parse_quantity};

/// A number with a unit, in the library's unit.
pub fn number(option: &str, text: &str, dimension: Dimension) -> Result<f64, Stop> {
    parse_quantity(text, dimension).map_err(|_| {
        let (what, unit) = if dimension == Dimension::Angle { ("an angle", "deg") } else { ("a length", "nm") };
        Stop::bad_input(
            format!("{option} has \"{text}\", which is not {what} with its unit"),
            format!("Write a number and a unit, such as \"10 {unit}\"."),
        )
    })
}

/// Two of them, from and to.
pub fn pair(option: &str, text: &str, dimension: Dimension) -> Result<[f64; 2], Stop> {
    let Some((from, to)) = text.split_once(',') else {
        let unit = if dimension == Dimension::Angle { "deg" } else { "nm" };
        return Err(Stop::bad_input(
            format!("{option} has \"{text}\", which is no range from,to"),
            format!("Write two numbers with their units, such as \"-10 {unit},10 {unit}\"."),
        ));
    };
    Ok([number(option, from, dimension)?, number(option, to, dimension)?])
}
