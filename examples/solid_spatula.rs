//! The pull-off of a spatula as a solid in space, beside the same spatula as a beam.
//!
//!     cargo run --release --example solid_spatula              # the beginning of the curve, up to u = 25 nm
//!     cargo run --release --example solid_spatula -- peak      # up to the first jump, with the errors of peak and jump: minutes
//!     cargo run --release --example solid_spatula -- peak 1    # the same on stations of 1 nm

use peelkit::model::{Hold, PeelModel, SolidSettings, Spatula};
use peelkit::study::{Accuracy, FollowedUntil, SolidLimitPoint, SolidOptions, StopCriteria, peel, peel_solid};
use std::error::Error;
use std::time::Instant;

/// How far the beginning goes, nm.
const BEGINNING: f64 = 25.0;

fn show(what: &str, at: Option<&SolidLimitPoint>) {
    let Some(SolidLimitPoint { displacement, force, errors, .. }) = at else { return };
    let error = errors.map_or("without a bound".to_owned(), |errors| format!("± {:.1e}", errors.force));
    println!("{what}: P {force:.5} nN {error} at u {displacement:.3} nm");
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut asked = std::env::args().skip(1);
    let whole = asked.next().is_some_and(|word| word == "peak");
    let usual = SolidSettings::default();
    let along = asked.next().map_or(Ok(usual.along), |word| word.parse())?;
    let mut model: PeelModel = Spatula::default().model();
    model.grip.rotation = Hold::Fixed;
    model.adhesion.far_face = false;
    let stop = match whole {
        true => StopCriteria { until: FollowedUntil::FirstJump, ..StopCriteria::default() },
        false => StopCriteria::up_to(BEGINNING),
    };
    let begun = Instant::now();
    let options = SolidOptions { stop: stop.clone(), ..SolidOptions::default() };
    let solid = peel_solid(&model, &SolidSettings { along, ..usual }, &options)?;
    let seconds = begun.elapsed().as_secs_f64();
    let (elements, unknowns) = (solid.body.elements(), solid.body.unknowns());
    println!("solid: {elements} elements, {unknowns} unknowns, {} iterations, {seconds:.0} s", solid.iterations);
    show("peak of the solid", solid.peak());
    show("first jump of the solid", solid.snap_off());
    let beam = peel(&model, &Accuracy::to(1e-4), &stop);
    if let Some(last) = solid.points.last().filter(|_| !whole) {
        println!("solid: P {:.5} nN at u {:.3} nm", last.force, last.displacement);
    }
    if let Some(last) = beam.points.last().filter(|_| !whole) {
        println!("beam:  P {:.5} nN at u {:.3} nm", last.force, last.displacement);
    }
    if let Some(peak) = beam.peak {
        println!("peak of the beam: P {:.5} nN at u {:.3} nm", peak.force, peak.displacement);
    }
    Ok(())
}
