//! The metric prefixes with which forces, lengths, works and bending stiffnesses are written for a person. Inside, and in files, they are in
//! nN, nm, aJ and nN nm².

/// A unit of a force, a length, a work or a bending stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// As it is written: "µN"
    pub name: &'static str,
    /// How many nN, nm, aJ or nN nm² it is
    pub size: f64,
}

const fn unit(name: &'static str, size: f64) -> Unit {
    Unit { name, size }
}

/// Units of forces, from small to large.
pub const FORCES: &[Unit] = &[unit("pN", 1e-3), unit("nN", 1.0), unit("µN", 1e3), unit("mN", 1e6), unit("N", 1e9)];
/// Units of lengths, from small to large.
pub const LENGTHS: &[Unit] = &[unit("pm", 1e-3), unit("nm", 1.0), unit("µm", 1e3), unit("mm", 1e6), unit("m", 1e9)];
/// In nN/nm²
pub const PRESSURES: &[Unit] = &[unit("Pa", 1e-9), unit("kPa", 1e-6), unit("MPa", 1e-3), unit("GPa", 1.0)];
/// Units of works, from small to large.
pub const WORKS: &[Unit] = &[
    unit("zJ", 1e-3),
    unit("aJ", 1.0),
    unit("fJ", 1e3),
    unit("pJ", 1e6),
    unit("nJ", 1e9),
    unit("µJ", 1e12),
    unit("mJ", 1e15),
    unit("J", 1e18),
];
/// Units of bending stiffnesses, from small to large.
pub const BENDING_STIFFNESSES: &[Unit] = &[
    unit("nN nm²", 1.0),
    unit("nN µm²", 1e6),
    unit("µN µm²", 1e9),
    unit("nN mm²", 1e12),
    unit("µN mm²", 1e15),
    unit("mN mm²", 1e18),
    unit("N mm²", 1e21),
    unit("N m²", 1e27),
];

/// Numbers from here to [`TOO_LARGE`] keep the unit of the files.
const TOO_SMALL: f64 = 1e-2;
const TOO_LARGE: f64 = 1e4;

impl Unit {
    /// Of these units, from small to large, that of the files where the largest number has an ordinary size; else the largest in which that is at
    /// least one.
    pub fn fitting(units: &[Self], largest: f64) -> Self {
        let ordinary = !largest.is_finite() || largest == 0.0 || (TOO_SMALL..TOO_LARGE).contains(&largest);
        let fits = |unit: &&Self| if ordinary { unit.size == 1.0 } else { unit.size <= largest };
        units.iter().rev().find(fits).copied().unwrap_or(units[0])
    }

    /// A number in nN, nm, aJ or nN nm² in this unit.
    pub fn of(&self, value: f64) -> f64 {
        value / self.size
    }
}

/// A length (nm) in the unit that fits it: "4 mm".
pub fn length_text(length: f64) -> String {
    let unit = Unit::fitting(LENGTHS, length.abs());
    // a division by a power of ten may leave a last digit: 15 are enough
    let value = format!("{:.14e}", unit.of(length)).parse().unwrap_or(length);
    format!("{value} {}", unit.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_has_the_prefix_that_fits() {
        for (length, text) in
            [(4e6, "4 mm"), (500.0, "500 nm"), (12345.6, "12.3456 µm"), (2e-3, "2 pm"), (0.0, "0 nm"), (3e12, "3000 m")]
        {
            assert_eq!(length_text(length), text);
        }
    }

    #[test]
    fn numbers_of_an_ordinary_size_keep_the_unit_of_the_files() {
        let name = |units, largest| Unit::fitting(units, largest).name;
        assert_eq!([name(FORCES, 0.02), name(LENGTHS, 9999.0), name(WORKS, 0.0)], ["nN", "nm", "aJ"]);
        assert_eq!([name(FORCES, 2e-3), name(LENGTHS, 2e4), name(WORKS, 1211222188.6)], ["pN", "µm", "nJ"]);
        assert_eq!(
            [166.7, 4.17e20, 2e27].map(|largest| name(BENDING_STIFFNESSES, largest)),
            ["nN nm²", "mN mm²", "N m²"]
        );
        assert_eq!([name(FORCES, 1e-9), name(LENGTHS, 1e30), name(WORKS, f64::NAN)], ["pN", "m", "aJ"]);
    }
}
