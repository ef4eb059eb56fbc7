//! The table `output`: the stations at which a path is computed besides, events of the user, and units, in a scene and on the command line.

use super::measured::{ANY, condition, named, number, quantity, text};
use crate::error::{ValueError, one_line};
use crate::key::kind::Setting;
use crate::value::form::{Entry, Form};
use crate::value::quantity::Dimension;
use crate::value::{Fault, Value, quoted};
use peelkit::study::{EventAction, EventAt, StationAt, StationQuantity};
use peelkit::units::{FORCES, FORCES_PER_WIDTH, LENGTHS, PEEL_ADHESIONS, PreferredUnits, Unit, WORKS};

/// Most stations of a path, and most events.
const MOST: usize = 1000;

/// `stations`
pub(crate) static STATIONS: Setting = Setting {
    takes: "a table of the quantities `displacement`, `force`, `front`, `end_rotation`, `free_end_gap` and `time`, each with a value or a list of values, with their units",
    brief: "a table",
    example: "{ displacement = [\"10 nm\", \"20 nm\"] }",
    form: || Form::Table(ENTRIES),
    read: |scene, value, _| {
        scene.stations = read_stations(value)?;
        Ok(())
    },
    write: |scene, _| (!scene.stations.is_empty()).then(|| written_stations(&scene.stations)),
};

const ENTRIES: &[Entry] = &[
    Entry::optional("displacement", || values(Dimension::Length)),
    Entry::optional("force", || values(Dimension::Force)),
    Entry::optional("front", || values(Dimension::Length)),
    Entry::optional("end_rotation", || values(Dimension::Angle)),
    Entry::optional("free_end_gap", || values(Dimension::Length)),
    Entry::optional("time", || values(Dimension::Time)),
];

/// One value, or a list of these.
fn values(dimension: Dimension) -> Form {
    let one = Form::Quantity(dimension, ANY);
    Form::Either(Box::new(one.clone()), Box::new(Form::list(one)))
}

fn read_stations(value: &Value) -> Result<Vec<StationAt>, Fault> {
    let Value::Table(entries) = value else { return Err(Fault::whole(format!("is {value}, no table"))) };
    let mut stations = Vec::new();
    for (name, value) in entries {
        let of = quantity(name, StationQuantity::is_continuous).map_err(|why| Fault::whole(format!("has {why}")))?;
        let values = if let Value::List(values) = value { values.as_slice() } else { std::slice::from_ref(value) };
        for value in values {
            let Value::Text(text) = value else {
                return Err(Fault::whole(format!("has `{name}` = {value}, no text with a number and its unit")));
            };
            let value = number(of, text).map_err(|why| Fault::whole(format!("has {why}")))?;
            stations.push(StationAt { quantity: of, value });
        }
    }
    match stations.len() {
        found if found > MOST => {
            Err(Fault::whole(format!("has {found} values, and a path has at most {MOST} stations")))
        }
        0 => Err(Fault::whole("has no values".to_owned())),
        _ => Ok(stations),
    }
}

/// A station of the command line, `u=10 nm`.
///
/// Fails where its quantity is not known, or its value is no number with a unit of the quantity.
pub fn station(text: &str) -> Result<StationAt, ValueError> {
    let read = || {
        let (name, value) = text.split_once('=').ok_or_else(|| format!("{}, which has no =", quoted(text)))?;
        let quantity = named(name.trim(), StationQuantity::is_continuous)?;
        Ok(StationAt { quantity, value: number(quantity, value)? })
    };
    read().map_err(|found: String| {
        ValueError::new(
            format!("is {found}"),
            "Give for example --at u=\"10 nm\", --at P=\"1 nN\", --at front=\"50 nm\", --at end_rotation=\"30 deg\", --at free_end_gap=\"2 nm\" or --at t=\"5 us\".",
        )
    })
}

fn written_stations(stations: &[StationAt]) -> Value {
    let of = |quantity: StationQuantity| {
        let own = stations.iter().filter(|at| at.quantity == quantity);
        let values: Vec<Value> = own.map(|at| Value::Text(text(quantity, at.value))).collect();
        (!values.is_empty()).then(|| (quantity.name().to_owned(), Value::List(values)))
    };
    Value::Table(StationQuantity::NAMED.into_iter().filter_map(|(_, quantity)| of(quantity)).collect())
}

// -- Events of the user --

/// `events`
pub(crate) static EVENTS: Setting = Setting {
    takes: "a list of tables with `when`, a condition such as \"front < 50 nm\", and if wanted `name` and `action` (\"record\" or \"stop\")",
    brief: "a list of tables",
    example: "[{ name = \"half off\", when = \"front < 50 nm\", action = \"stop\" }]",
    form: || Form::list(Form::Table(OF_EVENT)),
    read: |scene, value, _| {
        scene.events = read_events(value)?;
        Ok(())
    },
    write: |scene, _| (!scene.events.is_empty()).then(|| written_events(&scene.events)),
};

const OF_EVENT: &[Entry] = &[
    Entry::needed("when", || Form::Text),
    Entry::optional("name", || Form::Text),
    Entry::optional("action", || Form::word(&EventAction::NAMED)),
];

