//! What stations and events of the user are called in print.

use super::number::short;
use super::units::Units;
use peelkit::study::{EventAt, StationQuantity};
use peelkit_report::PassedAt;

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
        let with = |error: Option<f64>, exact: &dyn Fn(f64) -> String, value: String| error.map_or(value, exact);
        let place = at.machine.unwrap_or(at.displacement);
        let symbol = if at.machine.is_some() { "U" } else { "u" };
        // of a station at a displacement its own error is none
        let place =
            with(at.displacement_error, &|error| units.length.with_error(place, error), units.length.short(place));
        let force = with(at.force_error, &|error| units.force.with_error(at.force, error), units.force.short(at.force));
        let time = at.time.map_or(String::new(), |time| format!("t = {:.6e} s, ", 1e-9 * time));
        let tips = at.attached.map_or(String::new(), |attached| format!(", {attached} tips attached"));
        let jumped = if at.jumped { ", behind a jump" } else { "" };
        format!(
            "{}: {time}{symbol} = {place}, P = {force}{tips}{jumped}",
            looked_for_text(&looked_for[at.event], units)
        )
    };
    let mut lines: Vec<String> = passed.iter().map(found).collect();
    let missing = looked_for.iter().enumerate().filter(|(event, _)| passed.iter().all(|at| at.event != *event));
    lines.extend(missing.map(|(_, at)| format!("{}: not passed", looked_for_text(at, units))));
    let name = if looked_for.iter().all(|at| at.name.is_empty()) { "stations" } else { "stations, events" };
    lines.into_iter().enumerate().map(|(index, line)| (if index == 0 { name } else { "" }, line)).collect()
}
