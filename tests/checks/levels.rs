//! From atoms to the line load: how fast each approximation comes right, and what stays wrong.
//!
//! Reference: R. A. Sauer, Advances in the computational modeling of the gecko adhesion mechanism, Sections 2, 3 and 6; tables of
//! verification/pair_to_half_space.py, line_load_sections.py, piece_of_atoms.py.
//!
//!     o o o o o          continuum surface half a spacing a outside the first plane of atoms,
//!     ---------  gap     each atom stands for a³
//!     o o o o o
//!
//! Parameters: A_H = 1e-19 J, r0 = 0.4 nm, h = 10 nm; gaps of 0.26, 0.4 and 1 nm.
//!
//! Expected: the lattice error falls with a², the curvature error with gap/R; a section's line load is the integral of the body
//! force at every tilt; the traction on its bottom face is no line load once it is tilted.
//!
//! Why: each level is only as good as the step that leads to it.

use approx::assert_relative_eq;
use peelkit::adhesion::{
    BodyShape, CurvedBody, HalfSpace, Law, Level, LineLaw, LineLoad, Rule, TiltedBlock, section_by_body_force,
};
use peelkit_checks::suite::reference::{Row, read};
use peelkit_checks::suite::{Check, TOPICS};
use std::num::NonZeroUsize;

const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

fn number(row: &Row, column: &str) -> f64 {
    row.number(column).unwrap_or_else(|| panic!("no {column} in {row:?}"))
}

#[test]
fn every_check_of_the_topic_passes() {
    let topic = TOPICS.iter().find(|topic| topic.name == "levels").unwrap();
    let checks = topic.run();
    let failed: Vec<&Check> = checks.iter().filter(|check| !check.passes()).collect();
    assert!(checks.len() > 200 && failed.is_empty(), "{failed:#?}");
}

/// With the spacing halved the error is a quarter: an atom is the midpoint rule of its cube.
#[test]
fn lattice_error_falls_with_the_square_of_the_spacing() {
    let piece = TiltedBlock { half_space: LAW, length: 10.0, height: 10.0, tilt: 20f64.to_radians(), gap: 1.0 };
    let rule = Rule::new(NonZeroUsize::new(60).unwrap());
    let truth = piece.resultant(&Level::LineLoad { rule, far_face: true }).force;
    let error = |spacing| piece.resultant(&Level::Atoms { spacing, cutoff: 4.0 }).force / truth - 1.0;
    let (coarse, fine) = (error(0.2), error(0.1));
    assert!(fine < 0.0, "atoms attract less than the continuum: {fine}");
    assert_relative_eq!(coarse / fine, 4.0, max_relative = 0.05);
}

#[test]
fn curvature_error_falls_with_the_radius() {
    let error = |shape, radius| {
        let gap = LAW.strongest_gap();
        LAW.traction(gap) / CurvedBody { shape, radius }.traction(&LAW, gap) - 1.0
    };
    for shape in [BodyShape::Sphere, BodyShape::Cylinder] {
        assert_relative_eq!(error(shape, 50.0) / error(shape, 100.0), 2.0, max_relative = 0.01);
    }
    // a cylinder is curved in one direction of two
    assert_relative_eq!(error(BodyShape::Sphere, 100.0) / error(BodyShape::Cylinder, 100.0), 2.0, max_relative = 0.01);
}

/// All gaps of the table, near the zero of the traction too.
#[test]
fn line_load_is_the_integral_of_the_body_force() {
    let rule = Rule::new(NonZeroUsize::new(20).unwrap());
    let law = LineLaw { half_space: LAW, height: 10.0, law: Law::BodyForce, line_load: LineLoad::Full, far_face: true };
    for row in read(include_str!("../../verification/sections.csv")) {
        let tilt = number(&row, "tilt_deg").to_radians();
        let lowest = number(&row, "lowest_gap_nm");
        let axis = lowest + 5.0 * tilt.cos().abs();
        let at = law.response(axis - 5.0, tilt.sin(), tilt.cos());
        let (force, moment) = section_by_body_force(&LAW, 10.0, axis, tilt, &rule);
        // what the repulsion and the attraction are before they cancel, of a section as steep as this one
        let size = LAW.potential_scale() / 0.4 * (0.4 / lowest).powi(9) / tilt.cos().abs().max(0.05);
        for (computed, column, lever) in [
            (-at.by_gap, "force", 1.0),
            (force, "force", 1.0),
            (-at.by_rotation, "moment", 5.0),
            (moment, "moment", 5.0),
        ] {
            assert_relative_eq!(computed, number(&row, column), epsilon = 1e-12 * size * lever, max_relative = 1e-11);
        }
    }
}

/// Eq. (11) on the bottom face, an arc length of the axis, is T(r1) cos θ; eq. (17) is T(r1)/cos θ. Both give the same body the
/// same force, because the end face carries the rest, but not the same load to a section.
#[test]
fn bottom_traction_is_no_line_load_of_a_tilted_section() {
    for row in read(include_str!("../../verification/sections.csv")) {
        let degrees = number(&row, "tilt_deg");
        if degrees < 90.0 {
            let ratio = number(&row, "force_of_bottom_traction") / number(&row, "force_without_far_face");
            assert_relative_eq!(ratio, degrees.to_radians().cos().powi(2), max_relative = 1e-11);
        }
    }
}
