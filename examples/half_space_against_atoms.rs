//! The half space against the atoms that it stands for: how dense must they be for a sum to be an integral?
//!
//! What it shows: the traction between two crystals, summed atom by atom, beside that between two half spaces with the same Hamaker
//! constant. The atoms lie on top of one another, or over the hollows between four of the others.
//!
//! Equations: each pair has φ = ε (r0/r)¹² - 2ε (r0/r)⁶. Its integral over two half spaces at the gap g is the traction
//! T(g) = A_H/(2π r0³) [(r0/g)⁹/45 - (r0/g)³/3], with A_H = 2π² ε r0⁶/a⁶ and one atom in a cube of edge a. The crystals have a layer in the
//! middle of each slice of thickness a: the midpoint rule of both integrals, whose error is -(a²/12) T''. Where the attraction is
//! largest, T'' = 27 σ/g² with the strength σ: it is larger by 9/4 (a/g)² of itself. What depends on the place along the surface falls
//! faster than any power of a.
//!
//! What to try: a spacing of 0.3 nm, as solids have it, and gaps from 0.05 nm on: half spaces describe such atoms only with an A_H and r0
//! that were fitted to them. The place (a/2, 0) over a bridge between two atoms.
//!
//!     cargo run --release --example half_space_against_atoms
//!
//! writes out/examples/half_space_against_atoms.svg and .png.

use peelkit::adhesion::{HalfSpace, LatticeHalfSpace, LennardJones};
use peelkit::study::sweep;
use peelkit_report::chart::{Axis, Frame, Line, Mark, Panel, Picture, Stroke, colour, save};
use std::{error::Error, path::Path};

const HALF_SPACE: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
/// Spacings a, nm.
const SPACINGS: [f64; 5] = [0.2, 0.14, 0.1, 0.07, 0.05];
/// Atoms within this distance are summed one by one, nm.
const CUTOFF: f64 = 1.5;

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", draw(Path::new("out/examples"))?);
    Ok(())
}

/// Draws the picture in a folder, and gives the text to print.
pub fn draw(folder: &Path) -> Result<String, Box<dyn Error>> {
    let gaps: Vec<f64> = (0..=110).map(|k| 0.15 + 0.005 * f64::from(k)).collect();
    let cases: Vec<(f64, f64)> = SPACINGS.iter().flat_map(|&a| [(a, 0.0), (a, 0.5 * a)]).collect();
    let curves = sweep(&cases, &|| true, &|&(a, shift)| -> Vec<(f64, f64)> {
        let crystal = crystal(a);
        gaps.iter().map(|&gap| (gap, crystal.traction(gap, shift, shift))).collect()
    });
    let continuum = gaps.iter().map(|&gap| (gap, HALF_SPACE.traction(gap))).collect();
    let (strength, gap) = (HALF_SPACE.strength(), HALF_SPACE.strongest_gap());
    let above = |curve: &[(f64, f64)]| curve.iter().fold(0.0, |most: f64, at| most.max(-at.1)) / strength - 1.0;
    let second_order = |a: f64| 2.25 * (a / gap).powi(2);

    let mut text =
        format!("largest attraction of the half spaces: {strength:.6} GPa; what crystals have more, over that:\n");
    text += &format!("{:>14} {:>9} {:>13} {:>13}\n", "spacing a (nm)", "on top", "over hollows", "9/4 (a/g)^2");
    for (&a, pair) in SPACINGS.iter().zip(curves.chunks(2)) {
        let [top, hollow] = [0, 1].map(|k| above(&pair[k]));
        text += &format!("{a:>14} {top:>9.4} {hollow:>13.4} {:>13.4}\n", second_order(a));
    }

    let lines = vec![
        Line::named("a = 0.2 nm, on top", curves[0].clone(), Stroke::solid(colour::VERMILLION, 2.2)),
        Line::named("a = 0.2 nm, over hollows", curves[1].clone(), Stroke::dashed(colour::VERMILLION, 2.2)),
        Line::named("a = 0.1 nm", curves[4].clone(), Stroke::solid(colour::ORANGE, 2.2)),
        Line::named("half spaces", continuum, Stroke::solid(colour::INK, 2.2)),
    ];
    let (x, y) = (Axis::linear("gap g (nm)", 0.15, 0.7), Axis::linear("traction T (GPa)", -0.25, 0.05));
    let left = Panel::of_lines(Frame::column(0, 2), x, y, lines);

    let order = Line::named(
        "9/4 (a/g)²",
        [0.04, 0.22].map(|a| (a, second_order(a))).to_vec(),
        Stroke::dotted(colour::INK, 2.0),
    );
    let (x, y) = (
        Axis::log("spacing a (nm)", 0.04, 0.25),
        Axis::log("largest attraction: crystals / half spaces - 1", 0.03, 2.0),
    );
    let dots = |k: usize, name: &str, ink| {
        let dot = |(a, pair): (&f64, &[Vec<(f64, f64)>])| Mark {
            name: Some(name.into()),
            ..Mark::dot((*a, above(&pair[k])), ink)
        };
        SPACINGS.iter().zip(curves.chunks(2)).map(dot).collect::<Vec<_>>()
    };
    let marks = [dots(0, "on top", colour::VERMILLION), dots(1, "over hollows", colour::BLUE)].concat();
    let right = Panel { marks, ..Panel::of_lines(Frame::column(1, 2), x, y, vec![order]) };
    save(&Picture::of("Atoms and the half space", vec![left, right]), folder, "half_space_against_atoms")?;
    Ok(text)
}

/// Half a space of atoms so far apart, nm, that attracts as the continuum does from afar.
fn crystal(spacing: f64) -> LatticeHalfSpace {
    let density = spacing.powi(-3);
    LatticeHalfSpace { pair: LennardJones::behind(&HALF_SPACE, density, density), spacing, cutoff: CUTOFF }
}
