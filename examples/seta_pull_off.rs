//! The pull-off of a seta with 256 tips that follow the curve of their spatula.
//!
//!     cargo run --release --example seta_pull_off [free | held] [table] [forks=n] [normal | lateral | inclined] [upright] [preload=nN] [order=p] [divided=n] [paper] [balance=b]
//!         [tip=r]: relative tolerance of the curve of the tips; [law]: the law of the seta from pulls at 15 to 105 degrees, and its errors

use peelkit::model::{NormalPull, Seta, SetaMesh, SetaModel, Sideways, Spatula, TipLaw};
use peelkit::study::coarsening::{
    CoarseningOptions, PadEnd, RootPath, SetaLaw, SetaSheet, TableLaw, TipRange, coarsen,
};
use peelkit::study::{Accuracy, SetaLoading, SetaOptions, StopCriteria, converged_peak, pull_off, tip_curve};
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
    let mut paths = Vec::new();
    for degrees in [15, 30, 45, 60, 75, 90, 105] {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        let loading = SetaLoading::pull([cos, sin, 0.0], 60_000.0);
        let path = RootPath::resolved(model, &loading, options, &StopCriteria::default())?;
        if let Some(last) = path.points.last() {
            let [x, y] = last.force;
            println!("{degrees:4} degrees: first loss at {:.3?} nm, force {x:.3} and {y:.3} nN", last.root);
        }
        paths.push(path);
    }
    for degree in 2..=4 {
        let law = SetaLaw::fitted(&paths, degree)?;
        let [along, normal] = law.exit.direction;
        let [[a, b], [_, c]] = law.response(SetaSheet::Adhering, [0.0; 2]).stiffness;
        let (mean, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
        println!(
            "degree {degree}: plane at {:.3} nm, {:.3} degrees; stiffness {:.4} and {:.4} N/m; {:?}",
            law.exit.distance,
            normal.atan2(along).to_degrees(),
            mean - half,
            mean + half,
            law.errors
        );
    }
    Ok(())
}
