//! What a solver may ask of a discretised structure.
//!
//! A system is any structure with unknowns q and an energy Π(q), or, where its load has no potential, a residual R(q) in the
//! place of ∂Π/∂q. A chain of beam elements is one, a truss another. Newton's method, path following, limit points, branching
//! points and relaxation know nothing but this.
//!
//! Few of its unknowns are its *interface*: what end conditions hold or drive. To factorise eliminates all others, so that
//! the solver is left with a small dense block, to which it adds the grip, the force and the path constraint. A call
//! costs one dynamic dispatch a factorisation.

use super::error::SolveError;
use super::state::{History, MONITORS, Mesh, State};
use super::workspace::Workspace;
use std::sync::Arc;

/// The most unknowns of an interface.
pub const INTERFACE: usize = 6;

/// An unknown of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// As in messages
    pub name: &'static str,
    /// As in messages
    pub unit: &'static str,
}

/// What is added to the tangent K: K + C/`per_damping` + M/`per_mass`, with matrices C and M of the system; where one of them is infinite,
/// nothing. A step Δt of a gradient flow has Δt and ∞, one of an implicit rule of motion multiples of Δt and Δt².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// Of the damping matrix: a time
    pub per_damping: f64,
    /// Of the mass matrix: a time squared
    pub per_mass: f64,
}

impl Coefficients {
    /// The tangent alone.
    pub const STATIC: Self = Self { per_damping: f64::INFINITY, per_mass: f64::INFINITY };
}

/// What is added to the equations of single unknowns, a number each in the order of a direction; nothing where empty.
#[derive(Clone, Copy, Debug, Default)]
pub struct NodalTerms<'a> {
    /// To the diagonal of the tangent
    pub stiffness: &'a [f64],
    /// To the residual
    pub force: &'a [f64],
}

impl NodalTerms<'_> {
    /// Nothing.
    pub const NONE: Self = Self { stiffness: &[], force: &[] };

    /// Both of one unknown.
    #[inline(always)]
    pub fn at(&self, unknown: usize) -> (f64, f64) {
        let of = |terms: &[f64]| terms.get(unknown).copied().unwrap_or(0.0);
        (of(self.stiffness), of(self.force))
    }
}

/// What is left of a system when all unknowns but those of the interface are eliminated. Slots are those of the interface.
#[derive(Clone, Copy, Debug)]
pub struct CondensedSystem {
    /// Rows are equations, columns unknowns
    pub matrix: [[f64; INTERFACE]; INTERFACE],
    /// Of these equations
    pub residual: [f64; INTERFACE],
    /// The gradient of the weighed monitors, and what elimination adds to their sum.
    pub gradient: [f64; INTERFACE],
    /// What elimination adds to the sum of the weighed monitors
    pub gradient_residual: f64,
    /// Negative eigenvalues of the system with its interface held.
    pub negative: usize,
    /// The smallest pivot without its sign.
    pub least_pivot: f64,
    /// Before the update.
    pub evaluation: Evaluation,
}

/// Energy and monitors of a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// Π without the work of the force, aJ
    pub energy: f64,
    /// In the order of the system
    pub monitors: [f64; MONITORS],
    /// A number for the record, as in [`super::Observables::recorded`].
    pub recorded: f64,
}

/// How the monitors of a state change along a direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rates {
    /// Of each monitor per length of the direction
    pub monitors: [f64; MONITORS],
    /// Of the recorded quantity per length of the direction
    pub recorded: f64,
}

/// The roll of the driven end of a system in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndRoll {
    /// rad
    pub angle: f64,
    /// Its derivatives by the unknowns of the interface
    pub gradient: [f64; INTERFACE],
}

impl EndRoll {
    /// How it changes with the interface.
    pub fn along(&self, interface: &[f64; INTERFACE]) -> f64 {
        self.gradient.iter().zip(interface).map(|(by, change)| by * change).sum()
    }
}

/// How a path depends on its steps, because its material points remember them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepDependence {
    /// It does not.
    None,
    /// Faces slide under friction: where much that slides sticks at once the path has a corner, which whole updates of Newton's method overshoot.
    Friction,
    /// Sections yield: its points are so close to one another that an interpolant between them is as good as they are.
    Yielding,
}

