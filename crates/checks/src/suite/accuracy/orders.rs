//! Orders of convergence of the elements, p = 1 to 8: energy, displacement and peak force on uniform meshes.
//!
//! With p Gauss points for every term the nodes of elements of order p are as accurate as Gauss collocation, and the
//! energy converges with it: every quantity at order 2p. At high p an error is round-off before its rate is near 2p; the rate
//! between two meshes approaches it linearly in h, so that it is extrapolated to h = 0.

use crate::check::{Check, Measure, Topic};
use peelkit::model::{BeamProblem, Form, StripModel};
use peelkit::solve::{NewtonOptions, Observables, PathConstraint, Solution, State, Workspace, solve};

pub(in crate::suite) const TOPIC: Topic =
    Topic { name: "orders", about: "orders of convergence for p = 1 to 8 in energy, displacement, peak force", checks };

/// What is measured on a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Change of the stored and adhesion energy from rest to a given displacement.
    Energy,
    /// Displacement at a given force.
    Displacement,
    /// The first maximum of the force.
    PeakForce,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Quantity; 3] = [Quantity::Energy, Quantity::Displacement, Quantity::PeakForce];

    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Energy => "energy",
            Quantity::Displacement => "displacement",
            Quantity::PeakForce => "peak force",
        }
    }
}

/// Relative errors of one quantity at one order against the number of elements.
#[derive(Clone, Debug)]
pub struct Convergence {
    pub quantity: Quantity,
    /// p
    pub order: usize,
    /// Number of elements and relative error, coarse to fine, without those that are round-off.
    pub errors: Vec<(usize, f64)>,
}

impl Convergence {
    /// Rates between neighbouring meshes: middle h (geometric, in units of the length) and d ln(error)/d ln(h).
    fn rates(&self) -> Vec<(f64, f64)> {
        let rate = |pair: &[(usize, f64)]| {
            let [(coarse, before), (fine, after)] = [pair[0], pair[1]];
            let ratio = fine as f64 / coarse as f64;
            (1.0 / ((coarse * fine) as f64).sqrt(), (before / after).ln() / ratio.ln())
        };
        self.errors.windows(2).map(rate).collect()
    }

    /// The rate at h = 0 on the straight line through the last three rates; None where round-off leaves fewer.
    pub fn extrapolated(&self) -> Option<f64> {
        let rates = self.rates();
        let last = rates.len().checked_sub(3).map(|from| &rates[from..])?;
        let mean = |pick: fn(&(f64, f64)) -> f64| last.iter().map(pick).sum::<f64>() / last.len() as f64;
        let (h, rate) = (mean(|p| p.0), mean(|p| p.1));
        let slope = last.iter().map(|p| (p.0 - h) * (p.1 - rate)).sum::<f64>()
            / last.iter().map(|p| (p.0 - h).powi(2)).sum::<f64>();
        Some(rate - slope * h)
    }

    /// The rate between the two finest meshes whose error is above round-off.
    pub fn last(&self) -> Result<f64, String> {
        let few = || format!("{} meshes with an error above round-off are too few", self.errors.len());
        self.rates().last().map(|rate| rate.1).ok_or_else(few)
    }

    /// Against the theory: the extrapolated rate is 2p; where there is none, the last rate beats the p + 1 of elements whose
    /// nodes are not superconvergent.
    fn check(&self) -> Check {
        let (order, quantity) = (self.order as f64, self.quantity.name());
        let source = format!("order 2p = {} (p-stage Gauss collocation at the nodes)", 2 * self.order);
        match self.extrapolated() {
            Some(rate) => {
                // at high order the last errors are near round-off, and the line through their rates is less sure
                let tolerance = if self.order <= 6 { 0.1 } else { 0.15 };
                let name = format!("order of the {quantity}, p = {}, extrapolated to h = 0", self.order);
                Check::new(name, source, Ok(rate), 2.0 * order, Measure::Relative, tolerance)
            }
            None => {
                let name = format!("order of the {quantity}, p = {}, between two meshes", self.order);
                let source = format!("above p + 1; {source}, which round-off hides");
                Check::new(name, source, self.last(), order + 1.0, Measure::AtLeast, 0.0)
            }
        }
    }
}

/// Strip on which convergence is measured: of the paper's section, 12 nm long, r0 = 1 nm, so that uniform meshes of a few
/// elements resolve it.
fn strip() -> StripModel {
    let mut model = StripModel::of_the_paper(LENGTH, 1.0);
    model.adhesion.equilibrium_distance = 1.0;
    model
}

