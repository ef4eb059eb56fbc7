//! A seta as a time series for ParaView: states.pvd lists one unstructured grid a state, whose cells are lines of two nodes.

use super::motion::SetaPose;
use crate::states::grid::{Grid, PointData, collection};
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use crate::writing::reference::{Output, OutputKey};
use peelkit::beam::BranchSection;
use peelkit::study::SetaBranch;
use std::path::{Path, PathBuf};

/// An array of the grids: one number or three at each section of a branch.
pub struct SetaStateField {
    /// With its unit
    pub name: &'static str,
    /// What it is
    pub about: &'static str,
    /// One number, or three along x, y and z
    pub components: usize,
    value: fn(&SetaBranch, &BranchSection) -> [f64; 3],
}

type Value = fn(&SetaBranch, &BranchSection) -> [f64; 3];

const fn number(name: &'static str, about: &'static str, value: Value) -> SetaStateField {
    SetaStateField { name, about, components: 1, value }
}

const fn vector(name: &'static str, about: &'static str, value: Value) -> SetaStateField {
    SetaStateField { name, about, components: 3, value }
}

/// What is written of each section, in the order of the arrays.
pub const SETA_STATE_FIELDS: &[SetaStateField] = &[
    number("radius_nm", "radius of the round section", |branch, _| [branch.radius, 0.0, 0.0]),
    number("generation", "forks between the branch and the root", |branch, _| [branch.generation as f64, 0.0, 0.0]),
    number("attached", "1 where a tip behind the branch adheres, else 0", |branch, _| {
        [f64::from(u8::from(branch.attached)), 0.0, 0.0]
    }),
    vector("force_nN", "section force along x, y and z: of the ground on all tips behind the section", |_, at| {
        at.force
    }),
    vector("moment_nN_nm", "section moment about x, y and z: of these forces about the section", |_, at| at.moment),
];

/// The arrays.
pub(super) fn output() -> Output {
    let keys = SETA_STATE_FIELDS.iter().map(|field| OutputKey::new(field.name, field.about)).collect();
    Output { name: "states.pvd of a seta", parts: "array", keys }
}

/// Writes states.pvd, the list of the states, and states/state-000.vtu and so on, which it names: sections along the branches in nm, joined by
/// lines of two nodes, with [`SETA_STATE_FIELDS`] as point data; displacement and force of the root and the number of attached tips as field
/// data. Branches share no points: section forces differ on the two sides of a fork. The time of a state is its number.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_seta_states(dir: &Path, poses: &[SetaPose]) -> Result<Vec<PathBuf>, ReportError> {
    let name = |number: usize| format!("states/state-{number:03}.vtu");
    let list = dir.join("states.pvd");
    write_whole(&list, collection((0..poses.len()).map(name)).as_bytes())?;
    let mut files = vec![list];
    for (number, SetaPose { point, branches, .. }) in poses.iter().enumerate() {
        let path = dir.join(name(number));
        let of_state = [
            ("step", point.step as f64),
            ("displacement_nm", point.displacement),
            ("force_nN", point.force_along),
            ("tips_attached", point.attached as f64),
        ];
        let text = grid(branches).of_state(&of_state);
        let text = text.map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, text.as_bytes())?;
        files.push(path);
    }
    Ok(files)
}

fn grid(branches: &[SetaBranch]) -> Grid {
    let (mut points, mut cells) = (Vec::new(), Vec::new());
    for branch in branches {
        let first = points.len();
        points.extend(branch.sections.iter().map(|section| section.place));
        cells.extend((first + 1..points.len()).map(|k| vec![k - 1, k]));
    }
    let data = SETA_STATE_FIELDS.iter().map(|field| {
        let sections = branches.iter().flat_map(|branch| branch.sections.iter().map(move |section| (branch, section)));
        let numbers = |(branch, section)| (field.value)(branch, section).into_iter().take(field.components);
        PointData { name: field.name, components: field.components, values: sections.flat_map(numbers).collect() }
    });
    Grid { points, cells, data: data.collect() }
}
