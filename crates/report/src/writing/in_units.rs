//! Tables once more in the units that the user wants: the same rows, with other numbers and other units in the names of the columns.

use super::error::ReportError;
use super::file::write_whole;
use peelkit::units::{FORCES, LENGTHS, PreferredUnits, Unit, WORKS};
use std::io;
use std::path::{Path, PathBuf};

/// The folder of these tables.
const FOLDER: &str = "in-units";

/// Writes those of `files` that are tables directly in `dir`, and have a column in another unit than the wanted ones, to `dir/in-units`.
///
/// Fails with [`ReportError::Write`] where a table cannot be read again, or written.
pub fn write_in_units(dir: &Path, files: &[PathBuf], units: PreferredUnits) -> Result<Vec<PathBuf>, ReportError> {
    let mut written = Vec::new();
    if units.given().next().is_none() {
        return Ok(written);
    }
    let is_table = |file: &&PathBuf| file.parent() == Some(dir) && file.extension().is_some_and(|of| of == "csv");
    for file in files.iter().filter(is_table) {
        let path = dir.join(FOLDER).join(file.file_name().unwrap_or_default());
        let converted = std::fs::read(file).and_then(|text| in_units(&text, units));
        let converted = converted.map_err(|source| ReportError::Write { path: path.clone(), source })?;
        if let Some(text) = converted {
            write_whole(&path, &text)?;
            written.push(path);
        }
    }
    Ok(written)
}

/// A table in these units; nothing where none of its columns changes.
fn in_units(text: &[u8], units: PreferredUnits) -> io::Result<Option<Vec<u8>>> {
    let mut reader = csv::Reader::from_reader(text);
    let header = reader.headers()?.clone();
    let of_columns: Vec<Option<(String, Unit)>> = header.iter().map(|name| renamed(name, units)).collect();
    if of_columns.iter().all(Option::is_none) {
        return Ok(None);
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header.iter().zip(&of_columns).map(|(name, of)| of.as_ref().map_or(name, |(name, _)| name)))?;
    for row in reader.records() {
        let row = row?;
        let cell = |(cell, of): (&str, &Option<(String, Unit)>)| match (of, cell.parse()) {
            (Some((_, unit)), Ok(number)) => converted(number, *unit),
            _ => cell.to_owned(),
        };
        writer.write_record(row.iter().zip(&of_columns).map(cell))?;
    }
    writer.into_inner().map(Some).map_err(|error| error.into_error())
}

/// The name of a column in nN, nm or aJ in the wanted unit, and that. One of a quotient or a product of units is left as it is.
fn renamed(name: &str, units: PreferredUnits) -> Option<(String, Unit)> {
    let (stem, unit) = name.rsplit_once('_')?;
    let known = [FORCES, LENGTHS, WORKS];
    let of = known.into_iter().find(|units| units.iter().any(|known| known.size == 1.0 && known.name == unit))?;
    let before = stem.rsplit('_').next().unwrap_or_default();
    let is_alone = before != "per" && !known.iter().any(|units| units.iter().any(|known| known.name == before));
    let wanted = units.of(of).filter(|wanted| is_alone && wanted.size != 1.0)?;
    Some((format!("{stem}_{}", wanted.ascii()), wanted))
}

/// A number in the unit, to 15 digits: a division by a power of ten may leave a last one.
fn converted(number: f64, unit: Unit) -> String {
    let number: f64 = format!("{:.14e}", unit.of(number)).parse().unwrap_or_else(|_| unit.of(number));
    if number == 0.0 || (1e-5..1e16).contains(&number.abs()) { number.to_string() } else { format!("{number:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_one_unit_change_and_others_stay() {
        let table =
            "displacement_nm,force_nN,moment_nN_nm,stiffness_nN_per_nm,kind\n1234567.8,0.5,2,3,load\n,-2e-3,4,5,\n";
        let units = PreferredUnits::parse("µm,pN").unwrap();
        let text = in_units(table.as_bytes(), units).unwrap().unwrap();
        assert_eq!(
            String::from_utf8(text).unwrap(),
            "displacement_um,force_pN,moment_nN_nm,stiffness_nN_per_nm,kind\n1234.5678,500,2,3,load\n,-2,4,5,\n"
        );
        assert_eq!(in_units(b"work_aJ\n1\n", units).unwrap(), None);
        assert_eq!(in_units(b"displacement_nm\n1\n", PreferredUnits::parse("nm").unwrap()).unwrap(), None);
    }

    #[test]
    fn numbers_have_no_digits_of_the_division() {
        let [micro, milli] = [LENGTHS[2], LENGTHS[3]];
        assert_eq!(converted(0.3, micro), "0.0003");
        assert_eq!(converted(1.1e-3, milli), "1.1e-9");
        assert_eq!(converted(-70.0, micro), "-0.07");
    }
}
