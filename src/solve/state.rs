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
    /// Further numbers that it follows, as the system says: they are extrapolated along a path
    pub follows: Vec<f64>,
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

/// Where the material points of a body are that remember.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Places {
    /// So far apart (nm), from one end of the body to the other: no mesh moves them
    Even(f64),
    /// At the Gauss points of a mesh that stays: S, and the length that each stands for, nm
    Gauss(Arc<Vec<[f64; 2]>>),
}

/// What material points remember: as many numbers at each. Between the points they are interpolated by cubics. What the numbers are, their system
/// says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Where the points are
    pub places: Places,
    /// How many numbers each remembers
    width: usize,
    /// Point by point
    numbers: Vec<f64>,
    /// Energy dissipated since the beginning, aJ
    pub dissipated: f64,
    /// Where on their path the two newest steps ended, in a measure of the system's own
    #[serde(default)]
    pub ends: [f64; 2],
}

/// Fewest and most steps from place to place.
const FEWEST: usize = 16;
const MOST: usize = 100_000;

impl History {
    /// Of a body of this length (nm), with about `spacing` (nm) from one place to the next; `at` gives the numbers at S.
    pub fn even<const W: usize>(length: f64, spacing: f64, at: impl Fn(f64) -> [f64; W]) -> Self {
        let steps = ((length / spacing).ceil() as usize).clamp(FEWEST, MOST);
        let spacing = length / steps as f64;
        let numbers = (0..=steps).flat_map(|k| at(k as f64 * spacing)).collect();
        Self { places: Places::Even(spacing), width: W, numbers, dissipated: 0.0, ends: [0.0; 2] }
    }

    /// Of points at the Gauss points of a mesh: S, and the length (nm) that each stands for. Their numbers, `width` each, are zero.
    pub fn at_gauss_points(points: Vec<[f64; 2]>, width: usize) -> Self {
        let numbers = vec![0.0; points.len() * width];
        Self { places: Places::Gauss(Arc::new(points)), width, numbers, dissipated: 0.0, ends: [0.0; 2] }
    }

    /// The same at the Gauss points of another mesh. `mend` is given S and what the numbers there are by interpolation.
    pub fn on_gauss_points(&self, points: Vec<[f64; 2]>, mend: impl Fn(f64, &mut [f64])) -> Self {
        let mut numbers: Vec<f64> = points.iter().flat_map(|[s, _]| self.interpolated(*s, self.width)).collect();
        points.iter().zip(numbers.chunks_exact_mut(self.width)).for_each(|([s, _], row)| mend(*s, row));
        Self { places: Places::Gauss(Arc::new(points)), numbers, ..*self }
    }

    /// Of the points next to S the numbers, and how far S is from the first to the second.
    pub(crate) fn around(&self, s: f64) -> ([&[f64]; 2], f64) {
        let second = match &self.places {
            Places::Even(spacing) => (s / spacing).ceil().max(0.0) as usize,
            Places::Gauss(points) => points.partition_point(|point| point[0] < s),
        };
        let second = second.clamp(1, self.count() - 1);
        let [one, two] = [second - 1, second].map(|point| self.place(point));
        let row = |point: usize| &self.numbers[point * self.width..][..self.width];
        ([row(second - 1), row(second)], ((s - one) / (two - one)).clamp(0.0, 1.0))
    }

    /// How many points there are.
    fn count(&self) -> usize {
        self.numbers.len() / self.width
    }

    /// S of a point, nm
    fn place(&self, point: usize) -> f64 {
        match &self.places {
            Places::Even(spacing) => point as f64 * spacing,
            Places::Gauss(points) => points[point][0],
        }
    }

    /// The length that a point stands for, nm.
    fn length(&self, point: usize) -> f64 {
        match &self.places {
            Places::Even(spacing) if point == 0 || point + 1 == self.count() => 0.5 * spacing,
            Places::Even(spacing) => *spacing,
            Places::Gauss(points) => points[point][1],
        }
    }

    /// The first `K` numbers of a point; zero beyond what it remembers.
    pub fn of<const K: usize>(&self, point: usize) -> [f64; K] {
        let known = &self.numbers[point * self.width..][..self.width];
        std::array::from_fn(|column| known.get(column).copied().unwrap_or(0.0))
    }

    /// The first `K` numbers at S; zero beyond what is remembered.
    pub fn at<const K: usize>(&self, s: f64) -> [f64; K] {
        let mut all = [0.0; K];
        let known = self.interpolated(s, K.min(self.width));
        all.iter_mut().zip(known).for_each(|(number, known)| *number = known);
        all
    }

