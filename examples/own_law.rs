//! Peels a strip under a law of adhesion that the library does not have: a traction with a short range, beyond which nothing pulls.
//!
//!     cargo run --release --example own_law
//!
//! With t = δ/δ_r the opening δ over the range, the traction of a face is -σ s(t), s = 3125/256 t (1 - t)⁴ up to t = 1, which is σ at
//! t = 1/5, and its work of adhesion w = 3125/7680 σ δ_r. A long strip peels steadily at P + P²/(2EA) = w b, whatever the
//! law: that is checked.

use peelkit::adhesion::{LineResponse, OwnLaw, SectionLaw, TiltedSection};
use peelkit::analytic::kendall_force;
use peelkit::model::{Attraction, StripModel};
use peelkit::study::{Accuracy, StopCriteria, peel};
use std::f64::consts::FRAC_PI_2;

/// s is 1 at its largest.
const TOP: f64 = 3125.0 / 256.0;

#[derive(Debug)]
struct ShortRange {
    /// σ, GPa
    strength: f64,
    /// δ_r, nm
    range: f64,
    /// The distance at which a face is closed, nm
    closed: f64,
}

impl ShortRange {
    /// J/m²
    fn work(&self) -> f64 {
        TOP / 30.0 * self.strength * self.range
    }

    /// W (nN/nm), the traction T = -W' (GPa) and -T' (GPa/nm) of a face at the distance r, nm.
    fn levels(&self, r: f64) -> [f64; 3] {
        // how much of the range is left; a face that is pressed is pushed away by the same polynomial
        let left = (1.0 - (r - self.closed) / self.range).max(0.0);
        let work = left.powi(5) * (1.0 / 5.0 - left / 6.0);
        let traction = (1.0 - left) * left.powi(4);
        let slope = left.powi(3) * (5.0 * left - 4.0);
        let scale = TOP * self.strength;
        [-scale * self.range * work, -scale * traction, scale * slope / self.range]
    }
}

impl SectionLaw for ShortRange {
    fn name(&self) -> &'static str {
        "short-range"
    }

    fn response(&self, section: &TiltedSection) -> LineResponse<f64> {
        section.face_load(|r| self.levels(r))
    }

    fn cutoff_distance(&self) -> f64 {
        self.closed + self.range
    }

    fn rest_gap(&self, _height: f64) -> f64 {
        self.closed
    }

    /// At rest the traction rises twelve times as steeply, over a small part of the range.
    fn rest_stiffness(&self, _height: f64) -> f64 {
        self.strength / self.range
    }

    /// The fourth derivative of the traction jumps where the range ends: elements of order 7 see that.
    fn corners(&self) -> f64 {
        5.0
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let law = ShortRange { strength: 0.15, range: 0.5, closed: 0.25 };
    let work = law.work();
    let mut model = StripModel::of_the_paper(1000.0, 1.0);
    model.adhesion.attraction = Attraction::Own(OwnLaw::kept(law));

    let bounds = StopCriteria::after_points(20_000);
    let peel = peel(&model, &Accuracy::to(1e-6), &bounds);
    let peak = peel.initiation_peak.ok_or("the path has no peak")?;
    println!("initiation peak  {:.9} nN, wrong by no more than {:.0e} nN", peak.force, peak.force_error);
    let plateau = peel.plateau.ok_or("the path has no plateau")?.force;
    let strip = model.strip;
    let steady = kendall_force(work, strip.material.youngs_modulus, strip.height, strip.width, FRAC_PI_2);
    println!("plateau          {plateau:.9} nN; from the work of adhesion {steady:.9} nN");
    println!("end              {:?} after {} points", peel.end, peel.points.len());
    if (plateau / steady - 1.0).abs() > 1e-6 {
        return Err("the plateau is not that of the work of adhesion".into());
    }
    Ok(())
}