impl StepDependence {
    /// Whether it does.
    pub fn exists(self) -> bool {
        self != Self::None
    }

    /// Whether sections yield.
    pub fn is_yielding(self) -> bool {
        self == Self::Yielding
    }
}

/// A discretised structure.
///
/// A *direction* is a change of the unknowns, one number each in the system's order; a state holds values, which may be more
/// numbers than that where rotations are kept as quaternions.
pub trait System: Send + Sync {
    /// The unknowns that end conditions may be set on, at most [`INTERFACE`].
    fn interface(&self) -> &[Unknown];

    /// Numbers of a direction at this state.
    fn unknowns(&self, at: &State) -> usize;

    /// Values of the interface.
    fn interface_values(&self, at: &State) -> [f64; INTERFACE];

    /// Where in a direction the unknown of a slot of the interface stands.
    fn place_of(&self, slot: usize, at: &State) -> usize;

    /// How many unknowns are Lagrange multipliers: each adds a negative eigenvalue that is none of the structure's.
    fn multipliers(&self) -> usize {
        0
    }

    /// Whether the load has a potential: then the tangent is symmetric, work is a difference of energies, and the number of
    /// negative eigenvalues gives stability.
    fn is_conservative(&self) -> bool {
        true
    }

    /// Whether branches that nearly meet are to be expected on its paths: each step is then looked at for whether it stays on its branch.
    fn has_near_branches(&self) -> bool {
        false
    }

    /// The roll of the driven end: what tells the branches of a path apart where a symmetric plane loses its stability, while the monitors
    /// and the displacement stay as they are to first order. None of a system in the plane.
    fn roll(&self, _at: &State) -> Option<EndRoll> {
        None
    }

    /// How its paths depend on their steps.
    fn step_dependence(&self) -> StepDependence {
        StepDependence::None
    }

    /// Updates of this relative size, as in [`System::size`], may be round-off.
    fn round_off(&self) -> f64 {
        0.0
    }

