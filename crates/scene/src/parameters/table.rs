//! The cells of a profile's table.

use super::in_lists::NumberInList;
use peelkit::model::{Body, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable};

/// A column of a table.
type Column = fn(&mut ProfileColumns) -> &mut Vec<f64>;

/// In the order of [`ProfileTable::COLUMNS`].
const COLUMNS: [Column; 5] =
    [|c| &mut c.places, |c| &mut c.widths, |c| &mut c.heights, |c| &mut c.angles, |c| &mut c.roundness];

/// Column by column, row by row.
pub(super) fn numbers(model: &PeelModel) -> Vec<NumberInList> {
    let Body::Profile(Profile { form: ProfileForm::Table(table), .. }) = &model.body else { return Vec::new() };
    let mut columns = table.columns();
    let mut found = Vec::new();
    for (name, column) in ProfileTable::COLUMNS.into_iter().zip(COLUMNS) {
        let values = column(&mut columns).clone();
        for (row, _) in values.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            found.push(cell(format!("profile.table.{name}[{}]", row + 1), columns.clone(), column, row));
        }
    }
    found
}

fn cell(key: String, columns: ProfileColumns, column: Column, row: usize) -> NumberInList {
    let changed = move |model: &mut PeelModel, factor: f64| {
        let mut columns = columns.clone();
        column(&mut columns)[row] *= factor;
        let table = ProfileTable::new(columns).map_err(|wrong| wrong.to_string())?;
        if let Body::Profile(profile) = &mut model.body {
            profile.form = ProfileForm::Table(table);
        }
        Ok(())
    };
    NumberInList { key, changed: Box::new(changed) }
}
