//! When a beam that lies bonded on flat ground is no longer stable there: closed forms.
//!
//! Of a long uniform beam at y = y_eq and θ = 0 under a horizontal section force H the second variation of the energy is, per length, for a
//! deflection y and a rotation θ of its sections, with x minimised out,
//!
//!   2 φ₂ = GA_s (y' - a θ)² - (m - a H) θ² + EI θ'² + k y²,   a = 1 - g H,   g = 1/GA_s - 1/EA.
//!
//! k = bΨ,yy is the adhesion's stiffness and m = -bΨ,θθ its **tilt softening**, both at rest; Ψ,yθ is zero there by symmetry. A section that
//! tilts on an axis that stays where it is carries more of the body force a length: with the near face alone m = bw, the work of adhesion
//! of a unit length, with both faces a little less. Laws without that moment have m = 0.
//!
//! The horizontal force is the same all along, x answers to the second order, and the sum is that of H = 0 with aθ for θ, EI/a² for EI and
//! M = (m - aH)/a² for m. Let s² = k EI/a², the square of half the load under which a strut on this foundation buckles. Modes of the wave number q
//! have GA_s EI q⁴ + (k EI - GA_s m) q² + k (GA_s - m) for their least energy, so that the beam is unstable where
//!
//! - [`BondedMode::Tilting`]: M > GA_s, that is m > GA_s (1 - gH)(1 + H/EA), at q → 0: all sections tilt together, or in domains to either side
//!   with walls between, as many as the mesh resolves. EI does not count, nor does friction, which lets all of the beam shift;
//! - [`BondedMode::Wrinkling`]: where s < GA_s already from M > 2s - s²/GA_s on, at q² = (GA_s M - s²)/(2 GA_s EI/a²);
//! - [`BondedMode::FreeEnd`]: at an end without force and moment already where M²/(1 - M/GA_s) > s², in a mode that decays along the beam. From
//!   the two decaying solutions exp(λS) and V = θ' = 0 there: λ1² + λ1 λ2 + λ2² = k/GA_s.
//!
//! Where N does not follow the stretch linearly EA is N/Γ1 under H, in all of this.
//!
//! The last is the first of the three to come, by a factor of two where shear is stiff and by next to nothing where it is soft. The critical
//! M of each is what [`BondedBeam::ratio`] is relative to.

use super::material::stretch_law::StretchLaw;
use super::section::Section;
use crate::adhesion::section::line_load::LineLaw;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;

/// How a bonded beam loses its stability.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum BondedMode {
    /// Its sections tilt, all alike.
    Tilting,
    /// It takes on waves.
    Wrinkling,
    /// Its free end turns.
    FreeEnd,
}

impl fmt::Display for BondedMode {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Tilting => "its sections tilt in bulk",
            Self::Wrinkling => "it wrinkles",
            Self::FreeEnd => "its free end turns up",
        })
    }
}

/// A uniform beam bonded to flat ground, in small deflections from rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondedBeam {
    /// EA, GA_s and EI
    pub section: Section,
    /// How N follows the stretch
    pub stretch: StretchLaw,
    /// k = bΨ,yy, nN/nm²
    pub stiffness: f64,
    /// m = -bΨ,θθ, nN
    pub softening: f64,
}

impl BondedBeam {
    /// A section of this adhering width (nm) under its law, at rest.
    pub fn of(section: Section, stretch: StretchLaw, law: &LineLaw, width: f64) -> Self {
        let at = law.response(law.rest_gap(), 0.0, 1.0);
        Self { section, stretch, stiffness: width * at.gap_gap, softening: -width * at.rotation_rotation }
    }

    /// a = 1 - gH
    fn shortened(&self, force: f64) -> f64 {
        1.0 - force * (self.section.shear.recip() - self.axial(force).recip())
    }

    /// N/Γ1 under H, nN
    fn axial(&self, force: f64) -> f64 {
        self.stretch.secant(self.section.axial, force)
    }

