//! Chains of a density, with elements of order 1 to 8 chosen when the program runs.

use crate::beam::Density;
use crate::solve::{Chain, UniformChain};

/// Picks the chain of the given order, N = order + 1 nodes an element.
macro_rules! by_order {
    ($density:expr, $order:expr, $fields:literal, $extra:literal, $pin:expr) => {
        match $order {
            1 => Box::new(UniformChain::<_, $fields, 2, { 2 * $fields + $extra }>::new($density, $pin)),
            2 => Box::new(UniformChain::<_, $fields, 3, { 3 * $fields + $extra }>::new($density, $pin)),
            3 => Box::new(UniformChain::<_, $fields, 4, { 4 * $fields + $extra }>::new($density, $pin)),
            4 => Box::new(UniformChain::<_, $fields, 5, { 5 * $fields + $extra }>::new($density, $pin)),
            5 => Box::new(UniformChain::<_, $fields, 6, { 6 * $fields + $extra }>::new($density, $pin)),
            6 => Box::new(UniformChain::<_, $fields, 7, { 7 * $fields + $extra }>::new($density, $pin)),
            7 => Box::new(UniformChain::<_, $fields, 8, { 8 * $fields + $extra }>::new($density, $pin)),
            _ => Box::new(UniformChain::<_, $fields, 9, { 9 * $fields + $extra }>::new($density, $pin)),
        }
    };
}

/// Two unknowns a node, both free at the left end.
pub(super) fn two_field(density: impl Density<2> + 'static, order: usize) -> Box<dyn Chain> {
    by_order!(density, order, 2, 1, [None; 2])
}

/// The same with the horizontal force as one more unknown of the whole chain.
pub(super) fn two_field_held(density: impl Density<2> + 'static, order: usize) -> Box<dyn Chain> {
    by_order!(density, order, 2, 2, [None; 2])
}

/// Three unknowns a node; `pinned_left` holds fields of the left end where it has a value.
pub(super) fn three_field(
    density: impl Density<3> + 'static,
    order: usize,
    pinned_left: [Option<f64>; 3],
) -> Box<dyn Chain> {
    by_order!(density, order, 3, 1, pinned_left)
}
