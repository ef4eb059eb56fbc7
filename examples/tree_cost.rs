//! What it costs to eliminate a tree of beams in space: binary trees of about 100 to 200 000 elements of order 3.
//!
//! Each branch forks in two, at right angles to the fork before, and is 0.7 times as long and half as stiff as the one that carries it. The
//! tangent is factorised and solved for the residual; the error is that of the solution, K x - R over R, by the tangent's entries.
//!
//!     cargo run --release --example tree_cost

use peelkit::beam::{BeamTree, Branch, BranchingBeam, SpatialStiffness};
use peelkit::solve::{Coefficients, State, System, Workspace};
use std::error::Error;
use std::time::Instant;

const PER_BRANCH: usize = 4;
const REPEATS: usize = 3;

/// A binary tree of so many generations.
pub fn binary(generations: u32) -> BranchingBeam {
    let stiffness = |level: i32| {
        let factor = 0.5f64.powi(level);
        SpatialStiffness::diagonal(1e4 * factor, [4e3 * factor; 2], 100.0 * factor, [120.0 * factor; 2])
    };
    let mut branches =
        vec![Branch::straight([0, 1], [[0.0; 3], [0.0, 0.0, 10.0]], [0.3, 1.0, 0.2], stiffness(0), PER_BRANCH)];
    let mut tips = vec![(1, [0.0, 0.0, 10.0])];
    for level in 1..generations {
        let axis = (level % 2) as usize;
        let length = 10.0 * 0.7f64.powi(level as i32);
        let mut next = Vec::with_capacity(2 * tips.len());
        for (joint, from) in tips {
            for side in [-0.6, 0.6] {
                let (far, mut to): (_, [f64; 3]) = (branches.len() + 1, from);
                to[2] += 0.8 * length;
                to[axis] += side * length;
                branches.push(Branch::straight(
                    [joint, far],
                    [from, to],
                    [0.3, 1.0, 0.2],
                    stiffness(level as i32),
                    PER_BRANCH,
                ));
                next.push((far, to));
            }
        }
        tips = next;
    }
    BranchingBeam::new(branches, 0)
}

/// A state that is no equilibrium: every number of a node moved a little.
pub fn moved(tree: &BeamTree) -> State {
    let mut at = tree.stress_free(0);
    let direction: Vec<f64> =
        (1..=tree.unknowns(&at)).map(|k| (0.618_033_988_749_895 * k as f64).fract() - 0.5).collect();
    tree.retract(&mut at, &direction, 1e-4);
    at
}

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "{:>9} {:>9} {:>12} {:>12} {:>12} {:>9}",
        "elements", "unknowns", "factorise s", "solve s", "µs/element", "error"
    );
    for generations in [5, 8, 11, 15, 16] {
        let tree = binary(generations).build()?;
        let at = moved(&tree);
        let (mut ws, mut x) = (Workspace::default(), vec![0.0; tree.unknowns(&at)]);
        let mut best = [f64::INFINITY; 2];
        for _ in 0..REPEATS {
            let start = Instant::now();
            tree.factorise(&at, Coefficients::STATIC, [0.0; 2], &mut ws)?;
            best[0] = best[0].min(start.elapsed().as_secs_f64());
            let start = Instant::now();
            System::recover(&tree, &ws, &[0.0; 6], 1.0, &mut x);
            best[1] = best[1].min(start.elapsed().as_secs_f64());
        }
        // the root is held
        let mut residual = tree.residual(&at);
        let largest = residual.iter().fold(0.0f64, |most, r| most.max(r.abs()));
        tree.tangent_entries(&at).into_iter().for_each(|(row, column, value)| residual[row] -= value * x[column]);
        let miss = residual[6..].iter().fold(0.0f64, |most, r| most.max(r.abs()));
        println!(
            "{:>9} {:>9} {:>12.5} {:>12.5} {:>12.2} {:>9.1e}",
            tree.elements(),
            x.len(),
            best[0],
            best[1],
            (best[0] + best[1]) / tree.elements() as f64 * 1e6,
            miss / largest
        );
    }
    Ok(())
}
