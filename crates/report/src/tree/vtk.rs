//! A tree as a time series for ParaView: states.pvd lists one unstructured grid a moment, whose cells are lines of two nodes.

use super::shape::{BranchShape, TreeState};
use crate::error::ReportError;
use crate::file::write_whole;
use crate::states::{Grid, PointData, collection};
use peelkit::beam::BranchSection;
use std::path::{Path, PathBuf};

/// An array of the grids: one number or three at each section of a branch.
pub struct TreeField {
    /// With its unit
    pub name: &'static str,
    /// What it is
    pub about: &'static str,
    /// One number, or three along x, y and z
    pub components: usize,
    value: fn(&BranchShape, &BranchSection) -> [f64; 3],
}

const fn number(name: &'static str, about: &'static str, value: fn(&BranchShape, &BranchSection) -> [f64; 3]) -> TreeField {
    TreeField { name, about, components: 1, value }
}

const fn vector(name: &'static str, about: &'static str, value: fn(&BranchShape, &BranchSection) -> [f64; 3]) -> TreeField {
    TreeField { name, about, components: 3, value }
}

/// What is written of each section, in the order of the arrays.
pub const TREE_FIELDS: &[TreeField] = &[
    number("radius_nm", "radius of the round section", |branch, _| [branch.radius, 0.0, 0.0]),
    number("generation", "branchings between the branch and the root", |branch, _| [branch.generation as f64, 0.0, 0.0]),
    number("attached", "1 where a tip behind the branch adheres, else 0", |branch, _| {
        [f64::from(u8::from(branch.attached)), 0.0, 0.0]
    }),
    vector("force_nN", "section force along x, y and z: what the part nearer to the tips exerts", |_, at| at.force),
    vector("moment_nN_nm", "section moment about x, y and z", |_, at| at.moment),
];

/// Writes states.pvd, the list of the moments, and states/state-000.vtu and so on, which it names: the sections where elements begin and end,
/// in nm, joined by lines of two nodes, with [`TREE_FIELDS`] as point data; displacement, force and number of attached tips as field data.
/// Branches share no points: section forces differ on the two sides of a joint. The time of a moment is its number.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_tree_states(dir: &Path, states: &[TreeState]) -> Result<Vec<PathBuf>, ReportError> {
    let name = |number: usize| format!("states/state-{number:03}.vtu");
    let list = dir.join("states.pvd");
    write_whole(&list, collection((0..states.len()).map(name)).as_bytes())?;
    let mut files = vec![list];
    for (number, state) in states.iter().enumerate() {
        let path = dir.join(name(number));
        let of_state = [
            ("displacement_nm", state.displacement),
            ("force_nN", state.force),
            ("tips_attached", state.tips_attached() as f64),
        ];
        let text = grid(&state.branches).of_state(&of_state);
        let text = text.map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, text.as_bytes())?;
        files.push(path);
    }
    Ok(files)
}

fn grid(branches: &[BranchShape]) -> Grid {
    let (mut points, mut cells) = (Vec::new(), Vec::new());
    for branch in branches {
        let first = points.len();
        points.extend(branch.sections.iter().map(|section| section.place));
        cells.extend((first + 1..points.len()).map(|k| vec![k - 1, k]));
    }
    let data = TREE_FIELDS.iter().map(|field| {
        let at = |branch, section| (field.value)(branch, section).into_iter().take(field.components);
        let sections = branches.iter().flat_map(|branch| branch.sections.iter().map(move |section| (branch, section)));
        let values = sections.flat_map(|(branch, section)| at(branch, section)).collect();
        PointData { name: field.name, components: field.components, values }
    });
    Grid { points, cells, data: data.collect() }
}
