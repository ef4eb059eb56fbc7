//! The pull-off of a spatula as a solid in space: its curve on two meshes, its peak on stations of 1 nm, and what they cost.
//!
//!     cargo run --release --example solid_spatula            # the beginning of the curve, up to u = 25 nm, on one mesh
//!     cargo run --release --example solid_spatula -- curve   # up to u = 250 nm, on two
//!     cargo run --release --example solid_spatula -- peak    # and on to the peak

use peelkit::model::{FineZone, Hold, PeelModel, SolidSpatulaSettings, Spatula};
use peelkit::solid::spatula::SolidSpatula;
use peelkit::solve::{Coefficients, System, Workspace};
use peelkit::study::{SolidPull, SolidPullPoint};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

/// Where the curve is told, nm.
const CURVE: [f64; 6] = [25.0, 50.0, 100.0, 150.0, 200.0, 250.0];
/// Longest step between, nm.
const STEP: f64 = 50.0;
/// Where the stations at the tip become fine, how far from the tip, how close they are and how far the peak is looked for, nm.
const REFINED_AT: f64 = 345.0;
const ZONE: FineZone = FineZone { from: 0.0, to: 80.0, along: 1.0 };
const FARTHEST: f64 = 380.0;

/// What a mesh costs.
fn cost(name: &str, spatula: &SolidSpatula) -> Result<(), Box<dyn Error>> {
    let (mut ws, rest) = (Workspace::default(), spatula.at_rest());
    spatula.factorise(&rest, Coefficients::STATIC, [1.0, 0.0], &mut ws)?;
    let begun = Instant::now();
    spatula.factorise(&rest, Coefficients::STATIC, [1.0, 0.0], &mut ws)?;
    let seconds = begun.elapsed().as_secs_f64();
    let (elements, unknowns, megabytes) =
        (spatula.elements(), spatula.unknowns(), 8e-6 * spatula.factor_numbers() as f64);
    println!(
        "{name}: {elements} elements, {unknowns} unknowns, {megabytes:.0} MB of factors, {seconds:.3} s a factorisation"
    );
    Ok(())
}

fn show(name: &str, point: &SolidPullPoint, pull: &SolidPull, begun: Instant) {
    let SolidPullPoint { displacement, force, slope, front, .. } = point;
    let all: usize = pull.points().iter().map(|point| point.eliminations).sum();
    let jumps = pull.points().iter().filter(|point| point.jumped).count();
    let seconds = begun.elapsed().as_secs_f64();
    println!(
        "{name} u {displacement:.3} nm  P {force:.5} nN  dP/du {slope:+.5}  front {front:.1} nm  {all} factorisations, {jumps} relaxations, {seconds:.0} s"
    );
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = std::env::args().nth(1);
    let mut model: PeelModel = Spatula::default().model();
    model.grip.rotation = Hold::Fixed;
    model.adhesion.far_face = false;
    let settings = SolidSpatulaSettings::default();
    let coarse = Arc::new(settings.spatula(&model)?);
    cost("4 nm", &coarse)?;
    let begun = Instant::now();
    let mut pull = SolidPull::new(coarse, None)?;
    show("4 nm", pull.here(), &pull, begun);
    let Some(asked) = asked else {
        let point = *pull.to(CURVE[0], STEP)?;
        show("4 nm", &point, &pull, begun);
        return Ok(());
    };
    let fine = Arc::new(SolidSpatulaSettings { pad: 2.0, neck: 2.0, ..settings }.spatula(&model)?);
    let at_tip = Arc::new(SolidSpatulaSettings { fine: Some(ZONE), ..settings }.spatula(&model)?);
    cost("2 nm", &fine)?;
    cost("1 nm at the tip", &at_tip)?;
    for u in CURVE {
        let point = *pull.to(u, STEP)?;
        show("4 nm", &point, &pull, begun);
        let finer = pull.on(fine.clone())?;
        show("2 nm", finer.here(), &finer, begun);
    }
    if asked == "peak" {
        let point = *pull.to(REFINED_AT, STEP)?;
        show("4 nm", &point, &pull, begun);
        let mut finer = pull.on(at_tip)?;
        show("1 nm", finer.here(), &finer, begun);
        let peak = finer.peak(1.0, FARTHEST);
        finer.points().iter().for_each(|point| show("1 nm", point, &finer, begun));
        show("peak", &peak?, &finer, begun);
    }
    Ok(())
}
