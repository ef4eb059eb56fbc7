//! A beam given piece by piece, each by a formula.
//!
//! Along a piece of length l that begins at S0, t = (S - S0)/l, its width, roundness and the direction φ of its underside go from
//! their first value to their last by one course c(t), the height by one of its own: b = b0 + (b1 - b0) c(t), and so on;
//! φ = φ0 + bend c(t), so that a linear course is an arc. φ begins with zero and goes on from piece to piece. Widths and roundness may
//! jump between pieces; the height may not, nor may its slope, by half of which the axis is steeper than the underside.

use super::transition::Transition;
use crate::beam::varying::{BeamGeometry, SectionGeometry};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// One piece of a beam.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Piece {
    /// nm
    pub length: f64,
    /// Where it begins and where it ends, nm
    pub width: [f64; 2],
    /// Likewise, nm
    pub height: [f64; 2],
    /// Likewise; 0: a rectangle, 1: an ellipse
    pub roundness: [f64; 2],
    /// Rotation of the stress-free underside along it, rad
    pub bend: f64,
    /// Of width, roundness and the direction of the underside
    pub course: Transition,
    /// Of the height
    pub height_course: Transition,
}

/// A beam in pieces, from its free end on. It is written as the list of these, and checked when it is read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Piece>", into = "Vec<Piece>")]
pub struct ProfilePieces {
    pieces: Vec<Piece>,
    /// S (nm) and φ (rad) where each begins, and at the end of the last.
    joints: Vec<[f64; 2]>,
}

impl From<ProfilePieces> for Vec<Piece> {
    fn from(beam: ProfilePieces) -> Self {
        beam.pieces
    }
}

impl TryFrom<Vec<Piece>> for ProfilePieces {
    type Error = PiecesError;

    fn try_from(pieces: Vec<Piece>) -> Result<Self, PiecesError> {
        Self::new(pieces)
    }
}

/// What is wrong with pieces; those are counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum PiecesError {
    #[error("has {0} pieces; it takes 1 to {MOST_PIECES}")]
    Count(usize),
    #[error("has in piece {piece} `{key}` = {found}{unit}, which {wrong}")]
    Value { piece: usize, key: &'static str, found: f64, unit: &'static str, wrong: &'static str },
    #[error(
        "has piece {piece} of {length} nm in a beam of {whole} nm, less than a billionth: remove it, or correct its unit"
    )]
    Short { piece: usize, length: f64, whole: f64 },
    #[error(
        "ends piece {piece} with a height of {ends} nm and begins the next with {begins} nm: the two have to be the same"
    )]
    Step { piece: usize, ends: f64, begins: f64 },
    #[error(
        "has a kink between piece {piece}, whose height rises by {ends} nm/nm at its end, and the next, by {begins} at its \
         beginning: omit height_course from both"
    )]
    Kink { piece: usize, ends: f64, begins: f64 },
    #[error("rotates the underside by {degrees} deg up to the end of piece {piece}, which is not from -180 to 180")]
    Turned { piece: usize, degrees: f64 },
}

impl PiecesError {
    /// With which piece it is, if with one.
    pub fn piece(&self) -> Option<usize> {
        match *self {
            Self::Count(_) => None,
            Self::Value { piece, .. }
            | Self::Short { piece, .. }
            | Self::Step { piece, .. }
            | Self::Kink { piece, .. }
            | Self::Turned { piece, .. } => Some(piece),
        }
    }
}

/// Most pieces: there is an element at least in each.
const MOST_PIECES: usize = 200;
/// A length, width or height beyond this is taken for a slip, nm.
const LARGEST: f64 = 1e12;
/// Shortest piece, over the whole beam.
const SHORTEST: f64 = 1e-9;
/// Heights, over themselves, and slopes that differ by less are the same.
const SAME: f64 = 1e-9;

/// What is so much of the way from the first to the last; exact at both ends, however far these are apart.
fn between([first, last]: [f64; 2], gone: f64) -> f64 {
    first * (1.0 - gone) + last * gone
}

impl Piece {
    /// Of a length, width and height, nm: a straight rectangle of one section.
    pub fn straight(length: f64, width: f64, height: f64) -> Self {
        Self {
            length,
            width: [width; 2],
            height: [height; 2],
            roundness: [0.0; 2],
            bend: 0.0,
            course: Transition::Linear,
            height_course: Transition::Smooth,
        }
    }

    /// h, h' and h'' at t: nm, 1, 1/nm.
    fn height_at(&self, t: f64) -> [f64; 3] {
        let Self { height: [begins, ends], length, .. } = *self;
        let [gone, slope, bend] = self.height_course.at(t);
        let rises = (ends - begins) / length;
        [between(self.height, gone), rises * slope, rises / length * bend]
    }

