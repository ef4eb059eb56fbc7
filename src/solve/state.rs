//! A configuration of a system: its mesh, its unknowns, the force of its grip and what its material remembers.

use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Where a system is discretised, as far as that changes along a path; a system whose mesh is fixed leaves it empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    /// Boundaries of the elements, ascending; one more than there are elements.
    pub boundaries: Vec<f64>,
    /// What it follows: where the peeling front is
    pub focus: f64,
    /// Where the two edges of a section let go, from there, nm; zeros where the mesh does not follow these.
    pub edges: [f64; 2],
}

impl Mesh {
    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.boundaries.len().saturating_sub(1)
    }
}

/// A configuration of a system, in equilibrium or not.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct State {
    /// Where its elements end
    pub mesh: Mesh,
    /// The unknowns, as [`super::System`] lays them out.
    pub values: Vec<f64>,
    /// Force of the grip along the drive, nN (nN·nm where that is a rotation).
    pub force: f64,
    /// What the material points remembered before the step that ended here, of a system with history.
    pub history: Option<Arc<History>>,
}

/// What material points remember: three numbers at each place of a grid that no mesh moves. Between its places they are
/// interpolated by cubics. What the numbers are, their system says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// From one place to the next, nm
    pub spacing: f64,
    /// Place by place
    pub rows: Vec<[f64; 3]>,
    /// Energy dissipated since the beginning, aJ
    pub dissipated: f64,
}

/// Fewest and most steps from place to place.
const FEWEST: usize = 16;
const MOST: usize = 100_000;

impl History {
    /// Of a body of this length (nm), with about `spacing` (nm) from one place to the next; `at` gives the numbers at S.
    pub fn new(length: f64, spacing: f64, at: impl Fn(f64) -> [f64; 3]) -> Self {
        let steps = ((length / spacing).ceil() as usize).clamp(FEWEST, MOST);
        let spacing = length / steps as f64;
        Self { spacing, rows: (0..=steps).map(|k| at(k as f64 * spacing)).collect(), dissipated: 0.0 }
    }

    /// The first `K` numbers at S.
    pub fn at<const K: usize>(&self, s: f64) -> [f64; K] {
        let along = s / self.spacing;
        let first = (along.floor() as usize).clamp(1, self.rows.len() - 3) - 1;
        let t = along - first as f64;
        let weights = [
            (t - 1.0) * (t - 2.0) * (t - 3.0) / -6.0,
            t * (t - 2.0) * (t - 3.0) / 2.0,
            t * (t - 1.0) * (t - 3.0) / -2.0,
            t * (t - 1.0) * (t - 2.0) / 6.0,
        ];
        std::array::from_fn(|column| (0..4).map(|k| weights[k] * self.rows[first + k][column]).sum())
    }

    /// S of each place (nm), with its numbers.
    pub fn iter(&self) -> impl Iterator<Item = (f64, [f64; 3])> + '_ {
        self.rows.iter().enumerate().map(|(k, &row)| (k as f64 * self.spacing, row))
    }

    /// Behind a step: `update` gives, for S and its numbers, those of now and what was dissipated there, nN per length.
    pub fn updated(&self, mut update: impl FnMut(f64, [f64; 3]) -> ([f64; 3], f64)) -> Self {
        let mut next = self.clone();
        let last = self.rows.len() - 1;
        for (k, row) in next.rows.iter_mut().enumerate() {
            let share = if k == 0 || k == last { 0.5 } else { 1.0 };
            let lost;
            (*row, lost) = update(k as f64 * self.spacing, *row);
            next.dissipated += share * self.spacing * lost;
        }
        next
    }
}
