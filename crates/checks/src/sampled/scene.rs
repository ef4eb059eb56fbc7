//! A scene sampled over wide ranges, as a text that a user could have written.

use super::kind::SampleKind;
use peelkit::model::Attraction;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fmt::Write;

/// Scene `index` of a sample: the same for the same seed, on every machine.
pub fn scene_text(kind: SampleKind, seed: u64, index: u64) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(index);
    let mut sampler = Sampler { random, text: format!("# scene {index} of kind {}, seed {seed}\n", kind.name()) };
    match kind {
        SampleKind::Spatula => sampler.spatula(),
        SampleKind::Space => sampler.strip_in_space(),
        SampleKind::Oblique => sampler.oblique_strip(),
        SampleKind::Friction => sampler.strip_with_friction(),
        SampleKind::Rough => sampler.strip_on_waves(),
        SampleKind::Rate => sampler.strip_at_a_rate(),
        SampleKind::Seta => sampler.seta(),
        SampleKind::Tape => sampler.tape(None),
        SampleKind::Held => sampler.tape(Some((0.3, 10.0))),
        SampleKind::Observed => sampler.tested_strip(),
        SampleKind::Strip | SampleKind::Angle | SampleKind::Law => sampler.strip(kind),
    }
    sampler.text
}

struct Sampler {
    random: ChaCha8Rng,
    text: String,
}

impl Sampler {
    /// The table of a strip of length (nm), height (nm) and Young's modulus (GPa) within these ranges.
    fn usual_strip(&mut self, [length, height, youngs_modulus]: [(f64, f64); 3]) {
        self.line("[strip]");
        self.quantity("length", length, "nm");
        self.quantity("height", height, "nm");
        self.quantity("youngs_modulus", youngs_modulus, "GPa");
    }

    /// The adhesion of the half space, with the constants of van der Waals solids.
    fn half_space(&mut self) {
        self.line("[adhesion]");
        self.quantity("hamaker_constant", (1e-20, 5e-19), "J");
        self.quantity("equilibrium_distance", (0.2, 0.8), "nm");
    }

