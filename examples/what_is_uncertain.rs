//! What is uncertain: how well is a peak force known if the numbers behind it are not?
//!
//! What it shows: Hamaker constant, equilibrium distance, modulus and height of a strip are known to some ten per cent. Many strips are sampled
//! and peeled. The scatter of their peaks is compared with what one strip and its derivatives predict.
//!
//! Equations: with ln pᵢ = ln p₀ᵢ + σᵢ zᵢ, zᵢ normal, and sᵢ = d ln P/d ln pᵢ, to first order ln P is normal with the variance
//! Σ (sᵢ σᵢ)². The share of a parameter in it says what to measure better; Sobol's index is that share without the assumption of first order.
//!
//! What to try: a softer strip, whose peak depends less on the modulus; three times the scatter of the equilibrium distance: how far
//! does the first order hold?
//!
//!     cargo run --release --example what_is_uncertain
//!
//! writes out/examples/what_is_uncertain.svg and .png.

use peelkit::prelude::*;
use peelkit::study::uncertainty::*;
use peelkit::study::{PeelQuantity, Variation, sensitivities};
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Shape, Stroke, colour, save};
use peelkit_report::pictures::bars;
use std::{error::Error, f64::consts::PI, path::Path};

/// Name of a parameter, standard deviation σ of its logarithm, and where it is.
type Parameter = (&'static str, f64, fn(&mut StripModel) -> &mut f64);
const PARAMETERS: [Parameter; 4] = [
    ("equilibrium distance", 0.1, |model| &mut model.adhesion.equilibrium_distance),
    ("Hamaker constant", 0.2, |model| &mut model.adhesion.hamaker_constant),
    ("Young's modulus", 0.3, |model| &mut model.strip.material.youngs_modulus),
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
    let force = PeelQuantity::InitiationPeakForce;
    let own = peel(&strip(&[1.0; 4]), &Accuracy::to(1e-6), &StopCriteria::default());
    let median = force.value(&own).ok_or("no peak")?;
    let along = |k: usize, x: f64| strip(&std::array::from_fn::<f64, 4, _>(|j| if j == k { x.exp() } else { 1.0 }));
    let variations: Vec<Variation> = (0..4).map(|k| Variation::new(PARAMETERS[k].0, move |x| along(k, x))).collect();
    let derivatives = sensitivities(&own, &[force], &variations)?;
    let slope = |k: usize| derivatives.of(force, k).map_or(f64::NAN, |derivative| derivative.value / median);
    let first_order = (0..4).map(|k| (slope(k) * PARAMETERS[k].1).powi(2)).sum::<f64>().sqrt();

    // the inputs are the factors on the parameters
    let input = |&(name, log_deviation, _): &Parameter| Input {
        name: name.into(),
        distribution: Distribution::Lognormal { median: 1.0, log_deviation },
    };
    let inputs = PARAMETERS.iter().map(input).collect();
    let plan = Plan { inputs, correlations: Vec::new(), samples: 3840, seed: 1, indices: Indices::Estimated };
    let design = Design::new(plan)?;
    let (model, stop) = (|factors: &[f64]| Ok(strip(factors)), StopCriteria::default);
    let sampled = SampledPeel { model: &model, of: &[force], accuracy: &Accuracy::to(1e-6), stop: &stop };
    let run = |place| sampled.outcome(&design.inputs(place)).values[0];
    let peaks: Vec<Option<f64>> = sample(&design, &|| true, &run).into_iter().flatten().collect();
    let logarithms: Vec<Option<f64>> = peaks.iter().map(|peak| peak.map(f64::ln)).collect();
    let found = Statistics::of(&design, &logarithms, &[]).ok_or("no peaks")?;

    let mut text = format!("{:22} {:>14} {:>12} {:>14}\n", "p", "d ln P/d ln p", "share", "Sobol's index");
    let mut rows = Vec::new();
    for (k, index) in sobol_indices(&design, &logarithms).iter().enumerate() {
        let (name, share) = (PARAMETERS[k].0, (slope(k) * PARAMETERS[k].1 / first_order).powi(2));
        text += &format!("{name:22} {:>14.4} {share:>12.3} {:>14.3}\n", slope(k), index.first.value);
        rows.push((name, 100.0 * share));
    }
    text += &format!("first order: ln P scatters by {first_order:.4}\n{} samples: by ", found.count);
    text += &format!("{:.4}, with an error of {:.4}\n", found.deviation.value, found.deviation.error);

    let column = |k: usize| {
        let (from, to) = (COLUMN * k as f64, COLUMN * (k + 1) as f64);
        let count = peaks.iter().flatten().filter(|&&peak| peak >= from && peak < to).count() as f64;
        let high = 100.0 * count / peaks.len() as f64;
        Shape { corners: vec![(from, 0.0), (from, high), (to, high), (to, 0.0)], colour: colour::BLUE, opacity: 0.45 }
    };
    // the density of P where ln P is normal, times the width of a column
    let density = |force: f64| {
        let z = (force / median).ln() / first_order;
        (force, 100.0 * COLUMN * (-0.5 * z * z).exp() / ((2.0 * PI).sqrt() * first_order * force))
    };
    let points = (5..=80).map(|k| density(0.01 * f64::from(k))).collect();
    let line = Line::named("first order", points, Stroke::solid(colour::VERMILLION, 2.4));
    let (x, y) = (Axis::linear("initiation peak (nN)", 0.0, 0.8), Axis::linear("strips (%)", 0.0, 12.0));
    let mut left = Panel::of_lines(Frame { right: 450.0, ..Frame::across() }, x, y, vec![line]);
    left.shapes = (0..40).map(column).collect();
    let right = bars(Frame { left: 610.0, ..Frame::across() }, "share of the variance (%)", &rows);
    save(&Picture::of("What is uncertain of a peak force", vec![left, right]), folder, "what_is_uncertain")?;
    Ok(text)
}

/// The strip with its parameters times these factors.
fn strip(factors: &[f64]) -> PeelModel {
    let mut model = StripModel::of_the_paper(100.0, 1.0);
    PARAMETERS.iter().zip(factors).for_each(|((_, _, parameter), factor)| *parameter(&mut model) *= factor);
    model.into()
}
