//! What is said about a key: what it takes, an example, and what is wrong with a value.

use super::choice::listed;
use super::kind::{Key, Kind};
use crate::error::{ValueError, nearest, one_line};
use crate::key::pieces;
use crate::value::quantity::{Comma, Dimension, QuantityError};
use crate::value::{Value, quoted, show, steps};
use peelkit::model::Range;

impl Key {
    /// What the key takes, in words.
    pub fn takes(&self) -> String {
        match self.kind {
            Kind::Text(_) => "a text in quotes".into(),
            Kind::Number(range, _) | Kind::Share(range, _) => range.to_string(),
            Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => {
                format!("{dimension} above zero with its unit in quotes ({})", dimension.units().join(", "))
            }
            Kind::Measure(dimension, range, _) => {
                let units = dimension.units().join(", ");
                format!("{dimension} with its unit in quotes ({units}), {}", in_usual_unit(range, dimension))
            }
            Kind::Count(most, _) | Kind::Fixed(most, _) => format!("a whole number from 1 to {}", show(most as f64)),
            Kind::Flag(_) | Kind::InSpace => "true or false".into(),
            Kind::Table(_) => {
                "a CSV in quotes, or the name of a file beside the scene: one row for each position, with the columns s_nm, \
                               width_nm, height_nm and, optionally, angle_deg and roundness"
                    .into()
            }
            Kind::Word(_) | Kind::Shape(_) => listed(&self.choices()),
            Kind::Steps(_) => steps::TAKES.into(),
            Kind::Setting(setting) => setting.takes.into(),
            Kind::Pieces(_) => pieces::TAKES.into(),
            Kind::Tractions(_) => {
                "a CSV in quotes, or the name of a file beside the scene: one row for each opening, from 0 on, with the columns \
                               opening_um and traction_MPa, or of other units"
                    .into()
            }
            Kind::Heights(_) => {
                "a CSV in quotes, or the name of a file beside the scene: one row for each position, with the columns x_nm and \
                               height_nm"
                    .into()
            }
        }
    }

