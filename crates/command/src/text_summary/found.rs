//! What stations and events of the user are called in print.

use super::number::short;
use super::units::Units;
use peelkit::study::{EventAt, StationQuantity};

/// What was looked for: a value of a quantity, and the name of an event that has one.
pub(super) fn looked_for(at: &EventAt, units: &Units) -> String {
    let named = match at.quantity.named() {
        Some(StationQuantity::Displacement) => "u",
        Some(StationQuantity::Force) => "P",
        Some(StationQuantity::Front) => "front",
        Some(StationQuantity::EndRotation) => "rotation of the grip",
        Some(StationQuantity::FreeEndGap) => "gap of the free end",
        Some(StationQuantity::Time) => "t",
        Some(StationQuantity::Attached) => "attached",
        None => return at.name.clone(),
    };
    let condition = format!("{named} {} {}", at.passing.sign(), value_text(at, at.value, units));
    if at.name.is_empty() || at.name == condition { condition } else { format!("{}, {condition}", at.name) }
}

/// A value of what was looked for.
pub(super) fn value_text(at: &EventAt, value: f64, units: &Units) -> String {
    match at.quantity.named() {
        Some(StationQuantity::Displacement | StationQuantity::Front | StationQuantity::FreeEndGap) => {
            units.length.short(value)
        }
        Some(StationQuantity::Force) => units.force.short(value),
        Some(StationQuantity::EndRotation) => format!("{} deg", short(value.to_degrees())),
        Some(StationQuantity::Time) => format!("{} ns", short(value)),
        Some(StationQuantity::Attached) | None => short(value),
    }
}
