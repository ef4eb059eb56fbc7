//! Which values of a single number have a meaning.

use super::error::ModelErrorKind;
use std::fmt;

/// The numbers that have a meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Above zero, from [`Range::LEAST`] to [`Range::LARGEST`].
    Positive,
    /// Both ends excluded.
    Between(f64, f64),
    /// Both ends included.
    From(f64, f64),
}

/// 180 degrees, as a user may round it.
const HALF_TURN: f64 = 1.0001 * std::f64::consts::PI;

impl Range {
    /// The least number above zero that is taken, in the unit of the library: products of such numbers are doubles that keep all of their digits.
    pub const LEAST: f64 = 1e-30;
    /// The largest one.
    pub const LARGEST: f64 = 1e30;
    /// Of Poisson's ratio of an isotropic material.
    pub const POISSONS_RATIO: Self = Self::Between(-1.0, 0.5);
    /// Of the angle of a spatula's shaft, rad.
    pub const SHAFT_ANGLE: Self = Self::From(-HALF_TURN, HALF_TURN);
    /// Of the length over which a spatula's tip is rounded, nm; 0: blunt.
    pub const ROUNDING_LENGTH: Self = Self::From(0.0, 1e9);
    /// Of where a crest of the substrate is, nm.
    pub const OFFSET: Self = Self::From(-1e9, 1e9);
    /// Of Coulomb's coefficient of friction.
    pub const FRICTION_COEFFICIENT: Self = Self::From(0.0, 1e3);
    /// Of the angle of the pull, rad.
    pub const PULL_ANGLE: Self = Self::From(0.0, HALF_TURN);
    /// Of the direction of the pull along the substrate, rad.
    pub const AZIMUTH: Self = Self::From(-HALF_TURN, HALF_TURN);
    /// Of the angle of a seta's shaft and of its brush to the normal of the ground, rad: up to 89 degrees.
    pub const SETA_ANGLE: Self = Self::From(-1.5533, 1.5533);
    /// Of how the grip turns as it goes, rad/nm.
    pub const PULL_TURN: Self = Self::From(-1e4, 1e4);

    /// Whether the number is in it.
    pub fn contains(self, number: f64) -> bool {
        match self {
            Self::Positive => (Self::LEAST..=Self::LARGEST).contains(&number),
            Self::Between(low, high) => low < number && number < high,
            Self::From(low, high) => low <= number && number <= high,
        }
    }

    /// What is wrong with a number that is not finite or not in it.
    pub fn check(self, found: Measured) -> Result<(), ModelErrorKind> {
        if !found.value.is_finite() {
            return Err(ModelErrorKind::NotFinite { found, range: self });
        }
        if self.contains(found.value) { Ok(()) } else { Err(ModelErrorKind::OutOfRange { found, range: self }) }
    }
}

impl Range {
    /// What a number above zero is beyond, where that is why it is out of range: completes "out of range".
    pub(super) fn exceeded(self, found: f64) -> &'static str {
        match self {
            Self::Positive if found > Self::LARGEST => ": the largest is 1e30",
            Self::Positive if found > 0.0 && found < Self::LEAST => ": the least is 1e-30",
            _ => "",
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Positive => write!(f, "a number above zero"),
            Self::Between(low, high) => write!(f, "a number between {low} and {high}, both excluded"),
            Self::From(low, high) => write!(f, "a number from {low:e} to {high:e}"),
        }
    }
}

/// A number with its unit; the unit is empty where it has none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// In this unit
    pub value: f64,
    /// As in the library: nm, nN, GPa, J/m2, rad
    pub unit: &'static str,
}

impl fmt::Display for Measured {
    /// As a person writes it: "0.4 nm", "1e-19 nm".
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { value, unit } = *self;
        let plain = value == 0.0 || !value.is_finite() || (1e-4..1e7).contains(&value.abs());
        if plain { write!(f, "{value}") } else { write!(f, "{value:e}") }?;
        if unit.is_empty() { Ok(()) } else { write!(f, " {unit}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_as_they_are_written() {
        let shown = |value, unit| Measured { value, unit }.to_string();
        assert_eq!([shown(0.4, "nm"), shown(-0.0, "")], ["0.4 nm", "-0"]);
        assert_eq!([shown(1e7, "nm"), shown(9e-5, ""), shown(-1e-20, "J")], ["1e7 nm", "9e-5", "-1e-20 J"]);
        assert_eq!([shown(f64::NAN, "rad"), shown(f64::NEG_INFINITY, "")], ["NaN rad", "-inf"]);
    }

    #[test]
    fn ends_are_in_or_out() {
        for (range, inside, outside) in [
            (Range::Positive, [1e-30, 1e30], [0.0, -1.0]),
            (Range::Positive, [1e-29, 1e29], [f64::MIN_POSITIVE, 1e300]),
            (Range::Between(-1.0, 0.5), [-0.999, 0.499], [-1.0, 0.5]),
            (Range::From(0.0, 2.0), [0.0, 2.0], [-1e-300, 2.1]),
        ] {
            let unit = "";
            assert!(inside.into_iter().all(|value| range.check(Measured { value, unit }).is_ok()), "{range:?}");
            for value in outside {
                let found = Measured { value, unit };
                assert_eq!(range.check(found), Err(ModelErrorKind::OutOfRange { found, range }));
            }
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let error = range.check(Measured { value, unit }).unwrap_err();
                assert!(matches!(error, ModelErrorKind::NotFinite { .. }), "{value}: {error}");
            }
        }
    }
}
