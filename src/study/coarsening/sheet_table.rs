//! The nodes of one branch of a table.

use super::place::TipPlace;
use serde::{Deserialize, Serialize};

/// A node of a sheet: an equilibrium that was solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SheetNode {
    /// u, nm
    pub normal: f64,
    /// ∂u/∂s, nm
    pub slope: f64,
    /// E, aJ
    pub energy: f64,
    /// ∂E/∂(u, v, θ), nN, nN and nN·nm
    pub force: [f64; 3],
    /// Length of the pad that adheres: energy of adhesion over that of a unit length of its free end at rest, nm
    pub adhering: f64,
}

/// The nodes of one branch.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SheetTable {
    /// s from 0 to 1, ascending
    pub path: Vec<f64>,
    /// v, nm, ascending; one where the pad slides
    pub lateral: Vec<f64>,
    /// θ, rad, ascending
    pub rotation: Vec<f64>,
    /// By v, then θ, then s
    pub nodes: Vec<SheetNode>,
}

impl SheetTable {
    /// The nodes along s of a column.
    pub fn column(&self, lateral: usize, rotation: usize) -> &[SheetNode] {
        let length = self.path.len();
        &self.nodes[(lateral * self.rotation.len() + rotation) * length..][..length]
    }

    /// The limit points of its columns, with their places.
    pub fn limits(&self) -> impl Iterator<Item = (TipPlace, &SheetNode)> + '_ {
        let last = self.path.len() - 1;
        (0..self.lateral.len()).flat_map(move |v| {
            (0..self.rotation.len()).map(move |t| {
                let node = &self.column(v, t)[last];
                (TipPlace { normal: node.normal, lateral: self.lateral[v], rotation: self.rotation[t] }, node)
            })
        })
    }
}
