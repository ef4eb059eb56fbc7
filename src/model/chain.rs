//! Chains of a density, with elements of order 1 to 8 chosen when the program runs.

use crate::beam::{Chain, Density, Integrand, UniformChain};

/// Picks the chain of the given order, N = order + 1 nodes an element, with a border or without.
macro_rules! by_order {
    ($density:expr, $order:expr, $fields:literal, $border:literal, $pin:expr) => {
        match $order {
            1 => Box::new(UniformChain::<$fields, 2>::new::<$border>($density, $pin)),
            2 => Box::new(UniformChain::<$fields, 3>::new::<$border>($density, $pin)),
            3 => Box::new(UniformChain::<$fields, 4>::new::<$border>($density, $pin)),
            4 => Box::new(UniformChain::<$fields, 5>::new::<$border>($density, $pin)),
            5 => Box::new(UniformChain::<$fields, 6>::new::<$border>($density, $pin)),
            6 => Box::new(UniformChain::<$fields, 7>::new::<$border>($density, $pin)),
            7 => Box::new(UniformChain::<$fields, 8>::new::<$border>($density, $pin)),
            _ => Box::new(UniformChain::<$fields, 9>::new::<$border>($density, $pin)),
        }
    };
}

/// Two unknowns a node, both free at the left end.
pub(super) fn two_field(density: impl Density<2> + 'static, order: usize) -> Box<dyn Chain> {
    two(Box::new(density), order)
}

/// Three unknowns a node and no border; `pinned_left` holds fields of the left end where it has a value.
pub(super) fn three_field(
    density: impl Density<3> + 'static,
    order: usize,
    pinned_left: [Option<f64>; 3],
) -> Box<dyn Chain> {
    three(Box::new(density), order, pinned_left)
}

fn two(density: Box<dyn Integrand<2>>, order: usize) -> Box<dyn Chain> {
    if density.has_border() {
        by_order!(density, order, 2, true, [None; 2])
    } else {
        by_order!(density, order, 2, false, [None; 2])
    }
}

fn three(density: Box<dyn Integrand<3>>, order: usize, pinned_left: [Option<f64>; 3]) -> Box<dyn Chain> {
    by_order!(density, order, 3, false, pinned_left)
}
