//! A random rough profile as a CSV on standard output, for `[substrate] shape = "profile"`.
//!
//!     cargo run --example rough_profile > heights.csv
//!     peel run scenes/strip-100nm.toml --set substrate.shape=profile --set substrate.table="$PWD/heights.csv"

use peelkit::adhesion::SelfAffine;

fn main() {
    let rough = SelfAffine { hurst: 0.8, roughness: 1.0, longest: 100.0, shortest: 20.0, length: 400.0, seed: 1 };
    println!("# self-affine: {rough:?}");
    print!("{}", rough.table());
}
