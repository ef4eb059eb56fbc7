//! What is optimised: an objective over design variables, under constraints.
//!
//! Every variable runs from 0 to 1 between its bounds, evenly or logarithmically ([`DesignVariable::value`]). In these coordinates c the
//! problem is
//!
//! minimise ∓ ln Q(c) over 0 ≤ c ≤ 1 with g(c) ≤ 0 and e(c) = 0,
//!
//! - for a maximum, + for a minimum of the objective Q. Derivatives of ln Q have no unit, and neither have g and e.

use crate::model::peel::PeelModel;
use crate::study::asked::stop_criteria::StopCriteria;
use crate::study::parameters::limit_point_continuation::result::Spacing;
use crate::study::parameters::sensitivity::quantity::PeelQuantity;
use crate::study::peel::result::Peel;

/// Whether the objective is to be large or small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    /// As large as possible
    Maximise,
    /// As small as possible
    Minimise,
}

impl Goal {
    /// The factor of ln Q in what is minimised.
    pub(super) fn sign(self) -> f64 {
        match self {
            Self::Maximise => -1.0,
            Self::Minimise => 1.0,
        }
    }
}

/// What is maximised or minimised; it has to be above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Objective {
    /// A number of the peel
    Quantity(PeelQuantity),
    /// The same number pulled at one angle over that pulled at another: how well a body holds in one direction and lets go in the other.
    Ratio {
        /// Of both peels
        of: PeelQuantity,
        /// Angle of the pull above the line, rad
        holding_angle: f64,
        /// Angle of the pull below the line, rad
        release_angle: f64,
    },
}

/// One factor of an objective: a number of a peel to the power of `power`, 1 or -1.
#[derive(Clone, Copy)]
pub(super) struct Factor {
    pub of: PeelQuantity,
    pub power: f64,
    /// Of the pull, rad; none: that of the model
    pub angle: Option<f64>,
}

impl Factor {
    /// The model whose peel has the number.
    pub(crate) fn model(&self, mut model: PeelModel) -> PeelModel {
        if let Some(angle) = self.angle {
            model.pull.angle = angle;
        }
        model
    }
}

impl Objective {
    /// ln Q = Σ power ln(number of the peel of each factor).
    pub(super) fn factors(&self) -> Vec<Factor> {
        match *self {
            Self::Quantity(of) => vec![Factor { of, power: 1.0, angle: None }],
            Self::Ratio { of, holding_angle, release_angle } => vec![
                Factor { of, power: 1.0, angle: Some(holding_angle) },
                Factor { of, power: -1.0, angle: Some(release_angle) },
            ],
        }
    }

    /// The number of the peel that it is made of.
    pub fn quantity(&self) -> PeelQuantity {
        match *self {
            Self::Quantity(of) | Self::Ratio { of, .. } => of,
        }
    }
}

/// A number of the design and its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignVariable {
    /// Its name in results: a key of a scene, or a column of a profile with the place
    pub name: String,
    /// Least value, in the unit of the library
    pub lower: f64,
    /// Largest value
    pub upper: f64,
    /// How its coordinate runs between them
    pub spacing: Spacing,
    /// Of a value of a profile: which column, and S/L
    pub along: Option<(ProfileColumn, f64)>,
}

impl DesignVariable {
    /// With a logarithmic coordinate where both bounds are above zero and one is more than twice the other.
    pub fn new(name: impl Into<String>, lower: f64, upper: f64) -> Self {
        let wide = lower > 0.0 && upper > 2.0 * lower;
        let spacing = if wide { Spacing::Logarithmic } else { Spacing::Linear };
        Self { name: name.into(), lower, upper, spacing, along: None }
    }

    fn ends(&self) -> (f64, f64) {
        (self.spacing.coordinate(self.lower), self.spacing.coordinate(self.upper))
    }

    /// From bound to bound: ln of their ratio of a logarithmic coordinate.
    pub(super) fn range(&self) -> f64 {
        let (from, to) = self.ends();
        to - from
    }

    /// The value at a coordinate, which is 0 at the lower bound and 1 at the upper one; both exactly.
    pub fn value(&self, coordinate: f64) -> f64 {
        let (from, to) = self.ends();
        match coordinate {
            0.0 => self.lower,
            1.0 => self.upper,
            c => self.spacing.value(from + (to - from) * c),
        }
    }

    /// The coordinate of a value.
    pub(crate) fn coordinate(&self, value: f64) -> f64 {
        let (from, to) = self.ends();
        (self.spacing.coordinate(value) - from) / (to - from)
    }
}

/// Whether a constraint holds with equality.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstraintKind {
    /// e(values) = 0
    Equal,
    /// g(values) ≤ 0
    AtMost,
}

