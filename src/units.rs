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
/// Units of forces over a width, from small to large.
pub const FORCES_PER_WIDTH: &[Unit] = &[unit("mN/m", 1e-3), unit("N/m", 1.0), unit("kN/m", 1e3)];
/// Those in which peel adhesion is reported: no number is written in one because it fits.
pub const PEEL_ADHESIONS: &[Unit] = &[
    unit("gf/25mm", 0.392_266),
    unit("gf/cm", 0.980_665),
    unit("mN/mm", 1.0),
    unit("N/25mm", 40.0),
    unit("N/cm", 100.0),
    unit("N/mm", 1e3),
];
/// Units of works over a width, from small to large.
pub const WORKS_PER_WIDTH: &[Unit] = &[unit("nJ/m", 1.0), unit("µJ/m", 1e3), unit("mJ/m", 1e6), unit("J/m", 1e9)];
/// Units of moments, from small to large.
pub const MOMENTS: &[Unit] = &[
    unit("nN nm", 1.0),
    unit("nN µm", 1e3),
    unit("µN µm", 1e6),
    unit("mN µm", 1e9),
    unit("mN mm", 1e12),
    unit("N mm", 1e15),
    unit("N m", 1e18),
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

/// The units in which a person wants forces, lengths, works and forces over a width. Of what has none the one that fits is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreferredUnits {
    /// Of forces
    pub force: Option<Unit>,
    /// Of displacements and lengths
    pub length: Option<Unit>,
    /// Of works and energies
    pub work: Option<Unit>,
    /// Of forces over the width of a strip
    pub force_per_width: Option<Unit>,
}

impl PreferredUnits {
    /// Those of a text such as "mN, mm, nJ", where u stands for µ as well, and "auto" for nothing.
    ///
    /// # Errors
    /// The first word that is no unit of a force, a length, a work or a force over a width.
    pub fn parse(text: &str) -> Result<Self, &str> {
        let mut units = Self::default();
        for word in text.split(',').map(str::trim).filter(|&word| word != "auto") {
            let name = word.replace('μ', "µ");
            let find = |known: &[Unit]| known.iter().copied().find(|unit| [unit.name, &unit.ascii()].contains(&&*name));
            let per_width = || find(FORCES_PER_WIDTH).or_else(|| find(PEEL_ADHESIONS));
            match (find(FORCES), find(LENGTHS), find(WORKS)) {
                (Some(force), ..) => units.force = Some(force),
                (_, Some(length), _) => units.length = Some(length),
                (.., Some(work)) => units.work = Some(work),
                _ => units.force_per_width = Some(per_width().ok_or(word)?),
            }
        }
        Ok(units)
    }

    /// Each one that is given, forces first.
    pub fn given(&self) -> impl Iterator<Item = Unit> {
        [self.force, self.length, self.work, self.force_per_width].into_iter().flatten()
    }

    /// The one that is given of what has these units, if one is.
    pub fn of(&self, units: &[Unit]) -> Option<Unit> {
        match units {
            FORCES => self.force,
            LENGTHS => self.length,
            WORKS => self.work,
            FORCES_PER_WIDTH => self.force_per_width,
            _ => None,
        }
    }

    /// The same for a strip of this width (nm): its forces are written over the width where a unit of that is given and none of forces.
    pub fn across(self, width: f64) -> Self {
        let of_width = |unit: Unit| Unit { size: unit.size * width, ..unit };
        Self { force: self.force.or(self.force_per_width.map(of_width)), ..self }
    }

    /// The one that is given among these, else that which fits the largest number.
    pub fn fitting(&self, units: &[Unit], largest: f64) -> Unit {
        self.of(units).unwrap_or_else(|| Unit::fitting(units, largest))
    }
}

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

    /// Its name as in the names of columns: with u in place of µ, and in words what it is over.
    pub fn ascii(&self) -> String {
        self.name.replace('µ', "u").replace('/', "_per_")
    }

    /// A number in nN, nm, aJ or nN nm² in this unit.
    pub fn of(&self, value: f64) -> f64 {
        value / self.size
    }
}

/// A length (nm) in the unit that fits it: "4 mm".
pub(crate) fn length_text(length: f64) -> String {
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
    fn units_are_read_in_any_order() {
        let names =
            |text| PreferredUnits::parse(text).map(|units| units.given().map(|unit| unit.name).collect::<Vec<_>>());
        assert_eq!(names("um, pN"), Ok(vec!["pN", "µm"]));
        assert_eq!(names("auto"), Ok(vec![]));
        assert_eq!(names("μN,mm,fJ"), Ok(vec!["µN", "mm", "fJ"]));
        assert_eq!(names("N/25mm, mm"), Ok(vec!["mm", "N/25mm"]));
        assert_eq!(names("mm, furlong"), Err("furlong"));
        let units = PreferredUnits::parse("mm").unwrap();
        assert_eq!([units.fitting(LENGTHS, 3.0).name, units.fitting(FORCES, 3e6).name], ["mm", "mN"]);
    }

    #[test]
    fn the_force_of_a_strip_is_over_its_width_where_no_unit_of_forces_is_given() {
        // 2 N on 20 mm are 2.5 N on 25 mm, and 100 N/m
        let written = |text| {
            let units = PreferredUnits::parse(text).unwrap().across(20e6);
            let unit = units.fitting(FORCES, 2e9);
            (unit.of(2e9), unit.name, units.fitting(FORCES_PER_WIDTH, 100.0).of(100.0))
        };
        assert_eq!(written("N/25mm"), (2.5, "N/25mm", 2.5));
        assert_eq!(written("N,N/25mm"), (2.0, "N", 2.5));
        assert_eq!(written("auto"), (2.0, "N", 100.0));
        // 9.80665 m/s² for a gram
        assert_eq!(PEEL_ADHESIONS[1].of(9.80665), 10.0);
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
