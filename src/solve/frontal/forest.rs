//! How elements hang together, and in which order they are eliminated, four at a time.

use super::nodes::BUNDLE;

/// An element as its elimination sees it: from its far end to its near one, which leads to the root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// Numbers of its far and of its near node
    pub ends: [usize; 2],
    /// Where the near one stands: 0 at its left, 1 at its right
    pub near: usize,
    /// Number of its first interior node from the left; the others follow
    pub inside: usize,
    /// The joint that carries what is behind its far end
    pub from: usize,
    /// The joint onto which it passes that: the same, unless it is the last before a joint
    pub onto: usize,
    /// Whether its far end is that joint itself, where equations may be held
    pub is_first: bool,
}

/// Elements that are integrated and condensed side by side, by their numbers or by how a structure names them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bundle<E = usize> {
    /// The elements; behind the last one it is repeated.
    pub lanes: [E; BUNDLE],
    /// How many there are
    pub count: usize,
}

/// Elements of one order whose ends meet in joints, without a loop.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forest {
    /// Order p of its elements
    pub order: usize,
    /// By their numbers
    pub pieces: Vec<Piece>,
    /// Each behind those that it carries, also inside of a bundle
    pub bundles: Vec<Bundle>,
    /// How many joints there are
    pub joints: usize,
    /// The joint that is left, and the number of its node
    pub root: [usize; 2],
}

impl Piece {
    /// Numbers of the nodes at its left and at its right.
    #[inline(always)]
    pub(super) fn left_and_right(&self) -> [usize; 2] {
        [self.ends[1 - self.near], self.ends[self.near]]
    }
}

impl<E: Copy> Bundle<E> {
    /// Of up to four elements; panics where there is none.
    pub(crate) fn of(elements: &[E]) -> Self {
        let count = elements.len().min(BUNDLE);
        Self { lanes: std::array::from_fn(|l| elements[l.min(count - 1)]), count }
    }
}

impl Forest {
    /// A chain of elements whose nodes are numbered from left to right: joint 0 is its left end, joint 1, the root, its right one.
    pub(crate) fn chain(elements: usize, order: usize) -> Self {
        let piece = |e: usize| Piece {
            ends: [e * order, (e + 1) * order],
            near: 1,
            inside: e * order + 1,
            from: 0,
            onto: usize::from(e + 1 == elements),
            is_first: e == 0,
        };
        let numbers: Vec<usize> = (0..elements).collect();
        Self {
            order,
            pieces: (0..elements).map(piece).collect(),
            bundles: numbers.chunks(BUNDLE).map(Bundle::of).collect(),
            joints: 2,
            root: [1, elements * order],
        }
    }

    /// The elements one by one, each behind those that it carries: its number, its bundle, and which of the four it is there.
    pub(super) fn inwards(&self) -> impl DoubleEndedIterator<Item = (usize, usize, usize)> {
        let of = |(b, own): (usize, &Bundle)| {
            let (lanes, count) = (own.lanes, own.count);
            (0..count).map(move |l| (lanes[l], b, l))
        };
        self.bundles.iter().enumerate().flat_map(of)
    }
}
