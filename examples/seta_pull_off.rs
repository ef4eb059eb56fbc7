//! The pull-off of a seta with 256 tips that follow the curve of their spatula.
//!
//!     cargo run --release --example seta_pull_off [free | held] [table] [forks=n] [normal | lateral | inclined] [upright] [preload=nN] [order=p] [divided=n] [paper] [balance=b]
//!         [tip=r]: relative tolerance of the curve of the tips; [law]: the law of the seta from pulls at 15 to 105 degrees, its errors,
//!         and those on twenty other ways of the root

use peelkit::model::{NormalPull, Seta, SetaMesh, SetaModel, Sideways, Spatula, TipLaw};
use peelkit::study::coarsening::{
    CoarseningOptions, PadEnd, RootPath, SetaLaw, SetaLawOptions, TableLaw, TipRange, coarsen,
};
use peelkit::study::{
    Accuracy, SetaLoading, SetaOptions, SetaStart, SetaStep, StepEnd, StopCriteria, converged_peak, pull_off, tip_curve,
};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let is = |word: &str| words.iter().any(|own| own == word);
    let begun = Instant::now();
    let number = |key: &str| words.iter().find_map(|own| own.strip_prefix(key)?.strip_prefix('=')?.parse::<f64>().ok());
    let curve = tip_curve(&Spatula::default().model(), &Accuracy::to(number("tip").unwrap_or(1e-6)), 50.0)?;
    println!(
        "curve: {} points, {:.4} s, E at rest {:.4} aJ",
        curve.points().len(),
        begun.elapsed().as_secs_f64(),
        curve.energy_at_rest()
    );
    for u in [-50.0, -20.0, 0.0, 25.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0, 350.0, 361.243, 363.0, curve.snap_off()]
    {
        println!("{u:10.4} {:12.8} {:12.8} {:12.6}", curve.force(u).0, curve.force(u).1, curve.energy(u));
    }
    let sideways = if is("held") { Sideways::Held(1.0) } else { Sideways::Free };
    let number = |key: &str| words.iter().find_map(|own| own.strip_prefix(key)?.strip_prefix('=')?.parse::<f64>().ok());
    let law: Arc<dyn TipLaw> = if is("table") {
        let begun = Instant::now();
        let range = TipRange { press: 100.0, ..TipRange::SLIDING };
        let options = CoarseningOptions { range, tolerance: 1e-3, ..CoarseningOptions::of(PadEnd::Sliding) };
        let table = coarsen(&Spatula::default().model(), &options)?;
        println!("table: {} equilibria, {:.3} s", table.equilibria, begun.elapsed().as_secs_f64());
        Arc::new(TableLaw::new(Arc::new(table), sideways))
    } else {
        Arc::new(NormalPull { curve, sideways, contact_height: 0.0 })
    };
    let mut seta = Seta::default();
    if let Some(forks) = number("forks") {
        seta.forks = forks as usize;
    }
    if is("upright") {
        (seta.shaft_angle, seta.brush_angle) = (0.0, 0.0);
    }
    let mut model = SetaModel::new(seta, law);
    if is("paper") {
        model.mesh = SetaMesh::of_the_paper(model.seta.forks);
    }
    if let Some(order) = number("order") {
        model.mesh.order = order as usize;
    }
    if let Some(by) = number("divided") {
        model.mesh = model.mesh.divided(by as usize);
    }
    let options = SetaOptions { balance: number("balance").unwrap_or(1e-8), ..SetaOptions::default() };
    if is("law") {
        return print_law(&model, &options);
    }
    let direction = if is("lateral") {
        [1.0, 0.0, 0.0]
    } else if is("inclined") {
        [1.0, 1.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let loading = match number("preload") {
        None => SetaLoading::pull(direction, 60_000.0),
        Some(preload) => {
            SetaLoading::pressed_and_dragged(2.0 * model.seta.height_scatter + 1.0, preload, 0.0, 60_000.0)
        }
    };
    let begun = Instant::now();
    let pulled = pull_off(&model, &loading, &options, &StopCriteria::default())?;
    let seconds = begun.elapsed().as_secs_f64();
    if is("curve") {
        for point in &pulled.points {
            println!(
                "{:12.5} {:12.6} {:12.6} {:12.6} {:4} {:16.6} {:16.6} {:16.6}",
                point.displacement,
                point.force[0],
                point.force[1],
                point.force_along,
                point.attached,
                point.energy,
                point.work,
                point.released
            );
        }
    }
    println!(
        "{} elements of order {}, {} points, {} events, {} Newton iterations, {seconds:.3} s",
        pulled.effort.elements,
        model.mesh.order,
        pulled.points.len(),
        pulled.events.len(),
        pulled.effort.newton_iterations
    );
    println!("end {:?}, imbalance {:.2e}", pulled.end, pulled.imbalance());
    for (name, state) in
        [("first", &pulled.first_detachment), ("peak", &pulled.peak), ("last", &pulled.last_detachment)]
    {
        if let Some(state) = state {
            let p = state.point;
            println!(
                "{name}: u {:.6} nm, force {:.8} nN, attached {}, work {:.6}",
                p.displacement, p.force_along, p.attached, p.work
            );
            if let Some(error) = state.location {
                println!("    located to {:.1e} nm, {:.1e} nN", error.displacement, error.force);
            }
        }
    }
    let begun = Instant::now();
    if let Some(found) = converged_peak(&model, &loading, &options, &pulled, 1e-6, &StopCriteria::default())? {
        let (force, error, order) = (found.peak.force, found.mesh.force, found.order);
        let seconds = begun.elapsed().as_secs_f64();
        println!(
            "peak with elements of order {order}: {force:.8} nN, error of the mesh {error:.1e} nN, {seconds:.3} s"
        );
    }
    let most = pulled.events.iter().map(|event| event.tips.len()).max();
    println!("largest event: {most:?} tips");
    Ok(())
}

fn print_law(model: &SetaModel, options: &SetaOptions) -> Result<(), Box<dyn Error>> {
    let path = |loading: &SetaLoading| {
        let begun = Instant::now();
        let path = RootPath::resolved(model, loading, options, &StopCriteria::default())?;
        println!("{} equilibria in {:.1} s: {:?}", path.points.len(), begun.elapsed().as_secs_f64(), loading.steps);
        Ok::<_, Box<dyn Error>>(path)
    };
    let paths: Vec<RootPath> = [15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0]
        .map(|degrees| path(&SetaLoading::pull(direction(degrees), FAR)))
        .into_iter()
        .collect::<Result<_, _>>()?;
    let others: Vec<RootPath> = (0..OTHERS).map(|number| path(&other_way(number))).collect::<Result<_, _>>()?;
    for (degree, sheets) in [(2, 1), (2, 16), (3, 16), (4, 16)] {
        let law = SetaLaw::fitted(&paths, &SetaLawOptions { degree, sheets, ..SetaLawOptions::default() })?;
        let exit = law.first_exit();
        let [[a, b], [_, c]] = law.response(0, [0.0; 2]).stiffness;
        let (mean, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
        println!(
            "degree {degree}: plane at {:.3} nm, {:.3} degrees; stiffness {:.4} and {:.4} N/m",
            exit.distance,
            exit.angle().to_degrees(),
            mean - half,
            mean + half
        );
        println!("    sheets {:?}", law.sheets.iter().map(|sheet| sheet.tips).collect::<Vec<_>>());
        println!("    {:?}", law.errors);
        let off: Vec<[f64; 2]> = others.iter().map(|path| law.peak_and_work_error(path)).collect();
        let [peak, work] = [0, 1].map(|k| off.iter().map(|own| own[k].abs()).fold(0.0, f64::max));
        println!("    on {OTHERS} other ways: peak within {peak:.4}, work within {work:.4}");
    }
    Ok(())
}

/// No tip holds on so far, nm.
const FAR: f64 = 60_000.0;
/// Ways of the root that a law is not made of.
const OTHERS: usize = 20;

/// Pulled at some angle from 15 to 105 degrees, every other time behind a drag of up to 150 nm.
fn other_way(number: usize) -> SetaLoading {
    let part = |share: f64| (share * number as f64).fract();
    let pull = SetaStep { direction: direction(15.0 + 90.0 * part(0.618_033_988_7)), until: StepEnd::Detached(FAR) };
    let drag = SetaStep { direction: direction(0.0), until: StepEnd::Travel(1.0 + 149.0 * part(0.414_213_562_4)) };
    let steps = if number.is_multiple_of(2) { vec![pull] } else { vec![drag, pull] };
    SetaLoading { start: SetaStart::Adhering, steps }
}

fn direction(degrees: f64) -> [f64; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [cos, sin, 0.0]
}
