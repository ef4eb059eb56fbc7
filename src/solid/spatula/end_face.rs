//! The end face of a solid spatula, in a grip: it moves and turns as a whole.
//!
//! As the rigid grip of a strip does ([`crate::solid::grip`]), by the levers of its nodes.

use super::layout::{ACROSS, THROUGH};

/// Where the nodes of the face are at rest.
#[derive(Clone, Debug)]
pub(super) struct EndFace {
    lines: usize,
    /// x and y from the middle, by nodes through the thickness and across, nm
    levers: Vec<[f64; 2]>,
}

/// The first function that is a value on the right end of an element.
const FIRST: usize = 2 * THROUGH * ACROSS;

impl EndFace {
    /// Of so many lines of nodes across, by what the lever of a node is: through the thickness, and across.
    pub(super) fn new(lines: usize, lever: impl Fn((usize, usize)) -> [f64; 2]) -> Self {
        Self { lines, levers: (0..THROUGH * lines).map(|node| lever((node / lines, node % lines))).collect() }
    }

    /// The lever of a node.
    pub(super) fn lever(&self, (through, across): (usize, usize)) -> [f64; 2] {
        self.levers[through * self.lines + across]
    }

    /// The functions of an element before the face, of this strip, whose values move with it, each with its lever.
    pub(super) fn functions(&self, strip: usize) -> impl Iterator<Item = (usize, [f64; 2])> {
        (0..THROUGH * ACROSS).map(move |node| {
            let (through, across) = (node / ACROSS, (ACROSS - 1) * strip + node % ACROSS);
            (FIRST + node, self.lever((through, across)))
        })
    }

    /// Length of the longest lever, nm.
    pub(super) fn longest(&self) -> f64 {
        self.levers.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max)
    }
}
