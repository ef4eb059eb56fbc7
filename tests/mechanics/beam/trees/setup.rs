//! The tree of two levels with four tips that several tests share, and states of it.
//!
//! ```text
//!   3   4   5   6     tips
//!    \ /     \ /      twigs, 4 nm; the last one bent at rest
//!     1       2
//!      \     /        limbs, 6 nm, at 40 degrees
//!        \ /
//!         0'          joint 7
//!         |           shaft, 10 nm, along z
//!         0           root
//! ```

use peelkit::beam::{BeamTree, Branch, BranchRest, BranchingBeam, SpatialStiffness};
use peelkit::solve::{State, System};

/// Of the shaft, a limb and a twig: EA, GA, GJ, EI2, EI3.
pub const STIFFNESS: [[f64; 5]; 3] =
    [[4000.0, 1500.0, 300.0, 400.0, 500.0], [2000.0, 800.0, 90.0, 150.0, 100.0], [1000.0, 400.0, 25.0, 40.0, 30.0]];
/// Stress-free curvatures of the last twig, 1/nm.
pub const BENT: [f64; 3] = [0.02, 0.1, -0.05];

/// Stiffness of a level.
pub fn stiffness(level: usize) -> SpatialStiffness {
    let [axial, shear, torsion, second, third] = STIFFNESS[level];
    SpatialStiffness::diagonal(axial, [shear; 2], torsion, [second, third])
}

fn along(from: [f64; 3], direction: [f64; 3], length: f64) -> [f64; 3] {
    let size = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    std::array::from_fn(|i| from[i] + length / size * direction[i])
}

/// The tree, some of whose branches run towards the root; elements of a branch.
pub fn four_tips(order: usize, elements: usize) -> BranchingBeam {
    let (root, fork) = ([0.0; 3], [0.0, 0.0, 10.0]);
    let (sin, cos) = 40f64.to_radians().sin_cos();
    let (left, right) = (along(fork, [-sin, 0.0, cos], 6.0), along(fork, [sin, 0.0, cos], 6.0));
    let straight = |joints, ends, level| Branch::straight(joints, ends, [0.0, 1.0, 0.3], stiffness(level), elements);
    let mut branches = vec![
        straight([0, 7], [root, fork], 0),
        straight([1, 7], [left, fork], 1),
        straight([7, 2], [fork, right], 1),
        straight([1, 3], [left, along(left, [-0.5, -0.6, 1.0], 4.0)], 2),
        straight([4, 1], [along(left, [-0.3, 0.6, 1.0], 4.0), left], 2),
        straight([2, 5], [right, along(right, [0.3, -0.6, 1.0], 4.0)], 2),
        straight([2, 6], [right, along(right, [0.5, 0.6, 1.0], 4.0)], 2),
    ];
    if let BranchRest::Curve(rest) = &mut branches[6].rest {
        rest.curvature = BENT;
    }
    BranchingBeam { order, scale: [1e-2, 1e-2], ..BranchingBeam::new(branches, 0) }
}

/// A number between -1 and 1 for each place, the same at every run.
pub fn pseudo_random(count: usize) -> Vec<f64> {
    (0..count).map(|k| 2.0 * (0.618_033_988_749_895 * (k + 1) as f64).fract() - 1.0).collect()
}

/// The stress-free tree, moved by up to so many nm and rad at every node.
pub fn moved(tree: &BeamTree, by: f64) -> State {
    let mut at = tree.stress_free(0);
    let direction = pseudo_random(tree.unknowns(&at));
    tree.retract(&mut at, &direction, by);
    at
}
