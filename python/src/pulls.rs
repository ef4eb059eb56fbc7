//! The points of pulls as columns: those of curve.csv, without their units.

use crate::columns::{counts, floats};
use peelkit::study::SetaPoint;
use peelkit_report::{Contact, PointAtRate};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The columns of numbers, and of counts, by their names.
pub type Columns<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>);

/// A column: its name, and its value at a point.
type Column<P> = (&'static str, fn(&P) -> f64);

/// Of a pull-off, but for how far it has come; nm, nN, nN nm, aJ.
const OF_SETA: [Column<SetaPoint>; 14] = [
    ("displacement", |at| at.displacement),
    ("force", |at| at.force_along),
    ("root_x", |at| at.root[0]),
    ("root_y", |at| at.root[1]),
    ("root_z", |at| at.root[2]),
    ("force_x", |at| at.force[0]),
    ("force_y", |at| at.force[1]),
    ("force_z", |at| at.force[2]),
    ("moment_x", |at| at.moment[0]),
    ("moment_y", |at| at.moment[1]),
    ("moment_z", |at| at.moment[2]),
    ("energy", |at| at.energy),
    ("work", |at| at.work),
    ("released", |at| at.released),
];

/// s/ns
const S_PER_NS: f64 = 1e-9;

/// Of every pull at a rate; s, nm, nN, aJ.
const AT_RATE: [Column<PointAtRate>; 9] = [
    ("time", |at| S_PER_NS * at.time),
    ("displacement", |at| at.displacement),
    ("force", |at| at.force),
    ("work", |at| at.balance.work),
    ("stored", |at| at.balance.stored),
    ("adhesion", |at| at.balance.adhesion),
    ("spring", |at| at.balance.spring),
    ("kinetic", |at| at.balance.kinetic),
    ("dissipated", |at| at.balance.dissipated),
];

fn of<'py, P>(py: Python<'py>, points: &[P], columns: &[Column<P>]) -> PyResult<Columns<'py>> {
    let (numbers, whole) = (PyDict::new(py), PyDict::new(py));
    for (name, value) in columns {
        numbers.set_item(name, floats(py, points.iter().map(value))?)?;
    }
    Ok((numbers, whole))
}

/// Of the pull-off of a seta.
pub fn of_seta<'py>(py: Python<'py>, points: &[SetaPoint]) -> PyResult<Columns<'py>> {
    let (numbers, whole) = of(py, points, &OF_SETA)?;
    whole.set_item("step", counts(py, points.iter().map(|at| at.step + 1))?)?;
    whole.set_item("tips_attached", counts(py, points.iter().map(|at| at.attached))?)?;
    Ok((numbers, whole))
}

/// Of a pull at a rate: of a beam with its front, of a seta with its tips.
pub fn at_rate<'py>(py: Python<'py>, points: &[PointAtRate]) -> PyResult<Columns<'py>> {
    let (numbers, whole) = of(py, points, &AT_RATE)?;
    match points.first().map(|at| at.contact) {
        Some(Contact::Tips { .. }) => {
            numbers.set_item("tip_forces", floats(py, points.iter().map(|at| tips(at)[0]))?)?;
            numbers.set_item("released", floats(py, points.iter().map(|at| tips(at)[1]))?)?;
            let attached = points.iter().map(|at| at.attached().unwrap_or(0));
            whole.set_item("tips_attached", counts(py, attached)?)?;
        }
        _ => numbers.set_item("front", floats(py, points.iter().map(front))?)?,
    }
    Ok((numbers, whole))
}

/// Of a seta the forces of its tips, and what was released.
fn tips(at: &PointAtRate) -> [f64; 2] {
    match at.contact {
        Contact::Tips { force, released, .. } => [force, released],
        Contact::Front(_) => [0.0; 2],
    }
}

fn front(at: &PointAtRate) -> f64 {
    match at.contact {
        Contact::Front(front) => front,
        Contact::Tips { .. } => 0.0,
    }
}