/// nm
const LENGTH: f64 = 12.0;
/// Displacement at which the energy is taken, nm; the force there is the given force.
const DISPLACEMENT: f64 = 0.12;
/// Numbers of elements.
const MESHES: [usize; 20] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];
/// An error outside of this is round-off, or of a mesh that does not yet resolve the strip.
const MEASURED: std::ops::Range<f64> = 5e-13..1e-3;

/// The errors of every quantity at every order against 40 elements of order 8.
pub fn convergence() -> Result<Vec<Convergence>, String> {
    let exact = Measured::on(8, 40, None)?;
    let mut all = Vec::new();
    for order in 1..=8 {
        let on = |elements| Measured::on(order, elements, Some(exact.force)).ok().map(|found| (elements, found));
        let found: Vec<(usize, Measured)> = MESHES.into_iter().filter_map(on).collect();
        for quantity in Quantity::ALL {
            let error = |m: &Measured| (m.value(quantity) / exact.value(quantity) - 1.0).abs();
            let errors = found.iter().map(|(elements, m)| (*elements, error(m)));
            let errors = errors.filter(|(_, error)| MEASURED.contains(error)).collect();
            all.push(Convergence { quantity, order, errors });
        }
    }
    Ok(all)
}

/// What one mesh gives.
struct Measured {
    energy: f64,
    force: f64,
    displacement: f64,
    peak_force: f64,
}

impl Measured {
    fn value(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Energy => self.energy,
            Quantity::Displacement => self.displacement,
            Quantity::PeakForce => self.peak_force,
        }
    }

    /// On a uniform mesh; the displacement is taken at `force`, or at the mesh's own force.
    fn on(order: usize, elements: usize, force: Option<f64>) -> Result<Self, String> {
        let problem = strip().problem(Form::TwoField, order).map_err(|error| error.to_string())?;
        let mut mesh = Mesh::new(&problem, elements);
        let lift = |target| PathConstraint { weights: Observables::DISPLACEMENT, target };
        let rest = mesh.solve(&lift(0.0))?;
        let mut here = rest.clone();
        for step in 1..=4 {
            here = mesh.solve(&lift(DISPLACEMENT * f64::from(step) / 4.0))?;
        }
        let pull = PathConstraint { weights: Observables::FORCE, target: force.unwrap_or(here.observables.force) };
        let displacement = mesh.solve(&pull)?.observables.displacement;
        Ok(Self {
            energy: here.energy - rest.energy,
            force: here.observables.force,
            displacement,
            peak_force: mesh.peak(lift)?,
        })
    }
}

/// A fixed mesh, and the last equilibrium on it.
struct Mesh<'a> {
    problem: &'a BeamProblem,
    at: State,
    ws: Workspace,
}

impl<'a> Mesh<'a> {
    fn new(problem: &'a BeamProblem, elements: usize) -> Self {
        let mut at = problem.initial(elements);
        at.mesh.boundaries = (0..=elements).map(|k| problem.beam.length() * k as f64 / elements as f64).collect();
        Self { problem, at, ws: Workspace::default() }
    }

    fn solve(&mut self, constraint: &PathConstraint) -> Result<Solution, String> {
        let options = NewtonOptions { tolerance: 1e-13, largest_update: 5.0, most_iterations: 30, exact_slope: true };
        let found = solve(self.problem, self.at.clone(), constraint, &options, &mut self.ws);
        let solution = found.map_err(|error| error.to_string())?;
        self.at = solution.at.clone();
        Ok(solution)
    }

    /// The maximum of the force: the zero of dP/du by the secant rule.
    fn peak(&mut self, lift: impl Fn(f64) -> PathConstraint) -> Result<f64, String> {
        let slope = |s: &Solution| s.slope.force / s.slope.displacement;
        let (mut before, mut here) = (DISPLACEMENT, 1.2 * DISPLACEMENT);
        let mut slope_before = slope(&self.solve(&lift(before))?);
        for _ in 0..40 {
            let solution = self.solve(&lift(here))?;
            let slope_here = slope(&solution);
            let step = -slope_here * (here - before) / (slope_here - slope_before);
            // the maximum is flat: its value is exact long before its place is
            if !step.is_finite() || step.abs() < 1e-9 * here {
                return Ok(solution.observables.force);
            }
            (before, slope_before) = (here, slope_here);
            here += step.clamp(-0.5 * DISPLACEMENT, 0.5 * DISPLACEMENT);
        }
        Err("the maximum of the force was not found in 40 steps".into())
    }
}

fn checks() -> Vec<Check> {
    match convergence() {
        Ok(all) => all.iter().map(Convergence::check).collect(),
        Err(reason) => {
            let name = "errors against 40 elements of order 8";
            vec![Check::new(name, "order 2p", Err(reason), 0.0, Measure::AtMost, 0.0)]
        }
    }
}
