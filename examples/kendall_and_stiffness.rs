//! Kendall's force and the bending stiffness: adhesion holds a strip while it peels, stiffness decides when peeling begins.
//!
//! What it shows: a strip on a flat half space is lifted at its end. Two forces are drawn against its bending stiffness EI: the
//! initiation peak, at which peeling begins, and the plateau, at which it goes on.
//!
//! Equations: at 90 degrees Kendall's force P solves P + P²/(2EA) = w b, with the work of adhesion w and the width b; EI does not enter.
//! At the peak the pull is spread over the length ℓ = (EI/k)^(1/4) of a beam on a foundation of the stiffness k: the peak grows
//! like EI^(1/4), until the strip shears rather than bends.
//!
//! What to try: `model.adhesion.line_load = LineLoad::AxisGap`, in which tilted sections are pulled as if they lay flat: the peaks of soft
//! strips come down towards Kendall's force. A longer strip: the plateau reaches to larger stiffnesses.
//!
//!     cargo run --release --example kendall_and_stiffness
//!
//! writes out/examples/kendall_and_stiffness.svg and .png.

use peelkit::prelude::*;
use peelkit::study::{PeelResult, sweep};
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Stroke, colour, save};
use std::{error::Error, path::Path};

/// nm
const LENGTH: f64 = 200.0;

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", draw(Path::new("out/examples"))?);
    Ok(())
}

/// Draws the picture in a folder, and gives the text to print.
pub fn draw(folder: &Path) -> Result<String, Box<dyn Error>> {
    let strip = PeelModel::from(StripModel::of_the_paper(LENGTH, 1.0)).derived();
    let kendall = strip.section.ok_or("the section varies")?.kendall_force;
    let factors: Vec<f64> = (0..=16).map(|k| 10f64.powf(-4.0 + 0.5 * f64::from(k))).collect();
    // with a large shear correction a strip bends and does not shear
    let (shearing, rigid) = (peels(&factors, 5.0 / 6.0), peels(&factors, 1e6));

    let peak = |peel: &PeelResult| peel.initiation_peak.map(|peak| peak.force / kendall);
    let plateau = |peel: &PeelResult| {
        // a stiff strip tilts on its edge: its force may be level then, but it does not peel
        let peels = peel.plateau_front.is_some_and(|front| front > 0.01 * LENGTH);
        peel.plateau.filter(|_| peels).map(|plateau| plateau.force / kendall)
    };
    let curve = |peels: &[PeelResult], of: &dyn Fn(&PeelResult) -> Option<f64>| -> Vec<(f64, f64)> {
        factors.iter().zip(peels).filter_map(|(&factor, peel)| Some((factor, of(peel)?))).collect()
    };

    let word = |number: Option<f64>| number.map_or("none".into(), |number| format!("{number:.5}"));
    let mut text = format!("Kendall's force is {kendall:.6} nN. In units of it:\n");
    text += &format!("{:>8} {:>10} {:>10} {:>16}\n", "EI/EI0", "peak", "plateau", "peak, no shear");
    for k in [0, 4, 8, 12, 16] {
        let (factor, all) = (factors[k], [peak(&shearing[k]), plateau(&shearing[k]), peak(&rigid[k])].map(word));
        text += &format!("{factor:>8} {:>10} {:>10} {:>16}\n", all[0], all[1], all[2]);
    }
    let growth = peak(&rigid[16]).zip(peak(&rigid[8])).map(|(last, first)| (last / first).log10() / 4.0);
    text += &format!("Without shear the peak grows like EI to the power {} from EI/EI0 = 1 on.\n", word(growth));

    let quarter = [1.0, 3e3].map(|f: f64| (f, 20.0 * f.powf(0.25))).to_vec();
    let lines = vec![
        Line::named("initiation peak", curve(&shearing, &peak), Stroke::solid(colour::BLUE, 2.4)),
        Line::named("the same without shear", curve(&rigid, &peak), Stroke::solid(colour::ORANGE, 2.4)),
        Line::named("plateau", curve(&shearing, &plateau), Stroke::solid(colour::VERMILLION, 4.0)),
        Line::named("Kendall's force", vec![(1e-4, 1.0), (1e4, 1.0)], Stroke::dotted(colour::INK, 2.0)),
        Line::named("slope 1/4", quarter, Stroke::dashed(colour::GREY, 1.6)),
    ];
    let x = Axis::log("bending stiffness EI / EI₀", 1e-4, 1e4);
    let y = Axis::log("force P / Kendall's force", 0.7, 250.0);
    let picture = Picture::of("Kendall and stiffness", vec![Panel::of_lines(Frame::across(), x, y, lines)]);
    save(&picture, folder, "kendall_and_stiffness")?;
    Ok(text)
}

/// A peel for each factor on EI, on all cores.
fn peels(factors: &[f64], shear_correction: f64) -> Vec<PeelResult> {
    sweep(factors, &|| true, &|&factor| {
        let mut model = StripModel::of_the_paper(LENGTH, factor);
        model.strip.material.shear_correction = shear_correction;
        PeelResult::from(&peel(&model, &Accuracy::to(1e-6), &StopCriteria::default()))
    })
}
