//! A time series for ParaView: states.pvd lists one unstructured grid a state, the axis of the beam as lines; of a beam in space
//! states-surface.pvd lists its surface.

use super::fields::{SPATIAL_STATE_FIELDS, STATE_FIELDS, VECTORS};
use super::grid::{Grid, PointData, collection};
use super::surface;
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use peelkit::study::{BeamState, SectionFields, SpatialSectionFields, StateSections};
use std::path::{Path, PathBuf};

/// The folder of the grids, beside their lists.
const FOLDER: &str = "states";

/// Writes states.pvd, the list of the states, and states/state-000.vtu and so on, which it names: points of the axis in nm with
/// [`STATE_FIELDS`] as point data, of a beam in space with [`SPATIAL_STATE_FIELDS`], directors and loads among them as vectors; and u and P as
/// field data. The time of a state is its number. Of a beam in space states-surface.pvd and states/surface-000.vtu and so on are its surface.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_vtk(dir: &Path, states: &[BeamState]) -> Result<Vec<PathBuf>, ReportError> {
    let axis = |state: &BeamState| match &state.sections {
        StateSections::Planar(sections) => Some(planar_axis(sections)),
        StateSections::Spatial { sections, .. } => Some(spatial_axis(sections)),
    };
    let surface = |state: &BeamState| match &state.sections {
        StateSections::Planar(_) => None,
        StateSections::Spatial { outline, sections } => Some(surface::grid(*outline, sections)),
    };
    let mut files = write_series(dir, states, ["states.pvd", "state"], axis)?;
    if states.iter().any(|state| matches!(state.sections, StateSections::Spatial { .. })) {
        files.extend(write_series(dir, states, ["states-surface.pvd", "surface"], surface)?);
    }
    Ok(files)
}

/// A list with this name, and the grids that it names.
fn write_series(
    dir: &Path,
    states: &[BeamState],
    [list, stem]: [&str; 2],
    grid: impl Fn(&BeamState) -> Option<Grid>,
) -> Result<Vec<PathBuf>, ReportError> {
    let name = |number: usize| format!("{FOLDER}/{stem}-{number:03}.vtu");
    let list = dir.join(list);
    write_whole(&list, collection((0..states.len()).map(name)).as_bytes())?;
    let mut files = vec![list];
    for (number, state) in states.iter().enumerate() {
        let Some(grid) = grid(state) else { continue };
        let path = dir.join(name(number));
        let of_state = [
            ("displacement_nm", state.displacement),
            ("force_nN", state.force),
            ("path_position", state.path_position),
        ];
        let text = grid.of_state(&of_state).map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, text.as_bytes())?;
        files.push(path);
    }
    Ok(files)
}

/// Lines from place to place.
fn lines(points: usize) -> Vec<Vec<usize>> {
    (1..points).map(|k| vec![k - 1, k]).collect()
}

fn planar_axis(sections: &[SectionFields]) -> Grid {
    let data = STATE_FIELDS.iter().map(|field| PointData {
        name: field.name,
        components: 1,
        values: sections.iter().map(field.value).collect(),
    });
    let points = sections.iter().map(|section| [section.x, section.y, 0.0]).collect();
    Grid { points, cells: lines(sections.len()), data: data.collect() }
}

fn spatial_axis(sections: &[SpatialSectionFields]) -> Grid {
    let values = |name: &str| -> Vec<f64> {
        let field = SPATIAL_STATE_FIELDS.iter().filter(|field| field.name == name);
        field.flat_map(|field| sections.iter().map(field.value)).collect()
    };
    let is_part = |name: &str| VECTORS.iter().any(|(_, parts)| parts.contains(&name));
    let scalars = SPATIAL_STATE_FIELDS.iter().filter(|field| !is_part(field.name));
    let scalars = scalars.map(|field| PointData { name: field.name, components: 1, values: values(field.name) });
    let vectors = VECTORS.iter().map(|&(name, parts)| {
        let [x, y, z] = parts.map(values);
        let values = x.into_iter().zip(y).zip(z).flat_map(|((x, y), z)| [x, y, z]).collect();
        PointData { name, components: 3, values }
    });
    let points = sections.iter().map(|at| at.state.section.place).collect();
    Grid { points, cells: lines(sections.len()), data: scalars.chain(vectors).collect() }
}
