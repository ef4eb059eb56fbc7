//! Units as a mechanics person writes them: "nm", "mN/m", "J/m²", "N/m^2", "kN mm^-2".
//!
//! A unit may be over a number of others, as peel adhesion is written: "N/25mm". A unit is a product of SI units with prefixes and powers, and of a few that stand beside them (Å, eV, min, h, deg, dyn, erg).
//! It is read as powers of the units inside the library, a power of ten and a factor, so that a prefix moves the decimal point and
//! rounds nothing.

/// What a unit measures: the powers of length, force, time and angle.
pub(super) type Powers = [i32; 4];

/// A unit in those of the library: nm, nN, s, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    pub(super) powers: Powers,
    /// The power of ten
    decades: i32,
    /// What is left of it
    factor: f64,
}

/// Whether a unit takes a prefix.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Prefixed {
    Yes,
    No,
}

/// The units: name, powers, power of ten, factor.
#[rustfmt::skip]
const UNITS: &[(&str, Prefixed, Unit)] = &[
    ("m", Prefixed::Yes, unit([1, 0, 0, 0], 9, 1.0)),
    ("Å", Prefixed::No, unit([1, 0, 0, 0], -1, 1.0)),
    ("\u{212b}", Prefixed::No, unit([1, 0, 0, 0], -1, 1.0)),
    ("angstrom", Prefixed::No, unit([1, 0, 0, 0], -1, 1.0)),
    ("N", Prefixed::Yes, unit([0, 1, 0, 0], 9, 1.0)),
    ("dyn", Prefixed::No, unit([0, 1, 0, 0], 4, 1.0)),
    ("Pa", Prefixed::Yes, unit([-2, 1, 0, 0], -9, 1.0)),
    ("bar", Prefixed::Yes, unit([-2, 1, 0, 0], -4, 1.0)),
    ("J", Prefixed::Yes, unit([1, 1, 0, 0], 18, 1.0)),
    ("eV", Prefixed::Yes, unit([1, 1, 0, 0], -1, 1.602_176_634)),
    ("erg", Prefixed::No, unit([1, 1, 0, 0], 11, 1.0)),
    ("s", Prefixed::Yes, unit([0, 0, 1, 0], 0, 1.0)),
    ("g", Prefixed::Yes, unit([-1, 1, 2, 0], -3, 1.0)),
    ("min", Prefixed::No, unit([0, 0, 1, 0], 0, 60.0)),
    ("h", Prefixed::No, unit([0, 0, 1, 0], 0, 3600.0)),
    ("rad", Prefixed::Yes, unit([0, 0, 0, 1], 0, 1.0)),
    ("deg", Prefixed::No, unit([0, 0, 0, 1], 0, std::f64::consts::PI / 180.0)),
    ("°", Prefixed::No, unit([0, 0, 0, 1], 0, std::f64::consts::PI / 180.0)),
];

/// Prefixes; micro is written as the letter u, as U+00B5 or as the Greek letter.
const PREFIXES: &[(char, i32)] = &[
    ('y', -24),
    ('z', -21),
    ('a', -18),
    ('f', -15),
    ('p', -12),
    ('n', -9),
    ('u', -6),
    ('µ', -6),
    ('μ', -6),
    ('m', -3),
    ('c', -2),
    ('d', -1),
    ('h', 2),
    ('k', 3),
    ('M', 6),
    ('G', 9),
    ('T', 12),
];

/// Units that are not metric and that people write all the same.
const NOT_METRIC: &[&str] = &[
    "in", "inch", "inches", "\"", "ft", "foot", "feet", "'", "yd", "yard", "mi", "mile", "miles", "mil", "mils",
    "thou", "lb", "lbs", "lbf", "oz", "ozf", "kip", "kips", "psi", "ksi", "psf", "btu", "cal", "kcal", "kgf", "gf",
    "atm", "torr", "mmhg",
];

const fn unit(powers: Powers, decades: i32, factor: f64) -> Unit {
    Unit { powers, decades, factor }
}

impl Unit {
    /// Reads a unit; nothing where a part of it is not known.
    pub(super) fn read(text: &str) -> Option<Self> {
        const LONGEST: usize = 64;
        if text.len() > LONGEST {
            return None;
        }
        let mut product = unit([0; 4], 0, 1.0);
        for (index, part) in text.split('/').enumerate() {
            let sign = if index == 0 { 1 } else { -1 };
            let factors = part.split([' ', '·', '⋅', '*']).map(str::trim).filter(|factor| !factor.is_empty());
            // "N/m mm" could be read in two ways
            let mut count = 0;
            for factor in factors {
                // "N/25mm", "N/25 mm"
                let (number, factor) = if index > 0 { leading_number(factor) } else { (None, factor) };
                if let Some(number) = number {
                    product.factor /= number.parse::<f64>().ok().filter(|number| count == 0 && *number > 0.0)?;
                }
                if !factor.is_empty() {
                    product = product.times(power(factor)?, sign);
                    count += 1;
                }
            }
            if count == 0 || (index > 0 && count > 1) {
                return None;
            }
        }
        Some(product)
    }

    /// The product with another unit to this power.
    fn times(self, (other, power): (Self, i32), sign: i32) -> Self {
        let power = sign * power;
        let powers = std::array::from_fn(|i| self.powers[i] + power * other.powers[i]);
        let (decades, factor) = (self.decades + power * other.decades, self.factor * other.factor.powi(power));
        unit(powers, decades, factor)
    }

    /// The unit that is so many powers of ten as large.
    pub(super) fn moved(self, decades: i32) -> Self {
        Self { decades: self.decades + decades, ..self }
    }

