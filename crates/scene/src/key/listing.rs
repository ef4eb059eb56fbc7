//! A key in a few words, as a list of keys shows it: the title of its axis, and what it may be.

use super::kind::{Key, Kind};
use crate::body::shape_names;
use crate::key::pieces::PIECE;
use crate::value::form::Form;
use crate::value::quantity::Dimension;
use crate::value::{show, steps};
use peelkit::model::Range;

impl Key {
    /// The key as the title of an axis, in [`Key::usual_unit`]: "height of the section h (nm)".
    pub fn axis_title(&self) -> String {
        self.title_in(self.usual_unit())
    }

    /// The same in the unit of the library, [`Key::unit`]: angles are in rad.
    pub fn axis_title_in_library_unit(&self) -> String {
        self.title_in(self.unit())
    }

    fn title_in(&self, unit: &str) -> String {
        let (words, symbol) = if self.title.0.is_empty() { (self.about, "") } else { self.title };
        let symbol = if symbol.is_empty() { String::new() } else { format!(" {symbol}") };
        let unit = match unit {
            "" => String::new(),
            "J/m2" => " (J/m²)".to_owned(),
            unit => format!(" ({unit})"),
        };
        format!("{words}{symbol}{unit}")
    }

    /// How many of [`Key::usual_unit`] one unit of the library is: 180/π for an angle, or else 1.
    pub fn per_usual_unit(&self) -> f64 {
        if self.usual_unit() == self.unit() { 1.0 } else { 1f64.to_degrees() }
    }

    /// The unit that a list shows: of the library, but degrees for an angle; empty where the key takes no unit.
    pub fn usual_unit(&self) -> &'static str {
        self.dimension().map_or("", Dimension::usual_unit)
    }

    /// What the key measures, where it takes a quantity.
    pub fn dimension(&self) -> Option<Dimension> {
        match self.kind {
            Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => Some(dimension),
            _ => None,
        }
    }

    /// What the key may be, in words: "> 0", "from 0 to 180", "free, fixed".
    pub fn range_text(&self) -> String {
        match self.kind {
            Kind::Text(_) => "text".into(),
            Kind::Number(range, _) | Kind::Share(range, _) => numbers(range),
            Kind::Measure(Dimension::Angle, Range::From(low, high), _) => {
                format!("{:.0} to {:.0}", low.to_degrees(), high.to_degrees())
            }
            Kind::Measure(Dimension::AnglePerLength, Range::From(low, high), _) => {
                format!("{:.0e} to {:.0e}", low.to_degrees(), high.to_degrees())
            }
            Kind::Measure(_, range, _) => numbers(range),
            Kind::Quantity(..) | Kind::Bound(..) => numbers(Range::Positive),
            Kind::Count(most, _) | Kind::Fixed(most, _) => format!("1 to {}, whole", show(most as f64)),
            Kind::Flag(_) | Kind::InSpace => "true, false".into(),
            Kind::Tractions(_) => "CSV, file".into(),
            Kind::Table(_) | Kind::Heights(_) => "CSV, or its file".into(),
            Kind::Pieces(_) => "list of tables".into(),
            Kind::Steps(_) => "list of texts".into(),
            Kind::Setting(setting) => setting.brief.into(),
            _ => self.choices().join(", "),
        }
    }

    /// What its value looks like.
    pub fn form(&self) -> Form {
        match self.kind {
            Kind::Text(_) | Kind::Table(_) | Kind::Heights(_) | Kind::Tractions(_) => Form::Text,
            Kind::Number(range, _) | Kind::Share(range, _) => Form::Number(range),
            Kind::Measure(dimension, range, _) => Form::Quantity(dimension, range),
            Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => Form::Quantity(dimension, Range::Positive),
            Kind::Count(most, _) | Kind::Fixed(most, _) => Form::Whole(1.0, most as f64),
            Kind::Flag(_) | Kind::InSpace => Form::Flag,
            Kind::Pieces(_) => Form::list(Form::Table(PIECE)),
            Kind::Steps(_) => Form::list(Form::Step(steps::WORDS)),
            Kind::Setting(setting) => (setting.form)(),
            _ => Form::Word(self.choices()),
        }
    }

    /// The words that the key takes, where it takes one of several.
    pub fn choices(&self) -> Vec<&'static str> {
        match self.kind {
            Kind::Word(choice) => (choice.words)(),
            Kind::Shape(_) => shape_names(),
            _ => Vec::new(),
        }
    }
}

/// A range without words.
fn numbers(range: Range) -> String {
    match range {
        Range::Positive => "> 0".into(),
        Range::Between(low, high) => format!("> {low}, < {high}"),
        Range::From(low, high) => format!("{} to {}", show(low), show(high)),
    }
}
