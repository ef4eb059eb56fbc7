//! What stations and events of the user are called in print.

use super::number::short;
use super::units::{Unit, Units};
use peelkit::study::{EventAt, StationQuantity};
use peelkit_report::PassedAt;

/// An error below this share of its number is round-off.
const ROUND_OFF: f64 = 1e-10;

/// What was looked for: a value of a quantity, and the name of an event that has one.
pub(super) fn looked_for_text(at: &EventAt, units: &Units) -> String {
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

/// Where stations and events lie beside a path, a line each; and which of them lie nowhere.
pub(super) fn passed_lines(passed: &[PassedAt], looked_for: &[EventAt], units: &Units) -> Vec<(&'static str, String)> {
    let found = |at: &PassedAt| {
        // an error far below what is printed says nothing
        let known = |value: f64, error: Option<f64>| error.filter(|error| *error > ROUND_OFF * value.abs());
        let with = |unit: Unit, value: f64, error: Option<f64>| match known(value, error) {
            Some(error) => unit.with_error(value, error),
            None => unit.short(value),
        };
        let machine = at.machine.map_or(String::new(), |machine| format!("U = {}, ", units.length.short(machine)));
        let place = with(units.length, at.displacement, at.displacement_error);
        let force = with(units.force, at.force, at.force_error);
        let time = at.time.map_or(String::new(), |time| format!("t = {:.6e} s, ", 1e-9 * time));
        let tips = at.attached.map_or(String::new(), |attached| format!(", {attached} tips attached"));
        let jumped = if at.jumped { ", behind a jump" } else { "" };
        format!(
            "{}: {machine}{time}u = {place}, P = {force}{tips}{jumped}",
            looked_for_text(&looked_for[at.event], units)
        )
    };
    let mut lines: Vec<String> = passed.iter().map(found).collect();
    let missing = looked_for.iter().enumerate().filter(|(event, _)| passed.iter().all(|at| at.event != *event));
    lines.extend(missing.map(|(_, at)| format!("{}: not passed", looked_for_text(at, units))));
    let name = if looked_for.iter().all(|at| at.name.is_empty()) { "stations" } else { "stations, events" };
    lines.into_iter().enumerate().map(|(index, line)| (if index == 0 { name } else { "" }, line)).collect()
}
