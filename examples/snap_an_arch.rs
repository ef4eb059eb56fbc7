//! Presses a shallow arch at its crown until it has snapped through, and prints its limit points.
//!
//! A circular arch on two hinges; half of it is computed, with its crown held upright on the line of symmetry. The path goes
//! through both limit loads without stopping at either: between them the arch is unstable under a dead weight, and, if it
//! is slender enough, even under a prescribed displacement.
//!
//!     cargo run --release --example snap_an_arch

use peelkit::beam::{ReferenceCurve, Section};
use peelkit::model::{Drive, Hold, RodModel, Support};
use peelkit::solve::{Pace, PathOptions};
use peelkit::study::follow_rod;

/// Half the opening angle, rad, and half the length of the axis, nm.
const OPENING: f64 = 0.5;
const LENGTH: f64 = 100.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // height 12 nm, width 1 nm, E = 2 GPa, ν = 0.2
    let arch = RodModel {
        length: LENGTH,
        section: Section { axial: 24.0, shear: 24.0 * (5.0 / 6.0) / 2.4, bending: 288.0 },
        rest: ReferenceCurve::arc(OPENING, -OPENING / LENGTH),
        left: Support::HINGED,
        right: Support { x: Hold::Fixed, y: Hold::Free, rotation: Hold::Fixed },
        drive: Drive::Y,
    };
    let rise = arch.rest.at(LENGTH)[1];
    let options = PathOptions {
        elements: 8,
        step_tolerance: 1e-4,
        stride: 1.0,
        longest: None,
        prediction: 8,
        tolerance: 1e-10,
        first_displacement: -0.01 * rise,
        pace: Pace::Quick,
    };
    let problem = arch.problem(7)?;
    let path = follow_rod(&problem, options, 1000, |point| point.observables.displacement < -2.2 * rise)?;

    println!("an arch with a rise of {rise:.3} nm, pressed down at its crown: {} points", path.points.len());
    println!("{:>12} {:>14} {:>12} {:>10}", "limit of", "lowered / nm", "load / nN", "error / nN");
    for turn in &path.turns {
        // the half that is computed carries half the load
        let (at, error) = (turn.located.observables, turn.located.difference);
        let kind = format!("{:?}", turn.kind).to_lowercase();
        println!("{kind:>12} {:14.8} {:12.9} {:10.0e}", -at.displacement, -2.0 * at.force, 2.0 * error.force.abs());
    }
    Ok(())
}
