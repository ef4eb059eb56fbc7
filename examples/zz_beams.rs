use peelkit::model::*;
use peelkit::solve::*;
use peelkit::study::*;
use std::time::Instant;
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let (elements, order, tol, forks) = (a[0] as usize, a[1] as usize, a[2], a[3] as usize);
    let model = Spatula::default().model();
    let q = 4000.0 * 0.625f64.powi(8 - forks as i32);
    let b = 28000.0 * 0.6f64.powi(8 - forks as i32);
    let seta = Seta { forks, shaft_diameter: q, brush_height: b, shaft_length: 2.5 * b, height_scatter: a[4], ..Seta::default() };
    let mesh = SetaMesh { order, elements: vec![1; forks + 1] };
    let beams = SetaOfBeams { seta, mesh, spatula: model.branch().unwrap(), elements };
    let options = PathOptions { step_tolerance: tol, tolerance: 1e-8, pace: if a.len() > 5 { Pace::Wary } else { Pace::Quick }, first_displacement: 0.1, ..PathOptions::default() };
    let loading = SetaLoading::pull([0.0, 1.0, 0.0], 1e5);
    let t = Instant::now();
    let r = pull_off_of_beams(&beams, &loading, &options, &StopCriteria::default()).unwrap();
    println!("end {:?} points {} events {} {:?} {:?} imbalance {:.2e}", r.end, r.points.len(), r.events.len(), r.effort, t.elapsed(), r.imbalance());
    println!("peak {:?}", r.peak.as_ref().map(|p| (p.point, p.location)));
    for e in &r.events { println!("u {:.4} P {:.5} -> {:.5} released {:.4} tips {:?} attached {}", e.before.displacement, e.before.force_along, e.after.force_along, e.released, e.tips.iter().map(|t| (t.tip, t.to)).collect::<Vec<_>>(), e.after.attached); }
    for p in r.points.iter().rev().take(3) { println!("{p:?}"); }
}
