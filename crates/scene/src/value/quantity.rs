//! A number with its unit, as a user writes it: "100 nm", "2 GPa", "1e-19 J".

use super::unit;
use super::unit::{Powers, Unit, is_not_metric};
use std::fmt;

/// What a quantity measures; each has one unit inside the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// nm
    Length,
    /// GPa = nN/nm²
    Pressure,
    /// aJ = nN·nm
    Energy,
    /// s
    Time,
    /// N/m = nN/nm
    Stiffness,
    /// rad
    Angle,
    /// J/m² = nN/nm
    Work,
    /// nN
    Force,
    /// rad/nm
    AnglePerLength,
    /// m/s
    Velocity,
    /// kg/m³
    Density,
}

impl Dimension {
    const ALL: [Self; 11] = [
        Self::Length,
        Self::Pressure,
        Self::Energy,
        Self::Time,
        Self::Stiffness,
        Self::Angle,
        Self::Work,
        Self::Force,
        Self::AnglePerLength,
        Self::Velocity,
        Self::Density,
    ];

    /// The unit inside the library, as it stands in the names of outputs.
    pub const fn unit(self) -> &'static str {
        self.units()[0]
    }

    /// Units to propose to a user, that of the library first.
    pub const fn units(self) -> &'static [&'static str] {
        match self {
            Self::Length => &["nm", "um", "mm", "m", "pm"],
            Self::Pressure => &["GPa", "MPa", "kPa", "Pa", "N/m2"],
            Self::Energy => &["aJ", "zJ", "J", "eV"],
            Self::Time => &["s", "ms", "min", "h"],
            Self::Stiffness => &["N/m", "mN/m", "kN/m"],
            Self::Angle => &["rad", "deg"],
            Self::Work => &["J/m2", "mJ/m2", "N/m", "mN/m"],
            Self::Force => &["nN", "uN", "mN", "N", "pN"],
            Self::AnglePerLength => &["rad/nm", "deg/nm", "rad/um", "deg/um"],
            Self::Velocity => &["m/s", "mm/s", "um/s", "nm/s"],
            Self::Density => &["kg/m3", "g/cm3"],
        }
    }

    /// A regular expression of its units, as far as one can tell them from others.
    pub(crate) fn pattern(self) -> String {
        unit::pattern(self.powers())
    }

    /// The unit that a person most likely means who writes none.
    pub(crate) const fn usual_unit(self) -> &'static str {
        match self {
            Self::Angle => "deg",
            Self::AnglePerLength => "deg/nm",
            _ => self.unit(),
        }
    }

    /// The powers of length, force, time and angle.
    const fn powers(self) -> Powers {
        match self {
            Self::Length => [1, 0, 0, 0],
            Self::Pressure => [-2, 1, 0, 0],
            Self::Energy => [1, 1, 0, 0],
            Self::Time => [0, 0, 1, 0],
            Self::Stiffness | Self::Work => [-1, 1, 0, 0],
            Self::Angle => [0, 0, 0, 1],
            Self::Force => [0, 1, 0, 0],
            Self::AnglePerLength => [-1, 0, 0, 1],
            Self::Velocity => [1, 0, -1, 0],
            Self::Density => [-4, 1, 2, 0],
        }
    }

    /// The power of ten of its unit in products of nm, nN, s and rad: of most one.
    const fn decades(self) -> i32 {
        match self {
            Self::Velocity => 9,
            Self::Density => -27,
            _ => 0,
        }
    }

    /// What a unit of these powers measures, in words.
    fn measured_by(powers: Powers) -> String {
        let found: Vec<String> =
            Self::ALL.iter().filter(|known| known.powers() == powers).map(ToString::to_string).collect();
        if found.is_empty() { "something else".into() } else { found.join(" or ") }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Length => "a length",
            Self::Pressure => "a pressure",
            Self::Energy => "an energy",
            Self::Time => "a time",
            Self::Stiffness => "a stiffness",
            Self::Angle => "an angle",
            Self::Work => "a work per area",
            Self::Force => "a force",
            Self::AnglePerLength => "an angle per length",
            Self::Velocity => "a velocity",
            Self::Density => "a density",
        })
    }
}

