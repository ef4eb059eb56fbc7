//! The largest force against the rate of the pull, over five decades, of a strip of viscous material.
//!
//! What it shows: a strip of Kelvin and Voigt's material and one of a standard linear solid are pulled up at a rate. Slowly both peel at the peak of the
//! equilibria. The faster the pull, the more the dashpots carry; that of the standard linear solid gives way in the end, and its peak levels off.
//!
//! Equations: M dv/dt + R(q) + forces of the dashpots = P, followed by the generalised-α rule; dashpots τ C dε/dt, or g C (ε - e) with
//! de/dt = (ε - e)/τ. Work of the grip = stored + kinetic + adhesion + dissipated: the defect is printed.
//!
//! What to try: ten times the retardation time: the curve moves by a decade to the left and stays what it is. A density of 1e6 kg/m³: from which
//! rate on does inertia show? A stiffness ratio of 5.
//!
//!     cargo run --release --example pull_rate
//!
//! writes out/examples/pull_rate.svg and .png.

use peelkit::beam::Viscosity;
use peelkit::model::MovingMaterial;
use peelkit::prelude::*;
use peelkit::study::{PullRate, TimeAccuracy, Until, pull_in_time};
use peelkit_report::chart::{Axis, Frame, Line, Panel, Picture, Stroke, colour, save};
use std::{error::Error, path::Path};

/// τ, ns
const TIME: f64 = 1e3;

fn main() -> Result<(), Box<dyn Error>> {
    let model = StripModel::of_the_paper(100.0, 1.0);
    let statics = peel(&model, &Accuracy::to(1e-6), &StopCriteria::default());
    let peak = statics.initiation_peak.ok_or("no peak")?.force;
    println!("equilibria: {peak:.6} nN");
    let kelvin = Viscosity::KelvinVoigt { retardation_time: TIME };
    let solid = Viscosity::StandardLinearSolid { relaxation_time: TIME, stiffness_ratio: 2.0 };
    let mut lines = vec![Line::named("equilibria", vec![(1e-6, peak), (0.1, peak)], Stroke::dashed(colour::INK, 1.6))];
    for (name, viscosity, ink) in
        [("Kelvin-Voigt", kelvin, colour::BLUE), ("standard linear solid", solid, colour::VERMILLION)]
    {
        let material = MovingMaterial { density: 1300.0, viscosity, opening: None };
        let mut points = Vec::new();
        println!("{name}, {TIME} ns:  rate m/s   largest force nN   defect of the energy over the work");
        for k in 0..=10 {
            let rate = 1e-6 * 10f64.powf(0.5 * f64::from(k));
            let pull = PullRate { until: Until::Held(0.0), ..PullRate::new(1.0, rate) };
            let pulled = pull_in_time(&model.into(), &material, &pull, &TimeAccuracy::default(), None)
                .map_err(|failure| failure.why)?;
            println!("{rate:12.3e} {:12.6} {:12.1e}", pulled.largest_force(), pulled.balance_error());
            points.push((rate, pulled.largest_force()));
        }
        lines.push(Line::named(name, points, Stroke::solid(ink, 2.2)));
    }
    let (x, y) = (Axis::log("rate of the pull V (m/s)", 1e-6, 0.1), Axis::linear("largest force (nN)", 0.0, 1.6));
    let panel = Panel::of_lines(Frame::across(), x, y, lines);
    save(&Picture::of("Pull rate", vec![panel]), Path::new("out/examples"), "pull_rate")?;
    Ok(())
}
