use peelkit::{adhesion::LineLoad, model::*, study::*};
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|a| a.parse().unwrap()).collect();
    let (length, factor, relative) = (a[0], a[1], a[2]);
    let m = StripModel {
        strip: Strip {
            length,
            height: 10.0,
            width: 1.0,
            youngs_modulus: 2.0,
            poissons_ratio: 0.2,
            shear_correction: 5.0 / 6.0,
            bending_stiffness_factor: factor,
        },
        adhesion: Adhesion {
            hamaker_constant: 0.1,
            equilibrium_distance: 0.4,
            line_load: LineLoad::Full,
            far_face: true,
        },
        grip: Grip { rotation: Hold::Free, horizontal: Hold::Free },
    };
    let mut best = f64::INFINITY;
    let b = Bounds { points: 2000, time_s: None, displacement: None };
    let mut p = peel(&m, &Accuracy { relative }, &b);
    for _ in 0..(a.get(3).copied().unwrap_or(0.0) as usize) {
        let q = peel(&m, &Accuracy { relative }, &b);
        if q.solve_s < best {
            best = q.solve_s;
            p = q;
        }
    }
    println!("{:?} {:?} {:.2} ms", p.end, p.effort, 1e3 * p.solve_s);
    println!("peak {:?} plateau {:?}", p.peak, p.plateau);
    for l in &p.limit_points {
        println!(
            "{:?} {} u {:.12} +- {:.1e} P {:.12} +- {:.1e} W {:.9}",
            l.kind, l.after, l.displacement, l.displacement_error, l.force, l.force_error, l.work
        );
    }
    if a.len() > 5 {
        let s = p.shape(a[5] as usize);
        for i in (0..s.x.len()).step_by(3) {
            println!("x {:.4} y {:.4} th {:.4}", s.x[i], s.y[i], s.rotation[i]);
        }
    }
    if a.len() > 4 {
        for (i, l) in p.points.iter().enumerate() {
            println!(
                "{i} u {:.9} P {:.9} c {:.5} neg {} {} W {:.6} it {}",
                l.displacement,
                l.force,
                l.front,
                l.negative_eigenvalues,
                l.negative_eigenvalues_load,
                l.work,
                l.iterations
            );
        }
    }
}
