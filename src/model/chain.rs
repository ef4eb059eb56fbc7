//! Chains of a density, with elements of order 1 to 8 chosen when the program runs.

use crate::beam::{Chain, Density, UniformChain};

/// Picks the chain of the given order, N = order + 1 nodes an element.
macro_rules! by_order {
    ($density:expr, $order:expr, $fields:literal, $pin:expr) => {
        match $order {
            1 => Box::new(UniformChain::<_, $fields, 2>::new($density, $pin)),
            2 => Box::new(UniformChain::<_, $fields, 3>::new($density, $pin)),
            3 => Box::new(UniformChain::<_, $fields, 4>::new($density, $pin)),
            4 => Box::new(UniformChain::<_, $fields, 5>::new($density, $pin)),
            5 => Box::new(UniformChain::<_, $fields, 6>::new($density, $pin)),
            6 => Box::new(UniformChain::<_, $fields, 7>::new($density, $pin)),
            7 => Box::new(UniformChain::<_, $fields, 8>::new($density, $pin)),
            _ => Box::new(UniformChain::<_, $fields, 9>::new($density, $pin)),
        }
    };
}

/// Two unknowns a node, both free at the left end.
pub(super) fn two_field(density: impl Density<2> + 'static, order: usize) -> Box<dyn Chain> {
    by_order!(density, order, 2, [None; 2])
}

/// Three unknowns a node; `pinned_left` holds fields of the left end where it has a value.
pub(super) fn three_field(
    density: impl Density<3> + 'static,
    order: usize,
    pinned_left: [Option<f64>; 3],
) -> Box<dyn Chain> {
    by_order!(density, order, 3, pinned_left)
}
