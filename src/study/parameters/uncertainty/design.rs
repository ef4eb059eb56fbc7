//! Where a plan samples its inputs.
//!
//! A replicate is a Sobol sequence of N points, N a power of two, scrambled by Owen's method with a seed of its own: replicates are independent of
//! one another, and each is spread evenly. What R replicates give differs by chance alone, which is where errors come from.
//!
//! A sequence of twice as many dimensions as there are inputs gives in each of its points a row of two matrices, A and B. A row
//! besides is A with the inputs of group g from B: the inputs of g have changed and all others not (Saltelli et al., Comput. Phys. Commun. 181
//! (2010) 259). So N points of g groups are N (g + 2) samples, each of them distributed as the inputs are.

use super::distribution::{normal_below, normal_quantile};
use super::plan::{Dependence, Indices, NoDesign, Plan};

/// Replicates at the least: fewer say little about their spread.
const REPLICATES: usize = 10;
/// Fewest points of a replicate.
const FEWEST: usize = 4;
/// Most points of the sequence.
const MOST: usize = 1 << 16;
/// Half of what separates neighbours among the numbers of the sequence, which has 24 bits.
const HALF_A_STEP: f64 = 1.0 / (1u64 << 25) as f64;

/// Where a plan samples its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    plan: Plan,
    dependence: Dependence,
    replicates: usize,
    points: usize,
}

/// One sample of a design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SamplePlace {
    /// Number of the replicate
    pub replicate: usize,
    /// Number of the point of its sequence
    pub point: usize,
    /// Which row the point gives: 0 is A, 1 is B, 2 + g is A with the inputs of group g from B
    pub row: usize,
}

impl Design {
    /// The design of a plan: at least ten replicates of as many points as there can be.
    ///
    /// # Errors
    /// Where inputs, correlations or the number of samples allow none.
    pub fn new(plan: Plan) -> Result<Self, NoDesign> {
        plan.check()?;
        let dependence = Dependence::of(&plan)?;
        let inputs = dependence.groups.len();
        let rows = rows(&plan, inputs);
        let samples = plan.samples;
        let least = REPLICATES * FEWEST * rows;
        if samples < least {
            return Err(NoDesign::TooFew { samples, inputs, least });
        }
        let points = (samples / (REPLICATES * rows)).min(MOST);
        let points = if points.is_power_of_two() { points } else { points.next_power_of_two() / 2 };
        Ok(Self { replicates: samples / (points * rows), points, plan, dependence })
    }

    /// What is sampled.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// Inputs that vary together, by their numbers; independent ones are alone in their group.
    pub fn groups(&self) -> &[Vec<usize>] {
        &self.dependence.groups
    }

    /// Whether no inputs vary together.
    pub(crate) fn is_independent(&self) -> bool {
        self.dependence.is_independent()
    }

    /// R
    pub fn replicates(&self) -> usize {
        self.replicates
    }

    /// N, points of a replicate
    pub fn points(&self) -> usize {
        self.points
    }

    /// Samples to a point: 1, or g + 2 where indices are estimated.
    pub fn rows(&self) -> usize {
        rows(&self.plan, self.dependence.groups.len())
    }

    /// All samples.
    pub fn samples(&self) -> usize {
        self.replicates * self.samples_of_replicate()
    }

    /// Samples of one replicate: those of replicate r are `r * n..(r + 1) * n`.
    pub(crate) fn samples_of_replicate(&self) -> usize {
        self.points * self.rows()
    }

    /// Where a sample stands: rows of a point follow one another, points of a replicate, then the replicates.
    pub fn place(&self, sample: usize) -> SamplePlace {
        let (rest, row) = (sample / self.rows(), sample % self.rows());
        SamplePlace { replicate: rest / self.points, point: rest % self.points, row }
    }

    /// The inputs there, each in the unit of its distribution. They depend on the seed and the place, and not on how many samples there are.
    pub fn inputs(&self, at: SamplePlace) -> Vec<f64> {
        let count = self.plan.inputs.len();
        let seed = seed(self.plan.seed, at.replicate);
        let mut from_b = vec![at.row == 1; count];
        if let Some(group) = at.row.checked_sub(2).and_then(|group| self.dependence.groups.get(group)) {
            group.iter().for_each(|&input| from_b[input] = true);
        }
        let share = |input: usize| {
            let dimension = if from_b[input] { count + input } else { input };
            f64::from(sobol_burley::sample(at.point as u32, dimension as u32, seed)) + HALF_A_STEP
        };
        let mut shares: Vec<f64> = (0..count).map(share).collect();
        if !self.is_independent() {
            let independent: Vec<f64> = shares.iter().map(|&share| normal_quantile(share)).collect();
            shares = self.dependence.correlated(&independent).into_iter().map(inner_share).collect();
        }
        self.plan.inputs.iter().zip(shares).map(|(input, share)| input.distribution.quantile(share)).collect()
    }
}

fn rows(plan: &Plan, groups: usize) -> usize {
    match plan.indices {
        Indices::Estimated => groups + 2,
        Indices::Omitted => 1,
    }
}

/// Φ(z), below 1 however large z is.
fn inner_share(z: f64) -> f64 {
    normal_below(z).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON)
}

/// The seed of a replicate: splitmix64 of both numbers.
fn seed(plan: u64, replicate: usize) -> u32 {
    let mut z = plan.wrapping_add((replicate as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (z ^ (z >> 31)) as u32
}
