//! A face of a body that is drawn in projection.

use super::canvas::Stroke;
use super::panel::Shape;

/// A filled outline with lines on it. It covers what was drawn before it: faces stand in a panel from the farthest to the nearest.
#[derive(Clone, Debug)]
pub struct Face {
    /// What is filled
    pub shape: Shape,
    /// Lines on it, in the units of the axes.
    pub lines: Vec<(Vec<(f64, f64)>, Stroke)>,
}

/// What stands around a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rim {
    /// A frame with ticks, numbers and the titles of the axes
    Axes,
    /// A pale frame: the units of the axes mean nothing to a reader
    Plain,
}
