//! The pull-off of a gecko's spatula: a pad holds by the length of its front, not by its area.
//!
//! What it shows: a spatula, a thin pad on a thicker shaft, is lifted by its shaft. It peels from the root of the pad to its tip, which is the
//! widest place; the largest force comes last. A pad with a wider tip holds more, a longer one does not.
//!
//! Equations: a front of the width b holds P ≈ w b, w ∝ A_H/r0². If that were all, d ln P/d ln p were 1 for the width and for A_H, -2 for
//! r0, and 0 for everything else. What is left is bending: it spreads the pull over more than a line.
//!
//! What to try: a pad of constant width, `body.neck_width = 200.0`: where is the peak then? A shaft that stands upright,
//! `body.shaft_angle = FRAC_PI_2`; the modulus of the pad, 1 to 4 GPa.
//!
//!     cargo run --release --example spatula_pull_off
//!
//! writes out/examples/spatula_pull_off.svg and .png.

use peelkit::prelude::*;
use peelkit::study::{Exponent, PeelQuantity, Variation, sensitivities, sweep};
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, Symbol, colour, save};
use peelkit_report::pictures::bars;
use std::{error::Error, path::Path};

/// What is varied, and d ln P/d ln p of P = w b.
const PARAMETERS: [(&str, f64); 6] = [
    ("tip width", 1.0),
    ("Hamaker constant", 1.0),
    ("equilibrium distance", -2.0),
    ("pad thickness", 0.0),
    ("pad length", 0.0),
    ("Young's modulus", 0.0),
];

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", draw(Path::new("out/examples"))?);
    Ok(())
}

/// Draws the picture in a folder, and gives the text to print.
pub fn draw(folder: &Path) -> Result<String, Box<dyn Error>> {
    let (force, whole) = (PeelQuantity::PeakForce, pulled("tip width", 1.0));
    let variations: Vec<Variation> =
        PARAMETERS.iter().map(|&(name, _)| Variation::new(name, move |x| spatula(name, x.exp()))).collect();
    let exponents = sensitivities(&whole, &[force], &variations)?.exponents(&whole);
    let parameter = |exponent: &Exponent| PARAMETERS[exponent.variation];
    let mut text = format!("{:22} {:>14} {:>9}\n", "p", "d ln P/d ln p", "of w b");
    for exponent in &exponents {
        let (name, estimate) = parameter(exponent);
        text += &format!("{name:22} {:>14.4} {estimate:>9}\n", exponent.value);
    }

    let curves = [
        ("as it is", "tip width", 1.0, colour::BLUE),
        ("tip wider by a quarter", "tip width", 1.25, colour::VERMILLION),
        ("pad longer by a quarter", "pad length", 1.25, colour::GREEN),
        ("pad thicker by a quarter", "pad thickness", 1.25, colour::ORANGE),
    ];
    let peels = sweep(&curves, &|| true, &|&(_, parameter, factor, _)| pulled(parameter, factor));
    let (mut lines, mut marks) = (Vec::new(), Vec::new());
    for ((name, _, _, ink), peel) in curves.iter().zip(&peels) {
        let stable = peel.dense_curve(8).into_iter().take_while(|at| at.2 == 0);
        lines.push(Line::named(name, stable.map(|(u, force, _)| (u, force)).collect(), Stroke::solid(*ink, 2.2)));
        let at = peel.peak.ok_or("no peak")?;
        marks.push(Mark::labelled((at.displacement, at.force), *ink, &[&format!("{:.2} nN", at.force)]));
    }
    let (x, y) = (Axis::linear("displacement u (nm)", 0.0, 500.0), Axis::linear("force P (nN)", 0.0, 9.0));
    let left = Panel { marks, ..Panel::of_lines(Frame { right: 415.0, ..Frame::across() }, x, y, lines) };
    let rows: Vec<(&str, f64)> = exponents.iter().map(|exponent| (parameter(exponent).0, exponent.value)).collect();
    let estimate = |(row, exponent): (usize, &Exponent)| {
        let at = (parameter(exponent).1, (rows.len() - 1 - row) as f64);
        Mark { symbol: Symbol::Diamond, ..Mark::dot(at, colour::INK) }
    };
    let (marks, title) = (exponents.iter().enumerate().map(estimate).collect(), "diamonds: if P were w b".into());
    let x = Axis::linear("d ln P / d ln p", -2.3, 1.5);
    let right = bars(Frame { left: 570.0, ..Frame::across() }, "", &rows);
    let right = Panel { marks, title, x, ..right };
    save(&Picture::of("Spatula pull-off", vec![left, right]), folder, "spatula_pull_off")?;
    Ok(text)
}

/// The spatula with a parameter multiplied.
fn spatula(parameter: &str, factor: f64) -> PeelModel {
    let (mut body, mut adhesion) = (Spatula::default(), Adhesion::default());
    match parameter {
        "tip width" => body.tip_width *= factor,
        "pad thickness" => body.pad_thickness *= factor,
        "pad length" => body.pad_length *= factor,
        "Young's modulus" => body.material.youngs_modulus *= factor,
        "Hamaker constant" => adhesion.hamaker_constant *= factor,
        _ => adhesion.equilibrium_distance *= factor,
    }
    PeelModel { adhesion, ..body.model() }
}

/// Its peel.
fn pulled(parameter: &str, factor: f64) -> Peel {
    peel(&spatula(parameter, factor), &Accuracy::to(1e-6), &StopCriteria::default())
}