    /// A value that is right, as it stands in a scene.
    pub fn example(&self) -> &'static str {
        match (self.name, &self.kind) {
            (_, Kind::Setting(setting)) => setting.example,
            (_, Kind::Word(choice)) => choice.example,
            ("rows" | "columns", _) => "60",
            ("lamellae", _) => "12",
            ("across", _) => "2",
            ("pulled_at" | "joined_at", _) => "30",
            ("pitch", _) => "\"10 um\"",
            ("lamella_pitch", _) => "\"500 um\"",
            ("diameter", _) => "\"4 um\"",
            ("strength_scatter", _) => "0.2",
            ("seed", Kind::Number(..)) => "1",
            ("thickness", _) => "\"30 um\"",
            ("reach", _) => "\"5 um\"",
            ("last_reach", _) => "\"10 um\"",
            ("dome_radius", _) => "\"2 mm\"",
            ("exit_angle", _) => "\"90 deg\"",
            ("pretension", Kind::Measure(..)) => "\"0 nN\"",
            ("length" | "wavelength", _) => "\"100 nm\"",
            ("radius", _) => "\"200 nm\"",
            ("along", _) => "\"2 nm\"",
            ("force_zero", _) => "\"0 nN\"",
            ("yield_strength" | "tangent_modulus", _) => "\"100 MPa\"",
            ("crack", _) => "\"30 nm\"",
            ("height", _) => "\"10 nm\"",
            ("equilibrium_distance", _) => "\"0.4 nm\"",
            ("poissons_ratio", _) => "0.2",
            ("shear_correction", _) => "0.8333333333333334",
            ("presliding", _) => "\"0.01 nm\"",
            ("coefficient", _) => "0.3",
            ("height_ratio" | "diameter_ratio", _) => "0.6",
            ("tip_pitch", _) => "\"1 um\"",
            ("shaft_length" | "brush_height", _) => "\"30 um\"",
            ("rate", _) => "\"1 mm/s\"",
            ("density", _) => "\"1300 kg/m3\"",
            ("retardation_time" | "relaxation_time" | "held", _) => "\"1 us\"",
            ("stiffness_ratio", _) => "2.0",
            ("tip_tolerance", _) => "1e-4",
            ("tolerance", _) => "2e-6",
            ("relative", _) => "1e-6",
            ("order", _) => "7",
            ("mixing_exponent", _) => "2.0",
            (_, Kind::Text(_)) => "\"Peeling of a strip\"",
            (_, Kind::Number(..)) => "1.0",
            (_, Kind::Measure(Dimension::Angle, ..) | Kind::Quantity(Dimension::Angle, _)) => "\"45 deg\"",
            (_, Kind::Bound(Dimension::Angle, _)) => "\"45 deg\"",
            (_, Kind::Measure(Dimension::AnglePerLength, ..) | Kind::Quantity(Dimension::AnglePerLength, _)) => {
                "\"0.5 deg/nm\""
            }
            (_, Kind::Bound(Dimension::AnglePerLength, _)) => "\"0.5 deg/nm\"",
            (_, Kind::Measure(..)) => "\"0 nm\"",
            (_, Kind::Quantity(Dimension::Length, _)) => "\"1 nm\"",
            (_, Kind::Bound(Dimension::Length, _)) => "\"500 nm\"",
            (_, Kind::Quantity(Dimension::Pressure, _) | Kind::Bound(Dimension::Pressure, _)) => "\"2 GPa\"",
            (_, Kind::Quantity(Dimension::Energy, _) | Kind::Bound(Dimension::Energy, _)) => "\"1e-19 J\"",
            (_, Kind::Quantity(Dimension::Time, _) | Kind::Bound(Dimension::Time, _)) => "\"60 s\"",
            (_, Kind::Quantity(Dimension::Stiffness, _) | Kind::Bound(Dimension::Stiffness, _)) => "\"0.5 N/m\"",
            (_, Kind::Quantity(Dimension::Work, _) | Kind::Bound(Dimension::Work, _)) => "\"0.03 J/m2\"",
            (_, Kind::Quantity(Dimension::Force, _) | Kind::Bound(Dimension::Force, _)) => "\"1 nN\"",
            (_, Kind::Quantity(Dimension::Velocity, _) | Kind::Bound(Dimension::Velocity, _)) => "\"1 mm/s\"",
            (_, Kind::Quantity(Dimension::Density, _) | Kind::Bound(Dimension::Density, _)) => "\"1300 kg/m3\"",
            ("forks", _) => "8",
            ("through", _) => "5",
            (_, Kind::Count(..)) => "20000",
            (_, Kind::Fixed(..)) => "20",
            (_, Kind::Share(..)) => "0.01",
            (_, Kind::Flag(_) | Kind::InSpace) => "true",
            (_, Kind::Table(_)) => "\"s_nm,width_nm,height_nm\\n0,20,5\\n100,20,10\"",
            (_, Kind::Pieces(_)) => "[{ length = \"90 nm\", width = [\"9 nm\", \"5 nm\"], height = \"5 nm\" }]",
            (_, Kind::Steps(_)) => "[\"press 0.1 nm\", \"turn 1 deg\", \"hold\"]",
            (_, Kind::Shape(_)) => "\"flat\"",
            (_, Kind::Tractions(_)) => "\"opening_um,traction_MPa\\n0,0\\n20,0.8\\n150,0\"",
            (_, Kind::Heights(_)) => "\"x_nm,height_nm\\n0,0\\n50,-8\\n100,0\"",
        }
    }

    /// A line of a scene that is right.
    pub(crate) fn example_line(&self) -> String {
        format!("{} = {}", self.name, self.example())
    }

    pub(super) fn remedy(&self) -> String {
        format!("`{}` takes {}; for example {}", self.name, self.takes(), self.example_line())
    }

    /// The number of one of these words.
    pub(super) fn pick(&self, words: &[&'static str], found: &str) -> Result<usize, ValueError> {
        if let Some(number) = words.iter().position(|word| *word == found) {
            return Ok(number);
        }
        let near = nearest(found, words.iter().copied());
        let guess = near.map(|word| format!("Did you mean \"{word}\"? ")).unwrap_or_default();
        Err(ValueError::new(
            format!("is {}, which is none of its values", quoted(found)),
            format!("{guess}{}", self.remedy()),
        ))
    }

    pub(super) fn no_quantity(&self, text: &str, dimension: Dimension, error: QuantityError) -> ValueError {
        match error {
            QuantityError::NoNumber if text.trim_start().starts_with(['[', '{']) => {
                let kind = if text.trim_start().starts_with('[') { "a list" } else { "a table" };
                ValueError::new(format!("is {kind}: {}", one_line(text.trim())), self.remedy())
            }
            QuantityError::NoNumber => {
                ValueError::new(format!("is {}, which does not begin with a number", quoted(text)), self.remedy())
            }
            QuantityError::Comma(comma) => self.with_comma(text, &comma),
            QuantityError::NotMetric { unit } => {
                ValueError::new(format!("is {}: {} is no metric unit", quoted(text), one_line(&unit)), self.remedy())
            }
            QuantityError::NoUnit => self.no_unit(&quoted(text), &one_line(text.trim()), dimension),
            QuantityError::UnknownUnit { unit, near } => {
                let guess = near.map(|near| format!("Did you mean \"{near}\"? ")).unwrap_or_default();
                ValueError::new(
                    format!("is {}, whose unit {} is not known", quoted(text), quoted(&unit)),
                    format!("{guess}{}", self.remedy()),
                )
            }
            QuantityError::WrongDimension { unit, measures } => ValueError::new(
                format!("is {}: {unit} measures {measures}, not {dimension}", quoted(text)),
                self.remedy(),
            ),
        }
    }

    fn no_unit(&self, found: &str, number: &str, dimension: Dimension) -> ValueError {
        let unit = dimension.usual_unit();
        let remedy = format!("Write \"{number} {unit}\" if {unit} is meant. {}", self.remedy());
        ValueError::new(format!("is {found}, a number without a unit"), remedy)
    }

    /// That a number has a comma.
    pub(super) fn with_comma(&self, text: &str, comma: &Comma) -> ValueError {
        let remedy = comma.remedy(|text| match self.is_text() {
            true => quoted(text.trim()),
            false => one_line(text.trim()),
        });
        ValueError::new(format!("is {}, a number with a comma", quoted(text)), remedy)
    }

    pub(super) fn wrong_type(&self, value: &Value) -> ValueError {
        match (&self.kind, value) {
            (
                Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _),
                Value::Number(number),
            ) => self.no_unit(&show(*number), &show(*number), *dimension),
            (Kind::Number(..) | Kind::Share(..) | Kind::Count(..) | Kind::Fixed(..), Value::Text(text))
                if let Some(comma) = Comma::find(text) =>
            {
                self.with_comma(text, &comma)
            }
            (Kind::Number(..) | Kind::Share(..) | Kind::Count(..) | Kind::Fixed(..), Value::Text(text))
                if text.trim().parse::<f64>().is_ok() =>
            {
                ValueError::new(
                    format!("is {}, a number in quotes", quoted(text)),
                    format!("Remove the quotes: {} = {}", self.name, one_line(text.trim())),
                )
            }
            (Kind::Flag(_) | Kind::InSpace, Value::Text(text)) if matches!(text.trim(), "true" | "false") => {
                ValueError::new(
                    format!("is {} in quotes", quoted(text)),
                    format!("Remove the quotes: {} = {}", self.name, text.trim()),
                )
            }
            _ => ValueError::new(format!("is {value}"), self.remedy()),
        }
    }
}

/// A range as a person writes it: of angles in degrees.
fn in_usual_unit(range: Range, dimension: Dimension) -> String {
    match (range, dimension) {
        // the ends are half turns, as a user may round them
        (Range::From(low, high), Dimension::Angle) => {
            format!("from {:.0} to {:.0} deg", low.to_degrees(), high.to_degrees())
        }
        (Range::From(low, high), _) => format!("from {low:e} to {high:e} {}", dimension.unit()),
        _ => format!("{range} in {}", dimension.unit()),
    }
}
