//! What of a seta cannot be computed.

use super::parameters::{Seta, SetaMesh};
use super::whole_tree::MOST_TIPS;
use crate::beam::element::basis::MOST_ORDER;
use crate::beam::spatial::tree::branching_beam::TreeError;
use crate::model::check::error::Range;

/// Most forks: 4096 tips.
pub const MOST_FORKS: usize = 12;
/// Most branches behind one fork.
const MOST_BRANCHES: usize = 64;

/// Why a seta cannot be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaError {
    /// A number that is out of range.
    #[error("`seta.{key}` is {value}, which is out of range: give {range}")]
    OutOfRange { key: &'static str, value: f64, range: &'static str },
    /// Tips that lie above the joint that carries them.
    #[error(
        "the tips of the seta are scattered by ±{scatter} nm and the last fork stands {height:.1} nm above them: give a scatter of at most half that height"
    )]
    Scatter { scatter: f64, height: f64 },
    /// Lists that do not fit the number of forks.
    #[error(
        "`seta.{key}` has {given} numbers, and a way from the root to a tip of the seta {wanted} {what}: give one for each"
    )]
    Levels { key: &'static str, given: usize, wanted: usize, what: &'static str },
    /// More tips than are computed.
    #[error("the branches {branches:?} of the seta end in {tips} tips: give branches for at most 4096")]
    Tips { branches: Vec<usize>, tips: f64 },
    /// A mesh for another seta.
    #[error(
        "the mesh of the seta is for {generations} generations of branches, of which it has {wanted}: give one number of elements for each"
    )]
    Generations { generations: usize, wanted: usize },
    /// Elements that do not exist.
    #[error(
        "elements of order {order} in {elements:?} per generation of the seta: orders are 1 to 8, and every generation needs at least one"
    )]
    Elements { order: usize, elements: Vec<usize> },
    /// A loading without a step.
    #[error("the loading of the seta has no step: give at least one")]
    NoSteps,
    /// A step that is none.
    #[error(
        "step {} of the loading of the seta goes along {direction:?} to {amount}: the direction needs a length, and nm or nN have to be positive", .step + 1
    )]
    Step { step: usize, direction: [f64; 3], amount: f64 },
    /// A start below the ground.
    #[error("the seta starts {height} nm above the ground: give zero or more")]
    Above { height: f64 },
    /// The tree of its beams.
    #[error("the beams of the seta: {0}")]
    Tree(#[from] TreeError),
}

impl Seta {
    /// That it can be computed.
    ///
    /// # Errors
    /// The first number that is out of range.
    pub fn check(&self) -> Result<(), SetaError> {
        let Self { material, .. } = self;
        let positive = [
            ("youngs_modulus", material.youngs_modulus),
            ("shear_correction", material.shear_correction),
            ("bending_stiffness_factor", material.bending_stiffness_factor),
        ];
        for (key, value) in positive {
            within(key, value, value > 0.0 && value.is_finite(), "a positive number")?;
        }
        let nu = material.poissons_ratio;
        within("poissons_ratio", nu, nu > -1.0 && nu < 0.5, "a number above -1 and below 0.5")?;
        // a tree that is given whole has been checked when it was made
        if self.tree.is_some() { Ok(()) } else { self.check_levels() }
    }

    fn check_levels(&self) -> Result<(), SetaError> {
        let positive = [
            ("tip_pitch", self.tip_pitch),
            ("shaft_length", self.shaft_length),
            ("brush_height", self.brush_height),
            ("shaft_diameter", self.shaft_diameter),
        ];
        let listed = self.diameters.iter().map(|&diameter| ("diameters", diameter));
        for (key, value) in positive.into_iter().chain(listed) {
            within(key, value, value > 0.0 && value.is_finite(), "a positive number")?;
        }
        for (key, value) in [("height_ratio", self.height_ratio), ("diameter_ratio", self.diameter_ratio)] {
            within(key, value, value > 0.0 && value < 1.0, "a number between 0 and 1")?;
        }
        for (key, value) in [("shaft_angle", self.shaft_angle), ("brush_angle", self.brush_angle)] {
            within(key, value, Range::SETA_ANGLE.contains(value), "an angle between -89 and 89 degrees")?;
        }
        within("forks", self.forks as f64, (1..=MOST_FORKS).contains(&self.forks), "a number from 1 to 12")?;
        let levels = self.branches.len();
        within("branches", levels as f64, levels <= MOST_FORKS, "at most 12 numbers")?;
        for &branches in &self.branches {
            within("branches", branches as f64, (1..=MOST_BRANCHES).contains(&branches), "numbers from 1 to 64")?;
        }
        let tips: f64 = self.branches.iter().map(|&branches| branches as f64).product();
        if tips > MOST_TIPS as f64 {
            return Err(SetaError::Tips { branches: self.branches.clone(), tips });
        }
        let wanted = self.levels();
        let lists = [
            ("fork_heights", self.fork_heights.len(), wanted, "forks"),
            ("diameters", self.diameters.len(), wanted + 1, "branches"),
        ];
        for (key, given, wanted, what) in lists {
            if given != 0 && given != wanted {
                return Err(SetaError::Levels { key, given, wanted, what });
            }
        }
        let below = self.fork_heights.iter().skip(1).chain([&0.0]);
        for (&height, &below) in self.fork_heights.iter().zip(below) {
            let falls = height > below && height.is_finite();
            within("fork_heights", height, falls, "heights above the tips that fall from the shaft on")?;
        }
        let scatter = self.height_scatter;
        within("height_scatter", scatter, scatter >= 0.0 && scatter.is_finite(), "zero or a positive number")?;
        let height = self.height(wanted - 1);
        if scatter > 0.5 * height {
            return Err(SetaError::Scatter { scatter, height });
        }
        Ok(())
    }

    /// That a mesh is one for it.
    pub(super) fn check_mesh(&self, mesh: &SetaMesh) -> Result<(), SetaError> {
        let (generations, wanted) = (mesh.elements.len(), self.levels() + 1);
        if generations != wanted {
            return Err(SetaError::Generations { generations, wanted });
        }
        if !(1..=MOST_ORDER).contains(&mesh.order) || mesh.elements.contains(&0) {
            return Err(SetaError::Elements { order: mesh.order, elements: mesh.elements.clone() });
        }
        Ok(())
    }
}

fn within(key: &'static str, value: f64, is_right: bool, range: &'static str) -> Result<(), SetaError> {
    if is_right { Ok(()) } else { Err(SetaError::OutOfRange { key, value, range }) }
}
