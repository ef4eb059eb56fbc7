//! The two ways into the library: a whole peel with error bounds, and the path alone, point by point. The docs/reference/library.md has this program.
//!
//!     cargo run --release --example as_a_library

use peelkit::solve::{Path, PathOptions};
use peelkit::{model::Form, study::peel};
use peelkit_scene::Scene;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let text = include_str!("../scenes/strip-100nm.toml");
    let scene = Scene::parse("strip.toml", text, &[])?;

    // the whole peel, with bounds
    let peel = peel(&scene.model, &scene.accuracy, &scene.bounds.from_now());
    println!("{:?}, {:?}", peel.peak, peel.end);

    // the path alone, point by point
    let problem = scene.model.problem(Form::TwoField, 7)?;
    let options = PathOptions { elements: 14, first_displacement: 0.008, ..PathOptions::default() };
    for point in Path::new(&problem, options) {
        let point = point?;
        if point.observables.displacement > 10.0 {
            break;
        }
    }
    Ok(())
}