    /// What the beam itself puts against a tilt of its sections under H, GA_s (1 - gH)(1 + H/EA), nN; `held` is the length (nm) from a free end
    /// to where sections cannot tilt, if there is such a place, which adds EI (π/2ℓ)²: less than that does not keep θ = cos(πS/2ℓ), y = 0
    /// from growing.
    pub(crate) fn tilt_resistance(&self, force: f64, held: Option<f64>) -> f64 {
        let Section { shear, bending, .. } = self.section;
        let bulk = shear * self.shortened(force) * (1.0 + force / self.axial(force));
        bulk + held.map_or(0.0, |length| bending * (FRAC_PI_2 / length).powi(2))
    }

    /// The softening M over what a mode takes in a beam of infinite length under H (nN): unstable from 1 on.
    pub fn ratio(&self, mode: BondedMode, force: f64) -> f64 {
        let (a, shear) = (self.shortened(force), self.section.shear);
        if a <= 0.0 {
            return f64::INFINITY;
        }
        let square = self.stiffness * self.section.bending / (a * a);
        let root = square.sqrt();
        let critical = match mode {
            BondedMode::Tilting => shear,
            BondedMode::Wrinkling if root < shear => root * (2.0 - root / shear),
            BondedMode::Wrinkling => shear,
            BondedMode::FreeEnd => 2.0 * root / (root / shear + (root / shear).hypot(2.0)),
        };
        over((self.softening - a * force) / (a * a), critical)
    }

    /// The tension (nN) from which on all sections tilt, (1 - gH)(1 + H/EA) = m/GA_s; none where there is no such tension, zero
    /// where they do at rest. Of a beam that stretches linearly.
    pub fn critical_tension(&self) -> Option<f64> {
        let Section { axial, shear, .. } = self.section;
        let (left, g, e) = (1.0 - self.softening / shear, shear.recip() - axial.recip(), axial.recip());
        if left <= 0.0 {
            return Some(0.0);
        }
        // g e H² + (g - e) H = left
        let root = ((g - e).powi(2) + 4.0 * g * e * left).sqrt();
        (g > 0.0).then(|| 2.0 * left / (g - e + root)).filter(|tension| *tension > 0.0 && tension.is_finite())
    }

    /// The length of the waves that grow first under H, nm; none where it does not wrinkle.
    pub(crate) fn wavelength(&self, force: f64) -> Option<f64> {
        let (a, shear) = (self.shortened(force), self.section.shear);
        let bending = self.section.bending / (a * a);
        let square =
            (shear * (self.softening - a * force) / (a * a) - self.stiffness * bending) / (2.0 * shear * bending);
        (a > 0.0 && square > 0.0).then(|| TAU / square.sqrt())
    }
}

