//! The columns of a table that have been computed, and their nodes: each once, many side by side.

use super::branch::BranchStart;
use super::column::Column;
use super::error::HeldError;
use super::sheet_table::SheetNode;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// v and θ, by their bits.
type Key = (u64, u64);

/// The columns of one branch.
pub(super) struct Columns {
    start: BranchStart,
    known: BTreeMap<Key, KnownColumn>,
}

struct KnownColumn {
    column: Column,
    nodes: BTreeMap<u64, SheetNode>,
}

/// Zero has two signs and one key.
fn bits(value: f64) -> u64 {
    (value + 0.0).to_bits()
}

impl Columns {
    /// None yet.
    pub fn new(start: BranchStart) -> Self {
        Self { start, known: BTreeMap::new() }
    }

    /// Where its branch begins.
    pub fn start(&self) -> &BranchStart {
        &self.start
    }

    /// The same without the columns.
    pub fn into_start(self) -> BranchStart {
        self.start
    }

    /// How many have been followed.
    pub fn len(&self) -> usize {
        self.known.len()
    }

    /// How many equilibria were solved at nodes and between.
    pub fn nodes(&self) -> usize {
        self.known.values().map(|column| column.nodes.len()).sum()
    }

    /// The largest error of a limit point by the mesh, nm.
    pub fn mesh_error(&self) -> f64 {
        self.known.values().map(|known| known.column.limit_error).fold(0.0, f64::max)
    }

    /// Computes the nodes `path` of the columns at these v and θ, as far as they are not known.
    pub fn compute(&mut self, places: &[(f64, f64)], path: &[f64]) -> Result<(), HeldError> {
        let work: Vec<(Key, (f64, f64), Option<KnownColumn>)> = places
            .iter()
            .map(|&(v, t)| ((bits(v), bits(t)), (v, t)))
            .collect::<BTreeMap<_, _>>()
            .into_iter()
            .filter_map(|(key, place)| match self.known.get(&key) {
                Some(known) if path.iter().all(|&s| known.nodes.contains_key(&bits(s))) => None,
                _ => Some((key, place, self.known.remove(&key))),
            })
            .collect();
        let start = &self.start;
        let done: Vec<Result<(Key, KnownColumn), HeldError>> = work
            .into_par_iter()
            .map(|(key, (v, t), known)| {
                let mut known = match known {
                    Some(known) => known,
                    None => KnownColumn { column: start.column(v, t)?, nodes: BTreeMap::new() },
                };
                let mut ws = start.spatula().workspace();
                for &s in path {
                    if !known.nodes.contains_key(&bits(s)) {
                        let node = known.column.node(start.spatula(), s, &mut ws)?;
                        known.nodes.insert(bits(s), node);
                    }
                }
                Ok((key, known))
            })
            .collect();
        let mut first = None;
        for found in done {
            match found {
                Ok((key, known)) => drop(self.known.insert(key, known)),
                Err(why) => first = first.or(Some(why)),
            }
        }
        first.map_or(Ok(()), Err)
    }

    /// A node that has been computed.
    pub fn node(&self, (v, t): (f64, f64), s: f64) -> Option<&SheetNode> {
        self.known.get(&(bits(v), bits(t)))?.nodes.get(&bits(s))
    }
}
