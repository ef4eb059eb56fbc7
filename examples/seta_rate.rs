//! The largest force of a seta against the rate at which its root is pulled: branches of viscous material, without mass.
//!
//!     cargo run --release --example seta_rate [forks=n] [tolerance=t] [only=µm] [kelvin-voigt | solid]
//!
//! The force depends on rate times retardation time alone. 16 tips unless told otherwise; `forks=8` is the seta of 256 tips.

use peelkit::beam::Viscosity;
use peelkit::model::{MovingMaterial, NormalPull, Seta, SetaModel, Sideways, Spatula};
use peelkit::study::{
    Accuracy, SetaLoading, SetaOptions, SetaPullRate, SetaTimeAccuracy, StopCriteria, pull_off, pull_seta_in_time,
    tip_curve,
};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

/// τ, ns
const TIME: f64 = 1e6;
/// Rate times τ, µm
const LENGTHS: [f64; 8] = [0.001, 0.01, 0.1, 1.0, 3.0, 10.0, 30.0, 100.0];
/// Of Kelvin and Voigt, and the standard linear solid with E₀/E∞ = 2
const MATERIALS: [&str; 2] = ["kelvin-voigt", "solid"];
/// The root goes no farther, nm.
const MOST: f64 = 60_000.0;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |key: &str| words.iter().find_map(|own| own.strip_prefix(key)?.strip_prefix('=')?.parse::<f64>().ok());
    let forks = number("forks").unwrap_or(4.0) as usize;
    let curve = tip_curve(&Spatula::default().model(), &Accuracy::to(1e-6), 50.0)?;
    let single = curve.points().iter().map(|point| point.force).fold(0.0, f64::max);
    let law = Arc::new(NormalPull { curve, sideways: Sideways::Free, contact_height: 0.0 });
    // a shaft that bends as much under fewer tips
    let whole = Seta::default();
    let share = 2f64.powi(forks as i32 - whole.forks as i32);
    let seta = Seta { forks, shaft_diameter: whole.shaft_diameter * share.powf(0.25), ..whole };
    let model = SetaModel::new(seta, law);
    let all = single * model.seta.tips() as f64;
    let loading = SetaLoading::pull([0.0, 1.0, 0.0], MOST);
    let slow = pull_off(&model, &loading, &SetaOptions::default(), &StopCriteria::default())?;
    let slow = slow.peak.map_or(0.0, |peak| peak.point.force_along);
    println!(
        "{} tips; equilibria: {slow:.4} nN, {:.3} of the sum of all tips, {all:.4} nN",
        model.seta.tips(),
        slow / all
    );
    println!("rate times time, µm   material   force, nN   over that of equilibria   steps   balance   tips apart   s");
    for (name, viscosity) in [
        ("kelvin-voigt", Viscosity::KelvinVoigt { retardation_time: TIME }),
        ("solid", Viscosity::StandardLinearSolid { relaxation_time: TIME, stiffness_ratio: 2.0 }),
    ] {
        let is_left_out = words.iter().any(|own| MATERIALS.contains(&&own[..])) && !words.iter().any(|own| name == own);
        if is_left_out {
            continue;
        }
        for length in LENGTHS.into_iter().filter(|length| number("only").is_none_or(|only| only == *length)) {
            let material = MovingMaterial { density: 0.0, viscosity, opening: None };
            let pull = SetaPullRate::normal(MOST, 1e3 * length / TIME);
            let mut accuracy = SetaTimeAccuracy::default();
            accuracy.tolerance = number("tolerance").unwrap_or(accuracy.tolerance);
            let begun = Instant::now();
            let pulled = pull_seta_in_time(&model, &material, &pull, &accuracy, None);
            let pulled = pulled.map_err(|failed| failed.why.to_string())?;
            let peak = pulled.peak();
            let apart = pulled.points.iter().map(|at| (at.force - at.tip_force).abs()).fold(0.0, f64::max);
            println!(
                "{length:19}   {name:12} {:9.4}   {:8.4}   {:6}   {:7.1e}   {apart:7.1e}   {:.2}",
                peak.force,
                peak.force / slow,
                pulled.tried,
                pulled.balance_error(),
                begun.elapsed().as_secs_f64(),
            );
        }
    }
    Ok(())
}
