//! Scenes that are sampled over wide ranges.

use crate::job::Job;
use peelkit::model::Attraction;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fmt::Write as _;

/// One stream for each scene.
struct Random(ChaCha8Rng);

impl Random {
    fn next(&mut self) -> u64 {
        self.0.next_u64()
    }

    fn uniform(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in the logarithm, to four digits: the text of the scene is then the number.
    fn log_uniform(&mut self, from: f64, to: f64) -> String {
        format!("{:.3e}", 10f64.powf(self.uniform(from.log10(), to.log10())))
    }

    fn one_in(&mut self, count: u64) -> bool {
        self.next().is_multiple_of(count)
    }

    fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.next() % choices.len() as u64) as usize]
    }
}

/// Most points of a path of a sampled scene.
const POINTS: usize = 1500;

pub fn sampled_scene(seed: u64, index: u64) -> Job {
    let mut random = Random(ChaCha8Rng::seed_from_u64(seed));
    random.0.set_stream(index);
    let random = &mut random;
    let spatula = index % 15 == 7;
    let text = scene_text(random, spatula);
    // a test is of a load with a potential, without friction
    let tested = !["force-only", "surface-traction", "[friction]"].iter().any(|word| text.contains(word));
    let observed = !spatula && tested && random.one_in(6);
    let body = if spatula { "spatula" } else { "strip" };
    Job { name: format!("sampled-{index:03}-{body}.toml"), text, observed, folder: None }
}

/// A strip or a spatula over wide ranges. Combinations that the scene refuses are not sampled.
fn scene_text(random: &mut Random, spatula: bool) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    line(format!("[{}]", if spatula { "spatula" } else { "strip" }));
    // ground that is not flat takes small elements wherever a beam lies
    let rough = !spatula && random.one_in(12);
    if spatula {
        line(format!("pad_length = \"{} nm\"", random.log_uniform(60.0, 600.0)));
        line(format!("pad_thickness = \"{} nm\"", random.log_uniform(5.0, 20.0)));
        line(format!("shaft_angle = \"{:.1} deg\"", random.uniform(5.0, 90.0)));
        line(format!("tip_rounding_length = \"{} nm\"", random.pick(&["0", "30"])));
        line(format!("youngs_modulus = \"{} GPa\"", random.log_uniform(0.5, 20.0)));
    } else {
        line(format!("length = \"{} nm\"", random.log_uniform(20.0, if rough { 500.0 } else { 2e4 })));
        line(format!("height = \"{} nm\"", random.log_uniform(2.0, 50.0)));
        line(format!("youngs_modulus = \"{} GPa\"", random.log_uniform(if rough { 1.0 } else { 0.01 }, 100.0)));
        line(format!("poissons_ratio = {:.3}", random.uniform(0.0, 0.49)));
        line(format!("bending_stiffness_factor = {}", random.log_uniform(if rough { 1.0 } else { 1e-4 }, 1e4)));
    }
    let (least, most) = if spatula || rough { (2e-20, 2e-19) } else { (1e-21, 1e-18) };
    line("[adhesion]".into());
    line(format!("hamaker_constant = \"{} J\"", random.log_uniform(least, most)));
    let (least, most) = if spatula || rough { (0.2, 0.8) } else { (0.1, 2.0) };
    line(format!("equilibrium_distance = \"{} nm\"", random.log_uniform(least, most)));
    line(format!("far_face = {}", random.one_in(2)));
    let mut law = "body-force";
    if !rough && random.one_in(3) {
        law = random.pick(&Attraction::all().map(Attraction::name).collect::<Vec<_>>());
        let load = random.pick(&["full", "full", "force-only", "axis-gap"]);
        line(format!("law = \"{law}\"\nline_load = \"{load}\""));
    }
    let half_space = law.contains('-');
    let rubs = !rough && half_space && random.one_in(10);
    if rough {
        let (wave, height) = (random.log_uniform(100.0, 1000.0), random.log_uniform(0.1, 2.0));
        let sinusoid = format!("shape = \"sinusoid\"\nheight = \"{height} nm\"\nwavelength = \"{wave} nm\"");
        let round = format!("shape = \"cylinder\"\nradius = \"{} nm\"", random.log_uniform(3e4, 1e6));
        line(format!("[substrate]\n{}", if random.one_in(3) { round } else { sinusoid }));
    }
    if rubs {
        line(format!("[friction]\nstrength = \"{} MPa\"", random.log_uniform(1.0, 100.0)));
    }
    let hold = |random: &mut Random| random.pick(&["free", "fixed"]);
    line(format!("[grip]\nrotation = \"{}\"\nhorizontal = \"{}\"", hold(random), hold(random)));
    if random.one_in(3) {
        line(format!("[drive]\nangle = \"{:.1} deg\"", random.uniform(10.0, 170.0)));
    }
    let points = if rough { POINTS / 10 } else { POINTS };
    line(format!("[accuracy]\nrelative = 1e-6\n[bounds]\npoints = {points}\ntime = \"1000 s\""));
    text
}