    /// `value` of this unit in those of the library: the decimal point moves, nothing is rounded twice.
    pub(super) fn inside(self, value: f64) -> f64 {
        let moved = || {
            let text = format!("{value:e}");
            let (digits, exponent) = text.split_once('e')?;
            let exponent = exponent.parse::<i32>().ok()? + self.decades;
            format!("{digits}e{exponent}").parse::<f64>().ok()
        };
        moved().unwrap_or(value * 10f64.powi(self.decades)) * self.factor
    }
}

/// The digits at the beginning of a factor, if there are any, and what is behind them.
fn leading_number(factor: &str) -> (Option<&str>, &str) {
    let (number, rest) = factor.split_at(factor.len() - factor.trim_start_matches(|c: char| c.is_ascii_digit()).len());
    (Some(number).filter(|number| !number.is_empty()), rest)
}

/// A regular expression of units of these powers: those with a name of their own, and every product, whose powers no expression counts.
pub(super) fn pattern(powers: Powers) -> String {
    let of = |chosen: &dyn Fn(&Unit) -> bool| {
        let named = |prefixed: Prefixed| -> Vec<&str> {
            UNITS.iter().filter(|(_, takes, unit)| *takes == prefixed && chosen(unit)).map(|(name, ..)| *name).collect()
        };
        let prefixes: String = PREFIXES.iter().map(|(prefix, _)| prefix).collect();
        let with = named(Prefixed::Yes);
        let with = (!with.is_empty()).then(|| format!("[{prefixes}]?(?:{})", with.join("|")));
        with.into_iter().chain(named(Prefixed::No).into_iter().map(str::to_owned)).collect::<Vec<_>>().join("|")
    };
    let factor = format!("(?:{})(?:\\^?[-⁻]?[0-9⁰¹²³⁴-⁹]+)?", of(&|_| true));
    let product = format!("{factor}(?:[ ·⋅*/]+(?:[0-9]+ ?)?{factor})+");
    let named = of(&|unit| unit.powers == powers);
    if named.is_empty() { format!("(?:{product})") } else { format!("(?:{named}|{product})") }
}

/// Whether a part of this unit is one that is not metric.
pub(super) fn is_not_metric(text: &str) -> bool {
    let mut parts = text.split(['/', ' ', '·', '*']).map(str::trim);
    let word = |part: &str| {
        let part = part.trim_end_matches(|c: char| c.is_ascii_digit() || "^²³".contains(c));
        NOT_METRIC.contains(&part.to_lowercase().as_str()) && atom(part).is_none()
    };
    parts.any(word)
}

/// A unit with its power: "m2", "m^2", "m²", "m^-1".
fn power(text: &str) -> Option<(Unit, i32)> {
    const RAISED: [(char, char); 11] = [
        ('⁻', '-'),
        ('⁰', '0'),
        ('¹', '1'),
        ('²', '2'),
        ('³', '3'),
        ('⁴', '4'),
        ('⁵', '5'),
        ('⁶', '6'),
        ('⁷', '7'),
        ('⁸', '8'),
        ('⁹', '9'),
    ];
    let lowered = |c: char| RAISED.iter().find(|(raised, _)| *raised == c).map_or(c, |(_, plain)| *plain);
    let plain: String = text.chars().map(lowered).collect();
    let is_power = |c: char| c.is_ascii_digit() || c == '-' || c == '^';
    let name = plain.trim_end_matches(is_power);
    let power = &plain[name.len()..];
    let power = match power.strip_prefix('^').unwrap_or(power) {
        "" if power.is_empty() => 1,
        digits => digits.parse().ok().filter(|power: &i32| (1..=9).contains(&power.abs()))?,
    };
    Some((atom(name)?, power))
}

/// One unit, with a prefix or without.
fn atom(name: &str) -> Option<Unit> {
    let find = |name: &str| UNITS.iter().find(|(known, ..)| *known == name);
    if let Some((.., unit)) = find(name) {
        return Some(*unit);
    }
    let prefix = name.chars().next()?;
    let (_, decades) = PREFIXES.iter().find(|(known, _)| *known == prefix)?;
    let (.., found) = find(&name[prefix.len_utf8()..]).filter(|(_, prefixed, _)| *prefixed == Prefixed::Yes)?;
    Some(unit(found.powers, found.decades + decades, found.factor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_powers_are_read_in_every_spelling() {
        let pressure = Unit::read("Pa").unwrap();
        for text in ["N/m2", "N/m^2", "N/m²", "N m^-2", "N·m⁻²", "N/m/m", "J/m3"] {
            assert_eq!(Unit::read(text), Some(pressure), "{text}");
        }
        assert_eq!(Unit::read("nN/nm²").unwrap().inside(2.0), 2.0);
        assert_eq!(Unit::read("mJ/m2"), Unit::read("mN/m"));
        assert_eq!(Unit::read("N m"), Unit::read("J"));
        for text in ["N/25mm", "N/25 mm"] {
            assert!((Unit::read(text).unwrap().inside(1.0) / 40.0 - 1.0).abs() < 1e-15, "{text}");
        }
    }

    #[test]
    fn what_is_no_unit_is_refused() {
        for text in [
            "", "/", "N/", "/m", "N//m", "m^", "m^0", "m2x", "nn", "kmin", "NM", "N/m mm", "furlong", "m^-", "m99",
            "N/25", "N/0mm", "25N/m", "N/mm25",
        ] {
            assert_eq!(Unit::read(text), None, "{text}");
        }
    }

    #[test]
    fn units_that_are_not_metric_are_known_as_such() {
        for text in ["mil", "mi", "in", "psi", "lbf", "lbf/in", "lb/ft2", "PSI"] {
            assert!(is_not_metric(text) && Unit::read(text).is_none(), "{text}");
        }
        for text in ["min", "m", "N/m", "furlong"] {
            assert!(!is_not_metric(text), "{text}");
        }
    }
}
