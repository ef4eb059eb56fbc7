//! The units of what is printed for a person: those that `--units` or the scene names, else those that fit the size of the numbers. Files keep the
//! units that stand in the names of their columns and keys.

use super::number::{short, with_error};
use crate::terminal::stop::Stop;
use clap::Args;
use peelkit::units::{self, FORCES, LENGTHS, MOMENTS, PreferredUnits, WORKS};
use peelkit_scene::{Scene, ValueError};

/// A unit of a force, a length, a work or a force over a width, with which numbers are printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit(units::Unit);

/// Which units results are printed, drawn and written in besides.
#[derive(Args, Clone, Debug, Default)]
pub struct UnitsArgs {
    /// Units of summary and pictures: µN,µm,fJ [default: those that fit]
    ///
    /// One each of forces, lengths, works and forces over a width. Tables keep theirs; copies are in in-units.
    #[arg(long, value_name = "LIST")]
    units: Option<String>,
}

impl UnitsArgs {
    /// Those that are given, if they are understood.
    pub fn given(&self) -> Result<Option<PreferredUnits>, Stop> {
        let read = self.units.as_deref().map(peelkit_scene::units).transpose();
        read.map_err(|why| Stop::bad_input(format!("--units {}", why.found), why.remedy))
    }

    /// Puts them into a scene, in place of its own.
    pub fn put(&self, scene: &mut Scene) -> Result<(), Stop> {
        scene.units = self.given()?.unwrap_or(scene.units);
        self.check(scene, [])
    }

    /// Refuses those that a scene has no use for, if these keys are varied.
    pub fn check(&self, scene: &Scene, varied: impl IntoIterator<Item = String>) -> Result<(), Stop> {
        let name = if self.units.is_some() { "--units" } else { "output.units" };
        let refused = |why: ValueError| Stop::bad_input(format!("{name} {}", why.found), why.remedy);
        scene.units_problem(varied).map_or(Ok(()), |why| Err(refused(why)))
    }
}

/// The units of one summary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Of forces
    pub force: Unit,
    /// Of displacements and lengths
    pub length: Unit,
    /// Of works and energies
    pub work: Unit,
}

impl Units {
    /// Those that are wanted, and else those that fit the largest force (nN), length (nm) and work (aJ).
    pub fn fitting(wanted: PreferredUnits, [force, length, work]: [f64; 3]) -> Self {
        Self {
            force: Unit(wanted.fitting(FORCES, force)),
            length: Unit(wanted.fitting(LENGTHS, length)),
            work: Unit(wanted.fitting(WORKS, work)),
        }
    }
}

/// A number of these units, such as those of lengths, in the one that fits it: "416.667 mN mm²".
pub fn fitting_text(units: &[units::Unit], value: f64) -> String {
    Unit(units::Unit::fitting(units, value.abs())).short(value)
}

/// A moment in the unit that fits it, to six decimals of nN nm: "-710.353153 N mm".
pub fn moment_text(value: f64) -> String {
    Unit(units::Unit::fitting(MOMENTS, value.abs())).fixed(value, 6)
}

/// Most digits of a number without a bound.
const MOST_DIGITS: i32 = 11;

impl Unit {
    /// As it is printed.
    pub fn name(&self) -> &'static str {
        self.0.name
    }

    /// A number of the library's units in this one.
    pub fn of(&self, value: f64) -> f64 {
        self.0.of(value)
    }

    /// As many decimals as the error leaves, the error, and the unit.
    pub fn with_error(&self, value: f64, error: f64) -> String {
        format!("{} {}", self.bare_with_error(value, error), self.name())
    }

    /// The same without the unit, which stands behind the next number.
    pub fn bare_with_error(&self, value: f64, error: f64) -> String {
        with_error(self.of(value), self.of(error))
    }

    /// With its unit, to so many decimals of the unit of the files, but no more than eleven digits.
    pub fn fixed(&self, value: f64, decimals: i32) -> String {
        let value = self.of(value);
        let behind_the_first = MOST_DIGITS - 1 - value.abs().max(1.0).log10().floor() as i32;
        let decimals = (decimals + self.0.size.log10().round() as i32).min(behind_the_first).max(0) as usize;
        format!("{value:.decimals$} {}", self.name())
    }

    /// Six digits and the unit.
    pub fn short(&self, value: f64) -> String {
        format!("{} {}", short(self.of(value)), self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit::units::BENDING_STIFFNESSES;

    fn names(units: Units) -> [&'static str; 3] {
        [units.force.name(), units.length.name(), units.work.name()]
    }

    #[test]
    fn what_is_wanted_comes_before_what_fits() {
        let fitting = |text| names(Units::fitting(PreferredUnits::parse(text).unwrap(), [0.34, 7e6, 3.5]));
        assert_eq!(fitting("auto"), ["nN", "mm", "aJ"]);
        assert_eq!(fitting("pN, um"), ["pN", "µm", "aJ"]);
        assert_eq!(fitting("fJ"), ["nN", "mm", "fJ"]);
    }

    #[test]
    fn digits_stay_the_same_in_every_unit() {
        let (micrometre, piconewton, nanometre) = (Unit(LENGTHS[2]), Unit(FORCES[0]), Unit(LENGTHS[1]));
        assert_eq!(micrometre.with_error(48215.6178228, 3e-3), "48.215618 ± 3e-6 µm");
        assert_eq!(micrometre.fixed(48215.6178228, 6), "48.215617823 µm");
        assert_eq!(piconewton.short(0.0075), "7.5 pN");
        assert_eq!(nanometre.fixed(12345678901234.5, 6), "12345678901234 nm");
        assert_eq!(fitting_text(BENDING_STIFFNESSES, 4.16667e20), "416.667 mN mm²");
        assert_eq!(fitting_text(LENGTHS, 12345.678901234567), "12.3457 µm");
    }
}
