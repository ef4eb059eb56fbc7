//! What the solver asks of a chain of elements: to be eliminated down to its last node, and to go back from there.

use crate::beam::element::energy_density::SectionState;
use crate::beam::element::integration::ElementEnergy;
use crate::solve::error::SolveError;
use crate::solve::state::History;
use crate::solve::system::NodalTerms;
use std::any::Any;
use std::ops::Range;

/// The most fields a node can have.
pub(crate) const MOST_FIELDS: usize = 3;
/// Size of the root block: fields of the last node, border, residual and path.
pub const ROOT: usize = MOST_FIELDS + 2;

/// A configuration of the chain: where its elements end, and its unknowns.
#[derive(Clone, Copy, Debug)]
pub struct Configuration<'a> {
    /// Reference coordinates S of the ends of the elements, nm; one more than there are elements.
    pub ends: &'a [f64],
    /// Fields node by node from left to right: of three the first is ξ = x - S, nm.
    pub state: &'a [f64],
    /// The horizontal force H where it is one unknown of the whole chain, nN; zero elsewhere
    pub axial_multiplier: f64,
    /// What its material points remember, where there is friction or a face that does not heal.
    pub history: Option<&'a History>,
    /// What strains they had before a step in time, where the material is viscous or the adhesive resists its opening.
    pub strains: Option<KnownStrains<'a>>,
}

/// What a viscous material and its adhesive remember before a step in time.
#[derive(Clone, Copy, Debug)]
pub struct KnownStrains<'a> {
    /// What its elastic stiffness is multiplied with, without a unit
    pub factor: f64,
    /// c of the step, 1/time: the rate of what is remembered is c times its change
    pub per_time: f64,
    /// Γ1, Γ2, θ' (1/nm) and the distance of the bonded face (nm) from which the step counts, Gauss point by Gauss point and element by element.
    pub strains: &'a [[f64; 4]],
}

/// What the path condition wants of the chain: a linear functional of the coverage and of the left end's fields.
#[derive(Clone, Copy, Debug, Default)]
pub struct ConstraintGradient {
    /// Weight of the coverage, 1/aJ
    pub coverage: f64,
    /// Weights of the fields of the left end
    pub left: [f64; MOST_FIELDS],
}

/// What is left of the chain when all nodes but the last are eliminated.
#[derive(Clone, Copy, Debug)]
pub struct CondensedChain {
    /// Leading block: fields of the last node, then the border; then the residual column and the path row.
    pub matrix: [[f64; ROOT]; ROOT],
    /// Negative eigenvalues of the chain with its last node held.
    pub negative: usize,
    /// Energy before the update.
    pub energy: ElementEnergy,
    /// The pivot that came nearest to zero: how near to singular the chain is with its last node held.
    pub least_pivot: LeastPivot,
}

/// The pivot of an elimination that is nearest to zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastPivot {
    /// Without its sign, in the unit of the equation over that of its unknown
    pub size: f64,
    /// Where it was met: in the interior or at the left end of this element, counted from the left end of the chain from 0.
    pub element: usize,
}

/// What is left of a right-hand side at the root, and the root's solution: of the fields of the last node, then of the border.
pub(crate) type RootVector = [f64; MOST_FIELDS + 1];

/// Size of the block of an element's two ends: their fields, border, residual or path.
pub(super) const EDGE: usize = 2 * MOST_FIELDS + 2;

/// A row of the block of an element's ends.
pub(super) type EndRow = [f64; EDGE];

/// What stands below the pivots of an element's left end, in the rows of its right end and of the border.
pub(super) type BelowEnd = [[f64; MOST_FIELDS]; MOST_FIELDS + 1];

/// What a chain keeps for the way back; reused from solve to solve.
#[derive(Debug, Default)]
pub struct ChainFactors {
    /// Of a type that the chain alone knows: the fronts of its elements.
    pub(super) fronts: Option<Box<dyn Any + Send + Sync>>,
    /// Pivot rows of the left ends of the elements.
    pub(super) ends: Vec<EndRow>,
    /// The columns below them, element by element.
    pub(super) below: Vec<BelowEnd>,
}

/// State of one node between elements, from nodal forces.
#[derive(Clone, Copy, Debug)]
pub struct NodeState {
    /// S, nm
    pub position: f64,
    /// Fields at the node, x in place of ξ, nm and rad.
    pub values: [f64; MOST_FIELDS],
    /// Section forces and stretch there.
    pub section: SectionState,
    /// Adhesion energy per length there, nN
    pub adhesion: f64,
}

impl NodeState {
    /// The first integral H x' + V y' + M θ' - stored - bΨ, nN.
    pub fn first_integral(&self) -> f64 {
        self.section.eshelby() - self.adhesion
    }
}