    /// Factorises the tangent, with the gradient of Σ weights·monitors carried along; the factors stay in `ws`.
    ///
    /// Errors: a pivot that is zero to rounding, a number that is not finite, with their place.
    fn factorise(
        &self,
        at: &State,
        coefficients: Coefficients,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError>;

    /// The direction that solves K q = scale R, given its values on the interface. Of the residual at the factorised state.
    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]);

    /// Takes a right-hand side down to the interface with the factors of the last factorisation; what stays in `right` is for
    /// [`System::substitute`]. With `transposed` of Kᵀ.
    fn reduce(&self, ws: &Workspace, right: &mut [f64], transposed: bool) -> [f64; INTERFACE];

    /// From a reduced right-hand side and the solution on the interface to the whole solution, in place.
    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool);

    /// Energy and monitors of a state, and the rates of the monitors along a direction.
    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates);

    /// The gradient of Σ weights·monitors, one number an unknown.
    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64>;

    /// R of the free structure, without its grip: ∂Π/∂q where there is Π, one number an unknown.
    fn residual(&self, at: &State) -> Vec<f64>;

    /// Goes on from a state by `factor` times a direction.
    fn retract(&self, at: &mut State, direction: &[f64], factor: f64) {
        for (value, change) in at.values.iter_mut().zip(direction) {
            *value += factor * change;
        }
    }

    /// Goes on from a state by an update of Newton's method, so that what is stiff is not stretched by more than the update says.
    fn step(&self, at: &mut State, update: &[f64]) {
        self.retract(at, update, 1.0);
    }

    /// The direction that leads from one state to another on the same mesh.
    fn difference(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        to.iter().zip(from).map(|(to, from)| to - from).collect()
    }

    /// Σ weights·states of states on the same mesh, weights that sum to one: where an extrapolation leads. Rotations go by their
    /// differences to the first.
    fn combine(&self, states: &[&[f64]], weights: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; states.first().map_or(0, |state| state.len())];
        add_weighted(&mut sum, states, weights, 1.0);
        sum
    }

    /// By what a combination of states misses another one, as a direction, into `out`.
    fn miss(&self, reached: &[f64], states: &[&[f64]], weights: &[f64], out: &mut Vec<f64>) {
        out.clear();
        out.extend_from_slice(reached);
        add_weighted(out, states, weights, -1.0);
    }

    /// Size of a direction at these values: 1 is a change of the order of the problem's own scales. NaN where a number is none.
    fn size(&self, direction: &[f64], at: &State) -> f64 {
        let sizes = self.per_unit(at).into_iter().zip(direction).map(|(unit, change)| (unit * change).abs());
        sizes.fold(0.0, |largest: f64, size| if size.is_nan() || size > largest { size } else { largest })
    }

    /// What each number of a direction is multiplied with to be measured as in [`System::size`].
    fn per_unit(&self, at: &State) -> Vec<f64>;

    /// The stress-free configuration on so many elements.
    fn stress_free(&self, elements: usize) -> State;

    /// The same configuration on another number of elements.
    fn on_elements(&self, at: &State, elements: usize) -> State {
        let _ = elements;
        at.clone()
    }

    /// The same configuration on half as many elements again, wherever there are some.
    fn refined(&self, at: &State) -> State {
        at.clone()
    }

    /// The same configuration on a mesh of its own for these monitors, on as many elements.
    fn refocused(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        let _ = monitors;
        at.clone()
    }

    /// The mesh for these monitors and [`Mesh::follows`], with as many elements as `like` and near to it.
    fn mesh_for(&self, monitors: [f64; MONITORS], follows: &[f64], like: &Mesh) -> Mesh {
        let _ = (monitors, follows);
        like.clone()
    }

    /// A state on the mesh that it asks for itself, with these monitors of it, which is next to its own. Predictions combine these.
    fn aligned(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        let _ = monitors;
        at.clone()
    }

    /// The same state on the mesh that it asks for, if its own is too far from that.
    fn remeshed(&self, at: &State) -> Option<State> {
        let _ = at;
        None
    }

    /// What the material points remember before a step that ended in a state where that is not what the step was taken with: the path has a corner
    /// there, as where a face that does not heal begins to close, and the step is to be taken again with this.
    fn corner_before(&self, at: &State) -> Option<Arc<History>> {
        let _ = at;
        None
    }

    /// What the material points remember behind a step that ended in a state.
    fn commit(&self, at: &State) -> Option<Arc<History>> {
        let _ = at;
        None
    }

    /// A direction of this size, as in [`System::size`], that has a part in any critical direction: a push that starts a relaxation.
    fn disturbance(&self, at: &State, size: f64) -> Vec<f64> {
        vec![size; self.unknowns(at)]
    }

    /// Whether a prediction may be tried from a state with these monitors. A body that is far from an obstacle predicts well,
    /// whatever the step, and knows nothing of the obstacle.
    fn admits(&self, _from: &State, _monitors: [f64; MONITORS], _prediction: &State) -> bool {
        true
    }

    /// Whether a state is one that the structure can be in: no body within another.
    fn is_admissible(&self, _at: &State) -> bool {
        true
    }
}

/// Numbers of a sum that are added up side by side.
const LANES: usize = 16;

/// Adds `factor` times Σ weights·states to `sum`, state after state.
fn add_weighted(sum: &mut [f64], states: &[&[f64]], weights: &[f64], factor: f64) {
    let (blocks, rest) = sum.as_chunks_mut::<LANES>();
    for (k, block) in blocks.iter_mut().enumerate() {
        let mut own = *block;
        for (state, weight) in states.iter().zip(weights) {
            let (weight, values) = (factor * weight, &state[k * LANES..][..LANES]);
            for l in 0..LANES {
                own[l] += weight * values[l];
            }
        }
        *block = own;
    }
    let from = blocks.len() * LANES;
    for (state, weight) in states.iter().zip(weights) {
        for (s, value) in rest.iter_mut().zip(&state[from..]) {
            *s += factor * weight * value;
        }
    }
}
