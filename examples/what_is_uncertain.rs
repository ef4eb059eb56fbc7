//! What is uncertain: how well is a peak force known if the numbers behind it are not?
//!
//! What it shows: Hamaker constant, equilibrium distance, modulus and height of a strip are known to some ten per cent. A thousand strips are
//! drawn at random and peeled. The scatter of their peaks is compared with what one strip and its derivatives predict.
//!
//! Equations: with ln pᵢ = ln p₀ᵢ + σᵢ zᵢ, zᵢ normal, and sᵢ = d ln P/d ln pᵢ, to first order ln P is normal with the variance
//! Σ (sᵢ σᵢ)². The share of a parameter in it says what to measure better.
//!
//! What to try: a softer strip, whose peak depends less on the modulus; three times the scatter of the equilibrium distance: how far
//! does the first order hold?
//!
//!     cargo run --release --example what_is_uncertain
//!
//! writes out/examples/what_is_uncertain.svg and .png.

use peelkit::prelude::*;
use peelkit::study::{PeelQuantity, Variation, sensitivities, sweep};
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Shape, Stroke, colour, save};
use peelkit_report::pictures::bars;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::{error::Error, f64::consts::PI, path::Path};

/// Name of a parameter, standard deviation of its logarithm, and where it is.
type Parameter = (&'static str, f64, fn(&mut StripModel) -> &mut f64);
const PARAMETERS: [Parameter; 4] = [
    ("Hamaker constant", 0.2, |model| &mut model.adhesion.hamaker_constant),
    ("equilibrium distance", 0.1, |model| &mut model.adhesion.equilibrium_distance),
    ("Young's modulus", 0.3, |model| &mut model.strip.youngs_modulus),
    ("height", 0.1, |model| &mut model.strip.height),
];
/// Width of a column of the histogram, nN.
const COLUMN: f64 = 0.02;

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", draw(Path::new("out/examples"))?);
    Ok(())
}

/// Draws the picture in a folder, and gives the text to print.
pub fn draw(folder: &Path) -> Result<String, Box<dyn Error>> {
    let (force, own) = (PeelQuantity::InitiationPeakForce, peeled(&[0.0; 4]));
    let median = force.value(&own).ok_or("no peak")?;
    let along = |k: usize, x: f64| strip(&std::array::from_fn(|j| if j == k { x } else { 0.0 }));
    let variations: Vec<Variation> =
        (0..4).map(|k| Variation::new(PARAMETERS[k].0, move |x| along(k, x).into())).collect();
    let exponents = sensitivities(&own, &[force], &variations)?.exponents(&own);
    // s σ of each parameter, the largest exponent first
    let spread: Vec<f64> = exponents.iter().map(|exponent| exponent.value * PARAMETERS[exponent.variation].1).collect();
    let first_order = spread.iter().map(|part| part * part).sum::<f64>().sqrt();

    // Box and Muller's normal numbers
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut normal = || (-2.0 * random.random::<f64>().ln()).sqrt() * (2.0 * PI * random.random::<f64>()).cos();
    let samples: Vec<[f64; 4]> = (0..1000).map(|_| PARAMETERS.map(|(_, scatter, _)| scatter * normal())).collect();
    let peaks: Vec<f64> =
        sweep(&samples, &|| true, &|sample| force.value(&peeled(sample))).into_iter().flatten().collect();
    let mean = |of: &dyn Fn(f64) -> f64| peaks.iter().map(|&peak| of(peak)).sum::<f64>() / peaks.len() as f64;
    let centre = mean(&f64::ln);
    let sampled = mean(&|peak| (peak.ln() - centre).powi(2)).sqrt();

    let mut text = format!("{:22} {:>14} {:>18}\n", "p", "d ln P/d ln p", "share of variance");
    let mut rows = Vec::new();
    for (exponent, part) in exponents.iter().zip(spread) {
        let (name, share) = (PARAMETERS[exponent.variation].0, 100.0 * (part / first_order).powi(2));
        text += &format!("{name:22} {:>14.4} {share:>16.1} %\n", exponent.value);
        rows.push((name, share));
    }
    text += &format!("first order:  median {median:.4} nN, ln P scatters by {first_order:.4}\n");
    text += &format!("{} samples: median {:.4} nN, ln P scatters by {sampled:.4}\n", peaks.len(), centre.exp());

    let column = |k: usize| {
        let (from, to) = (COLUMN * k as f64, COLUMN * (k + 1) as f64);
        let count = peaks.iter().filter(|&&peak| peak >= from && peak < to).count() as f64;
        Shape { corners: vec![(from, 0.0), (from, count), (to, count), (to, 0.0)], colour: colour::BLUE, opacity: 0.45 }
    };
    // the density of P where ln P is normal, times the samples and the width of a column
    let density = |force: f64| {
        let z = (force / median).ln() / first_order;
        (force, peaks.len() as f64 * COLUMN * (-0.5 * z * z).exp() / ((2.0 * PI).sqrt() * first_order * force))
    };
    let points = (5..=80).map(|k| density(0.01 * f64::from(k))).collect();
    let line = Line::named("first order", points, Stroke::solid(colour::VERMILLION, 2.4));
    let (x, y) = (Axis::linear("initiation peak (nN)", 0.0, 0.8), Axis::linear("strips of 1000", 0.0, 130.0));
    let mut left = Panel::of_lines(Frame { right: 450.0, ..Frame::across() }, x, y, vec![line]);
    left.shapes = (0..40).map(column).collect();
    let right = bars(Frame { left: 610.0, ..Frame::across() }, "share of the variance (%)", &rows);
    save(&Picture::of("What is uncertain of a peak force", vec![left, right]), folder, "what_is_uncertain")?;
    Ok(text)
}

/// The strip with its parameters changed by these logarithms.
fn strip(logarithms: &[f64; 4]) -> StripModel {
    let mut model = StripModel::of_the_paper(100.0, 1.0);
    for ((_, _, parameter), logarithm) in PARAMETERS.iter().zip(logarithms) {
        *parameter(&mut model) *= logarithm.exp();
    }
    model
}

/// Its peel, as far as the initiation peak needs.
fn peeled(logarithms: &[f64; 4]) -> Peel {
    let initiation = StopCriteria { displacement: Some(3.0), ..StopCriteria::default() };
    peel(&strip(logarithms), &Accuracy::to(1e-6), &initiation)
}
