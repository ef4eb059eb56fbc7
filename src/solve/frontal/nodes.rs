//! The nodes of an element in the order in which they are eliminated: the interior ones from left to right, the left end, the right end.

/// The most nodes an element can have.
pub const MOST_NODES: usize = 9;
/// Elements that are treated side by side.
pub(crate) const BUNDLE: usize = 4;

/// How many nodes an element has, p + 1: known when the program is compiled, which is faster, or when it runs.
pub trait Nodes: Copy {
    /// For elements of an order.
    fn of_order(order: usize) -> Self;
    /// N = p + 1, from 2 to [`MOST_NODES`]
    fn count(self) -> usize;
}

/// So many nodes.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const N: usize>;

/// Any number of nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AnyNumber(usize);

impl<const N: usize> Nodes for Fixed<N> {
    #[inline(always)]
    fn of_order(order: usize) -> Self {
        assert_eq!(order + 1, N);
        Self
    }

    #[inline(always)]
    fn count(self) -> usize {
        N
    }
}

impl Nodes for AnyNumber {
    #[inline(always)]
    fn of_order(order: usize) -> Self {
        Self(order + 1)
    }

    #[inline(always)]
    fn count(self) -> usize {
        // so that the compiler knows it too
        self.0.clamp(2, MOST_NODES)
    }
}

/// Place of the node of rank `rank` (from the left, 0 to p) in the elimination order of an element of `nodes` nodes.
#[inline(always)]
pub fn slot(nodes: usize, rank: usize) -> usize {
    match rank {
        0 => nodes - 2,
        r if r == nodes - 1 => r,
        r => r - 1,
    }
}
