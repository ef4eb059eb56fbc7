//! A number with its unit, as a user writes it: "100 nm", "2 GPa", "1e-19 J".

use std::fmt;
use std::str::FromStr;
use uom::si::angle::radian;
use uom::si::energy::attojoule;
use uom::si::f64::{Angle, Energy, Force, Length, Pressure, RadiantExposure, SurfaceTension, Time};
use uom::si::force::nanonewton;
use uom::si::length::nanometer;
use uom::si::pressure::gigapascal;
use uom::si::radiant_exposure::joule_per_square_meter;
use uom::si::surface_tension::newton_per_meter;
use uom::si::time::second;

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
}

impl Dimension {
    const ALL: [Self; 9] = [
        Self::Length,
        Self::Pressure,
        Self::Energy,
        Self::Time,
        Self::Stiffness,
        Self::Angle,
        Self::Work,
        Self::Force,
        Self::AnglePerLength,
    ];

    /// The unit inside the library, as it stands in the names of outputs.
    pub const fn unit(self) -> &'static str {
        self.units()[0]
    }

    /// Units to propose to a user, that of the library first.
    pub const fn units(self) -> &'static [&'static str] {
        match self {
            Self::Length => &["nm", "um", "mm", "m", "pm"],
            Self::Pressure => &["GPa", "MPa", "kPa", "Pa"],
            Self::Energy => &["aJ", "zJ", "J", "eV"],
            Self::Time => &["s", "ms", "min", "h"],
            Self::Stiffness => &["N/m", "mN/m", "kN/m"],
            Self::Angle => &["rad", "deg"],
            Self::Work => &["J/m2", "mJ/m2"],
            Self::Force => &["nN", "uN", "mN", "N", "pN"],
            Self::AnglePerLength => &["rad/nm", "deg/nm", "rad/um", "deg/um"],
        }
    }

    /// How many of the library's units one `unit` is.
    fn factor(self, unit: &str) -> Option<f64> {
        let one = format!("1 {unit}");
        match self {
            Self::Length => Length::from_str(&one).ok().map(|q| q.get::<nanometer>()),
            Self::Pressure => Pressure::from_str(&one).ok().map(|q| q.get::<gigapascal>()),
            Self::Energy => Energy::from_str(&one).ok().map(|q| q.get::<attojoule>()),
            Self::Time => Time::from_str(&one).ok().map(|q| q.get::<second>()),
            // the quantity of this dimension that uom has
            Self::Stiffness => SurfaceTension::from_str(&one).ok().map(|q| q.get::<newton_per_meter>()),
            Self::Angle if unit == "deg" => Some(1f64.to_radians()),
            Self::Force => Force::from_str(&one).ok().map(|q| q.get::<nanonewton>()),
            // the quantity of this dimension that uom has
            Self::Work => {
                let one = one.replace("m^2", "m²").replace("m2", "m²");
                RadiantExposure::from_str(&one).ok().map(|q| q.get::<joule_per_square_meter>())
            }
            Self::Angle => Angle::from_str(&one).ok().map(|q| q.get::<radian>()),
            Self::AnglePerLength => {
                let (angle, length) = unit.split_once('/')?;
                let length = Self::Length.factor(&length.replace(['u', 'μ'], "µ"))?;
                Some(scale(Self::Angle.factor(angle)?, length.recip()))
            }
        }
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
        })
    }
}

/// Why a text is not the quantity that is needed.
#[derive(Clone, Debug, PartialEq)]
pub enum QuantityError {
    /// It does not begin with a number.
    NoNumber,
    /// The number stands alone.
    NoUnit,
    /// Nobody knows the unit; perhaps another one was meant.
    UnknownUnit {
        /// As it was written.
        unit: String,
        /// A unit of the right dimension that looks like it.
        near: Option<&'static str>,
    },
    /// The unit measures something else.
    WrongDimension {
        /// As it was written.
        unit: String,
        /// "a pressure"
        measures: String,
    },
}

/// Reads `text` as a quantity, in the library's unit of `dimension`.
///
/// Fails where it does not begin with a number, or its unit is missing, unknown or of something else. Its range is not looked at.
pub fn parse_quantity(text: &str, dimension: Dimension) -> Result<f64, QuantityError> {
    let (value, unit) = split(text.trim()).ok_or(QuantityError::NoNumber)?;
    if unit.is_empty() {
        return Err(QuantityError::NoUnit);
    }
    // uom writes micro as U+00B5; people also write it as the letter u or as the Greek letter.
    let micro = unit.strip_prefix(['u', 'μ']).map(|rest| format!("µ{rest}"));
    let spellings = [Some(unit.to_owned()), micro];
    let factor = |d: Dimension| spellings.iter().flatten().find_map(|unit| d.factor(unit));
    if let Some(factor) = factor(dimension) {
        return Ok(scale(value, factor));
    }
    let unit = unit.to_owned();
    if let Some(other) = Dimension::ALL.into_iter().find(|&d| factor(d).is_some()) {
        return Err(QuantityError::WrongDimension { unit, measures: other.to_string() });
    }
    let near = crate::near::nearest(&unit, dimension.units().iter().copied());
    Err(QuantityError::UnknownUnit { unit, near })
}

/// The longest beginning of the text that is a number, and the rest.
fn split(text: &str) -> Option<(f64, &str)> {
    // more than any double takes without a power of ten
    const LONGEST_NUMBER: usize = 400;
    let ends = text.char_indices().map(|(at, c)| at + c.len_utf8()).take(LONGEST_NUMBER);
    let ends: Vec<usize> = ends.collect();
    ends.into_iter().rev().find_map(|end| Some((text[..end].parse().ok()?, text[end..].trim_start())))
}

/// `value * factor`, exact where the factor is a power of ten: the decimal point moves, nothing is rounded twice.
fn scale(value: f64, factor: f64) -> f64 {
    let decades = factor.log10().round();
    let moved = || {
        let text = format!("{value:e}");
        let (digits, exponent) = text.split_once('e')?;
        let exponent = exponent.parse::<i32>().ok()? + decades as i32;
        format!("{digits}e{exponent}").parse::<f64>().ok()
    };
    let is_decades = (factor / 10f64.powf(decades) - 1.0).abs() < 1e-12;
    is_decades.then(moved).flatten().unwrap_or(value * factor)
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
            ("60 s", Dimension::Time, 60.0),
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
    }
}
