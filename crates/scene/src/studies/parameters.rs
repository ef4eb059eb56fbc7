//! The numbers of a scene that results can be differentiated by.

use crate::key::kind::Key;
use crate::keys::KEYS;
use crate::scene::Scene;
use crate::value::Value;
use peelkit::model::{Body, PeelModel, Piece, Profile, ProfileColumns, ProfileForm, ProfilePieces, ProfileTable, Step};
use peelkit::study::{MOST_CHANGED, Variation};

/// Tables whose numbers describe no beam but its computation.
const NOT_OF_THE_MODEL: [&str; 2] = ["accuracy", "bounds"];
/// By how much the logarithm of a number is changed to see whether the model depends on it.
const TRIED: f64 = 1e-4;

/// The numbers of a scene as parameters of its model.
#[derive(Default)]
pub struct Parameters {
    /// Each in its logarithm
    pub variations: Vec<Variation<'static>>,
    /// Those that cannot change alone, by what each is called, with the reason
    pub fixed: Vec<(String, String)>,
}

impl Scene {
    /// Every number of the scene that its model depends on and that is not zero, as a variation in its logarithm: given or left at its default. Of
    /// a list each number by its place, counted from 1: `profile.table.width_nm[3]`, `profile.pieces[2].length`, `profile.pieces[2].height[1]` for
    /// the first of two values, `drive.steps[1]`.
    pub fn parameters(&self) -> Parameters {
        let numbers = KEYS.iter().filter(|key| key.is_numeric() && !key.is_count() && key.belongs_to(self));
        let numbers = numbers.filter(|key| !NOT_OF_THE_MODEL.contains(&key.table));
        let mut found =
            Parameters { variations: numbers.filter_map(|key| self.variation(key)).collect(), fixed: vec![] };
        let lists = [numbers_of_table(&self.model), numbers_of_pieces(&self.model), numbers_of_steps(&self.model)];
        for number in lists.into_iter().flatten() {
            match number.into_variation(&self.model) {
                Ok(variation) => found.variations.push(variation),
                Err(fixed) => found.fixed.push(fixed),
            }
        }
        found.variations.retain(|variation| (variation.model)(TRIED) != self.model);
        found
    }

    /// The number of one key as a variation in its logarithm; nothing where it is not set or zero.
    pub fn variation(&self, key: &'static Key) -> Option<Variation<'static>> {
        let Some(Value::Number(number)) = key.value(self) else { return None };
        if number == 0.0 || !number.is_finite() {
            return None;
        }
        let scene = self.clone();
        Some(Variation::new(key.path(), move |change| {
            let mut scene = scene.clone();
            // a number out of its range is for the check of the model to refuse
            key.put_number(&mut scene, number * change.exp());
            scene.model
        }))
    }
}

/// Puts a list into a model in which one number is so many times as large; else what is wrong with that list.
type Changed = Box<dyn Fn(&mut PeelModel, f64) -> Result<(), String> + Send + Sync>;

/// A number of a list.
struct NumberInList {
    /// The key of the list with the place in it
    pub key: String,
    pub changed: Changed,
}

impl NumberInList {
    /// As a variation in its logarithm; its key and the reason where the list is none with the number changed alone as far as it is for a derivative.
    pub fn into_variation(self, model: &PeelModel) -> Result<Variation<'static>, (String, String)> {
        let wrong = [MOST_CHANGED, -MOST_CHANGED].map(|change| (self.changed)(&mut model.clone(), change.exp()).err());
        if let Some(wrong) = wrong.into_iter().flatten().next() {
            let percent = 100.0 * MOST_CHANGED;
            return Err((self.key, format!("changed alone by {percent} % it makes a list that {wrong}")));
        }
        let model = model.clone();
        Ok(Variation::new(self.key, move |change| {
            let mut model = model.clone();
            // farther than it was tried a list may be none, which the model does not take
            let _ = (self.changed)(&mut model, change.exp());
            model
        }))
    }
}

/// A column of a table.
type Column = fn(&mut ProfileColumns) -> &mut Vec<f64>;

/// In the order of [`ProfileTable::COLUMNS`].
const COLUMNS: [Column; 5] =
    [|c| &mut c.places, |c| &mut c.widths, |c| &mut c.heights, |c| &mut c.angles, |c| &mut c.roundness];

