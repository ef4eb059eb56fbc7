//! A beam at one point of its path, as a term of the model sees it.

use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::section::line_load::LineLaw;
use crate::adhesion::substrate::Substrate;
use crate::adhesion::substrate_response::GroundLaw;
use crate::beam::material::stretch_law::StretchLaw;
use crate::beam::planar::chain::Configuration;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::section::Section;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::number::gauss::Rule;
use crate::solve::newton::Solution;
use crate::solve::path::predictor::lagrange_weights;
use std::num::NonZeroUsize;

/// One equilibrium of a path, with the direction in which the path goes on.
pub(super) struct SectionSampling<'a> {
    model: &'a PeelModel,
    problem: &'a BeamProblem,
    beam: &'a PlanarBeam,
    pub solution: &'a Solution,
    rule: Rule,
    /// Weights of a sum over the points of an element that gives the integral from its left end to one of them.
    up_to: Vec<Vec<f64>>,
}

/// What a term sees of the beam at one place.
pub(super) struct Point {
    section: Section,
    stretch: StretchLaw,
    pub width: f64,
    pub height: f64,
    /// Of the axis along the substrate, from the free end where x is no unknown
    x: f64,
    pub gap: f64,
    pub rotation: f64,
    /// N and Q, nN
    normal: f64,
    shear: f64,
}

/// Step along the path over which energies are differenced, relative as in [`Problem::relative_size`].
const STEP: f64 = 1e-4;

impl<'a> SectionSampling<'a> {
    /// On a path of this model in the plane, with one more point than an element has unknowns along it.
    pub(crate) fn new(model: &'a PeelModel, problem: &'a BeamProblem, solution: &'a Solution) -> Option<Self> {
        let beam = problem.beam.planar()?;
        let rule = Rule::new(NonZeroUsize::MIN.saturating_add(problem.beam.order()));
        let places: Vec<f64> = rule.over(0.0, 1.0).map(|(place, _)| place).collect();
        let integral = |to: f64| {
            let mut weights = vec![0.0; places.len()];
            for (at, weight) in rule.over(0.0, to) {
                let shares = lagrange_weights(&places, at);
                weights.iter_mut().zip(shares).for_each(|(sum, share)| *sum += weight * share);
            }
            weights
        };
        let up_to = places.iter().map(|&place| integral(place)).collect();
        Some(Self { model, problem, beam, solution, rule, up_to })
    }

    /// dF of F = ∫ density dS, per unit of the path's parameter.
    pub(crate) fn rate(&self, density: impl Fn(&Point) -> f64) -> f64 {
        let total = |at: Configuration<'_>| {
            let mut sum = 0.0;
            self.each(at, |weight, point| sum += weight * density(&point));
            sum
        };
        let step = self.step();
        let [ahead, behind] = [step, -step].map(|step| self.solution.moved(self.problem, step));
        let beam = self.beam;
        (total(beam.configuration(&ahead)) - total(beam.configuration(&behind))) / (2.0 * step)
    }

    /// What friction would dissipate at its limit, per unit of the path's parameter: ∫ b τ |dx_b + c| dS, x_b the place of the face,
    /// with the c for which it is least. That is how a beam slides which friction alone holds along the substrate: what it carries
    /// one way and the other balances.
    pub(crate) fn dissipation(&self, law: &FrictionLaw) -> f64 {
        let (step, beam) = (self.step(), self.beam);
        let [onward, backward] = [step, -step].map(|step| self.solution.moved(self.problem, step));
        let mut ways = Vec::new();
        self.each(beam.configuration(&onward), |weight, point| {
            let limit = law.limit(point.face_gap())[0];
            ways.push((weight * point.width * limit, point.face()));
        });
        let mut ahead = ways.iter_mut();
        self.each(beam.configuration(&backward), |_, point| {
            ahead.by_ref().take(1).for_each(|(_, way)| *way = (*way - point.face()) / (2.0 * step));
        });
        let still = weighted_median(&mut ways);
        ways.iter().map(|(capacity, way)| capacity * (way - still).abs()).sum()
    }

    /// δR · dq of a load that turns the sections, ∫ moment dθ dS, per unit of the path's parameter.
    pub(crate) fn work_of_moment(&self, moment: impl Fn(&Point) -> f64) -> f64 {
        let (beam, at) = (self.beam, &self.solution.at);
        let here = beam.configuration(at);
        let change = Configuration { state: beam.nodes(&self.solution.tangent.direction), ..here };
        let mut turns = Vec::new();
        self.each(change, |_, point| turns.push(point.rotation));
        let (mut sum, mut turns) = (0.0, turns.into_iter());
        self.each(here, |weight, point| sum += weight * moment(&point) * turns.next().unwrap_or(0.0));
        sum
    }

    /// The least |cos θ| of its sections.
    pub(crate) fn steepest(&self) -> f64 {
        let mut least = f64::INFINITY;
        let at = self.beam.configuration(&self.solution.at);
        self.each(at, |_, point| least = least.min(point.rotation.cos().abs()));
        least
    }

    fn step(&self) -> f64 {
        STEP / self.problem.system.size(&self.solution.tangent.direction, &self.solution.at)
    }

    /// Every point of the rule on every element, with its weight.
    fn each(&self, at: Configuration<'_>, mut visit: impl FnMut(f64, Point)) {
        let rotation = self.beam.rotation;
        let mut begin = 0.0;
        for element in 0..at.ends.len() - 1 {
            let (from, length) = (at.ends[element], at.ends[element + 1] - at.ends[element]);
            let sample = |(share, _)| self.beam.chain.sample(at, element, 2.0 * share - 1.0);
            let samples: Vec<_> = self.rule.over(0.0, 1.0).map(sample).collect();
            let along = |weights: &mut dyn Iterator<Item = f64>| -> f64 {
                length * weights.zip(&samples).map(|(weight, sample)| weight * sample.1.horizontal_slope).sum::<f64>()
            };
            for (k, (share, weight)) in self.rule.over(0.0, 1.0).enumerate() {
                let (values, state) = &samples[k];
                let (sin, cos) = values[rotation].sin_cos();
                let (section, width, height) = self.model.section_at(from + share * length);
                let (h, v) = (state.horizontal_force, state.vertical_force);
                let x = match rotation {
                    1 => begin + along(&mut self.up_to[k].iter().copied()),
                    _ => values[0],
                };
                let point = Point {
                    section,
                    stretch: self.model.material().stretch,
                    width,
                    height,
                    x,
                    gap: values[rotation - 1],
                    rotation: values[rotation],
                    normal: h * cos + v * sin,
                    shear: v * cos - h * sin,
                };
                visit(weight * length, point);
            }
            begin += along(&mut self.rule.over(0.0, 1.0).map(|(_, weight)| weight));
        }
    }
}

