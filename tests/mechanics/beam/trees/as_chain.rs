//! A tree that does not branch is a chain of elements in space.
//!
//! ```text
//!   |/ tip, clamped o----------o----------o root
//! ```
//!
//! Reference: the chain itself, eliminated from its left end to its right. Parameters: 9 elements (so that the last four are not full) of orders
//! 3 and 7, moved by up to 0.3 nm and rad at every node. Expected: the same matrix of the last end, the same inertia and the same direction back,
//! bit for bit: the elimination is one. Cut into three branches with joints between them it is the same
//! to round-off.

use super::setup::{moved, stiffness};
use approx::assert_relative_eq;
use peelkit::beam::{
    Branch, BranchingBeam, EndRotation, JointCondition, SpatialChain, SpatialConfiguration, SpatialDensity, SpatialEnd,
    SpatialFactors, SpatialFunctional, SpatialProfile,
};
use peelkit::solve::{Eliminated, NodalTerms, State, System};

const ELEMENTS: usize = 9;
const LENGTH: f64 = 9.0;

/// The branches from the tip, the last joint, to the root, joint 0.
fn branches(cuts: usize) -> BranchingBeam {
    let place = |k: usize| [0.0, 0.0, LENGTH * k as f64 / cuts as f64];
    let branch = |k: usize| {
        let joints = [cuts - k, cuts - k - 1];
        Branch::straight(joints, [place(k), place(k + 1)], [0.0, 1.0, 0.0], stiffness(1), ELEMENTS / cuts)
    };
    let tip = JointCondition::clamped(cuts, place(0));
    BranchingBeam { conditions: vec![tip], ..BranchingBeam::new((0..cuts).map(branch).collect(), 0) }
}

/// The state of one branch as a chain from its tip to its root lays it out.
fn as_chain(at: &State) -> (Vec<f64>, [[f64; 3]; 2]) {
    let (fields, angles) = at.values.split_at(at.values.len() - 6);
    let (root, rest) = fields.split_at(7);
    let (tip, inside) = rest.split_at(7);
    let of = |end: usize| [angles[3 * end], angles[3 * end + 1], angles[3 * end + 2]];
    ([tip, inside, root].concat(), [of(1), of(0)])
}

#[test]
fn one_branch_is_a_chain_bit_for_bit() {
    for order in [3, 7] {
        let beam = BranchingBeam { order, ..branches(1) };
        let tree = beam.build().unwrap();
        let at = moved(&tree, 0.3);
        let end = |held: &JointCondition| SpatialEnd {
            axes: held.axes,
            rotation: EndRotation::Angles,
            rest: beam.branches[0].rest.at(0.0).1,
            dead_load: [[0.0; 3]; 2],
        };
        let density =
            SpatialDensity { profile: SpatialProfile::uniform(stiffness(1), 0.0, 0.0), adhesion: None, held: None };
        let tip = &beam.conditions[0];
        let chain = SpatialChain::new(density, order, [end(tip), end(tip)], tip.held);
        let (fields, angles) = as_chain(&at);
        let boundaries: Vec<f64> = (0..=ELEMENTS).map(|k| LENGTH * k as f64 / ELEMENTS as f64).collect();
        let seen = SpatialConfiguration { boundaries: &boundaries, fields: &fields, angles, known: None };
        let (mut own, mut other) = (SpatialFactors::default(), SpatialFactors::default());
        let found = tree.eliminate(&at, [0.0; 2], 0.0, &mut own).unwrap();
        let wanted = chain.eliminate(seen, &SpatialFunctional::default(), NodalTerms::NONE, &mut other).unwrap();
        assert_eq!(found.root, wanted.root, "order {order}");
        assert_eq!((found.negative, found.least_pivot), (wanted.negative, wanted.least_pivot));
        assert_relative_eq!(found.integrals[0], wanted.integrals[0], max_relative = 1e-15);
        let n = tree.unknowns(&at);
        let (mut direction, mut of_chain) = (vec![0.0; n], vec![0.0; n]);
        let root = [0.1, -0.2, 0.3, 0.01, 0.02, -0.03];
        own.recover(&root, 0.7, &mut direction);
        other.recover(&root, 0.7, &mut of_chain);
        let last = n - 6;
        for (k, wanted) in of_chain.iter().enumerate() {
            let place = if k < last { k + 6 } else { k - last };
            assert_eq!(direction[place], *wanted, "order {order}, unknown {k}");
        }
    }
}

#[test]
fn cut_into_branches_it_is_the_same_to_round_off() {
    for order in [2, 7] {
        let (whole, cut) = (BranchingBeam { order, ..branches(1) }, BranchingBeam { order, ..branches(3) });
        let condensed = |beam: &BranchingBeam| {
            let tree = beam.build().unwrap();
            let at = tree.stress_free(0);
            tree.eliminate(&at, [0.0; 2], 0.0, &mut SpatialFactors::default()).unwrap()
        };
        let (whole, cut) = (condensed(&whole), condensed(&cut));
        assert_eq!((whole.negative, cut.negative), (0, 0));
        let entries = |found: Eliminated<6>| [found.root.tangent.as_flattened(), &found.root.residual].concat();
        let (whole, cut) = (entries(whole), entries(cut));
        let largest = whole.iter().fold(0.0f64, |most, entry| most.max(entry.abs()));
        for (a, b) in whole.iter().zip(&cut) {
            assert_relative_eq!(*a, *b, epsilon = 1e-13 * largest, max_relative = 1e-11);
        }
    }
}