    /// What is wrong with its numbers: the key, what was found with its unit, and what it is.
    fn wrong(&self) -> Option<(&'static str, f64, &'static str, &'static str)> {
        let lengths = [("length", &[self.length][..]), ("width", &self.width), ("height", &self.height)];
        let lengths = lengths.into_iter().flat_map(|(key, found)| found.iter().map(move |&found| (key, found)));
        let lengths = lengths.map(|(key, found)| {
            let wrong = match found {
                _ if !found.is_finite() => Some("is not finite"),
                _ if found <= 0.0 => Some("is not above zero"),
                _ if found > LARGEST => Some("is more than 1e12"),
                _ => None,
            };
            (key, found, " nm", wrong)
        });
        let round = self.roundness.into_iter().map(|found| {
            let within = (0.0..=1.0).contains(&found);
            ("roundness", found, "", (!within).then_some("is not from 0 to 1"))
        });
        let bend = (!self.bend.is_finite()).then_some("is not finite");
        let all = lengths.chain(round).chain([("bend", self.bend, " rad", bend)]);
        all.filter_map(|(key, found, unit, wrong)| Some((key, found, unit, wrong?))).next()
    }
}

impl ProfilePieces {
    /// Of pieces from the free end on.
    ///
    /// ```
    /// use peelkit::beam::BeamGeometry;
    /// use peelkit::model::{Piece, ProfilePieces};
    ///
    /// let pad = Piece::straight(250.0, 200.0, 5.0);
    /// let neck = Piece { width: [200.0, 50.0], height: [5.0, 50.0], bend: 0.5, ..Piece::straight(150.0, 200.0, 5.0) };
    /// let beam = ProfilePieces::new(vec![pad, neck, Piece::straight(600.0, 50.0, 50.0)])?;
    /// assert_eq!((beam.length(), beam.breaks()), (1000.0, vec![250.0, 400.0]));
    /// assert_eq!((beam.at(325.0).width, beam.at(325.0).underside[0]), (125.0, 0.25));
    /// # Ok::<(), peelkit::model::PiecesError>(())
    /// ```
    pub fn new(pieces: Vec<Piece>) -> Result<Self, PiecesError> {
        if pieces.is_empty() || pieces.len() > MOST_PIECES {
            return Err(PiecesError::Count(pieces.len()));
        }
        let mut joints = vec![[0.0; 2]];
        let [mut place, mut turned] = [0.0, 0.0];
        for (index, own) in pieces.iter().enumerate() {
            let piece = index + 1;
            if let Some((key, found, unit, wrong)) = own.wrong() {
                return Err(PiecesError::Value { piece, key, found, unit, wrong });
            }
            (place, turned) = (place + own.length, turned + own.bend);
            // 180 degrees as a user may round it
            if turned.abs() > 1.0001 * PI {
                return Err(PiecesError::Turned { piece, degrees: turned.to_degrees() });
            }
            joints.push([place, turned]);
        }
        for (index, pair) in pieces.windows(2).enumerate() {
            let ([ends, slope, _], [begins, next_slope, _]) = (pair[0].height_at(1.0), pair[1].height_at(0.0));
            if (ends - begins).abs() > SAME * ends {
                return Err(PiecesError::Step { piece: index + 1, ends, begins });
            }
            if (slope - next_slope).abs() > SAME {
                return Err(PiecesError::Kink { piece: index + 1, ends: slope, begins: next_slope });
            }
        }
        let short = pieces.iter().position(|piece| piece.length < SHORTEST * place);
        match short {
            Some(index) => Err(PiecesError::Short { piece: index + 1, length: pieces[index].length, whole: place }),
            None => Ok(Self { pieces, joints }),
        }
    }

    /// From the free end on.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }
}

impl BeamGeometry for ProfilePieces {
    fn length(&self) -> f64 {
        self.joints[self.pieces.len()][0]
    }

    fn breaks(&self) -> Vec<f64> {
        self.joints[1..self.pieces.len()].iter().map(|joint| joint[0]).collect()
    }

