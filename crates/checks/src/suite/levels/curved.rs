//! Sphere and cylinder in the place of the half space, and what the half space costs.

use super::cells::{LAW, against, cell};
use crate::check::{Check, Measure};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::{BodyShape, CurvedBody};

const SOURCE: &str = "verification/curved_bodies.py: eq. (1) over the body";

pub(super) fn checks() -> Vec<Check> {
    let mut checks = Vec::new();
    for row in read(include_str!("../../../verification/curved_bodies.csv")) {
        let (radius, gap) = (cell(&row, "radius_nm"), cell(&row, "gap_nm"));
        if [1.0, 8.0, 100.0].contains(&radius) && [0.4, 1.0].contains(&gap) {
            checks.extend(forces(&row));
        }
    }
    read(include_str!("../../../verification/curved_radius.csv")).iter().for_each(|row| checks.push(needed(row)));
    checks
}

fn shape(row: &Row) -> (BodyShape, &'static str) {
    match row.text("shape") {
        Some("cylinder") => (BodyShape::Cylinder, "cylinder"),
        _ => (BodyShape::Sphere, "sphere"),
    }
}

fn forces(row: &Row) -> Vec<Check> {
    let ((shape, word), radius, gap) = (shape(row), cell(row, "radius_nm"), cell(row, "gap_nm"));
    let body = CurvedBody { shape, radius };
    [
        ("body force, nN/nm³", "body_force", body.body_force(&LAW, gap)),
        ("traction, nN/nm²", "traction", body.traction(&LAW, gap)),
    ]
    .map(|(what, column, value)| {
        let name = format!("{word} of {radius} nm, gap {gap} nm, {what}");
        against(name, SOURCE, row, column, value, Measure::Relative, 1e-10)
    })
    .into()
}

/// The error of the half space at the radius of the table, where it attracts most.
fn needed(row: &Row) -> Check {
    let ((shape, word), radius) = (shape(row), cell(row, "radius_nm"));
    let body = CurvedBody { shape, radius };
    let (what, error) = if row.text("quantity") == Some("traction") {
        let gap = LAW.strongest_gap();
        ("traction", LAW.traction(gap) / body.traction(&LAW, gap) - 1.0)
    } else {
        let gap = LAW.equilibrium_distance * 2f64.powf(-1.0 / 6.0);
        ("body force", LAW.body_force(gap) / body.body_force(&LAW, gap) - 1.0)
    };
    let name = format!("{word} of {radius:.3} nm, error of the half space in its largest {what}");
    against(name, SOURCE, row, "error", error, Measure::Relative, 1e-8)
}