fn read_events(value: &Value) -> Result<Vec<EventAt>, Fault> {
    let Value::List(items) = value else { return Err(Fault::whole(format!("is {value}, no list of tables"))) };
    if items.is_empty() || items.len() > MOST {
        return Err(Fault::whole(format!("has {} events; from 1 to {MOST} are looked for", items.len())));
    }
    let one = |(item, value): (usize, &Value)| one_event(value).map_err(|why| Fault::at(item, why));
    let events = items.iter().enumerate().map(one).collect::<Result<Vec<_>, _>>()?;
    let twice = events.iter().enumerate().find(|(n, event)| events[..*n].iter().any(|other| other.name == event.name));
    match twice {
        Some((item, event)) => Err(Fault::at(item, format!("has the name {} of an earlier one", quoted(&event.name)))),
        None => Ok(events),
    }
}

fn one_event(value: &Value) -> Result<EventAt, String> {
    let Value::Table(entries) = value else { return Err(format!("is {value}, no table with a `when`")) };
    let (mut name, mut when, mut action) = (None, None, EventAction::Record);
    for (key, value) in entries {
        let Value::Text(text) = value else { return Err(format!("has `{key}` = {value}, no text")) };
        match key.as_str() {
            "name" => name = Some(text.as_str()),
            "when" => when = Some(text.as_str()),
            "action" => {
                let known = EventAction::NAMED.into_iter().find(|named| named.0 == text);
                let none = || format!("has `action` = {}, which is neither \"record\" nor \"stop\"", quoted(text));
                action = known.ok_or_else(none)?.1;
            }
            _ => return Err(format!("has {}, which is none of `when`, `name`, `action`", quoted(key))),
        }
    }
    let when = when.ok_or("has no `when`, a condition such as \"front < 50 nm\"")?;
    let event = of_condition(name, when, action).map_err(|why| format!("has `when` = {why}"))?;
    Ok(event)
}

fn of_condition(name: Option<&str>, when: &str, action: EventAction) -> Result<EventAt, String> {
    let (quantity, passing, value) = condition(when)?;
    let condition = || {
        let (left, right) = when.split_once(passing.sign()).unwrap_or((when, ""));
        format!("{} {} {}", left.trim(), passing.sign(), right.trim())
    };
    let name = name.map(str::trim).filter(|name| !name.is_empty()).map_or_else(condition, one_line);
    Ok(EventAt { name, quantity, value, passing, action })
}

/// An event of the command line, `front < 50 nm` or `half off: front < 50 nm`.
///
/// Fails where its condition is none, its quantity is not known, or its value is no number with a unit of the quantity.
pub fn event(text: &str, action: EventAction) -> Result<EventAt, ValueError> {
    let (name, when) = match text.split_once(':') {
        Some((name, when)) => (Some(name), when),
        None => (None, text),
    };
    of_condition(name, when, action).map_err(|found| {
        ValueError::new(
            format!("is {found}"),
            "Give for example \"P > 0.04 nN\", \"front < 50 nm\" or \"half off: front < 50 nm\": > counts where it rises past the value, < where it falls, = both.",
        )
    })
}

fn written_events(events: &[EventAt]) -> Value {
    let one = |event: &EventAt| {
        let of = event.quantity.named()?;
        let when = format!("{} {} {}", of.name(), event.passing.sign(), text(of, event.value));
        let entry = |key: &str, value: &str| (key.to_owned(), Value::Text(value.to_owned()));
        Some(Value::Table(vec![entry("name", &event.name), entry("when", &when), entry("action", event.action.name())]))
    };
    Value::List(events.iter().filter_map(one).collect())
}

// -- Units --

/// `units`
pub(crate) static UNITS: Setting = Setting {
    takes: "a text of at most one unit each of forces, lengths, works and forces over a width",
    brief: "a text of units",
    example: "\"mN, mm, nJ\"",
    form: || Form::Text,
    read: |scene, value, _| {
        let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}, no text of units"))) };
        scene.units = PreferredUnits::parse(text).map_err(|word| Fault::whole(no_unit(word)))?;
        Ok(())
    },
    write: |scene, _| {
        let names: Vec<&str> = scene.units.given().map(|unit| unit.name).collect();
        (!names.is_empty()).then(|| Value::Text(names.join(", ")))
    },
};

fn no_unit(word: &str) -> String {
    format!(
        "has {}, which is no unit of a force, a length, a work or a force over a width that results are written in",
        quoted(word)
    )
}

/// The units of the command line, `mN,mm`.
///
/// Fails where a word is none of them.
pub fn units(text: &str) -> Result<PreferredUnits, ValueError> {
    let names = |units: &[Unit]| units.iter().map(|unit| unit.name).collect::<Vec<_>>().join(", ");
    PreferredUnits::parse(text).map_err(|word| {
        ValueError::new(
            no_unit(word),
            format!(
                "Give one unit each of what is not to be chosen by size: of forces {}; of lengths {}; of works {}; of forces over a width {}, {}. For example --units µN,µm,fJ.",
                names(FORCES),
                names(LENGTHS),
                names(WORKS),
                names(FORCES_PER_WIDTH),
                names(PEEL_ADHESIONS)
            ),
        )
    })
}