    fn pull_between(&mut self, least: f64, most: f64) {
        let angle = self.uniform(least, most);
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\""));
    }

    fn grip(&mut self) {
        let [rotation, horizontal] = [0, 1].map(|_| self.pick(&["free", "fixed"]));
        self.line(&format!("[grip]\nrotation = \"{rotation}\"\nhorizontal = \"{horizontal}\""));
    }

    fn quantity(&mut self, key: &str, range: (f64, f64), unit: &str) {
        let value = self.log_uniform(range);
        self.line(&format!("{key} = \"{value:.6e} {unit}\""));
    }

    fn line(&mut self, line: &str) {
        // a text cannot fail to be written to
        let _ = writeln!(self.text, "{line}");
    }

    /// Evenly in the logarithm.
    fn log_uniform(&mut self, (least, most): (f64, f64)) -> f64 {
        least * (most / least).powf(self.random.random_range(0.0..1.0))
    }

    fn uniform(&mut self, least: f64, most: f64) -> f64 {
        self.random.random_range(least..most)
    }

    fn pick(&mut self, choices: &[&'static str]) -> &'static str {
        choices[self.random.random_range(0..choices.len())]
    }
}

// -- Strips and spatulae in the plane --

const LINE_LOADS: [&str; 3] = ["full", "force-only", "axis-gap"];

impl Sampler {
    fn strip(&mut self, kind: SampleKind) {
        self.line("[strip]");
        self.quantity("length", (20.0, 2e4), "nm");
        self.quantity("height", (2.0, 50.0), "nm");
        self.quantity("youngs_modulus", (0.01, 100.0), "GPa");
        let factor = self.log_uniform((1e-4, 1e4));
        self.line(&format!("bending_stiffness_factor = {factor:.6e}"));
        self.line("[adhesion]");
        self.quantity("hamaker_constant", (1e-21, 1e-18), "J");
        self.quantity("equilibrium_distance", (0.1, 2.0), "nm");
        let far_face = self.pick(&["true", "false"]);
        self.line(&format!("far_face = {far_face}"));
        if kind == SampleKind::Law {
            let besides: Vec<_> =
                Attraction::all().filter(|law| *law != Attraction::BodyForce).map(Attraction::name).collect();
            let law = self.pick(&besides);
            let load = self.pick(&LINE_LOADS);
            self.line(&format!("law = \"{law}\"\nline_load = \"{load}\""));
        }
        self.grip();
        if kind == SampleKind::Angle {
            let angle = self.uniform(10.0, 170.0);
            self.line(&format!("[drive]\nangle = \"{angle:.3} deg\""));
        }
    }

    fn spatula(&mut self) {
        self.line("[spatula]");
        self.quantity("pad_length", (60.0, 600.0), "nm");
        self.quantity("pad_thickness", (5.0, 20.0), "nm");
        let angle = self.uniform(5.0, 90.0);
        let rounding = self.pick(&["0", "30"]);
        self.line(&format!("shaft_angle = \"{angle:.3} deg\"\ntip_rounding_length = \"{rounding} nm\""));
        self.quantity("youngs_modulus", (0.1, 20.0), "GPa");
        self.line("[adhesion]");
        self.quantity("hamaker_constant", (1e-20, 4e-19), "J");
        self.quantity("equilibrium_distance", (0.2, 0.8), "nm");
        let far_face = self.pick(&["true", "false"]);
        self.line(&format!("far_face = {far_face}"));
        self.grip();
    }

    // -- Strips in space --

    fn strip_in_space(&mut self) {
        self.line("space = true\n[strip]");
        self.quantity("length", (50.0, 200.0), "nm");
        let height = self.log_uniform((4.0, 14.0));
        let width = height * self.log_uniform((1.0, 8.0));
        self.line(&format!("height = \"{height:.6e} nm\"\nwidth = \"{width:.6e} nm\""));
        self.quantity("youngs_modulus", (0.5, 20.0), "GPa");
        let section = self.pick(&["rectangle", "rectangle", "rectangle", "ellipse"]);
        self.line(&format!("section = \"{section}\"\n[adhesion]"));
        self.quantity("hamaker_constant", (2e-20, 4e-19), "J");
        self.quantity("equilibrium_distance", (0.2, 0.8), "nm");
        self.grip();
        for hold in ["roll", "yaw", "lateral"] {
            let held = self.pick(&["free", "free", "free", "fixed"]);
            self.line(&format!("{hold} = \"{held}\""));
        }
        let (angle, azimuth) = (self.uniform(15.0, 90.0), self.uniform(-170.0, 170.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
    }

    /// Of widths that are no multiple of the height, in a grip that holds nothing, pulled flatter and to one side.
    fn oblique_strip(&mut self) {
        self.line("space = true\n[strip]");
        self.quantity("length", (60.0, 400.0), "nm");
        self.quantity("height", (4.0, 15.0), "nm");
        self.quantity("width", (5.0, 60.0), "nm");
        self.quantity("youngs_modulus", (0.5, 5.0), "GPa");
        self.half_space();
        self.line("[grip]\nhorizontal = \"free\"");
        let (angle, azimuth) = (self.uniform(20.0, 90.0), self.uniform(5.0, 175.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
    }

    // -- Adhesive tapes and films --

    /// With a shear strength in this range, over the strength, if there is one.
    fn tape(&mut self, shear_over_strength: Option<(f64, f64)>) {
        let height = self.log_uniform((5.0, 500.0));
        let length = height * self.log_uniform((20.0, 500.0));
        self.line(&format!("[strip]\nheight = \"{height:.6e} um\"\nlength = \"{length:.6e} um\""));
        self.quantity("width", (1.0, 30.0), "mm");
        self.quantity("youngs_modulus", (0.1, 5000.0), "MPa");
        let ratio = self.pick(&["0.3", "0.4", "0.49"]);
        self.line(&format!("poissons_ratio = {ratio}\n[adhesion]"));
        let laws: Vec<_> = Attraction::cohesive().map(Attraction::name).collect();
        let law = self.pick(&laws);
        self.line(&format!("law = \"{law}\""));
        self.quantity("work", (0.02, 300.0), "J/m2");
        let strength = self.log_uniform((0.02, 10.0));
        self.line(&format!("strength = \"{strength:.6e} MPa\""));
        if let Some(range) = shear_over_strength {
            let shear = strength * self.log_uniform(range);
            self.line(&format!("shear_strength = \"{shear:.6e} MPa\""));
        }
        self.quantity("equilibrium_distance", (0.5, 20.0), "nm");
        let rotation = self.pick(&["free", "fixed"]);
        self.line(&format!("[grip]\nrotation = \"{rotation}\""));
        if self.pick(&["up", "angle"]) == "angle" {
            self.pull_between(20.0, 160.0);
        }
    }

    // -- Strips that friction holds along the substrate --

    fn strip_with_friction(&mut self) {
        self.usual_strip([(50.0, 800.0), (4.0, 20.0), (0.3, 10.0)]);
        self.half_space();
        self.line("[friction]");
        self.quantity("strength", (1.0, 100.0), "MPa");
        self.pull_between(20.0, 150.0);
    }

    // -- Strips on wavy ground --

    fn strip_on_waves(&mut self) {
        self.usual_strip([(50.0, 1000.0), (3.0, 20.0), (0.2, 10.0)]);
        self.half_space();
        self.line("[substrate]\nshape = \"sinusoid\"");
        self.quantity("height", (0.5, 15.0), "nm");
        self.quantity("wavelength", (40.0, 300.0), "nm");
        let rotation = self.pick(&["free", "fixed"]);
        self.line(&format!("[grip]\nrotation = \"{rotation}\""));
        if self.pick(&["up", "angle"]) == "angle" {
            self.pull_between(30.0, 150.0);
        }
    }

    // -- Strips that are pulled at a rate --

    fn strip_at_a_rate(&mut self) {
        self.usual_strip([(50.0, 500.0), (4.0, 20.0), (0.3, 10.0)]);
        self.half_space();
        self.line("[time]\ndensity = \"1300 kg/m3\"");
        self.quantity("rate", (1e-6, 1.0), "m/s");
        if self.pick(&["elastic", "kelvin-voigt"]) == "kelvin-voigt" {
            self.line("material = \"kelvin-voigt\"");
            self.quantity("retardation_time", (1e-9, 1e-3), "s");
        }
    }

    // -- Strips in a displacement-controlled test --

    fn tested_strip(&mut self) {
        self.usual_strip([(50.0, 1500.0), (3.0, 25.0), (0.1, 20.0)]);
        self.half_space();
        if self.pick(&["up", "angle"]) == "angle" {
            self.pull_between(20.0, 160.0);
        }
    }

    // -- Setae: a shaft that forks into up to 64 tips --

    fn seta(&mut self) {
        self.line("[seta]");
        let forks = self.pick(&["1", "2", "3", "4", "5", "6"]);
        self.line(&format!("forks = {forks}"));
        self.quantity("shaft_diameter", (1.0, 6.0), "um");
        self.quantity("youngs_modulus", (0.5, 10.0), "GPa");
        self.quantity("height_scatter", (10.0, 300.0), "nm");
        self.line("[spatula]");
        self.half_space();
        let (angle, azimuth) = (self.uniform(30.0, 150.0), self.uniform(0.0, 90.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit_scene::Scene;

    /// Every kind gives scenes that are read, each of its own, and the same ones again.
    #[test]
    fn scenes_are_read_and_repeat() {
        for kind in SampleKind::all() {
            assert_eq!(SampleKind::named(kind.name()), Some(kind));
            let texts: Vec<String> = (0..50).map(|index| scene_text(kind, 7, index)).collect();
            assert_eq!(texts[3], scene_text(kind, 7, 3));
            assert_ne!(texts[3], scene_text(kind, 8, 3).replace("seed 8", "seed 7"));
            for text in &texts {
                let read = Scene::parse_any("sampled", text, &[]);
                // more waves than are resolved are a refusal of the survey
                let refused = |error: &str| kind == SampleKind::Rough && error.contains("at most 1000 are resolved");
                assert!(read.as_ref().map_or_else(|error| refused(&error.to_string()), |_| true), "{read:?}\n{text}");
            }
        }
    }
}
