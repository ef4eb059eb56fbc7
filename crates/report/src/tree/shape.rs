//! A tree of beams as it lies at one moment.

use peelkit::beam::BranchSection;

/// A branch of a tree as it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchShape {
    /// Where its elements begin and end, from S = 0 on
    pub sections: Vec<BranchSection>,
    /// Radius of its round section, nm
    pub radius: f64,
    /// How many branchings lie between it and the root: 0 of the stem
    pub generation: usize,
    /// Whether a tip behind it adheres
    pub attached: bool,
}

/// A tree of beams at one moment of a pull-off.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeState {
    /// Displacement of the root along the pull, nm
    pub displacement: f64,
    /// Force on the root along the pull, nN
    pub force: f64,
    /// Force on each tip away from the ground, nN; none of one that is detached
    pub tip_loads: Vec<Option<f64>>,
    /// All branches, in the order of the tree
    pub branches: Vec<BranchShape>,
}

impl TreeState {
    /// How many tips adhere.
    pub fn tips_attached(&self) -> usize {
        self.tip_loads.iter().flatten().count()
    }
}