/// A function of the values of all variables.
pub(crate) type DesignFunction<'m> = Box<dyn Fn(&[f64]) -> f64 + Send + Sync + 'm>;

/// A constraint that costs nothing to evaluate beside a peel: a function of the values, without a unit, that changes by about as much
/// as ln of the values does.
pub struct DesignConstraint<'m> {
    /// Its name in results
    pub name: String,
    /// What it demands
    pub kind: ConstraintKind,
    /// e or g of the values of all variables
    pub function: DesignFunction<'m>,
}

/// The model of the values of all variables; none where there is no such model.
pub(crate) type DesignModel<'m> = Box<dyn Fn(&[f64]) -> Option<PeelModel> + Send + Sync + 'm>;

/// A number of a design that was computed by something else than a peel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DesignNumber {
    /// In its unit
    pub value: f64,
    /// Bound on its error; none where there is none
    pub error: Option<f64>,
    /// Displacement (nm) and force (nN) of what was computed
    pub curve: Vec<(f64, f64)>,
}

/// What was computed of a design, one a factor of the objective.
#[derive(Debug)]
pub enum DesignFound {
    /// Peels
    Peels(Vec<Peel>),
    /// Displacement (nm) and force (nN) of something else
    Curves(Vec<Vec<(f64, f64)>>),
}

/// The number of the objective from the values of all variables and, of a ratio, the angle of the pull (rad), computed as long as the criteria let it;
/// or why there is none.
pub type NumberOf<'m> =
    Box<dyn Fn(&[f64], Option<f64>, &StopCriteria) -> Result<DesignNumber, String> + Send + Sync + 'm>;

/// How the number of a design is computed.
pub enum NumberBy<'m> {
    /// By the peel of its model, with derivatives
    Peel,
    /// By something that has no derivatives, such as the pull-off of a seta
    Values(NumberOf<'m>),
}

/// An objective over design variables, under constraints.
pub struct DesignProblem<'m> {
    /// What is optimised
    pub objective: Objective,
    /// In which direction
    pub goal: Goal,
    /// What is free
    pub variables: Vec<DesignVariable>,
    /// What has to hold beside the bounds of the variables
    pub constraints: Vec<DesignConstraint<'m>>,
    /// From the values of the variables to what is peeled; where the number is not that of its peel, to what is checked and drawn of a design
    pub model: DesignModel<'m>,
    /// How the number of a design is computed
    pub number: NumberBy<'m>,
    /// The values of the design that the optimum is compared with, and where the first search begins
    pub start: Vec<f64>,
}

/// A step of the differences of a constraint.
const STEP: f64 = 1e-5;

impl DesignProblem<'_> {
    /// The values at coordinates.
    pub fn values(&self, coordinates: &[f64]) -> Vec<f64> {
        self.variables.iter().zip(coordinates).map(|(variable, &c)| variable.value(c)).collect()
    }

    /// The coordinates of values.
    pub(crate) fn coordinates(&self, values: &[f64]) -> Vec<f64> {
        self.variables.iter().zip(values).map(|(variable, &value)| variable.coordinate(value)).collect()
    }

    /// The model at coordinates.
    pub(super) fn model_at(&self, coordinates: &[f64]) -> Option<PeelModel> {
        (self.model)(&self.values(coordinates))
    }

    /// A constraint at coordinates.
    pub(super) fn constraint(&self, index: usize, coordinates: &[f64]) -> f64 {
        (self.constraints[index].function)(&self.values(coordinates))
    }

    /// Its gradient, by central differences: it costs nothing beside a peel, and their error is below 1e-9.
    pub(super) fn constraint_gradient(&self, index: usize, coordinates: &[f64]) -> Vec<f64> {
        let mut at = coordinates.to_vec();
        (0..at.len())
            .map(|i| {
                let mut value = |c: f64| {
                    at[i] = c;
                    self.constraint(index, &at)
                };
                let difference = value(coordinates[i] + STEP) - value(coordinates[i] - STEP);
                at[i] = coordinates[i];
                difference / (2.0 * STEP)
            })
            .collect()
    }

    /// By how much the worst constraint is violated; zero where all hold.
    pub fn violation(&self, coordinates: &[f64]) -> f64 {
        let values = self.values(coordinates);
        let of = |constraint: &DesignConstraint| {
            let value = (constraint.function)(&values);
            if constraint.kind == ConstraintKind::Equal { value.abs() } else { value.max(0.0) }
        };
        self.constraints.iter().map(of).fold(0.0, f64::max)
    }
}

/// What varies along the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ProfileColumn {
    /// The width
    Width,
    /// The height of the section
    Height,
}

impl ProfileColumn {
    /// Its name in a scene and in results.
    pub fn word(self) -> &'static str {
        match self {
            Self::Width => "width",
            Self::Height => "height",
        }
    }
}
