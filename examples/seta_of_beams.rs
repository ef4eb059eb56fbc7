//! A seta whose spatulae are beams that adhere, pulled off as one structure, beside the same seta whose tips follow the table of their spatula.
//!
//!     cargo run --release --example seta_of_beams [forks=n] [elements=n] [order=p]
//!
//! The last branches of the default seta with 2 tips unless told otherwise; `forks=4` has 16. Elements are those of a spatula.

use peelkit::model::{PeelModel, Seta, SetaMesh, SetaModel, SetaOfBeams, Sideways, Spatula, TipLaw};
use peelkit::solve::{Pace, PathOptions};
use peelkit::study::coarsening::{CoarseningOptions, GrowingTable, PadEnd, TipRange, coarsen, pull_off_by_table};
use peelkit::study::{
    BeamsProgress, SetaLoading, SetaOptions, SetaPullOff, SetaState, StopCriteria, peak_of_beams_on_finer_mesh,
    pull_off_of_beams,
};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

/// The root goes no farther, nm.
const MOST: f64 = 60_000.0;
/// Error of the table, over the largest force.
const TOLERANCE: f64 = 1e-2;
/// By how much the table begins with a tip pressed, nm, and the range of its rotation, rad.
const PRESSED: f64 = 5.0;
const TURNED: [f64; 2] = [-0.4, 0.65];

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |key: &str, usual: usize| {
        words.iter().find_map(|own| own.strip_prefix(key)?.strip_prefix('=')?.parse().ok()).unwrap_or(usual)
    };
    let forks = number("forks", 1);
    let whole = Seta::default();
    let behind = (whole.forks - forks) as i32;
    let brush_height = whole.brush_height * whole.height_ratio.powi(behind);
    let seta = Seta {
        forks,
        brush_height,
        shaft_length: whole.shaft_length / whole.brush_height * brush_height,
        shaft_diameter: whole.shaft_diameter * whole.diameter_ratio.powi(behind),
        height_scatter: 20.0,
        ..whole
    };
    let (model, loading) = (Spatula::default().model(), SetaLoading::pull([0.0, 1.0, 0.0], MOST));
    let stop = StopCriteria::default();

    let started = Instant::now();
    let mesh = SetaMesh { order: number("order", 5), elements: vec![1; forks + 1] };
    let beams = SetaOfBeams { seta: seta.clone(), mesh, spatula: model.branch()?, elements: number("elements", 32) };
    let options = PathOptions { pace: Pace::Wary, first_displacement: 0.1, ..PathOptions::default() };
    let mut nobody = |_: &SetaState, _: Option<&BeamsProgress>| {};
    let found = pull_off_of_beams(&beams, &loading, &options, &stop, None, &mut nobody)?;
    print("beams", &found.result, started);
    let started = Instant::now();
    if let Some(finer) = peak_of_beams_on_finer_mesh(&beams, &loading, &options, &found, &stop)? {
        let (peak, mesh, seconds) = (finer.peak, finer.mesh, started.elapsed().as_secs_f64());
        println!(
            "  on a finer mesh {:.4} nN at {:.2} nm, {:.1e} nN from that, {seconds:.1} s",
            peak.force, peak.displacement, mesh.force
        );
    }

    let started = Instant::now();
    let range = TipRange { press: PRESSED, rotation: TURNED, ..TipRange::SLIDING };
    let making = CoarseningOptions { range, tolerance: TOLERANCE, ..CoarseningOptions::of(PadEnd::Sliding) };
    let upright = PeelModel { grip: Default::default(), ..model };
    let mut table = GrowingTable::of(&upright, Arc::new(coarsen(&upright, &making)?));
    let of = |law: Arc<dyn TipLaw>| SetaModel::new(seta.clone(), law);
    let by = SetaOptions { balance: 1e-6, ..SetaOptions::default() };
    let (found, _) = pull_off_by_table(&mut table, (&of, Sideways::Free), (&loading, &by), &stop)?;
    print("table", &found, started);
    Ok(())
}

fn print(name: &str, found: &SetaPullOff, started: Instant) {
    let (effort, seconds) = (found.effort, started.elapsed().as_secs_f64());
    println!(
        "{name}: {:?}, {} elements, {} points, {} Newton iterations, {seconds:.1} s; work and energy differ by {:.1e}",
        found.end,
        effort.elements,
        found.points.len(),
        effort.newton_iterations,
        found.imbalance()
    );
    if let Some(peak) = &found.peak {
        let at = peak.point;
        println!("  peak {:.4} nN at {:.2} nm, {} tips attached", at.force_along, at.displacement, at.attached);
    }
    for event in &found.events {
        let (before, after, tips) = (event.before, event.after, event.tips.len());
        println!(
            "  at {:9.3} nm {:8.4} nN to {:8.4} nN, {tips} tips, {:9.3} aJ released",
            before.displacement, before.force_along, after.force_along, event.released
        );
    }
}
