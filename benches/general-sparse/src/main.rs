//! The elimination of a tree of beams from its tips to its root, beside a general sparse factorisation of the same tangent.
//!
//! The trees, the state and the right-hand side are those of `examples/tree_cost.rs`. The general method is the Cholesky factorisation of
//! [faer](https://codeberg.org/sarah-quinones/faer) (LLᵀ, supernodal or simplicial as it chooses, ordered by AMD) on one thread, of the
//! tangent with the root held, all unknowns of the elements in it. `ordered` is what it does once for a pattern, `factorised` for each
//! tangent. Ours evaluates the elements within its factorisation; for the general method that, and putting the entries into columns, is
//! `assembled`. Expected: the same solution; ours in proportion to the number of elements, and the general method a little worse than that.
//!
//!     cargo run --release --manifest-path benches/general-sparse/Cargo.toml

#[allow(dead_code)]
#[path = "../../../examples/tree_cost.rs"]
mod tree_cost;

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Col, Par, Side};
use peelkit::beam::BeamTree;
use peelkit::solve::{Coefficients, State, System, Workspace};
use std::error::Error;
use std::time::Instant;

/// Unknowns of the root, which is held.
const ROOT: usize = 6;
const REPEATS: usize = 3;

/// The least of a few times, s, and what was computed last.
fn least<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let start = Instant::now();
        let found = work();
        (start.elapsed().as_secs_f64(), found)
    };
    let mut best = timed();
    for _ in 1..REPEATS {
        let (seconds, found) = timed();
        best = (best.0.min(seconds), found);
    }
    best
}

/// The lower half of the tangent without the root.
fn lower(tree: &BeamTree, at: &State) -> SparseColMat<usize, f64> {
    let unknowns = tree.unknowns(at) - ROOT;
    let entries = tree.tangent_entries(at).into_iter().filter(|&(row, column, _)| row >= column && column >= ROOT);
    let entries: Vec<_> = entries.map(|(row, column, value)| Triplet::new(row - ROOT, column - ROOT, value)).collect();
    SparseColMat::try_new_from_triplets(unknowns, unknowns, &entries).expect("entries lie within the tangent")
}

fn main() -> Result<(), Box<dyn Error>> {
    faer::set_global_parallelism(Par::Seq);
    println!("{:>9} | {:^20} | {:^45} | {:>10}", "", "peelkit, s", "faer, s", "");
    println!(
        "{:>9} | {:>10} {:>9} | {:>10} {:>10} {:>12} {:>10} | {:>10}",
        "elements", "factorised", "solved", "assembled", "ordered", "factorised", "solved", "difference"
    );
    for generations in [5, 8, 11, 15, 16] {
        let tree = tree_cost::binary(generations).build()?;
        let at = tree_cost::moved(&tree);
        let residual = tree.residual(&at);
        let (mut ws, mut x) = (Workspace::default(), vec![0.0; tree.unknowns(&at)]);
        let (factorised, _) = least(|| tree.factorise(&at, Coefficients::STATIC, [0.0; 3], &mut ws).is_ok());
        let (solved, ()) = least(|| System::recover(&tree, &ws, &[0.0; 6], 1.0, &mut x));

        let (assembled, tangent) = least(|| lower(&tree, &at));
        let (ordered, symbolic) = least(|| SymbolicLlt::try_new(tangent.symbolic(), Side::Lower));
        let symbolic = symbolic.map_err(|error| format!("{error:?}"))?;
        let (general, factors) = least(|| Llt::try_new_with_symbolic(symbolic.clone(), tangent.as_ref(), Side::Lower));
        let factors = factors.map_err(|error| format!("{error:?}"))?;
        let load = Col::from_fn(residual.len() - ROOT, |row| residual[row + ROOT]);
        let (substituted, other) = least(|| factors.solve(&load));

        let largest = x.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        let apart = (0..other.nrows()).fold(0.0f64, |most, row| most.max((other[row] - x[row + ROOT]).abs()));
        println!(
            "{:>9} | {factorised:>10.5} {solved:>9.5} | {assembled:>10.5} {ordered:>10.5} {general:>12.5} {substituted:>10.5} | {:>10.1e}",
            tree.elements(),
            apart / largest
        );
    }
    Ok(())
}
