//! The best stiffness: which strip takes the most work to tear off?
//!
//! What it shows: the work of a pull up to the jump, at which the strip comes off, against its bending stiffness. It has a maximum: neither a
//! soft tape nor a stiff plate takes the most work.
//!
//! Equations: until the jump nothing is lost. The work of the grip is W = ΔΨ + U, the adhesion that has been overcome and the elastic
//! energy. A soft tape peels to its end, ΔΨ = w b L, and stores next to nothing. A stiffer strip stores more, but jumps while more of it
//! still adheres. If the jump takes the strip off, it dissipates what W is above w b L.
//!
//! What to try: a length of 100 nm; a grip that holds the rotation, `model.grip.rotation = Hold::Fixed`.
//!
//!     cargo run --release --example best_stiffness
//!
//! writes out/examples/best_stiffness.svg and .png.

use peelkit::prelude::*;
use peelkit::study::optimisation::{
    DesignProblem, DesignVariable, Goal, NumberBy, Objective, OptimisationOptions, optimise,
};
use peelkit::study::{BeamState, LimitPointKind, PeelQuantity, SectionFields, StateSections, sweep};
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, colour, save};
use std::{error::Error, path::Path};

/// nm
const LENGTH: f64 = 200.0;

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", draw(Path::new("out/examples"))?);
    Ok(())
}

/// Draws the picture in a folder, and gives the text to print.
pub fn draw(folder: &Path) -> Result<String, Box<dyn Error>> {
    let all: Vec<AtJump> = at_jump((0..=24).map(|k| -3.0 + 0.2 * f64::from(k)));
    let best = all.iter().max_by(|a, b| a.work.total_cmp(&b.work)).ok_or("no strip jumps")?;
    let top = at_jump([best_decade(best)?]).pop().ok_or("the best strip does not jump")?;

    // w b L: what a tape without stiffness takes
    let tape = -LENGTH * StripModel::of_the_paper(LENGTH, 1.0).line_law().rest_energy();
    let mut text = format!("energies at the jump over w b L = {tape:.5} aJ\n");
    text += &format!("{:>10} {:>8} {:>9} {:>8}\n", "EI/EI0", "work", "adhesion", "elastic");
    for at in all.iter().step_by(5).chain([&top]) {
        let [work, adhesion, elastic] = [at.work, at.adhesion, at.elastic].map(|energy| energy / tape);
        text += &format!("{:>10.4} {work:>8.4} {adhesion:>9.4} {elastic:>8.4}\n", at.factor());
    }
    text += &format!("The last is the best stiffness: {:.3} of the strip's own.\n", top.factor());

    let line = |name, of: fn(&AtJump) -> f64, stroke| {
        Line::named(name, all.iter().map(|at| (at.factor(), of(at) / tape)).collect(), stroke)
    };
    let lines = vec![
        line("work up to the jump", |at| at.work, Stroke::solid(colour::GREEN, 2.6)),
        line("adhesion overcome", |at| at.adhesion, Stroke::dashed(colour::VERMILLION, 2.2)),
        line("elastic energy", |at| at.elastic, Stroke::dashed(colour::BLUE, 2.2)),
    ];
    let note = format!("largest at EI = {:.2} EI₀", top.factor());
    let marks = vec![Mark::labelled((top.factor(), top.work / tape), colour::INK, &[&note])];
    let x = Axis::log("bending stiffness EI / EI₀", 1e-3, 1e2);
    let panel = Panel::of_lines(Frame::across(), x, Axis::linear("energy / (w b L)", 0.0, 1.4), lines);
    save(&Picture::of("The best stiffness", vec![Panel { marks, ..panel }]), folder, "best_stiffness")?;
    Ok(text)
}

/// Where the work is largest: the search begins at a strip that is near to that.
fn best_decade(near: &AtJump) -> Result<f64, Box<dyn Error>> {
    let problem = DesignProblem {
        objective: Objective::Quantity(PeelQuantity::FirstJumpWork),
        goal: Goal::Maximise,
        variables: vec![DesignVariable::new("bending stiffness", 0.2 * near.factor(), 5.0 * near.factor())],
        constraints: Vec::new(),
        model: Box::new(|values| Some(StripModel::of_the_paper(LENGTH, values[0]).into())),
        number: NumberBy::Peel,
        start: vec![near.factor()],
    };
    let options = OptimisationOptions { starts: 1, neighbours: 0, ..OptimisationOptions::to(Accuracy::to(1e-6)) };
    Ok(optimise(&problem, &options)?.after.values[0].log10())
}

/// Energies at the first turning point of the displacement, aJ, of a strip with 10^`decade` times the bending stiffness.
#[derive(Clone, Copy)]
struct AtJump {
    decade: f64,
    work: f64,
    adhesion: f64,
    elastic: f64,
}

impl AtJump {
    fn factor(&self) -> f64 {
        10f64.powf(self.decade)
    }
}

/// Those of strips that jump.
fn at_jump(decades: impl IntoIterator<Item = f64>) -> Vec<AtJump> {
    let run = |&decade: &f64| {
        let model = StripModel::of_the_paper(LENGTH, 10f64.powf(decade));
        let peel = peel(&model, &Accuracy::to(1e-6), &StopCriteria::default());
        let states = peel.states(2);
        let jump = states.iter().find(|state| state.limit_point == Some(LimitPointKind::Displacement))?;
        let adhesion = |state| integral(state, |section| section.adhesion_energy);
        let elastic = integral(jump, |section| section.stored_energy);
        Some(AtJump { decade, work: peel.snap_off?.work, adhesion: adhesion(jump) - adhesion(&states[0]), elastic })
    };
    sweep(&decades.into_iter().collect::<Vec<_>>(), &|| true, &run).into_iter().flatten().collect()
}

/// ∫ of a field along the beam.
fn integral(state: &BeamState, field: fn(&SectionFields) -> f64) -> f64 {
    let StateSections::Planar(sections) = &state.sections else { return 0.0 };
    sections.iter().map(|section| section.weight * field(section)).sum()
}
