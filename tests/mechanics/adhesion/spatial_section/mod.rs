//! The energy of a section of a beam in space, tilted along the beam and across it.
//!
//! Reference: verification/spatial_sections.csv, the energies as they are defined at 400 digits (mpmath); the laws in
//! the plane.
//!
//!            ______              y: height of the axis
//!       ____/     /  c           a = b d2·e_y: rise from side to side
//!      /   y     /               c = h d3·e_y: rise from bottom to top
//!     /     ____/
//!    /_____/   a
//!   -----------------
//!
//! Parameters: A_H = 1e-19 J, r0 = 0.4 nm; lowest corners from 0.2 to 100 nm, widths from 1 to 200 nm, tilts of 0,
//! 1e-12, .., 90 degrees both ways.
//!
//! Expected: value, gradient and Hessian to 1e-13 of their repulsive and attractive parts; level across, the law in the
//! plane; even in both tilts; each derivative that of the number it belongs to; no moment about its axis on a disc.
//!
//! Why: the forces and moments on a beam in space, and the tangent of Newton's method, are these ten numbers.

mod definition;
mod identities;

use crate::common::PAPER;
use peelkit::adhesion::{
    Cohesive, CohesiveShape, Law, LineLaw, LineLoad, LineResponse, OwnLaw, SectionLaw, SectionShape, SpatialSection,
    SpatialSectionResponse, TiltedSection,
};
use std::collections::BTreeMap;

const NAMES: [&str; 10] = ["", "_y", "_a", "_c", "_yy", "_ya", "_yc", "_aa", "_ac", "_cc"];

fn line_law(height: f64, law: Law, far_face: bool) -> LineLaw {
    LineLaw { half_space: PAPER, height, law, line_load: LineLoad::Full, far_face }
}

fn cohesive(shape: CohesiveShape) -> Law {
    Law::Cohesive(Cohesive::calibrated(shape, PAPER.strength(), PAPER.work_of_adhesion(), &PAPER))
}

fn section(shape: SectionShape, width: f64, law: LineLaw) -> SpatialSection {
    SpatialSection::new(shape, width, law).unwrap()
}

fn ten(at: SpatialSectionResponse) -> [f64; 10] {
    let mut out = [at.energy; 10];
    out[1..4].copy_from_slice(&at.gradient);
    out[4..].copy_from_slice(&at.hessian);
    out
}

/// A law of one's own: the body force's lower face and upper face, told from outside by the angle, as in the plane.
#[derive(Debug)]
struct Told(LineLaw);

impl SectionLaw for Told {
    fn name(&self) -> &'static str {
        "told"
    }

    fn response(&self, section: &TiltedSection) -> LineResponse<f64> {
        self.0.response_of(section.height, section.gap, section.sin, section.cos)
    }

    fn cutoff_distance(&self) -> f64 {
        self.0.cutoff_distance()
    }

    fn rest_gap(&self, _height: f64) -> f64 {
        self.0.rest_gap()
    }

    fn has_potential(&self) -> bool {
        self.0.has_potential()
    }
}

fn told(law: LineLaw) -> LineLaw {
    LineLaw { law: Law::Own(OwnLaw::kept(Told(law))), ..law }
}

/// Laws with a potential, on a rectangle of this height.
fn rectangle_laws(height: f64) -> Vec<LineLaw> {
    let mut laws = vec![line_law(height, Law::BodyForce, true), line_law(height, Law::BodyForce, false)];
    laws.extend(CohesiveShape::ALL.iter().map(|&shape| line_law(height, cohesive(shape), true)));
    laws.push(LineLaw { line_load: LineLoad::AxisGap, ..line_law(height, Law::BodyForce, true) });
    laws.push(LineLaw { line_load: LineLoad::AxisGap, ..line_law(height, Law::SurfaceTraction, false) });
    laws
}

/// Rows of the table: columns by name, and the form.
fn table() -> Vec<(String, BTreeMap<&'static str, f64>)> {
    let text = include_str!("../../../../verification/spatial_sections.csv");
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap().split(',').skip(1).collect();
    let row = |line: &'static str| {
        let (form, numbers) = line.split_once(',').unwrap();
        let numbers = numbers.split(',').map(|number| number.parse().unwrap());
        (form.to_string(), names.iter().copied().zip(numbers).collect())
    };
    lines.map(row).collect()
}