    fn at(&self, place: f64) -> SectionGeometry {
        let index = self.joints[1..self.pieces.len()].partition_point(|joint| joint[0] <= place);
        let (piece, [begins, direction]) = (&self.pieces[index], self.joints[index]);
        let t = (place - begins) / piece.length;
        let [gone, going, _] = piece.course.at(t);
        SectionGeometry {
            width: between(piece.width, gone),
            height: piece.height_at(t),
            roundness: between(piece.roundness, gone),
            underside: [direction + piece.bend * gone, piece.bend * going / piece.length],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Spatula;
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Every kind of piece: derivatives of the outline against central differences, and no jump of what may not jump.
    #[test]
    fn slopes_are_those_of_the_outline() {
        let first = Piece { height: [5.0, 8.0], height_course: Transition::Linear, ..Piece::straight(60.0, 20.0, 5.0) };
        let second = Piece {
            height: [8.0, 11.0],
            roundness: [0.2, 0.9],
            bend: -0.4,
            course: Transition::Smooth,
            ..Piece { length: 60.0, ..first }
        };
        let beam = ProfilePieces::new(vec![first, second]).unwrap();
        let step = 1e-4;
        for k in 0..12 {
            let place = 10.0 * f64::from(k) + 5.3;
            let [before, here, after] = [place - step, place, place + step].map(|s| beam.at(s));
            let slope = |of: fn(&SectionGeometry) -> f64| (of(&after) - of(&before)) / (2.0 * step);
            assert_abs_diff_eq!(here.height[1], slope(|o| o.height[0]), epsilon = 1e-9);
            assert_abs_diff_eq!(here.height[2], slope(|o| o.height[1]), epsilon = 1e-9);
            assert_abs_diff_eq!(here.underside[1], slope(|o| o.underside[0]), epsilon = 1e-9);
        }
        let [before, after] = [60.0 - 1e-12, 60.0].map(|s| beam.at(s));
        for (before, after) in
            before.height[..2].iter().chain(&before.underside).zip(after.height[..2].iter().chain(&after.underside))
        {
            assert_abs_diff_eq!(*before, *after, epsilon = 1e-11);
        }
        assert_eq!(beam.at(120.0).underside[0], -0.4);
    }

    /// A spatula that bends where its neck is has three pieces.
    #[test]
    fn three_pieces_are_a_spatula() {
        let spatula = Spatula { bend_length: 150.0, ..Spatula::default() };
        let pad = Piece { width: [200.0, 50.0], ..Piece::straight(240.0, 200.0, 10.0) };
        let neck = Piece {
            height: [10.0, 50.0],
            roundness: [0.0, 1.0],
            bend: spatula.shaft_angle,
            course: Transition::Smooth,
            ..Piece::straight(150.0, 50.0, 10.0)
        };
        let shaft = Piece { roundness: [1.0; 2], ..Piece::straight(600.0, 50.0, 50.0) };
        let pieces = ProfilePieces::new(vec![pad, neck, shaft]).unwrap();
        assert_eq!((pieces.length(), pieces.breaks()), (spatula.length(), spatula.breaks()));
        for k in 0..=990 {
            let (of_pieces, whole) = (pieces.at(f64::from(k)), spatula.at(f64::from(k)));
            let numbers = |o: SectionGeometry| {
                let ([height, slope, bend], [angle, turn]) = (o.height, o.underside);
                [o.width, height, slope, 100.0 * bend, o.roundness, angle, 100.0 * turn]
            };
            for (a, b) in numbers(of_pieces).into_iter().zip(numbers(whole)) {
                assert_abs_diff_eq!(a, b, epsilon = 1e-12);
            }
        }
    }

    #[test]
    fn bad_pieces_are_refused_by_name() {
        let good = Piece::straight(40.0, 20.0, 5.0);
        let refused = |pieces: Vec<Piece>| ProfilePieces::new(pieces).unwrap_err().to_string();
        let second = |piece: Piece| refused(vec![good, piece]);
        assert_eq!(refused(vec![]), "has 0 pieces; it takes 1 to 200");
        assert_eq!(refused(vec![good; 201]), "has 201 pieces; it takes 1 to 200");
        for (found, said) in [
            (Piece { length: 0.0, ..good }, "has in piece 2 `length` = 0 nm, which is not above zero"),
            (Piece { width: [1.0, f64::NAN], ..good }, "has in piece 2 `width` = NaN nm, which is not finite"),
            (
                Piece { height: [5.0, 2e12], ..good },
                "has in piece 2 `height` = 2000000000000 nm, which is more than 1e12",
            ),
            (Piece { roundness: [0.0, 1.1], ..good }, "has in piece 2 `roundness` = 1.1, which is not from 0 to 1"),
            (Piece { length: 1e-8, ..good }, "has piece 2 of 0.00000001 nm in a beam of 40.00000001 nm"),
            (Piece { height: [6.0, 5.0], ..good }, "ends piece 1 with a height of 5 nm and begins the next with 6 nm"),
            (Piece { bend: -4.0, ..good }, "rotates the underside by -229.1831180523293 deg up to the end of piece 2"),
            (
                Piece { height: [5.0, 9.0], height_course: Transition::Linear, ..good },
                "has a kink between piece 1, whose height rises by 0 nm/nm at its end, and the next, by 0.1",
            ),
        ] {
            let refused = second(found);
            assert!(refused.starts_with(said), "{refused}");
        }
    }
}
