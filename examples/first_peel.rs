//! Peels the strip of a scene and prints what a test rig would see: the peak force and where the strip snaps off.
//!
//!     cargo run --release --example first_peel

use peelkit::study::peel;
use peelkit_scene::Scene;

const SCENE: &str = r#"
[strip]
length = "100 nm"
height = "10 nm"
youngs_modulus = "2 GPa"

[adhesion]
hamaker_constant = "1e-19 J"
equilibrium_distance = "0.4 nm"
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Scene::parse("first_peel", SCENE, &[])?;
    let peel = peel(&scene.model, &scene.accuracy, &scene.bounds.from_now());

    let peak = peel.peak.ok_or("the path has no peak")?;
    println!("peak force  {:.9} nN, wrong by no more than {:.0e} nN", peak.force, peak.force_error);
    let snap_off = peel.snap_off.ok_or("the path has no snap-off")?;
    println!("snap-off    at u = {:.6} nm after a work of {:.6} aJ", snap_off.displacement, snap_off.work);
    println!("end         {:?} after {} points", peel.end, peel.points.len());
    Ok(())
}
