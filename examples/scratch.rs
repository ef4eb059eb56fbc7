use peelkit::{adhesion::LineLoad, model::*, solve::*};
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|a| a.parse().unwrap()).collect();
    let (length, factor, order, elements, tol) = (a[0], a[1], a[2] as usize, a[3] as usize, a[4]);
    let most = a.get(5).copied().unwrap_or(200.0) as usize;
    let m = StripModel {
        strip: Strip { length, height: 10.0, width: 1.0, youngs_modulus: 2.0, poissons_ratio: 0.2, shear_correction: 5.0 / 6.0, bending_stiffness_factor: factor },
        adhesion: Adhesion { hamaker_constant: 0.1, equilibrium_distance: 0.4, line_load: LineLoad::Full, far_face: true },
        grip: Grip { rotation: Hold::Free, horizontal: Hold::Free },
    };
    let p = m.problem(Form::TwoField, order);
    println!("l {} rest {:?} w {}", p.process_length, p.rest, p.rest_adhesion);
    let mut path = Path::new(&p, PathOptions { elements, step_tolerance: tol, tolerance: 1e-9, first_displacement: 0.01 });
    let t = std::time::Instant::now();
    for _ in 0..most {
        match path.advance() {
            Ok(s) => {
                if a.len() > 6 { 
                let n = p.chain.node_states(s.at.configuration());
                let inv: Vec<f64> = n.iter().map(|n| n.section.eshelby() - n.adhesion).collect();
                let d = inv.iter().map(|i| (i - inv[0]).abs()).fold(0.0, f64::max) / p.rest_adhesion.abs();
                println!("{:3} u {:.9} P {:.9} c {:.5} th {:.5} dP {:+.2e} du {:+.2e} neg {} {} it {} corr {:.1e} I {:.1e}", path.points().len(), s.observables.displacement, s.observables.force, s.observables.front, s.observables.tip_rotation, s.slope.force, s.slope.displacement, s.negative, s.negative_load, s.iterations, s.correction, d);}
                if path.points().len() > 5 && (s.observables.displacement < 0.0 || s.observables.force < 0.0) { break; }
            }
            Err(e) => { println!("{e}"); break; }
        }
    }
    println!("points {} iterations {} time {:?}", path.points().len(), path.iterations(), t.elapsed());
}
