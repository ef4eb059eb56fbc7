//! The parameters of a seta, as plain data.
//!
//! ```text
//!   root ●  held, moved by the loading
//!         \         shaft
//!          \
//!           ●       fork 1: the two branches part in x, at fork 2 in z, and so on in turn
//!          / \
//!         ●   ●
//!        /|   |\
//!       ●●●   ●●●   tips, on a square grid; y = 0 is the ground, y its normal
//! ```
//!
//! A choice within the ranges of the literature, as neither the paper nor the papers that it cites give the geometry.

use super::tip_law::TipLaw;
use super::whole_tree::SetaTree;
use crate::beam::element::basis::MOST_ORDER;
use crate::beam::section::Material;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_3, FRAC_PI_4};
use std::sync::Arc;

/// Geometry and material of a seta. Lengths in nm, angles in rad.
///
/// What lists say level by level, and what a tree says whole, stands in place of the numbers from which it follows otherwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Seta {
    /// n: how often a way from the root to a tip forks, 0 to 12; there are 2ⁿ tips.
    pub forks: usize,
    /// Branches behind each fork, from the shaft on; empty: two behind each of `forks`
    #[serde(default)]
    pub branches: Vec<usize>,
    /// Heights of the forks above the plane of the tips, from the shaft on; empty: by `brush_height` and `height_ratio`
    #[serde(default)]
    pub fork_heights: Vec<f64>,
    /// Diameters of the shaft, and of a branch behind each fork; empty: by `shaft_diameter` and `diameter_ratio`
    #[serde(default)]
    pub diameters: Vec<f64>,
    /// All joints, in place of every number of the geometry; none: a seta by levels
    #[serde(default)]
    pub tree: Option<Arc<SetaTree>>,
    /// Distance of a tip from the next one on their square grid
    pub tip_pitch: f64,
    /// Of the part between the root and the first fork
    pub shaft_length: f64,
    /// Between the shaft and the normal of the ground; it leans towards +x as it goes up.
    pub shaft_angle: f64,
    /// Height H of the first fork above the plane of the tips
    pub brush_height: f64,
    /// Between the axis of the brush and the normal of the ground, towards +x
    pub brush_angle: f64,
    /// q: forks k = 0, 1, … stand at H (qᵏ - qⁿ)/(1 - qⁿ), and the tips at k = n.
    pub height_ratio: f64,
    /// Diameter d of the shaft
    pub shaft_diameter: f64,
    /// Diameter of a branch over that of the branch that carries it
    pub diameter_ratio: f64,
    /// a: tip i stands a (2 frac(0.618034 i) - 1) too high.
    pub height_scatter: f64,
    /// Of all branches, whose sections are circles
    pub material: Material,
}

impl Default for Seta {
    /// 256 tips, 112 µm from the root to a tip, 4 µm thick.
    fn default() -> Self {
        Self {
            forks: 8,
            branches: Vec::new(),
            fork_heights: Vec::new(),
            diameters: Vec::new(),
            tree: None,
            tip_pitch: 1000.0,
            shaft_length: 70_000.0,
            shaft_angle: FRAC_PI_3,
            brush_height: 28_000.0,
            brush_angle: FRAC_PI_4,
            height_ratio: 0.6,
            shaft_diameter: 4000.0,
            diameter_ratio: 0.625,
            height_scatter: 100.0,
            material: Material { shear_correction: 0.9, ..Material::of(2.0, 0.2) },
        }
    }
}

/// A seta with its elements and with what adheres its tips: what a pull-off is computed of.
#[derive(Clone, Debug)]
pub struct SetaModel {
    /// Geometry and material
    pub seta: Seta,
    /// Elements of the branches
    pub mesh: SetaMesh,
    /// Of every tip
    pub law: Arc<dyn TipLaw>,
}

impl SetaModel {
    /// On the default mesh.
    pub fn new(seta: Seta, law: Arc<dyn TipLaw>) -> Self {
        Self { mesh: SetaMesh::usual(seta.levels()), seta, law }
    }
}

// -- How a seta is divided into elements --

/// Elements of the branches of a seta, those of one branch of equal length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaMesh {
    /// Order p of the elements, 1 to 8
    pub order: usize,
    /// Of the shaft, then of each branch behind the first fork, the second one and so on
    pub elements: Vec<usize>,
}

/// Elements of the paper's seta, 1 700 in all on 256 tips.
const OF_THE_PAPER: [usize; 9] = [12, 8, 6, 6, 4, 4, 4, 3, 3];

impl SetaMesh {
    /// Of order 2: four elements along the shaft, two along a branch behind the first two forks, one along each other.
    pub fn usual(forks: usize) -> Self {
        let along = |generation| match generation {
            0 => 4,
            1 | 2 => 2,
            _ => 1,
        };
        Self { order: 2, elements: (0..=forks).map(along).collect() }
    }

    /// Of order 1, as many as the paper has for 8 forks; more forks as its last.
    pub fn of_the_paper(forks: usize) -> Self {
        Self { order: 1, elements: (0..=forks).map(|k| OF_THE_PAPER[k.min(OF_THE_PAPER.len() - 1)]).collect() }
    }

    /// The same with each element divided into so many.
    pub fn divided(&self, by: usize) -> Self {
        Self { order: self.order, elements: self.elements.iter().map(|n| n * by).collect() }
    }

    /// The same with elements one order higher; of the highest order each element divided in two.
    pub fn finer(&self) -> Self {
        if self.order < MOST_ORDER { Self { order: self.order + 1, ..self.clone() } } else { self.divided(2) }
    }

    /// Elements of all branches of a seta.
    pub fn total(&self, seta: &Seta) -> usize {
        (1..seta.joints()).map(|joint| self.elements[seta.generation(joint)]).sum()
    }
}
