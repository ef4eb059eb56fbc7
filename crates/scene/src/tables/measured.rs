//! The quantities at whose values a path is asked for, as a scene and the command line write them, and which of them a scene has.

use crate::error::ValueError;
use crate::scene::rate::NS_PER_S;
use crate::scene::{Described, Scene};
use crate::value::quantity::{Dimension, parse_quantity};
use crate::value::quoted;
use peelkit::model::Range;
use peelkit::study::{EventQuantity, Passing, StationQuantity};

/// What a value may be, in the unit of the library.
pub(super) const ANY: Range = Range::From(-Range::LARGEST, Range::LARGEST);

/// What a quantity is measured in; nothing where it is a whole number.
pub(super) fn dimension(quantity: StationQuantity) -> Option<Dimension> {
    match quantity {
        StationQuantity::Displacement | StationQuantity::Front | StationQuantity::FreeEndGap => Some(Dimension::Length),
        StationQuantity::Force => Some(Dimension::Force),
        StationQuantity::EndRotation => Some(Dimension::Angle),
        StationQuantity::Time => Some(Dimension::Time),
        StationQuantity::Attached => None,
    }
}

/// The quantity of a name, of those among which it has to be.
pub(super) fn quantity(name: &str, among: impl Fn(StationQuantity) -> bool) -> Result<StationQuantity, String> {
    let known: Vec<_> = StationQuantity::NAMED.into_iter().filter(|known| among(known.1)).collect();
    known.iter().find(|known| known.0 == name).map(|known| known.1).ok_or_else(|| {
        let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
        format!("{}, which is none of {}", quoted(name), names.join(", "))
    })
}

/// The same, or of its symbol.
pub(super) fn named(text: &str, among: impl Fn(StationQuantity) -> bool) -> Result<StationQuantity, String> {
    match text {
        "u" => Ok(StationQuantity::Displacement),
        "P" => Ok(StationQuantity::Force),
        "t" => Ok(StationQuantity::Time),
        name => quantity(name, among),
    }
}

/// A value of a quantity, in the unit of the library; else what is wrong with it.
pub(super) fn number(of: StationQuantity, text: &str) -> Result<f64, String> {
    let Some(dimension) = dimension(of) else {
        let whole = text.trim().parse::<u32>().map_err(|_| text);
        return whole
            .map(f64::from)
            .map_err(|_| format!("`{}` = {}, which is not a whole number", of.name(), quoted(text)));
    };
    let number = parse_quantity(text, dimension).ok().filter(|&number| ANY.contains(number));
    let scale = if dimension == Dimension::Time { NS_PER_S } else { 1.0 };
    number.map(|number| scale * number).ok_or_else(|| {
        let unit = match dimension {
            Dimension::Angle => "deg",
            Dimension::Time => "us",
            other => other.unit(),
        };
        format!("`{}` = {}, which is not {dimension} with its unit, as \"30 {unit}\"", of.name(), quoted(text))
    })
}

/// A value as a scene writes it.
pub(super) fn text(of: StationQuantity, value: f64) -> String {
    match dimension(of) {
        None => value.to_string(),
        Some(Dimension::Time) => format!("{value} ns"),
        Some(dimension) => format!("{value} {}", dimension.unit()),
    }
}

/// What is wrong with the stations and events of a scene: by the key of the scene.
pub fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let (what, stations, events) = offered(scene);
    let lacks = |quantity: StationQuantity, of: &[StationQuantity], key: &str| {
        let names: Vec<String> = of.iter().map(|one| format!("`{}`", one.name())).collect();
        let remedy = match names.is_empty() {
            true => "Remove it.".to_owned(),
            false => format!("Give values of {}, or remove it.", names.join(", ")),
        };
        let has_none = of.is_empty();
        let found = if has_none { "none at all".into() } else { format!("no `{}`", quantity.name()) };
        (format!("output.{key}"), ValueError::new(format!("is given, and {what} has {found} to look for"), remedy))
    };
    let stray = scene.stations.iter().map(|at| at.quantity).find(|quantity| !stations.contains(quantity));
    if let Some(quantity) = stray {
        return Some(lacks(quantity, &stations, "stations"));
    }
    let named = scene.events.iter().filter_map(|at| at.quantity.named());
    named.into_iter().find(|quantity| !events.contains(quantity)).map(|quantity| lacks(quantity, events, "events"))
}

/// What a scene describes, and the quantities of which it has stations and events.
fn offered(scene: &Scene) -> (&'static str, Vec<StationQuantity>, &'static [StationQuantity]) {
    let (what, events) = match scene.describes() {
        Described::Peel => ("the path of a beam", StationQuantity::OF_BEAM),
        Described::Solid(_) => ("a strip computed as a solid", StationQuantity::OF_SOLID),
        Described::Array(_) => return ("an array of setae", Vec::new(), &[]),
        Described::Seta(_) => ("the pull-off of a seta", StationQuantity::OF_SETA),
        Described::Rate(..) if scene.seta.is_some() => ("a seta pulled at a rate", StationQuantity::OF_SETA_IN_TIME),
        Described::Rate(..) => ("a beam pulled at a rate", StationQuantity::OF_BEAM_IN_TIME),
    };
    (what, events.iter().copied().filter(|of| of.is_continuous()).collect(), events)
}

/// A condition, `front < 50 nm`: what passes which value, and which way.
pub(super) fn condition(text: &str) -> Result<(EventQuantity, Passing, f64), String> {
    let Some(at) = text.find(['=', '<', '>']) else { return Err(format!("{}, which has no =, < or >", quoted(text))) };
    let (name, value) = (text[..at].trim(), &text[at + 1..]);
    let of = named(name, |_| true)?;
    let passing = Passing::NAMED
        .into_iter()
        .find(|(sign, _)| text[at..].starts_with(sign))
        .map_or(Passing::Either, |named| named.1);
    if passing == Passing::Either && !of.is_continuous() {
        return Err(format!("{}, and `{}` goes by whole numbers: write < or >", quoted(text), of.name()));
    }
    Ok((EventQuantity::Named(of), passing, number(of, value)?))
}