/// A quotient that is infinite where there is nothing to be over.
fn over(softening: f64, critical: f64) -> f64 {
    if critical > 0.0 { softening / critical } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const BEAM: BondedBeam = BondedBeam {
        section: Section { axial: 3.0, shear: 1.2, bending: 0.04 },
        stretch: StretchLaw::Linear,
        stiffness: 5.0,
        softening: 0.3,
    };

    /// Least energy of a mode of wave number q under H, from the density itself.
    fn least_energy(beam: &BondedBeam, force: f64, q: f64) -> f64 {
        let Section { axial, shear, bending } = beam.section;
        let a = 1.0 - (1.0 / shear - 1.0 / axial) * force;
        let (yy, yt) = (shear * q * q + beam.stiffness, shear * q * a);
        let tt = bending * q * q + a * (force + shear * a) - beam.softening;
        tt - yt * yt / yy
    }

    #[test]
    fn bulk_modes_are_those_of_the_density() {
        for force in [-0.4, 0.0, 0.5] {
            for softening in [0.05, 0.3, 0.7, 1.1, 1.3] {
                let beam = BondedBeam { softening, ..BEAM };
                let least =
                    (0..4000).map(|k| least_energy(&beam, force, 0.01 * f64::from(k))).fold(f64::INFINITY, f64::min);
                let ratios = [BondedMode::Tilting, BondedMode::Wrinkling].map(|mode| beam.ratio(mode, force));
                assert_eq!(least < 0.0, ratios[0].max(ratios[1]) > 1.0, "{force} {softening} {least} {ratios:?}");
                assert!(beam.ratio(BondedMode::FreeEnd, force) >= ratios[1] || ratios[1] <= 0.0);
            }
        }
    }

    #[test]
    fn the_wavelength_is_that_of_the_least_energy() {
        let beam = BondedBeam { softening: 0.85, ..BEAM };
        let q = TAU / beam.wavelength(0.0).unwrap();
        // det = (GA q² + k) times the least energy is least there
        let det = |q: f64| least_energy(&beam, 0.0, q) * (beam.section.shear * q * q + beam.stiffness);
        assert!(det(q) < det(0.99 * q) && det(q) < det(1.01 * q));
    }

    #[test]
    fn sections_tilt_from_the_critical_tension_on() {
        let tension = BEAM.critical_tension().unwrap();
        let resistance = |share: f64| BEAM.tilt_resistance(share * tension, None);
        assert_relative_eq!(resistance(1.0), BEAM.softening, max_relative = 1e-14);
        assert_relative_eq!(BEAM.ratio(BondedMode::Tilting, tension), 1.0, max_relative = 1e-13);
        assert!(resistance(0.99) > BEAM.softening && resistance(1.01) < BEAM.softening);
        assert_eq!(BondedBeam { softening: 1.3, ..BEAM }.critical_tension(), Some(0.0));
        let unshearable = Section { shear: 1e9, ..BEAM.section };
        assert_eq!(BondedBeam { section: unshearable, ..BEAM }.critical_tension(), None);
    }

    /// The density of a section that is stretched by H: GA_s (y' - λθ)² + 2H y'θ - Hλθ², with λ = 1 + Γ1(H).
    #[test]
    fn a_stretched_section_counts_by_its_secant() {
        let beam = BondedBeam { stretch: StretchLaw::NeoHookean, softening: 0.0, ..BEAM };
        let Section { axial, shear, bending } = beam.section;
        for force in [-0.4, 0.3, 0.9] {
            let stretch = 1.0 + beam.stretch.strain(force / axial);
            let least = |q: f64| {
                let (yy, yt) = (shear * q * q + beam.stiffness, q * (shear * stretch - force));
                bending * q * q + stretch * (shear * stretch - force) - yt * yt / yy
            };
            let least = (0..4000).map(|k| least(0.01 * f64::from(k))).fold(f64::INFINITY, f64::min);
            let ratios = [BondedMode::Tilting, BondedMode::Wrinkling].map(|mode| beam.ratio(mode, force));
            assert_eq!(least < 0.0, ratios[0].max(ratios[1]) > 1.0, "{force} {least} {ratios:?}");
        }
        let resistance = |force: f64| beam.tilt_resistance(force, None);
        let stretch = 1.0 + beam.stretch.strain(0.9 / axial);
        assert_relative_eq!(resistance(0.9), stretch * (shear * stretch - 0.9), max_relative = 1e-13);
    }

    /// A strut without shear on its foundation: 2 (kEI)^½ along it, half of that at its free end.
    #[test]
    fn without_shear_it_is_a_strut() {
        let section = Section { shear: 1e12, axial: 1e12, ..BEAM.section };
        let root = (BEAM.stiffness * section.bending).sqrt();
        let strut = BondedBeam { section, softening: 0.0, ..BEAM };
        assert_relative_eq!(strut.ratio(BondedMode::Wrinkling, -root), 0.5, max_relative = 1e-9);
        assert_relative_eq!(strut.ratio(BondedMode::FreeEnd, -root), 1.0, max_relative = 1e-9);
    }
}
