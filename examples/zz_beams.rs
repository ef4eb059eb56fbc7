use peelkit::beam::*;
use peelkit::model::*;
use peelkit::solve::*;
use std::time::Instant;
fn spatula() -> PeelModel {

    Spatula::default().model()
}
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let (elements, order, tol) = (a[0] as usize, a[1] as usize, a[2]);
    let model = spatula();
    let body = model.branch().unwrap();
    let branch = Branch {
        joints: [1, 0],
        rest: BranchRest::Placed(PlacedRest { rest: body.rest.clone(), turn: [1.0, 0.0, 0.0, 0.0], origin: [0.0; 3] }),
        length: body.length,
        sections: BranchSections::Adhering(body.sections.clone()),
        mesh: BranchMesh::Following { policy: body.mesh.clone(), elements },
    };
    let beam = BranchingBeam { order, scale: [10.0, 1e-2], conditions: vec![JointCondition::free(0)], ..BranchingBeam::new(vec![branch], 0) };
    let tree = beam.build().unwrap();
    let axes = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let tree = tree.with_root_axes(axes);
    let rest = tree.stress_free(0);
    let origin = tree.interface_values(&rest);
    let mut held = [true; 6];
    held[0] = false;
    let problem = Problem {
        grip: EndConditions { held, origin, scale: [1.0, 1.0, 1.0, 0.01, 0.01, 0.01], ..EndConditions::drive(0) },
        system: std::sync::Arc::new(tree),
        measure: PathMeasure { monitors: [f64::INFINITY; 2], force: 0.3, beside: MeasuredBeside::Force },
        start: InitialState::StressFree,
    };
    let t = Instant::now();
    let mut ws = Workspace::default();
    let r = relax(&problem, rest, Held::Displacement(0.0), &RelaxOptions::default(), &mut ws).unwrap();
    println!("relaxed {} steps {:?} E {} P {}", r.steps, t.elapsed(), r.solution.energy, r.solution.observables.force);
    let t = Instant::now();
    let options = PathOptions { step_tolerance: tol, tolerance: 1e-8, first_displacement: 0.1, ..PathOptions::default() };
    let path = Path::from(&problem, options, r.solution.at.clone());
    let mut tracer = PathTracer::new(&problem, path, TraceOptions { kinds: &[LimitPointKind::Displacement, LimitPointKind::Load], branches: true, relative: 1e-6, behind: 2 });
    let mut n = 0;
    loop {
        match tracer.advance() {
            Ok(PathEvent::Point(p)) => {
                n += 1;
                if n % 10 == 1 { println!("{n} u {:.3} P {:.5} neg {} it {}", p.observables.displacement, p.observables.force, p.negative, p.iterations); }
                if n > 600 { break; }
            }
            Ok(PathEvent::LimitPoint { kind, located, .. }) => {
                println!("LIMIT {kind} u {:.5} P {:.7} after {n} {:?}", located.observables.displacement, located.observables.force, t.elapsed());
                if kind == LimitPointKind::Displacement { break; }
            }
            Ok(e) => { println!("{}", format!("{e:?}").chars().take(80).collect::<String>()); break; }
            Err(e) => { println!("ERR {e}"); break; }
        }
    }
    println!("points {n} iterations {} {:?}", tracer.iterations(), t.elapsed());
}