impl Point {
    /// Ψ on level ground times the width, nN.
    pub(crate) fn adhesion(&self, law: &LineLaw) -> f64 {
        let (sin, cos) = self.rotation.sin_cos();
        self.width * law.response_of(self.height, self.gap, sin, cos).energy
    }

    /// The same on ground of any shape, of a beam that lies higher by `lift`, nm.
    pub(crate) fn adhesion_on(&self, ground: &GroundLaw, lift: f64) -> f64 {
        let (sin, cos) = self.rotation.sin_cos();
        self.width * ground.response(self.height, [self.x, self.gap + lift], [sin, cos]).energy
    }

    /// What Ψ on level ground times the width changes by, nN, to first order in heights and slopes of the ground, where the beam lies
    /// higher by `lift`, nm. In contact, where Ψ hardly changes with the gap, the beam follows the ground: the second order is no energy.
    pub(crate) fn adhesion_by_ground(&self, law: &LineLaw, substrate: &Substrate, lift: f64) -> f64 {
        let (sin, cos) = self.rotation.sin_cos();
        let response = law.response_of(self.height, self.gap, sin, cos);
        let (height, foot) = (-substrate.clearance(self.x, 0.0), substrate.project(self.x, 0.0));
        let slope = foot.sin.atan2(foot.cos);
        self.width * ((lift - height) * response.by_gap - slope * response.energy_by_rotation)
    }

    /// ½ Q²/GA_s
    pub(crate) fn shear(&self) -> f64 {
        0.5 * self.shear * self.shear / self.section.shear
    }

    /// N Γ1 - w: ½ N²/EA where the stretch is linear.
    pub(crate) fn extension(&self) -> f64 {
        self.stretch.complementary_energy(self.section.axial, self.normal)
    }

    /// x_b of the face that looks down, nm.
    fn face(&self) -> f64 {
        self.x + 0.5 * self.height * self.rotation.sin()
    }

    /// Its gap, nm.
    fn face_gap(&self) -> f64 {
        self.gap + 0.5 * self.height * (1.0 - self.rotation.cos())
    }
}

/// The number from which weighted numbers, (weight, number), are away least in all. They are sorted.
fn weighted_median(numbers: &mut [(f64, f64)]) -> f64 {
    numbers.sort_by(|a, b| a.1.total_cmp(&b.1));
    let half = 0.5 * numbers.iter().map(|(weight, _)| weight).sum::<f64>();
    let mut sum = 0.0;
    let middle = numbers.iter().find(|(weight, _)| {
        sum += weight;
        sum >= half
    });
    middle.map_or(0.0, |(_, number)| *number)
}

#[cfg(test)]
mod tests {
    use super::weighted_median;

    #[test]
    fn the_median_is_where_half_of_the_weight_lies() {
        assert_eq!(weighted_median(&mut [(1.0, 5.0), (1.0, -1.0), (1.0, 2.0)]), 2.0);
        assert_eq!(weighted_median(&mut [(1.0, 5.0), (5.0, -1.0), (1.0, 2.0)]), -1.0);
        assert_eq!(weighted_median(&mut []), 0.0);
    }
}