/// Why a text is not the quantity that is needed.
#[derive(Clone, Debug, PartialEq)]
pub enum QuantityError {
    /// It does not begin with a number.
    NoNumber,
    /// It has a comma.
    Comma(Comma),
    /// The number stands alone.
    NoUnit,
    /// Nobody knows the unit; perhaps another one was meant.
    UnknownUnit {
        /// As it was written.
        unit: String,
        /// A unit of the right dimension that looks like it.
        near: Option<&'static str>,
    },
    /// The unit is an imperial one, or another that is not metric.
    NotMetric {
        /// As it was written.
        unit: String,
    },
    /// The unit measures something else.
    WrongDimension {
        /// As it was written.
        unit: String,
        /// "a pressure"
        measures: String,
    },
}

/// A number that is written with a comma, and what it may mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Comma {
    /// With a decimal point in place of the comma
    pub decimal: String,
    /// Without it, where it may separate thousands
    pub thousands: Option<String>,
}

impl Comma {
    /// The comma in the number that a text begins with, if it is one.
    pub fn find(text: &str) -> Option<Self> {
        let (whole, rest) = text.trim().split_once(',')?;
        let digits = rest.chars().take_while(char::is_ascii_digit).count();
        if whole.parse::<f64>().is_err() || digits == 0 {
            return None;
        }
        let thousands = (digits == 3 && !whole.contains('.')).then(|| format!("{whole}{rest}"));
        Some(Self { decimal: format!("{whole}.{rest}"), thousands })
    }

    /// What would be right: a sentence of its own. `shown` puts a text as the user has to write it.
    pub(crate) fn remedy(&self, shown: impl Fn(&str) -> String) -> String {
        let decimal = shown(&self.decimal);
        match &self.thousands {
            Some(plain) => {
                format!("Write {decimal} if the comma is a decimal one, {} if it separates thousands.", shown(plain))
            }
            None => format!("Write {decimal}, with a decimal point."),
        }
    }
}

/// Reads `text` as a quantity, in the library's unit of `dimension`.
///
/// Fails where it does not begin with a number, or its unit is missing, unknown, not metric or of something else. Its range is not
/// looked at.
pub fn parse_quantity(text: &str, dimension: Dimension) -> Result<f64, QuantityError> {
    if let Some(comma) = Comma::find(text) {
        return Err(QuantityError::Comma(comma));
    }
    let (value, written) = split(text.trim()).ok_or(QuantityError::NoNumber)?;
    if written.is_empty() {
        return Err(QuantityError::NoUnit);
    }
    match Unit::read(written) {
        Some(unit) if unit.powers == dimension.powers() => Ok(unit.moved(-dimension.decades()).inside(value)),
        Some(unit) => Err(QuantityError::WrongDimension {
            unit: written.to_owned(),
            measures: Dimension::measured_by(unit.powers),
        }),
        None if is_not_metric(written) => Err(QuantityError::NotMetric { unit: written.to_owned() }),
        None => {
            let near = crate::error::nearest(written, dimension.units().iter().copied());
            Err(QuantityError::UnknownUnit { unit: written.to_owned(), near })
        }
    }
}

