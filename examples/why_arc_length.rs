//! Why arc length: where the force or the displacement turns back, a computation that prescribes it loses the strip.
//!
//! What it shows: the equilibria of one strip, computed in three ways. The force is raised; the displacement is raised; or a step is taken
//! along the curve, whichever way that goes.
//!
//! Equations: equilibrium R(q, P) = 0 is one equation short. It is completed by P = P₁ (force control), by u(q) = u₁ (displacement
//! control), or by t·(z - z₀) = Δs with the tangent t of the curve at its last point z₀ (arc length). At a load limit point, dP/ds = 0,
//! the first of the three systems is singular; at a displacement limit point, du/ds = 0, the second is; the third is regular at both.
//!
//! What to try: a strip of 20 nm and one of 400 nm: how much of the curve does displacement control miss? Is any of it found on the way
//! back, when the displacement is lowered (`study::observed`)?
//!
//!     cargo run --release --example why_arc_length
//!
//! writes out/examples/why_arc_length.svg and .png.

use peelkit::prelude::*;
use peelkit::solve::{Observables, controlled};
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, colour, save};
use std::{error::Error, path::Path};

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", draw(Path::new("out/examples"))?);
    Ok(())
}

/// Draws the picture in a folder, and gives the text to print.
pub fn draw(folder: &Path) -> Result<String, Box<dyn Error>> {
    let model = StripModel::of_the_paper(100.0, 1.0);
    let path = peel(&model, &Accuracy::to(1e-6), &StopCriteria::default());
    let (peak, turn) = path.initiation_peak.zip(path.snap_off).ok_or("no peak or no turning point")?;
    let loaded = raised(&model, Observables::FORCE, 0.02)?;
    let moved = raised(&model, Observables::DISPLACEMENT, 2.0)?;

    let last = |points: &[(f64, f64)]| points.last().copied().unwrap_or_default();
    let mut text = format!("force control reaches P = {:.2} nN; ", last(&loaded).1);
    text += &format!("the load limit point is at u = {:.6} nm, P = {:.6} nN\n", peak.displacement, peak.force);
    text += &format!("displacement control reaches u = {:.0} nm; ", last(&moved).0);
    text += &format!("the displacement limit point is at u = {:.5} nm, P = {:.7} nN\n", turn.displacement, turn.force);
    text += &format!("arc length passes {} limit points ", path.limit_points.len());
    text += &format!("and goes on to u = {:.3} nm\n", path.points.last().map_or(0.0, |point| point.displacement));

    // stable and unstable parts of the curve, each up to where the stability changes
    let dense = path.dense_curve(20);
    let stroke = |negative: usize| match negative {
        0 => Stroke::solid(colour::BLUE, 2.2),
        _ => Stroke::dashed(colour::VERMILLION, 2.2),
    };
    let part = |part: &[(f64, f64, usize)]| {
        let points = part.iter().map(|&(u, p, _)| (u, p)).collect();
        Line::plain(points, stroke(part[0].2))
    };
    let mut lines: Vec<Line> = dense.chunk_by(|a, b| a.2.min(1) == b.2.min(1)).map(part).collect();
    lines.push(Line::named("arc length: stable", Vec::new(), stroke(0)));
    lines.push(Line::named("arc length: unstable", Vec::new(), stroke(1)));
    let marks = |points: &[(f64, f64)], name: &str, ink| -> Vec<Mark> {
        points.iter().map(|&at| Mark { name: Some(name.into()), ..Mark::dot(at, ink) }).collect()
    };
    let panel = |index, x, marks| {
        let y = Axis::linear("force P (nN)", 0.0, 0.38);
        Panel { marks, ..Panel::of_lines(Frame::column(index, 2), x, y, lines.clone()) }
    };
    let first =
        panel(0, Axis::linear("displacement u (nm)", 0.0, 1.0), marks(&loaded, "force control", colour::ORANGE));
    let whole = Axis::linear("displacement u (nm)", 0.0, 60.0);
    let second = panel(1, whole, marks(&moved, "displacement control", colour::INK));
    save(&Picture::of("Three ways along one curve", vec![first, second]), folder, "why_arc_length")?;
    Ok(text)
}

/// Displacement (nm) and force (nN) of the equilibria at which what is weighed is raised step by step, until there is none.
fn raised(model: &StripModel, weights: Observables, step: f64) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let problem = model.problem(Form::TwoField, 7)?;
    let (mut at, mut found) = (problem.initial(28), Vec::new());
    for k in 1..200 {
        let Ok(solved) = controlled(&problem, at.clone(), weights, &[f64::from(k) * step], 1e-9) else { break };
        let Some(solution) = solved.into_iter().last() else { break };
        found.push((solution.observables.displacement, solution.observables.force));
        at = solution.at;
    }
    Ok(found)
}
