//! Body force, surface traction and line load of tilted sections and of a tilted piece of strip.

use super::cells::{LAW, against, cell, rule};
use crate::check::{Check, Measure};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::{Faces, Law, Level, LineLaw, LineLoad, Resultant, TiltedBlock, section_by_body_force};

const SECTION: &str = "verification/line_load_sections.py: body force integrated over the section";
const PIECE: &str = "verification/line_load_sections.py: traction over four faces, body force over the area";
const HEIGHT: f64 = 10.0;

pub(super) fn checks() -> Vec<Check> {
    let mut checks = Vec::new();
    for row in read(include_str!("../../../verification/sections.csv")) {
        if cell(&row, "lowest_gap_nm") == 0.4 {
            checks.extend(section(&row));
        }
    }
    for row in read(include_str!("../../../verification/pieces.csv")) {
        if cell(&row, "corner_gap_nm") == 0.4 && [5.0, 20.0].contains(&cell(&row, "tilt_deg")) {
            checks.extend(piece(&row));
        }
    }
    checks
}

/// The line load in closed form, and the body force integrated by the crate, at tilts from 0 to 120 degrees.
fn section(row: &Row) -> Vec<Check> {
    let degrees = cell(row, "tilt_deg");
    let tilt = degrees.to_radians();
    let (sin, cos) = tilt.sin_cos();
    let axis = cell(row, "lowest_gap_nm") + 0.5 * HEIGHT * cos.abs();
    let law =
        LineLaw { half_space: LAW, height: HEIGHT, law: Law::BodyForce, line_load: LineLoad::Full, far_face: true };
    let at = law.response(axis - 0.5 * HEIGHT, sin, cos);
    let (force, moment) = section_by_body_force(&LAW, HEIGHT, axis, tilt, &rule(20));
    // a moment that vanishes by symmetry is held against the force at the lever of half the height
    let lever = 0.5 * HEIGHT * cell(row, "force").abs();
    [
        ("Ψ, nN/nm", "energy", at.energy, Measure::Relative, 1e-11),
        ("T_c by eq. (17), nN/nm²", "force", -at.by_gap, Measure::Relative, 1e-11),
        ("T_c by body force, nN/nm²", "force", force, Measure::Relative, 1e-11),
        ("M_c by eq. (20), nN/nm", "moment", -at.by_rotation, Measure::Absolute, 1e-12 * lever),
        ("M_c by body force, nN/nm", "moment", moment, Measure::Absolute, 1e-12 * lever),
    ]
    .map(|(what, column, value, measure, tolerance)| {
        against(format!("section at {degrees}°, {what}"), SECTION, row, column, value, measure, tolerance)
    })
    .into()
}

/// Every level on one piece of strip; what the paper leaves out is held against its own truth.
fn piece(row: &Row) -> Vec<Check> {
    let (degrees, gap) = (cell(row, "tilt_deg"), cell(row, "corner_gap_nm"));
    let piece = TiltedBlock { half_space: LAW, length: 10.0, height: HEIGHT, tilt: degrees.to_radians(), gap };
    let (rays, fine) = (rule(6), rule(48));
    let levels = [
        ("volumes", "", Level::Volumes { rule: fine.clone(), rays }),
        ("body force", "", Level::BodyForce { rule: fine.clone() }),
        ("traction on all faces", "", Level::SurfaceTraction { rule: fine.clone(), faces: Faces::All }),
        ("traction on near faces", "near_faces_", Level::SurfaceTraction { rule: fine.clone(), faces: Faces::Near }),
        ("line load", "", Level::LineLoad { rule: fine.clone(), far_face: true }),
        ("line load without the upper surface", "near_line_", Level::LineLoad { rule: fine, far_face: false }),
    ];
    let mut checks = Vec::new();
    for (level, columns, how) in levels {
        let Resultant { force, moment } = piece.resultant(&how);
        for (what, column, value) in [("force, nN/nm", "force", force), ("moment, nN", "moment", moment)] {
            let name = format!("piece at {degrees}°, gap {gap} nm, {level}, {what}");
            checks.push(against(name, PIECE, row, &format!("{columns}{column}"), value, Measure::Relative, 1e-10));
        }
    }
    checks
}
