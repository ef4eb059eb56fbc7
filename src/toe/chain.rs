//! Bands as linear beams, joined to a tree, with what holds their nodes: one elimination without fill-in.
//!
//! A node has the unknowns (u, w, θ): along the ground, off it, and its turn, which are small. Between two nodes a band has EA and EI, and the
//! cubic element is exact, as nothing acts between them. Nodes are numbered so that a node comes before the one it is joined to, the last one is
//! the root; each block of three is eliminated onto that of the node behind it. Where one node changes, only those between it and the root
//! are eliminated again.
//!
//! It stands beside the trees of geometrically exact beams because an array has an event a seta: 10⁵ of them leave microseconds for each.

use nalgebra::{Matrix3, Vector3};

/// Stiffnesses of the cross-section of a band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BandSection {
    /// EI, nN nm²
    pub bending: f64,
    /// EA, nN
    pub axial: f64,
}

impl BandSection {
    /// Of a band of a width and thickness, nm, and a modulus in GPa.
    pub fn rectangular(width: f64, thickness: f64, modulus: f64) -> Self {
        let area = width * thickness;
        Self { bending: modulus * area * thickness * thickness / 12.0, axial: modulus * area }
    }
}

/// A tree of nodes with its factors.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    /// The node behind each; the root has none
    behind: Vec<Option<usize>>,
    /// The nodes before each
    before: Vec<Vec<usize>>,
    /// From each node to the one behind: how far along the ground, and the section
    pieces: Vec<Option<(f64, BandSection)>>,
    /// Stiffness of the piece behind each node at that node, at its other end, and between
    own: Vec<Matrix3<f64>>,
    other: Vec<Matrix3<f64>>,
    across: Vec<Matrix3<f64>>,
    /// What holds each node
    held: Vec<Matrix3<f64>>,
    /// Whether nothing holds a node and those before it
    free: Vec<bool>,
    /// Inverses of the pivots, and what each node with its piece gives to the one behind it
    inverse: Vec<Matrix3<f64>>,
    given: Vec<Matrix3<f64>>,
}

impl Chain {
    /// A node after another, each joined to one that is added later by [`Chain::join`].
    pub(crate) fn of_nodes(nodes: usize) -> Self {
        let zero = vec![Matrix3::zeros(); nodes];
        Self {
            behind: vec![None; nodes],
            before: vec![Vec::new(); nodes],
            pieces: vec![None; nodes],
            own: zero.clone(),
            other: zero.clone(),
            free: vec![false; nodes],
            across: zero.clone(),
            held: zero.clone(),
            inverse: zero.clone(),
            given: zero,
        }
    }

    /// A piece of a band from `node` to `behind`, which has a higher number and lies `along` (nm, of either sign) farther along the ground.
    pub(crate) fn join(&mut self, node: usize, behind: usize, along: f64, section: &BandSection) {
        debug_assert!(node < behind && self.behind[node].is_none());
        let (length, towards) = (along.abs(), along.signum());
        let (ea, ei) = (section.axial / length, section.bending / length.powi(3));
        let (a, b) = (6.0 * ei * length * towards, ei * length * length);
        let end = |sign: f64| Matrix3::new(ea, 0.0, 0.0, 0.0, 12.0 * ei, sign * a, 0.0, sign * a, 4.0 * b);
        (self.own[node], self.other[node]) = (end(1.0), end(-1.0));
        self.across[node] = Matrix3::new(-ea, 0.0, 0.0, 0.0, -12.0 * ei, a, 0.0, -a, 2.0 * b);
        self.pieces[node] = Some((along, *section));
        self.behind[node] = Some(behind);
        self.before[behind].push(node);
    }

    /// How many nodes.
    pub(crate) fn nodes(&self) -> usize {
        self.own.len()
    }

    /// Sets what holds a node, without a new elimination.
    pub(crate) fn set_held(&mut self, node: usize, held: Matrix3<f64>) {
        self.held[node] = held;
    }

    /// Eliminates all, or what has changed with one node. False where a pivot is zero or none.
    pub(crate) fn eliminate(&mut self, changed: Option<usize>) -> bool {
        match changed {
            None => (0..self.nodes()).all(|node| self.eliminate_one(node)),
            Some(node) => {
                let mut at = Some(node);
                while let Some(node) = at {
                    if !self.eliminate_one(node) {
                        return false;
                    }
                    at = self.behind[node];
                }
                true
            }
        }
    }

    fn eliminate_one(&mut self, node: usize) -> bool {
        let mut pivot = self.own[node] + self.held[node];
        for &before in &self.before[node] {
            pivot += self.given[before];
        }
        let Some(inverse) = pivot.try_inverse() else { return false };
        self.inverse[node] = inverse;
        self.free[node] =
            self.held[node] == Matrix3::zeros() && self.before[node].iter().all(|&before| self.free[before]);
        // what hangs on nothing gives nothing: exactly, where a difference would leave its rounding
        self.given[node] = match self.free[node] {
            true => Matrix3::zeros(),
            false => self.other[node] - self.across[node].tr_mul(&(inverse * self.across[node])),
        };
        inverse.iter().all(|entry| entry.is_finite())
    }

    /// Places of all nodes under forces on them, nm and rad; forces are replaced.
    pub(crate) fn solve(&self, forces: &mut [Vector3<f64>]) {
        for node in 0..self.nodes() {
            if let Some(behind) = self.behind[node]
                && forces[node] != Vector3::zeros()
            {
                let onto = self.across[node].tr_mul(&(self.inverse[node] * forces[node]));
                forces[behind] -= onto;
            }
        }
        for node in (0..self.nodes()).rev() {
            let from = self.behind[node].map_or(Vector3::zeros(), |behind| self.across[node] * forces[behind]);
            forces[node] = self.inverse[node] * (forces[node] - from);
        }
    }

    /// Elastic energy of the bands alone, aJ. By the strains of each piece: places alone would cancel where a band moves without bending.
    pub(crate) fn energy(&self, places: &[Vector3<f64>]) -> f64 {
        let mut out = 0.0;
        for (node, piece) in self.pieces.iter().enumerate() {
            let (Some((along, section)), Some(behind)) = (piece, self.behind[node]) else { continue };
            let (here, there) = (&places[node], &places[behind]);
            let length = along.abs();
            let chord = (there.y - here.y) / along;
            let (a, b) = (here.z - chord, there.z - chord);
            out += 0.5 * section.axial / length * (there.x - here.x).powi(2);
            out += 2.0 * section.bending / length * (a * a + a * b + b * b);
        }
        out
    }
}
