//! The strip of 100 nm as a plane solid: its first peak, its limit points, and the force in steady peeling, with errors by a finer mesh.
//!
//!     cargo run --release --example solid_peel [-- ELEMENT [ALONG THROUGH [rigid]]]
//!
//! ELEMENT is Q1C1 to Q1C8, Q1CH, H1(2), Q(4,4) and so on, ALONG the length of an element in nm, THROUGH the number of rows. With `rigid` the end
//! face is rigid, as that of a beam; else a parabolic shear traction pulls at it. Only the contact face adheres.

use peelkit::model::{PeelModel, SolidSettings, StripModel};
use peelkit::solid::{SolidElement, SolidGrip};
use peelkit::study::{SolidOptions, StationAt, StationQuantity, StopCriteria, peel_solid};
use std::error::Error;
use std::time::Instant;

/// Displacements at which the force is asked for, nm.
const STATIONS: [f64; 7] = [5.0, 8.0, 10.0, 15.0, 20.0, 30.0, 40.0];

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut settings = SolidSettings { grip: SolidGrip::Parabolic, ..SolidSettings::default() };
    if let Some(name) = words.first() {
        settings.element = SolidElement::named(name).ok_or("no such element")?;
    }
    if let [_, along, through, ..] = &words[..] {
        (settings.along, settings.through) = (along.parse()?, through.parse()?);
    }
    if words.iter().any(|word| word == "rigid") {
        settings.grip = SolidGrip::Rigid;
    }
    let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
    model.adhesion.far_face = false;
    if let Some(long) = settings.long_elements(&model) {
        println!(
            "elements of {} nm, and a process zone of {:.2} nm: the force oscillates",
            long.along, long.process_length
        );
    }
    let at = |value| StationAt { quantity: StationQuantity::Displacement, value }.into();
    let stop = StopCriteria { events: STATIONS.map(at).to_vec(), ..StopCriteria::default() };
    let options = SolidOptions { stop, ..SolidOptions::default() };
    let begun = Instant::now();
    let peel = peel_solid(&model, &settings, &options)?;
    println!(
        "{} of {} nm in {} rows: {} unknowns, {} points, {} iterations, {} limit points, {:.2} s",
        settings.element,
        settings.along,
        settings.through,
        peel.body.unknowns(),
        peel.points.len(),
        peel.iterations,
        peel.limit_points.len(),
        begun.elapsed().as_secs_f64(),
    );
    for point in peel.limit_points.iter().take(7) {
        print!("limit point of the {:<12} u = {:10.6} nm  P = {:.7} nN", point.kind, point.displacement, point.force);
        match point.errors {
            Some(errors) if errors.confirmed => {
                println!("  ± {:.1e} nm  ± {:.1e} nN", errors.displacement, errors.force)
            }
            Some(errors) => {
                println!("  ± {:.1e} nm  ± {:.1e} nN, not on the finer mesh", errors.displacement, errors.force)
            }
            None => println!(),
        }
    }
    for station in &peel.stations {
        print!("u = {:4.1} nm  P = {:.6} nN", station.point.displacement, station.point.force);
        println!("{}", station.force_error.map_or(String::new(), |error| format!("  ± {error:.1e}")));
    }
    println!("it ended: {:?}; left out: {}", peel.end, peel.left_out.len());
    Ok(())
}