    /// The first numbers at S, as many as are asked for.
    fn interpolated(&self, s: f64, columns: usize) -> impl Iterator<Item = f64> {
        let (first, weights) = match &self.places {
            Places::Even(spacing) => {
                let along = s / spacing;
                let first = (along.floor() as usize).clamp(1, self.count() - 3) - 1;
                let t = along - first as f64;
                let weights = [
                    (t - 1.0) * (t - 2.0) * (t - 3.0) / -6.0,
                    t * (t - 2.0) * (t - 3.0) / 2.0,
                    t * (t - 1.0) * (t - 3.0) / -2.0,
                    t * (t - 1.0) * (t - 2.0) / 6.0,
                ];
                (first, weights)
            }
            Places::Gauss(points) => {
                let first = points.partition_point(|point| point[0] < s).clamp(2, points.len() - 2) - 2;
                let at: [f64; 4] = std::array::from_fn(|k| points[first + k][0]);
                let others = |k: usize| (0..4).filter(move |&j| j != k);
                (first, std::array::from_fn(|k| others(k).map(|j| (s - at[j]) / (at[k] - at[j])).product()))
            }
        };
        (0..columns)
            .map(move |column| (0..4).map(|k| weights[k] * self.numbers[(first + k) * self.width + column]).sum())
    }

    /// Of each point S and the length that it stands for (nm), and its numbers.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64, &[f64])> {
        self.numbers.chunks_exact(self.width).enumerate().map(|(k, row)| (self.place(k), self.length(k), row))
    }

    /// The numbers of each point, to be changed.
    pub(crate) fn numbers_mut(&mut self) -> impl Iterator<Item = &mut [f64]> {
        self.numbers.chunks_exact_mut(self.width)
    }

    /// Behind a step: `update` turns the numbers at S into those of now, and gives an energy per length, nN; the integral of this along the body, aJ.
    pub(crate) fn updated(&self, mut update: impl FnMut(f64, &mut [f64]) -> f64) -> (Self, f64) {
        let (mut next, mut energy) = (self.clone(), 0.0);
        for (k, row) in next.numbers_mut().enumerate() {
            energy += self.length(k) * update(self.place(k), row);
        }
        (next, energy)
    }
}

// -- The numbers that tell where on a path an equilibrium lies, and linear conditions on them --

/// How many numbers of its own a system may measure a path by.
pub const MONITORS: usize = 2;

/// The numbers that tell where on the path an equilibrium lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Observables {
    /// Numbers of the system, as [`crate::solve::System::evaluate`] gives them.
    pub monitors: [f64; MONITORS],
    /// u of the drive, nm (rad where that is a rotation); of the far end of its spring where it has one
    pub displacement: f64,
    /// P that does work on u, nN (nN·nm where that is a rotation)
    pub force: f64,
    /// A further number of the system, for the record; no constraint weighs it.
    pub recorded: f64,
    /// The roll of the driven end, rad, where it measures the path: see [`crate::solve::MeasuredBeside::Roll`]
    pub roll: f64,
}

impl Observables {
    const NOTHING: Self = Self { monitors: [0.0; MONITORS], displacement: 0.0, force: 0.0, recorded: 0.0, roll: 0.0 };
    /// Weights of displacement control.
    pub const DISPLACEMENT: Self = Self { displacement: 1.0, ..Self::NOTHING };
    /// Weights of a held force.
    pub const FORCE: Self = Self { force: 1.0, ..Self::NOTHING };

    /// Weights of a held monitor.
    pub const fn monitor(index: usize) -> Self {
        let mut monitors = [0.0; MONITORS];
        monitors[index] = 1.0;
        Self { monitors, ..Self::NOTHING }
    }

    /// Sum of the products of what a constraint can weigh.
    pub fn dot(&self, other: &Self) -> f64 {
        self.monitors[0] * other.monitors[0]
            + self.displacement * other.displacement
            + self.monitors[1] * other.monitors[1]
            + self.force * other.force
            + self.roll * other.roll
    }

    /// Whether every component is a finite number.
    pub(crate) fn is_finite(&self) -> bool {
        let Self { monitors: [first, second], displacement, force, recorded, roll } = *self;
        [first, second, displacement, force, recorded, roll].iter().all(|number| number.is_finite())
    }

    /// Each component times a number.
    pub fn times(&self, factor: f64) -> Self {
        Self {
            monitors: self.monitors.map(|monitor| factor * monitor),
            displacement: factor * self.displacement,
            force: factor * self.force,
            recorded: factor * self.recorded,
            roll: factor * self.roll,
        }
    }

    /// The sum with another.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        self.since(&other.times(-1.0))
    }

    /// The difference to an earlier point.
    pub fn since(&self, earlier: &Self) -> Self {
        Self {
            monitors: std::array::from_fn(|k| self.monitors[k] - earlier.monitors[k]),
            displacement: self.displacement - earlier.displacement,
            force: self.force - earlier.force,
            recorded: self.recorded - earlier.recorded,
            roll: self.roll - earlier.roll,
        }
    }
}

/// weights · observables = target: displacement control, force control, or a step along the path.
#[derive(Clone, Copy, Debug)]
pub struct PathConstraint {
    /// One for each observable
    pub weights: Observables,
    /// In the unit of weights times observables
    pub target: f64,
}

/// Σ wᵢ xᵢ of lists of numbers that are equally long.
pub(crate) fn weighted_sum(states: &[&[f64]], weights: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; states.first().map_or(0, |state| state.len())];
    for (state, weight) in states.iter().zip(weights) {
        sum.iter_mut().zip(*state).for_each(|(sum, value)| *sum += weight * value);
    }
    sum
}
