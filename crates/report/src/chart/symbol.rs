//! What marks a point.

use super::canvas::{Align, Canvas, Pixel};
use super::drawn::Drawn;
use super::style::size;
use plotters::style::RGBColor;

/// The shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// Nothing: the mark is there for its note.
    None,
    /// A disc.
    Dot,
    /// A square on its corner.
    Diamond,
    /// A triangle on its base.
    Triangle,
    /// A square on its side.
    Square,
    /// A letter.
    Letter(char),
}

pub(super) fn draw_symbol(canvas: &Canvas<'_>, symbol: Symbol, (x, y): Pixel, colour: RGBColor) -> Drawn {
    let corners = match symbol {
        Symbol::None => return Ok(()),
        Symbol::Dot => return canvas.disc((x, y), 3.6, colour),
        Symbol::Letter(letter) => return canvas.text(&letter.to_string(), (x, y), size::TEXT, colour, Align::Centre),
        Symbol::Diamond => vec![(x, y - 6.0), (x + 6.0, y), (x, y + 6.0), (x - 6.0, y)],
        Symbol::Triangle => vec![(x, y - 6.0), (x + 5.6, y + 4.2), (x - 5.6, y + 4.2)],
        Symbol::Square => vec![(x - 4.6, y - 4.6), (x + 4.6, y - 4.6), (x + 4.6, y + 4.6), (x - 4.6, y + 4.6)],
    };
    canvas.area(&corners, colour, 1.0)
}
