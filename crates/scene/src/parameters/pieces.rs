//! The numbers of a profile's pieces.
//!
//! One that a piece has at its beginning and at its end alike is one number, and so is a height that two pieces share where they meet: it may not
//! jump there. The first piece that has it gives it its name.

use super::in_lists::NumberInList;
use peelkit::model::{Body, PeelModel, Piece, Profile, ProfileForm, ProfilePieces};

/// A number of a piece.
type Number = fn(&mut Piece) -> &mut f64;
/// Its values at its beginning and at its end.
type Ends = fn(&mut Piece) -> &mut [f64; 2];
/// Which piece, and 0 for its beginning or 1 for its end.
type Place = (usize, usize);

/// Piece by piece length, bend, width and roundness; then the heights.
pub(super) fn numbers(model: &PeelModel) -> Vec<NumberInList> {
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
