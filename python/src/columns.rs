//! Columns of tables as the memory of arrays.

use peelkit_report::{Cell, Record, columns_of, without_unit};
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyList};

/// A column for Python: its name without the unit, the unit, the type of its array, and the memory of that; of words a list of them.
pub type Column = (String, String, &'static str, Py<PyAny>);

/// The columns of records, in the order of their table.
pub fn of_records<R: Record>(py: Python, rows: impl Iterator<Item = R>) -> PyResult<Vec<Column>> {
    of_cells(py, columns_of(rows))
}

/// Columns by the names of their table.
pub fn of_cells(py: Python, columns: Vec<(String, Vec<Cell>)>) -> PyResult<Vec<Column>> {
    let column = |(name, cells): (String, Vec<Cell>)| {
        let (kind, memory) = array(py, &cells)?;
        let (name, unit) = without_unit(&name);
        Ok((name.to_owned(), unit.to_owned(), kind, memory.unbind()))
    };
    columns.into_iter().map(column).collect()
}

fn array<'py>(py: Python<'py>, cells: &[Cell]) -> PyResult<(&'static str, Bound<'py, PyAny>)> {
    let number = |cell: &Cell| if let Cell::Number(number) = cell { *number } else { f64::NAN };
    let count = |cell: &Cell| if let Cell::Count(count) = cell { *count as usize } else { 0 };
    let words = |cell: &Cell| if let Cell::Text(text) = cell { text.clone() } else { String::new() };
    Ok(match cells.first() {
        Some(Cell::Count(_)) => ("int64", counts(py, cells.iter().map(count))?.into_any()),
        Some(Cell::Flag(_)) => {
            let flags: Vec<u8> = cells.iter().map(|cell| u8::from(*cell == Cell::Flag(true))).collect();
            ("bool", PyByteArray::new(py, &flags).into_any())
        }
        Some(Cell::Text(_)) => ("str", PyList::new(py, cells.iter().map(words))?.into_any()),
        _ => ("float64", floats(py, cells.iter().map(number))?.into_any()),
    })
}

/// Numbers as the memory of an array of float64, which `numpy.frombuffer` takes as it is.
pub fn floats<'py>(py: Python<'py>, values: impl ExactSizeIterator<Item = f64>) -> PyResult<Bound<'py, PyByteArray>> {
    memory(py, values.len(), values.map(f64::to_ne_bytes))
}

/// Counts as the memory of an array of int64.
pub fn counts<'py>(py: Python<'py>, values: impl ExactSizeIterator<Item = usize>) -> PyResult<Bound<'py, PyByteArray>> {
    memory(py, values.len(), values.map(|count| (count as i64).to_ne_bytes()))
}

fn memory<'py>(
    py: Python<'py>,
    length: usize,
    items: impl Iterator<Item = [u8; 8]>,
) -> PyResult<Bound<'py, PyByteArray>> {
    PyByteArray::new_with(py, 8 * length, |memory| {
        memory.chunks_exact_mut(8).zip(items).for_each(|(place, item)| place.copy_from_slice(&item));
        Ok(())
    })
}
