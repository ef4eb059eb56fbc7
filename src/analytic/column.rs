//! Loads under which a straight column is in neutral equilibrium.
//!
//! Reissner's beam, compressed by P, linearised about the straight state with λ = 1 - P/EA: constant vertical force V gives
//! the shear strain y' - λθ = (V + Pθ)/GA_s, and moment equilibrium EI θ'' + (λ + P/GA_s)(V + Pθ) = 0. Hence
//! θ = -V/P + a cos kS + b sin kS with EI k² = P (λ + P/GA_s). With EA and GA_s infinite these are Euler's loads.

use crate::beam::section::Section;
use crate::number::root::Bracket;
use std::f64::consts::PI;

/// P in nN of a column that buckles in a sine of the wave number k (1/nm): P (1 - P/EA + P/GA_s) = EI k².
///
/// k = π/L on two hinges, π/(2L) clamped and free, 2π/L between two clamps, and multiples for the higher loads. NaN where
/// the column is so stocky, and so soft against stretch, that there is no such load.
pub fn buckling_load(section: &Section, wave_number: f64) -> f64 {
    let euler = section.bending * wave_number * wave_number;
    let softening = 1.0 / section.shear - 1.0 / section.axial;
    2.0 * euler / (1.0 + (1.0 + 4.0 * softening * euler).sqrt())
}

/// The lowest P in nN of a column of length L (nm), clamped at one end and hinged at the other.
///
/// y = 0 at both ends, θ = 0 at one and θ' = 0 at the other leave (λ + P/GA_s) tan kL = λ kL: Euler's tan kL = kL where
/// nothing shears.
pub fn propped_buckling_load(section: &Section, length: f64) -> f64 {
    let mismatch = |angle: f64| {
        let load = buckling_load(section, angle / length);
        let shortened = 1.0 - load / section.axial;
        (shortened + load / section.shear) * angle.sin() - shortened * angle * angle.cos()
    };
    let angles = Bracket { low: PI, high: 1.5 * PI };
    let narrow = angles.bisected(|angle| mismatch(angle) > 0.0, |left| left.width() <= 4.0 * f64::EPSILON * left.high);
    buckling_load(section, narrow.middle() / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_stiff_column_has_eulers_loads() {
        let section = Section { axial: 1e15, shear: 1e15, bending: 3.0 };
        assert_relative_eq!(buckling_load(&section, PI / 2.0), 3.0 * (PI / 2.0).powi(2), max_relative = 1e-13);
        // tan x = x at 4.4934094579090642
        let expected = 3.0 * (4.493_409_457_909_064 / 7.0f64).powi(2);
        assert_relative_eq!(propped_buckling_load(&section, 7.0), expected, max_relative = 1e-13);
    }

    /// Engesser's column, which shears and does not stretch: P (1 + P/GA_s) = EI k².
    #[test]
    fn the_load_satisfies_its_equation() {
        let section = Section { axial: 400.0, shear: 150.0, bending: 2.0 };
        let p = buckling_load(&section, 1.3);
        assert_relative_eq!(p * (1.0 - p / 400.0 + p / 150.0), 2.0 * 1.69, max_relative = 1e-14);
    }
}
