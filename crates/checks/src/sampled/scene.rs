//! A scene sampled over wide ranges, as a text that a user could have written.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fmt::Write;

/// What is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleKind {
    /// Strips of any material, size and grip, pulled straight up.
    Strip,
    /// The same, pulled at 10 to 170 degrees.
    Angle,
    /// Spatulae.
    Spatula,
    /// Strips under every law and every line load but the half space's body force with all of them.
    Law,
    /// Strips in space, pulled in any direction over the substrate, in grips that hold this or that.
    Space,
}

impl SampleKind {
    /// All of them, in the order in which help lists them.
    pub const ALL: [Self; 5] = [Self::Strip, Self::Angle, Self::Spatula, Self::Law, Self::Space];

    /// What the command calls it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strip => "strip",
            Self::Angle => "angle",
            Self::Spatula => "spatula",
            Self::Law => "law",
            Self::Space => "space",
        }
    }

    /// What the command calls so.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// The laws besides that of the half space's body force.
const LAWS: [&str; 5] = ["surface-traction", "bilinear", "exponential", "dugdale", "trapezoidal"];
const LINE_LOADS: [&str; 3] = ["full", "force-only", "axis-gap"];

/// Scene `index` of a sample: the same for the same seed, on every machine.
pub fn scene_text(kind: SampleKind, seed: u64, index: u64) -> String {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(index);
    let mut sampler = Sampler { random, text: format!("# scene {index} of kind {}, seed {seed}\n", kind.name()) };
    match kind {
        SampleKind::Spatula => sampler.spatula(),
        SampleKind::Space => sampler.strip_in_space(),
        SampleKind::Strip | SampleKind::Angle | SampleKind::Law => sampler.strip(kind),
    }
    sampler.text
}

struct Sampler {
    random: ChaCha8Rng,
    text: String,
}

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
            let law = self.pick(&LAWS);
            let load = self.pick(&LINE_LOADS);
            self.line(&format!("law = \"{law}\"\nline_load = \"{load}\""));
        }
        self.grip();
        if kind == SampleKind::Angle {
            let angle = self.random.random_range(10.0..170.0);
            self.line(&format!("[drive]\nangle = \"{angle:.3} deg\""));
        }
    }

    fn spatula(&mut self) {
        self.line("[spatula]");
        self.quantity("pad_length", (60.0, 600.0), "nm");
        self.quantity("pad_thickness", (5.0, 20.0), "nm");
        let angle = self.random.random_range(5.0..90.0);
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
        let (angle, azimuth) = (self.random.random_range(15.0..90.0), self.random.random_range(-170.0..170.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
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

    fn pick(&mut self, choices: &[&'static str]) -> &'static str {
        choices[self.random.random_range(0..choices.len())]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peelkit_scene::Scene;

    /// Every kind gives scenes that are read, each of its own, and the same ones again.
    #[test]
    fn scenes_are_read_and_repeat() {
        for kind in SampleKind::ALL {
            assert_eq!(SampleKind::named(kind.name()), Some(kind));
            let texts: Vec<String> = (0..50).map(|index| scene_text(kind, 7, index)).collect();
            assert_eq!(texts[3], scene_text(kind, 7, 3));
            assert_ne!(texts[3], scene_text(kind, 8, 3).replace("seed 8", "seed 7"));
            for text in &texts {
                Scene::parse("sampled", text, &[]).unwrap_or_else(|error| panic!("{error}\n{text}"));
            }
        }
    }
}