/// A chain of elements of one order and one density.
pub trait Chain: Send + Sync {
    /// Fields a node.
    fn fields(&self) -> usize;
    /// Order p of the elements.
    fn order(&self) -> usize;
    /// Place of the node of rank `rank` (0 to p) within its element, as a fraction of its length.
    fn node_fraction(&self, rank: usize) -> f64;
    /// Weight of the node of rank `rank` in the Gauss-Lobatto rule of its element, as a fraction of its length.
    fn node_weight(&self, rank: usize) -> f64;
    /// Whether one unknown is shared by the whole chain.
    fn has_border(&self) -> bool;
    /// Integrates and eliminates; what is needed to go back stays in `eliminated`.
    fn eliminate(
        &self,
        at: Configuration,
        path: &ConstraintGradient,
        eliminated: &mut ChainFactors,
    ) -> Result<CondensedChain, SolveError> {
        self.eliminate_with(at, path, NodalTerms::NONE, eliminated)
    }
    /// The same with terms of the nodes added.
    fn eliminate_with(
        &self,
        at: Configuration,
        path: &ConstraintGradient,
        added: NodalTerms,
        eliminated: &mut ChainFactors,
    ) -> Result<CondensedChain, SolveError>;
    /// Goes back from the root's solution `root` (last node's fields, border): x = scale × residual part - U⁻¹ root part.
    /// Panics unless `eliminated` comes from an elimination of a chain of this kind.
    fn recover(&self, eliminated: &ChainFactors, root: &[f64], scale: f64, out: &mut [f64]);
    /// Takes a right-hand side b of K x = b, or of Kᵀ x = b where `transposed`, through the elimination that `eliminated` comes from,
    /// down to the root: returns what is left there, for the leading block of [`CondensedChain::matrix`] or its transpose to be solved for.
    ///
    /// K is the tangent that was eliminated, damping included. In the row of a field that is held at the left end it has one on the
    /// diagonal and nothing else; its column is what it is. `right` holds a number an unknown: the fields node by node from left to
    /// right, then the border where there is one. [`Chain::substitute`] turns it into x. Panics unless `eliminated` comes from an
    /// elimination of a chain of this kind and `right` has so many numbers.
    fn reduce(&self, eliminated: &ChainFactors, right: &mut [f64], transposed: bool) -> RootVector;
    /// Goes back from the root's solution (last node's fields, border): makes x of a right-hand side that [`Chain::reduce`] has gone
    /// through, with the same `eliminated` and `transposed`.
    fn substitute(&self, eliminated: &ChainFactors, root: &[f64], right: &mut [f64], transposed: bool);
    /// Adds to the heights of the nodes of `state` what a step by `direction`, which is not taken here, leaves out: with it the vertical section
    /// force of every Gauss point is what its linearisation says. `axial`: the border and its change. The left end stays.
    fn follow_force(&self, ends: &[f64], state: &mut [f64], direction: &[f64], axial: [f64; 2]);
    /// Energy of a configuration, and how its coverage changes along `direction`, a change of the fields.
    fn energy(&self, at: Configuration, direction: &[f64]) -> (ElementEnergy, f64);
    /// The gradient of the energy by the fields of the nodes, and by the border; for the fields that the left end holds, how far they are
    /// from there.
    fn residual(&self, at: Configuration) -> (Vec<f64>, f64);
    /// The gradient of the coverage by the fields of the nodes.
    fn coverage_gradient(&self, at: Configuration) -> Vec<f64>;
    /// Section state at every end of the elements of a range.
    fn node_states(&self, at: Configuration, elements: Range<usize>) -> Vec<NodeState>;
    /// S of every Gauss point, and the length that it stands for, nm
    fn gauss_points(&self, ends: &[f64]) -> Vec<[f64; 2]>;
    /// What the material points remember behind a step that ended in a configuration, the step before being `before` times as long, and the
    /// integral of the energy that
    /// [`EnergyDensity::remember`](crate::beam::element::energy_density::EnergyDensity::remember) gives, aJ; nothing where nothing remembers.
    fn updated_history(&self, at: Configuration, before: f64) -> Option<(History, f64)>;
    /// Fields at the local coordinate `local` in [-1, 1] of element `element`, x in place of ξ, and the section state there.
    fn sample(&self, at: Configuration, element: usize, local: f64) -> ([f64; MOST_FIELDS], SectionState);
    /// The state on element ends that lie a little beside its own: each node's value moved along its element's polynomial,
    /// to second order in the move.
    fn shifted(&self, at: Configuration, ends: &[f64]) -> Vec<f64>;
    /// The state on other ends of elements, each new node read off the element it falls in.
    fn resampled(&self, at: Configuration, ends: &[f64]) -> Vec<f64>;
}
