//! A scene sampled over wide ranges, as a text that a user could have written.

mod friction;
mod observed;
mod planar;
mod rate;
mod rough;
mod seta;
mod space;
mod tape;

use super::kind::SampleKind;
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