/// Column by column, row by row.
fn numbers_of_table(model: &PeelModel) -> Vec<NumberInList> {
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

/// A number of a piece.
type Number = fn(&mut Piece) -> &mut f64;
/// Its values at its beginning and at its end.
type Ends = fn(&mut Piece) -> &mut [f64; 2];
/// Which piece, and 0 for its beginning or 1 for its end.
type Place = (usize, usize);

/// Piece by piece length, bend, width and roundness; then the heights.
fn numbers_of_pieces(model: &PeelModel) -> Vec<NumberInList> {
    let Body::Profile(Profile { form: ProfileForm::Pieces(beam), .. }) = &model.body else { return Vec::new() };
    let pieces = beam.pieces();
    let mut found = Vec::new();
    for index in 0..pieces.len() {
        found.extend(along("length", pieces, index, |piece| &mut piece.length));
        found.extend(along("bend", pieces, index, |piece| &mut piece.bend));
        found.extend(at_ends("width", pieces, &[index], |piece| &mut piece.width));
        found.extend(at_ends("roundness", pieces, &[index], |piece| &mut piece.roundness));
    }
    let all: Vec<usize> = (0..pieces.len()).collect();
    found.extend(at_ends("height", pieces, &all, |piece| &mut piece.height));
    found
}

/// A number of one piece, unless it is zero.
fn along(name: &str, pieces: &[Piece], index: usize, number: Number) -> Option<NumberInList> {
    let key = format!("profile.pieces[{}].{name}", index + 1);
    let is_zero = *number(&mut pieces[index].clone()) == 0.0;
    (!is_zero).then(|| with_pieces(key, pieces, move |pieces, factor| *number(&mut pieces[index]) *= factor))
}

/// Numbers at the ends of pieces that follow each other: places with one number together.
fn at_ends(name: &str, pieces: &[Piece], among: &[usize], ends: Ends) -> Vec<NumberInList> {
    let value = |&(index, end): &Place| ends(&mut pieces[index].clone())[end];
    let places: Vec<Place> = among.iter().flat_map(|&index| [(index, 0), (index, 1)]).collect();
    let groups = places.chunk_by(|a, b| a.0 != b.0 || value(a) == value(b)).filter(|group| value(&group[0]) != 0.0);
    let one = |group: &[Place]| {
        let (index, end) = group[0];
        let piece = format!("profile.pieces[{}].{name}", index + 1);
        let has_two = value(&(index, 0)) != value(&(index, 1));
        let key = if has_two { format!("{piece}[{}]", end + 1) } else { piece };
        let group = group.to_vec();
        with_pieces(key, pieces, move |pieces, factor| {
            group.iter().for_each(|&(index, end)| ends(&mut pieces[index])[end] *= factor);
        })
    };
    groups.map(one).collect()
}

/// A number that is multiplied in a list of pieces.
fn with_pieces(
    key: String,
    pieces: &[Piece],
    multiplied: impl Fn(&mut [Piece], f64) + Send + Sync + 'static,
) -> NumberInList {
    let pieces = pieces.to_vec();
    let changed = move |model: &mut PeelModel, factor: f64| {
        let mut pieces = pieces.clone();
        multiplied(&mut pieces, factor);
        let pieces = ProfilePieces::new(pieces).map_err(|wrong| wrong.to_string())?;
        if let Body::Profile(profile) = &mut model.body {
            profile.form = ProfileForm::Pieces(pieces);
        }
        Ok(())
    };
    NumberInList { key, changed: Box::new(changed) }
}

/// One a step that has an amount.
fn numbers_of_steps(model: &PeelModel) -> Vec<NumberInList> {
    let with_amount = model.steps.iter().enumerate().filter(|(_, step)| step.motion().is_some());
    with_amount.map(|(index, step)| amount(index, *step)).collect()
}

fn amount(index: usize, step: Step) -> NumberInList {
    let changed = move |model: &mut PeelModel, factor: f64| {
        let step = step.scaled(factor);
        step.check().map_err(|wrong| format!("has a step {} {wrong}", index + 1))?;
        if let Some(place) = model.steps.get_mut(index) {
            *place = step;
        }
        Ok(())
    };
    NumberInList { key: format!("drive.steps[{}]", index + 1), changed: Box::new(changed) }
}
