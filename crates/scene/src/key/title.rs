//! What an axis calls a key: words, symbol and unit.

use super::kind::Key;

/// Words and symbol of the keys that can be varied; a symbol may be missing.
#[rustfmt::skip]
const TITLES: &[(&str, &str, &str)] = &[
    ("strip.length", "length of the strip", "L"),
    ("strip.height", "height of the section", "h"),
    ("strip.width", "width of the section", "b"),
    ("strip.crack", "length of the initial crack", "a₀"),
    ("strip.bending_stiffness_factor", "bending stiffness over that of the section", "EI/EI₀"),
    ("spatula.pad_length", "length of the pad", ""),
    ("spatula.neck_length", "length of the neck", ""),
    ("spatula.shaft_length", "length of the shaft", ""),
    ("spatula.bend_length", "length of the bend", ""),
    ("spatula.tip_width", "width of the pad at the tip", "b"),
    ("spatula.neck_width", "width of the pad at its end", ""),
    ("spatula.shaft_diameter", "diameter of the shaft", ""),
    ("spatula.pad_thickness", "thickness of the pad", "h"),
    ("spatula.shaft_angle", "angle of the shaft to the pad", ""),
    ("spatula.tip_rounding_length", "length of the rounded tip", ""),
    ("spatula.tip_rounding_width", "width of the end face of the rounded tip", ""),
    ("spatula.bending_stiffness_factor", "bending stiffness over that of the section", "EI/EI₀"),
    ("profile.bending_stiffness_factor", "bending stiffness over that of the section", "EI/EI₀"),
    ("seta.forks", "forks from root to tip", "n"),
    ("seta.tip_pitch", "distance of neighbouring tips", ""),
    ("seta.shaft_length", "length of the shaft", ""),
    ("seta.shaft_angle", "angle of the shaft to the normal", ""),
    ("seta.shaft_diameter", "diameter of the shaft", "d"),
    ("seta.brush_height", "height of the brush", "H"),
    ("seta.brush_angle", "angle of the brush to the normal", ""),
    ("seta.height_ratio", "ratio of the heights of forks", "q"),
    ("seta.diameter_ratio", "ratio of the diameters of branches", ""),
    ("seta.height_scatter", "half the range of the heights of tips", "a"),
    ("seta.lateral_stiffness", "stiffness that holds attached tips", "k"),
    ("seta.contact_height", "height at which a detached tip adheres again", ""),
    ("seta.preload", "preload", ""),
    ("seta.tip_tolerance", "relative error of the table of the tips", ""),
    ("seta.resolve_within", "distance to snapping off from which tips are resolved", ""),
    ("seta.bending_stiffness_factor", "bending stiffness over that of the section", "EI/EI₀"),
    ("youngs_modulus", "Young's modulus", "E"),
    ("poissons_ratio", "Poisson's ratio", "ν"),
    ("shear_correction", "shear correction factor", "k"),
    ("adhesion.hamaker_constant", "Hamaker constant", "A_H"),
    ("adhesion.equilibrium_distance", "equilibrium distance", "r₀"),
    ("adhesion.work", "work of adhesion", "w"),
    ("adhesion.strength", "cohesive strength", "σ"),
    ("substrate.radius", "radius of the substrate", "R"),
    ("substrate.height", "height of the ground, crest to valley", "H"),
    ("substrate.wavelength", "wavelength of the ground", "λ"),
    ("substrate.offset", "distance of a crest from the free end", ""),
    ("friction.strength", "shear strength of the contact", "τ"),
    ("friction.coefficient", "friction coefficient", "μ"),
    ("friction.presliding", "elastic presliding displacement", ""),
    ("grip.stiffness", "stiffness of the machine", "k"),
    ("grip.pretension", "pretension", "T"),
    ("drive.angle", "angle of the pull to the substrate", "α"),
    ("drive.azimuth", "direction of the pull along the substrate", "β"),
    ("drive.turn", "rotation of the grip per displacement", ""),
    ("time.rate", "rate of the pull", "V"),
    ("time.density", "density", "ρ"),
    ("time.retardation_time", "retardation time", "τ"),
    ("time.relaxation_time", "relaxation time", "τ"),
    ("time.stiffness_ratio", "instantaneous over relaxed modulus", "E₀/E∞"),
    ("time.displacement", "where the grip comes to rest", ""),
    ("time.held", "time at rest", ""),
    ("time.acceleration", "way on which the grip accelerates", ""),
    ("time.tolerance", "error of a step in time over the equilibrium gap", ""),
    ("accuracy.relative", "relative tolerance", ""),
    ("accuracy.order", "order of the elements", "p"),
    ("accuracy.elements", "number of elements", ""),
    ("accuracy.step", "predictor tolerance over the equilibrium gap", ""),
    ("bounds.points", "largest number of points of the path", ""),
    ("bounds.time", "longest time for a path", ""),
    ("bounds.displacement", "largest displacement of the grip", ""),
    ("fit.force_error", "standard error of the measured forces", ""),
    ("fit.displacement_error", "standard error of the measured displacements", ""),
    ("fit.displacement_zero", "zero of the measured displacement", "d"),
    ("fit.jump", "measured displacement of the jump", ""),
];

