//! Short ways to the usual picture: one panel across the sheet, or two side by side, with named lines.

use super::axis::Axis;
use super::canvas::Stroke;
use super::panel::{Line, Mark, Note, Panel};
use super::picture::Picture;
use super::place::Frame;
use super::style::WIDTH;
use super::symbol::Symbol;
use plotters::style::RGBColor;

/// Room above the panels for the title, to the left of each for ticks and label, to the right, and below, pixels.
const ABOVE: f64 = 40.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 18.0;
const BELOW: f64 = 54.0;
/// Height of the panels, pixels.
const HEIGHT: f64 = 340.0;

impl Frame {
    /// Across the whole sheet, under the title.
    pub fn across() -> Self {
        Self::column(0, 1)
    }

    /// One of `count` columns of the same width, counted from 0 on the left.
    pub fn column(index: usize, count: usize) -> Self {
        let width = f64::from(WIDTH) / count as f64;
        let left = index as f64 * width;
        Self { left: left + LEFT, top: ABOVE, right: left + width - RIGHT, bottom: ABOVE + HEIGHT }
    }
}

impl Picture {
    /// Panels under a title, on a sheet as high as they need.
    pub fn of(title: &str, panels: Vec<Panel>) -> Self {
        let lowest = panels.iter().map(|panel| panel.frame.bottom).fold(0.0, f64::max);
        Self { title: title.into(), height: (lowest + BELOW).ceil() as u32, panels }
    }
}

impl Panel {
    /// A panel with lines, and nothing else yet.
    pub fn of_lines(frame: Frame, x: Axis, y: Axis, lines: Vec<Line>) -> Self {
        Self { lines, ..Self::new(frame, x, y) }
    }
}

impl Line {
    /// A line that stands in the legend.
    pub fn named(name: &str, points: Vec<(f64, f64)>, stroke: Stroke) -> Self {
        Self { points, stroke, name: Some(name.into()) }
    }

    /// A line without a name.
    pub fn plain(points: Vec<(f64, f64)>, stroke: Stroke) -> Self {
        Self { points, stroke, name: None }
    }
}

impl Mark {
    /// A diamond with a label of one or more lines.
    pub fn labelled(at: (f64, f64), colour: RGBColor, text: &[&str]) -> Self {
        let note = Note { badge: None, text: text.iter().map(|line| (*line).to_owned()).collect() };
        Self { at, symbol: Symbol::Diamond, colour, name: None, note: Some(note) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_side_by_side_on_the_sheet() {
        let [left, right] = [0, 1].map(|index| Frame::column(index, 2));
        assert!(left.left > 0.0 && left.right < right.left && right.right < f64::from(WIDTH));
        assert_eq!(left.width(), right.width());
        assert!(Frame::across().width() > 2.0 * left.width());
        let axis = || Axis::linear("x", 0.0, 1.0);
        let picture = Picture::of("", vec![Panel::of_lines(left, axis(), axis(), Vec::new())]);
        assert!(f64::from(picture.height) > left.bottom);
    }
}
