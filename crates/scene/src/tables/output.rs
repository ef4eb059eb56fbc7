//! The table `output`: the stations at which a path is computed besides, in a scene and on the command line.

use crate::error::ValueError;
use crate::key::kind::Setting;
use crate::value::form::{Entry, Form};
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::{Fault, Value, quoted};
use peelkit::model::Range;
use peelkit::study::{StationAt, StationQuantity};

/// What a value may be, in the unit of the library.
const ANY: Range = Range::From(-Range::LARGEST, Range::LARGEST);
/// Most stations of a path.
const MOST: usize = 1000;

/// `stations`
pub(crate) static STATIONS: Setting = Setting {
    takes: "a table of the quantities `displacement`, `force`, `front` and `end_rotation`, each with a value or a list of values, with their units",
    brief: "a table",
    example: "{ displacement = [\"10 nm\", \"20 nm\"] }",
    form: || Form::Table(ENTRIES),
    read: |scene, value, _| {
        scene.stations = read(value)?;
        Ok(())
    },
    write: |scene, _| (!scene.stations.is_empty()).then(|| written(&scene.stations)),
};

const ENTRIES: &[Entry] = &[
    Entry::optional("displacement", || values(Dimension::Length)),
    Entry::optional("force", || values(Dimension::Force)),
    Entry::optional("front", || values(Dimension::Length)),
    Entry::optional("end_rotation", || values(Dimension::Angle)),
];

/// One value, or a list of these.
fn values(dimension: Dimension) -> Form {
    let one = Form::Quantity(dimension, ANY);
    Form::Either(Box::new(one.clone()), Box::new(Form::list(one)))
}

/// What a quantity is measured in.
fn dimension(quantity: StationQuantity) -> Dimension {
    match quantity {
        StationQuantity::Displacement | StationQuantity::Front => Dimension::Length,
        StationQuantity::Force => Dimension::Force,
        StationQuantity::EndRotation => Dimension::Angle,
    }
}

/// The quantity of a name.
fn quantity(name: &str) -> Result<StationQuantity, String> {
    let mut known = StationQuantity::NAMED.into_iter();
    known.clone().find(|known| known.0 == name).map(|known| known.1).ok_or_else(|| {
        let names: Vec<String> = known.by_ref().map(|(name, _)| format!("`{name}`")).collect();
        format!("{}, which is none of {}", quoted(name), names.join(", "))
    })
}

/// The same, or of its symbol.
fn named(text: &str) -> Result<StationQuantity, String> {
    match text {
        "u" => Ok(StationQuantity::Displacement),
        "P" => Ok(StationQuantity::Force),
        name => quantity(name),
    }
}

/// A value of a quantity, in the unit of the library; else what is wrong with it.
fn number(of: StationQuantity, text: &str) -> Result<f64, String> {
    let dimension = dimension(of);
    let number = parse_quantity(text, dimension).ok().filter(|&number| ANY.contains(number));
    number.ok_or_else(|| {
        format!(
            "`{}` = {}, which is not {dimension} with its unit, as \"30 {}\"",
            of.name(),
            quoted(text),
            dimension.units()[usize::from(dimension == Dimension::Angle)]
        )
    })
}

fn read(value: &Value) -> Result<Vec<StationAt>, Fault> {
    let Value::Table(entries) = value else { return Err(Fault::whole(format!("is {value}, no table"))) };
    let mut stations = Vec::new();
    for (name, value) in entries {
        let of = quantity(name).map_err(|why| Fault::whole(format!("has {why}")))?;
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
        let quantity = named(name.trim())?;
        Ok(StationAt { quantity, value: number(quantity, value)? })
    };
    read().map_err(|found: String| {
        ValueError::new(
            format!("is {found}"),
            "Give for example --at u=\"10 nm\", --at P=\"1 nN\", --at front=\"50 nm\" or --at end_rotation=\"30 deg\".",
        )
    })
}

fn written(stations: &[StationAt]) -> Value {
    let of = |quantity: StationQuantity| {
        let own = stations.iter().filter(|at| at.quantity == quantity);
        let values: Vec<Value> =
            own.map(|at| Value::Text(format!("{} {}", at.value, dimension(quantity).unit()))).collect();
        (!values.is_empty()).then(|| (quantity.name().to_owned(), Value::List(values)))
    };
    Value::Table(StationQuantity::NAMED.into_iter().filter_map(|(_, quantity)| of(quantity)).collect())
}