impl Key {
    /// The key as the title of an axis, in [`Key::usual_unit`]: "height of the section h (nm)".
    pub fn axis_title(&self) -> String {
        self.titled(self.usual_unit())
    }

    /// The same in the unit of the library, [`Key::unit`]: angles are in rad.
    pub fn axis_title_in_library_unit(&self) -> String {
        self.titled(self.unit())
    }

    fn titled(&self, unit: &str) -> String {
        let path = self.path();
        let found = TITLES.iter().find(|(key, ..)| *key == path || *key == self.name);
        let (words, symbol) = found.map_or((self.about, ""), |&(_, words, symbol)| (words, symbol));
        let symbol = if symbol.is_empty() { String::new() } else { format!(" {symbol}") };
        let unit = match unit {
            "" => String::new(),
            "J/m2" => " (J/m²)".to_owned(),
            unit => format!(" ({unit})"),
        };
        format!("{words}{symbol}{unit}")
    }

    /// How many of [`Key::usual_unit`] one unit of the library is: 180/π for an angle, or else 1.
    pub fn per_usual_unit(&self) -> f64 {
        if self.usual_unit() == self.unit() { 1.0 } else { 1f64.to_degrees() }
    }
}

#[cfg(test)]
mod tests {
    use super::TITLES;
    use crate::keys::{KEYS, find_key};

    #[test]
    fn every_key_that_can_be_varied_has_a_title_in_words() {
        for key in KEYS.iter().filter(|key| key.is_numeric()) {
            let known = TITLES.iter().any(|(path, ..)| *path == key.path() || *path == key.name);
            assert!(known, "{} has no title", key.path());
            let title = key.axis_title();
            assert!(!title.contains(&key.path()) && !title.contains("_") || title.contains("A_H"), "{title}");
        }
        for (path, ..) in TITLES {
            assert!(KEYS.iter().any(|key| key.path() == *path || key.name == *path), "{path} is no key");
        }
    }

    #[test]
    fn titles_have_symbol_and_unit() {
        let title = |path| find_key(path).unwrap().axis_title();
        assert_eq!(title("strip.height"), "height of the section h (nm)");
        assert_eq!(title("spatula.youngs_modulus"), "Young's modulus E (GPa)");
        assert_eq!(title("drive.angle"), "angle of the pull to the substrate α (deg)");
        assert_eq!(title("adhesion.work"), "work of adhesion w (J/m²)");
        assert_eq!(find_key("drive.angle").unwrap().per_usual_unit(), 180.0 / std::f64::consts::PI);
    }
}
