//! The pieces of a profile as a scene writes them.

use crate::error::{nearest, one_line};
use crate::value::form::{Entry, Form};
use crate::value::quantity::Dimension;
use crate::value::steps::quantity;
use crate::value::{Fault, Value};
use peelkit::model::{Piece, ProfilePieces, Range, Transition, angle_text};

/// What a list of pieces takes.
pub(crate) const TAKES: &str = "a list of pieces from the free end on, each with length, width and height and, optionally, roundness (0: rectangle, 1: \
                                ellipse), bend (rotation of the underside along the piece), course and height_course (\"linear\" or \"smooth\"); width, height and \
                                roundness are one value, or two: at the beginning and at the end";

/// The keys of a piece.
pub(crate) const PIECE: &[Entry] = &[
    Entry::needed("length", || POSITIVE),
    Entry::needed("width", || Form::AtBothEnds(Box::new(POSITIVE))),
    Entry::needed("height", || Form::AtBothEnds(Box::new(POSITIVE))),
    Entry::optional("roundness", || Form::AtBothEnds(Box::new(Form::Number(Range::From(0.0, 1.0))))),
    Entry::optional("bend", || Form::Quantity(Dimension::Angle, Range::SHAFT_ANGLE)),
    Entry::optional("course", || Form::word(&COURSES)),
    Entry::optional("height_course", || Form::word(&COURSES)),
];
const POSITIVE: Form = Form::Quantity(Dimension::Length, Range::Positive);
const COURSES: [(&str, Transition); 2] = [("linear", Transition::Linear), ("smooth", Transition::Smooth)];

/// Reads the pieces of a list.
pub(crate) fn read(items: &[Value]) -> Result<ProfilePieces, Fault> {
    let piece = |(item, value): (usize, &Value)| {
        let number = item + 1;
        let read = match value {
            Value::Table(entries) => one(entries).map_err(|found| format!("has in piece {number} {found}")),
            value => Err(format!("has as piece {number} {value}, no table of its keys")),
        };
        read.map_err(|found| Fault { item: Some(item), found })
    };
    let pieces = items.iter().enumerate().map(piece).collect::<Result<_, _>>()?;
    ProfilePieces::new(pieces)
        .map_err(|error| Fault { item: error.piece().map(|piece| piece - 1), found: error.to_string() })
}

/// Reads one from its keys.
fn one(entries: &[(String, Value)]) -> Result<Piece, String> {
    let names: Vec<&str> = PIECE.iter().map(|entry| entry.name).collect();
    if let Some((name, _)) = entries.iter().find(|(name, _)| !names.contains(&name.as_str())) {
        let near = nearest(name, names.iter().copied());
        let guess = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        return Err(format!("the key `{}`, which is none of {}{guess}", one_line(name), names.join(", ")));
    }
    let given = |name: &str| entries.iter().find(|(given, _)| given == name).map(|(_, value)| value);
    if let Some(entry) = PIECE.iter().find(|entry| entry.needed && given(entry.name).is_none()) {
        return Err(format!("no `{}`", entry.name));
    }
    // what a key holds, or its default
    fn of<T>(
        name: &str,
        value: Option<&Value>,
        default: T,
        read: impl Fn(&Value) -> Result<T, String>,
    ) -> Result<T, String> {
        value.map_or(Ok(default), |value| read(value).map_err(|why| format!("`{name}` = {value}, {why}")))
    }
    let length = |name: &str| of(name, given(name), f64::NAN, |value| measure(value, Dimension::Length));
    let lengths = |name: &str| {
        of(name, given(name), [f64::NAN; 2], |value| ends(value, |value| measure(value, Dimension::Length)))
    };
    let plain = Piece::straight(length("length")?, f64::NAN, f64::NAN);
    Ok(Piece {
        width: lengths("width")?,
        height: lengths("height")?,
        roundness: of("roundness", given("roundness"), plain.roundness, |value| ends(value, number))?,
        bend: of("bend", given("bend"), plain.bend, |value| measure(value, Dimension::Angle))?,
        course: of("course", given("course"), plain.course, course)?,
        height_course: of("height_course", given("height_course"), plain.height_course, course)?,
        ..plain
    })
}

/// One value all along, or those at the beginning and at the end.
fn ends(value: &Value, one: impl Fn(&Value) -> Result<f64, String>) -> Result<[f64; 2], String> {
    match value {
        Value::List(values) => match &values[..] {
            [begins, ends] => Ok([one(begins)?, one(ends)?]),
            values => {
                Err(format!("which has {} values: it takes one, or two, at the beginning and at the end", values.len()))
            }
        },
        value => one(value).map(|value| [value; 2]),
    }
}

fn measure(value: &Value, dimension: Dimension) -> Result<f64, String> {
    match value {
        Value::Text(text) => quantity(text, dimension, "which does not begin with a number"),
        Value::Number(number) => {
            Err(format!("a number without a unit: write \"{number} {}\" if that is meant", dimension.unit()))
        }
        _ => Err(format!("which is not {dimension} with its unit in quotes")),
    }
}

fn number(value: &Value) -> Result<f64, String> {
    if let Value::Number(number) = value { Ok(*number) } else { Err("which is not a number".into()) }
}

fn course(value: &Value) -> Result<Transition, String> {
    let found = COURSES.iter().find(|(word, _)| matches!(value, Value::Text(text) if text == word));
    found.map(|&(_, course)| course).ok_or_else(|| "which is neither \"linear\" nor \"smooth\"".into())
}

/// Pieces as a scene writes them.
pub(crate) fn written(pieces: &ProfilePieces) -> Value {
    let nanometres = |length: f64| Value::Text(format!("{length} nm"));
    let both = |[begins, ends]: [f64; 2], value: fn(f64) -> Value| {
        if begins == ends { value(begins) } else { Value::List(vec![value(begins), value(ends)]) }
    };
    let word = |course: Transition| {
        let word = COURSES.iter().find(|(_, known)| *known == course).map_or("", |(word, _)| word);
        Value::Text(word.to_owned())
    };
    let piece = |piece: &Piece| {
        let values = [
            nanometres(piece.length),
            both(piece.width, nanometres),
            both(piece.height, nanometres),
            both(piece.roundness, Value::Number),
            Value::Text(angle_text(piece.bend)),
            word(piece.course),
            word(piece.height_course),
        ];
        Value::Table(PIECE.iter().map(|entry| entry.name.to_owned()).zip(values).collect())
    };
    Value::List(pieces.pieces().iter().map(piece).collect())
}
