//! An unstructured grid and a list of such in VTK's XML.
//!
//! <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>

use super::table::written;
use std::io;

/// Points with cells between them and numbers at them.
pub(crate) struct Grid {
    /// x, y, z, nm
    pub points: Vec<[f64; 3]>,
    /// Numbers of their corners: two of a line, three of a triangle, four of a quadrilateral
    pub cells: Vec<Vec<usize>>,
    /// Numbers at the points
    pub data: Vec<PointData>,
}

/// One array of a grid: so many numbers a point.
pub(crate) struct PointData {
    pub name: &'static str,
    pub components: usize,
    pub values: Vec<f64>,
}

/// VTK's number of a cell with so many corners.
fn cell_type(corners: usize) -> usize {
    match corners {
        2 => 3,
        3 => 5,
        _ => 9,
    }
}

impl Grid {
    /// The grid of a state, with numbers of the whole state as field data. Fails where a number is not finite.
    pub fn of_state(&self, fields_of_state: &[(&str, f64)]) -> io::Result<String> {
        let mut of_state = String::new();
        for &(name, value) in fields_of_state {
            let value = written(name, value)?;
            of_state += &array("Float64", &format!("Name=\"{name}\" NumberOfTuples=\"1\""), &value);
        }
        let mut fields = String::new();
        for PointData { name, components, values } in &self.data {
            let components =
                if *components == 1 { String::new() } else { format!(" NumberOfComponents=\"{components}\"") };
            fields += &array("Float64", &format!("Name=\"{name}\"{components}"), &numbers(name, values)?);
        }
        let places = numbers("Points", self.points.as_flattened())?;
        let places = array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", &places);
        let corners = self.cells.iter().map(|cell| words(cell.iter())).collect::<Vec<_>>().join(" ");
        let ends = self.cells.iter().scan(0, |end, cell| {
            *end += cell.len();
            Some(*end)
        });
        let cells = array("Int64", "Name=\"connectivity\"", &corners)
            + &array("Int64", "Name=\"offsets\"", &words(ends))
            + &array("UInt8", "Name=\"types\"", &words(self.cells.iter().map(|cell| cell_type(cell.len()))));
        let (points, count) = (self.points.len(), self.cells.len());
        let piece = format!("    <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{count}\">\n")
            + &format!("      <PointData>\n{fields}      </PointData>\n      <CellData>\n      </CellData>\n")
            + &format!("      <Points>\n{places}      </Points>\n      <Cells>\n{cells}      </Cells>\n    </Piece>\n");
        let data = format!("    <FieldData>\n{of_state}    </FieldData>\n");
        Ok(in_file("UnstructuredGrid", &format!("  <UnstructuredGrid>\n{data}{piece}  </UnstructuredGrid>\n")))
    }
}

/// The list of the files of a time series; the time of a file is its number.
pub(crate) fn collection(files: impl Iterator<Item = String>) -> String {
    let line = |(time, file): (usize, String)| {
        format!("    <DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{file}\"/>\n")
    };
    let lines: String = files.enumerate().map(line).collect();
    in_file("Collection", &format!("  <Collection>\n{lines}  </Collection>\n"))
}

fn numbers(name: &str, values: &[f64]) -> io::Result<String> {
    let values = values.iter().map(|&value| written(name, value));
    Ok(values.collect::<io::Result<Vec<_>>>()?.join(" "))
}

fn words(values: impl Iterator<Item = impl ToString>) -> String {
    values.map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
}

fn array(kind: &str, attributes: &str, values: &str) -> String {
    format!("        <DataArray type=\"{kind}\" {attributes} format=\"ascii\">{values}</DataArray>\n")
}

fn in_file(kind: &str, content: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n{content}</VTKFile>\n"
    )
}
