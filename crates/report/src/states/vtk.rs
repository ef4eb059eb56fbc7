//! A time series for ParaView: states.pvd lists one unstructured grid a state, the axis of the beam as lines, in VTK's XML.
//!
//! <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>

use super::fields::STATE_FIELDS;
use super::table::written;
use crate::error::ReportError;
use crate::file::write_whole;
use peelkit::study::BeamState;
use std::io;
use std::path::{Path, PathBuf};

/// The folder of the grids, beside states.pvd.
const FOLDER: &str = "states";
/// VTK's number of a line between two points.
const LINE: usize = 3;

/// Writes states.pvd, the list of the states, and states/state-000.vtu and so on, which it names: points (x, y, 0) of the axis in nm with
/// [`STATE_FIELDS`] as point data, and u and P as field data. The time of a state is its number.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_vtk(dir: &Path, states: &[BeamState]) -> Result<Vec<PathBuf>, ReportError> {
    let name = |number: usize| format!("{FOLDER}/state-{number:03}.vtu");
    let list = dir.join("states.pvd");
    write_whole(&list, collection((0..states.len()).map(name)).as_bytes())?;
    let mut files = vec![list];
    for (number, state) in states.iter().enumerate() {
        let path = dir.join(name(number));
        let text = grid(state).map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, text.as_bytes())?;
        files.push(path);
    }
    Ok(files)
}

fn collection(files: impl Iterator<Item = String>) -> String {
    let line = |(time, file): (usize, String)| {
        format!("    <DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{file}\"/>\n")
    };
    let lines: String = files.enumerate().map(line).collect();
    in_file("Collection", &format!("  <Collection>\n{lines}  </Collection>\n"))
}

fn grid(state: &BeamState) -> io::Result<String> {
    let points = state.sections.len();
    let lines = points.saturating_sub(1);
    let mut of_state = String::new();
    for (name, value) in
        [("displacement_nm", state.displacement), ("force_nN", state.force), ("path_position", state.path_position)]
    {
        let value = written(name, value)?;
        of_state += &array("Float64", &format!("Name=\"{name}\" NumberOfTuples=\"1\""), &value);
    }
    let mut fields = String::new();
    for field in STATE_FIELDS {
        let values = state.sections.iter().map(|section| written(field.name, (field.value)(section)));
        fields +=
            &array("Float64", &format!("Name=\"{}\"", field.name), &values.collect::<io::Result<Vec<_>>>()?.join(" "));
    }
    let place = |x: f64, y: f64| Ok(format!("{} {} 0", written("x_nm", x)?, written("y_nm", y)?));
    let places = state.sections.iter().map(|section| place(section.x, section.y)).collect::<io::Result<Vec<_>>>()?;
    let places = array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", &places.join(" "));
    let numbers = |of: &dyn Fn(usize) -> String| (0..lines).map(of).collect::<Vec<_>>().join(" ");
    let cells = array("Int64", "Name=\"connectivity\"", &numbers(&|k| format!("{k} {}", k + 1)))
        + &array("Int64", "Name=\"offsets\"", &numbers(&|k| (2 * (k + 1)).to_string()))
        + &array("UInt8", "Name=\"types\"", &numbers(&|_| LINE.to_string()));
    let piece = format!("    <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{lines}\">\n")
        + &format!("      <PointData>\n{fields}      </PointData>\n      <CellData>\n      </CellData>\n")
        + &format!("      <Points>\n{places}      </Points>\n      <Cells>\n{cells}      </Cells>\n    </Piece>\n");
    let data = format!("    <FieldData>\n{of_state}    </FieldData>\n");
    Ok(in_file("UnstructuredGrid", &format!("  <UnstructuredGrid>\n{data}{piece}  </UnstructuredGrid>\n")))
}

fn array(kind: &str, attributes: &str, values: &str) -> String {
    format!("        <DataArray type=\"{kind}\" {attributes} format=\"ascii\">{values}</DataArray>\n")
}

fn in_file(kind: &str, content: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n{content}</VTKFile>\n"
    )
}