/// The longest beginning of the text that is a number, and the rest.
fn split(text: &str) -> Option<(f64, &str)> {
    // more than any double takes without a power of ten
    const LONGEST_NUMBER: usize = 400;
    let ends = text.char_indices().map(|(at, c)| at + c.len_utf8()).take(LONGEST_NUMBER);
    let ends: Vec<usize> = ends.collect();
    ends.into_iter().rev().find_map(|end| Some((text[..end].parse().ok()?, text[end..].trim_start())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metric_prefixes_move_the_decimal_point_and_round_nothing() {
        for (text, dimension, inside) in [
            ("100 nm", Dimension::Length, 100.0),
            ("0.4nm", Dimension::Length, 0.4),
            ("0.1 um", Dimension::Length, 100.0),
            ("0.1 µm", Dimension::Length, 100.0),
            ("0.1 μm", Dimension::Length, 100.0),
            ("1e-4 mm", Dimension::Length, 100.0),
            ("1e-7 m", Dimension::Length, 100.0),
            ("2 GPa", Dimension::Pressure, 2.0),
            ("2000 MPa", Dimension::Pressure, 2.0),
            ("2e9 Pa", Dimension::Pressure, 2.0),
            ("1e-19 J", Dimension::Energy, 0.1),
            ("1e-19J", Dimension::Energy, 0.1),
            ("0.1 aJ", Dimension::Energy, 0.1),
            ("100 zJ", Dimension::Energy, 0.1),
            ("0.5 N/m", Dimension::Stiffness, 0.5),
            ("20 mN/m", Dimension::Stiffness, 0.02),
            ("0.2 rad/nm", Dimension::AnglePerLength, 0.2),
            ("200 rad/um", Dimension::AnglePerLength, 0.2),
            ("30 mN/m", Dimension::Work, 0.03),
            ("30 mJ/m²", Dimension::Work, 0.03),
            ("0.03 J/m^2", Dimension::Work, 0.03),
            ("30 erg/cm2", Dimension::Work, 0.03),
            ("2e9 N/m2", Dimension::Pressure, 2.0),
            ("2e9 N/m²", Dimension::Pressure, 2.0),
            ("2 nN/nm^2", Dimension::Pressure, 2.0),
            ("2 kN/mm2", Dimension::Pressure, 2.0),
            ("4 Å", Dimension::Length, 0.4),
            ("0.2 uN", Dimension::Force, 200.0),
            ("60 s", Dimension::Time, 60.0),
            ("0.1 mm/s", Dimension::Velocity, 1e-4),
            ("0.001 m/s", Dimension::Velocity, 0.001),
            ("1.3 g/cm3", Dimension::Density, 1300.0),
            ("1300 kg/m³", Dimension::Density, 1300.0),
            ("1300 N s2/m4", Dimension::Density, 1300.0),
            ("1 min", Dimension::Time, 60.0),
        ] {
            assert_eq!(parse_quantity(text, dimension), Ok(inside), "{text}");
        }
        let electronvolt = parse_quantity("1 eV", Dimension::Energy).unwrap();
        assert!((electronvolt / 0.1602176634 - 1.0).abs() < 1e-15, "{electronvolt}");
    }

    #[test]
    fn a_number_may_be_written_in_full() {
        for number in [f64::MIN_POSITIVE, 5e-324, 1.234_567_890_123_456_7e-300, f64::MAX] {
            assert_eq!(parse_quantity(&format!("{number} nm"), Dimension::Length), Ok(number));
        }
    }

    #[test]
    fn says_what_is_wrong() {
        use QuantityError::*;
        let length = |text| parse_quantity(text, Dimension::Length).unwrap_err();
        assert_eq!(length("100"), NoUnit);
        assert_eq!(length("nm"), NoNumber);
        assert_eq!(length(""), NoNumber);
        assert_eq!(length("1 NM"), UnknownUnit { unit: "NM".into(), near: Some("nm") });
        assert_eq!(length("1 furlongs"), UnknownUnit { unit: "furlongs".into(), near: None });
        assert_eq!(length("1 GPa"), WrongDimension { unit: "GPa".into(), measures: "a pressure".into() });
        assert_eq!(length("1 nN"), WrongDimension { unit: "nN".into(), measures: "a force".into() });
        let both = "a stiffness or a work per area".into();
        assert_eq!(length("1 mN/m"), WrongDimension { unit: "mN/m".into(), measures: both });
        assert_eq!(length("1 m2"), WrongDimension { unit: "m2".into(), measures: "something else".into() });
        for unit in ["mil", "mi", "in", "ft", "psi", "lbf"] {
            let error = parse_quantity(&format!("1 {unit}"), Dimension::Length).unwrap_err();
            assert_eq!(error, NotMetric { unit: unit.into() });
        }
        let comma = |decimal: &str, thousands: Option<&str>| {
            Comma(super::Comma { decimal: decimal.into(), thousands: thousands.map(Into::into) })
        };
        assert_eq!(length("0,4 nm"), comma("0.4 nm", None));
        assert_eq!(length("1,000 nm"), comma("1.000 nm", Some("1000 nm")));
        assert_eq!(length("1, nm"), UnknownUnit { unit: ", nm".into(), near: None });
    }
}
