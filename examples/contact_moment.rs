//! What the contact moment does: without it, adhesion does less work than it should.
//!
//! What it shows: the ground pulls a tilted section with a force and a moment. Three line loads are compared over the bending stiffness: both;
//! the force alone; and the traction at the gap below the axis, which is independent of the section's rotation and has no moment.
//!
//! Equations: with the potential Ψ(y, θ) per length and width T_c = -∂Ψ/∂y and M_c = -∂Ψ/∂θ. To peel a unit of length off takes
//! ∫ (Ψ_y y' + Ψ_θ θ') dS = w, the work of adhesion, so that P + P²/(2EA) = w b. Leave M_c out, and only ∫ Ψ_y y' dS remains:
//! P + P²/(2EA) = w b - b ∫ Ψ_θ θ' dS. The integral depends on how sharply the strip bends.
//!
//! What to try: a thinner strip. The moment of one face is T_c (h/2) sin θ: when does it matter little?
//!
//!     cargo run --release --example contact_moment
//!
//! writes out/examples/contact_moment.svg and .png.

use peelkit::analytic::steady_force;
use peelkit::prelude::*;
use peelkit::study::{BeamState, SectionFields, StateSections, sweep};
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
    let strip = strip(1.0, LineLoad::Full);
    let (rest, axial) = (strip.line_law().rest_energy(), strip.section().axial);
    let kendall = steady_force(rest, axial);
    let factors: Vec<f64> = (0..=7).map(|k| 10f64.powf(-3.5 + 0.5 * f64::from(k))).collect();
    let loads = [LineLoad::Full, LineLoad::AxisGap, LineLoad::ForceOnly];
    let names = ["force and moment", "at the gap of the axis", "force without moment"];
    let cases: Vec<_> = loads.iter().flat_map(|&load| factors.iter().map(move |&factor| (factor, load))).collect();
    let peels = sweep(&cases, &|| true, &|&(factor, load)| {
        peel(&self::strip(factor, load), &Accuracy::to(1e-5), &StopCriteria::default())
    });

    let over = |force: f64| force / kendall;
    let word = |number: Option<f64>| number.map_or("none".into(), |number| format!("{:.5}", over(number)));
    let mut text = String::from("Plateau over Kendall's force, and what the missing work makes of it:\n");
    text += &format!("{:>8} {:>18} {:>22} {:>10}\n", "EI/EI0", names[0], names[2], "estimate");
    for (factor, k) in factors.iter().zip(0..) {
        let [full, force_only] = [&peels[k], &peels[2 * factors.len() + k]];
        let plateau = |peel: &Peel| word(peel.plateau.map(|plateau| plateau.force));
        let estimate = word(missing_work(force_only).map(|work| steady_force(rest + work, axial)));
        text += &format!("{factor:>8.5} {:>18} {:>22} {estimate:>10}\n", plateau(full), plateau(force_only));
    }

    let strokes =
        [Stroke::solid(colour::BLUE, 2.4), Stroke::dashed(colour::GREEN, 2.4), Stroke::solid(colour::VERMILLION, 2.4)];
    let lines = |of: &dyn Fn(&Peel) -> Option<f64>| -> Vec<Line> {
        let line = |k: usize| {
            let row = &peels[k * factors.len()..(k + 1) * factors.len()];
            let points = factors.iter().zip(row).filter_map(|(&factor, peel)| Some((factor, over(of(peel)?))));
            Line::named(names[k], points.collect(), strokes[k])
        };
        (0..3).map(line).collect()
    };
    let x = || Axis::log("bending stiffness EI / EI₀", factors[0], factors[7]);
    let peaks = lines(&|peel| Some(peel.initiation_peak?.force));
    let left = Panel::of_lines(Frame::column(0, 2), x(), Axis::log("initiation peak / Kendall", 1.0, 20.0), peaks);
    let plateaus = lines(&|peel| Some(peel.plateau?.force));
    let right = Panel::of_lines(Frame::column(1, 2), x(), Axis::linear("plateau / Kendall", 0.0, 1.2), plateaus);
    save(&Picture::of("What the contact moment does", vec![left, right]), folder, "contact_moment")?;
    Ok(text)
}

fn strip(factor: f64, load: LineLoad) -> StripModel {
    let mut model = StripModel::of_the_paper(LENGTH, factor);
    model.adhesion.line_load = load;
    model
}

/// b ∫ Ψ_θ θ' dS at the plateau, nN: the work that the pull is spared without the contact moment.
fn missing_work(peel: &Peel) -> Option<f64> {
    let plateau = peel.plateau?;
    let away =
        |state: &BeamState| (state.displacement / plateau.displacement - 1.0).hypot(state.force / plateau.force - 1.0);
    let states = peel.states(200);
    let state = states.iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
    let StateSections::Planar(sections) = &state.sections else { return None };
    let law = peel.model.line_law();
    let moment = |at: &SectionFields| {
        let (sin, cos) = at.rotation.sin_cos();
        law.response(at.y - 0.5 * at.height, sin, cos).energy_by_rotation
    };
    Some(sections.iter().map(|at| at.weight * at.width * moment(at) * at.curvature).sum())
}
