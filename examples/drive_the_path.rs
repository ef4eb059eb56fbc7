//! Drives the path of equilibria point by point and stops it at will: here where the grip has been lifted by 10 nm.
//!
//! Nothing is located or bounded on such a path; `study::peel` does that.
//!
//!     cargo run --release --example drive_the_path

use peelkit::model::{Form, StripModel};
use peelkit::solve::{Pace, Path, PathOptions};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = StripModel::of_the_paper(100.0, 1.0);
    let problem = model.problem(Form::TwoField, 7)?;
    let options = PathOptions {
        elements: 14,
        step_tolerance: 1e-2,
        stride: 1.0,
        longest: None,
        prediction: 8,
        tolerance: 1e-9,
        first_displacement: 0.008,
        pace: Pace::Quick,
    };
    let mut path = Path::new(&problem, options);

    println!("    u / nm     P / nN  unstable directions");
    // `by_ref` keeps the path: it could be driven on from where the loop stops.
    for point in path.by_ref() {
        let point = point?;
        let at = point.observables;
        println!("{:10.5} {:10.6}  {}", at.displacement, at.force, point.negative);
        if at.displacement > 10.0 {
            break;
        }
    }
    println!("{} points, {} Newton iterations", path.points().len(), path.iterations());
    Ok(())
}
