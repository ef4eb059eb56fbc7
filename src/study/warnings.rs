//! Where a peel leaves what its model can be trusted with: said with numbers, and without changing one.

use super::Peel;
use crate::beam::{NodeState, PlanarBeam, Section};
use crate::solve::Solution;
use crate::study::SMALLEST_RADIUS;
use serde::{Deserialize, Serialize};
use std::fmt;

/// What of the model is not to be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WarningKind {
    /// Length of the process zone over the height of the section there.
    ShortProcessZone,
    /// Largest |κ| h/2 on the path.
    FoldedOutline,
    /// Length over height.
    ShortBeam,
    /// Largest strain on the path: of the faces, |Γ1| + |κ - κ0| h/2, or of shear, |Γ2|.
    LargeStrain,
    /// Height of the ground, from crest to valley, over r0.
    HighGround,
    /// Smallest radius of curvature of the ground where the beam adheres, nm.
    SharpGround,
    /// Negative eigenvalues of the equilibrium that the beam has left before the path starts.
    RelaxedStart,
}

impl WarningKind {
    /// As outputs call it.
    pub fn code(self) -> &'static str {
        match self {
            Self::ShortProcessZone => "short-process-zone",
            Self::FoldedOutline => "folded-outline",
            Self::ShortBeam => "short-beam",
            Self::LargeStrain => "large-strain",
            Self::HighGround => "high-ground",
            Self::SharpGround => "sharp-ground",
            Self::RelaxedStart => "relaxed-start",
        }
    }
}

/// A number that is beyond what the model can be trusted with.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// What it is
    pub kind: WarningKind,
    /// What was found
    pub value: f64,
    /// What it may be at least, or at most
    pub limit: f64,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { kind, value, limit } = self;
        match kind {
            WarningKind::ShortProcessZone => write!(
                f,
                "the process zone is {value:.3} times as long as the section is high, less than {limit}: sections deform there, and the model \
                 keeps them rigid"
            ),
            WarningKind::FoldedOutline => write!(
                f,
                "|κ| h/2 comes to {value:.3} on the path, more than {limit}: the outline folds through itself"
            ),
            WarningKind::ShortBeam => {
                write!(f, "the beam is {value:.3} times as long as it is high, less than {limit}: it is hardly a beam")
            }
            WarningKind::LargeStrain => write!(
                f,
                "strains come to {value:.3} on the path, more than {limit}: the material is taken to be linear"
            ),
            WarningKind::HighGround => write!(
                f,
                "the ground is {value:.3} r0 from crest to valley, more than {limit}: a section is attracted by the nearest point alone, and where \
                 the beam comes to rest may depend on substrate.start"
            ),
            WarningKind::SharpGround => write!(
                f,
                "the ground has a radius of curvature of {value:.2} nm where the beam adheres, less than {limit} nm: the half space is no good \
                 approximation of it"
            ),
            WarningKind::RelaxedStart => write!(
                f,
                "the equilibrium next to the stress-free configuration is unstable, with {value} negative eigenvalues; the path starts in the \
                 stable one to which the beam has been relaxed from there"
            ),
        }
    }
}

/// Least process zone over height, least length over height, most curvature times half the height, largest strain, largest height of the ground
/// over r0.
const ZONE: f64 = 1.0;
const SLENDER: f64 = 5.0;
const FOLDED: f64 = 1.0;
const STRAINED: f64 = 0.1;
const HIGH: f64 = 1.0;

impl Peel {
    /// What of its model is not to be trusted with this peel. Bending and strains are those where elements end, of a peel that has its solutions:
    /// at the point of the path at which neighbouring nodes turn most against each other, and at that of the largest force.
    pub fn warnings(&self) -> Vec<Warning> {
        let model = &self.model;
        let height = model.free_end().1;
        let below = |kind, value: f64, limit: f64| (value < limit).then_some(Warning { kind, value, limit });
        let above = |kind, value: f64, limit: f64| (value > limit).then_some(Warning { kind, value, limit });
        let [folded, strained] = self.largest_bend_and_strain();
        let ground = model.ground.substrate.peak_to_valley() / model.adhesion.equilibrium_distance;
        let radius = self.contact(0).and_then(|contact| contact.sharp());
        let start = self.relaxed_start.map_or(0.0, |start| start.negative as f64);
        [
            below(WarningKind::ShortProcessZone, model.process_length() / height, ZONE),
            above(WarningKind::FoldedOutline, folded, FOLDED),
            below(WarningKind::ShortBeam, model.length() / height, SLENDER),
            above(WarningKind::LargeStrain, strained, STRAINED),
            above(WarningKind::HighGround, if ground.is_finite() { ground } else { 0.0 }, HIGH),
            radius.and_then(|radius| below(WarningKind::SharpGround, radius, SMALLEST_RADIUS)),
            above(WarningKind::RelaxedStart, start, 0.0),
        ]
        .into_iter()
        .flatten()
        .filter(|warning| warning.value.is_finite())
        .collect()
    }

    /// The largest |θ'| h/2 and the largest strain of the two points.
    fn largest_bend_and_strain(&self) -> [f64; 2] {
        let Some(trace) = &self.trace else { return [0.0; 2] };
        let Some(beam) = trace.problem.beam.planar() else { return [0.0; 2] };
        let one = |node: &NodeState| {
            let (Section { axial, shear, bending }, _, height) = self.model.section_at(node.position);
            let (sin, cos) = node.values[beam.rotation].sin_cos();
            let [horizontal, vertical] = [node.section.horizontal_force, node.section.vertical_force];
            let stretch = ((horizontal * cos + vertical * sin) / axial).abs();
            let slide = ((vertical * cos - horizontal * sin) / shear).abs();
            let bent = (node.section.moment / bending).abs() * 0.5 * height;
            [node.section.curvature.abs() * 0.5 * height, slide.max(stretch + bent)]
        };
        let at_most = |size: &dyn Fn(&Solution) -> f64| {
            let sizes = trace.points.iter().map(|point| size(point)).enumerate();
            sizes.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
        };
        let points = [at_most(&|point| most_turned(beam, point)), at_most(&|point| point.observables.force.abs())];
        let nodes = points.into_iter().flatten().flat_map(|index| self.sections(index));
        nodes.map(|node| one(&node)).fold([0.0; 2], |[a, b], [c, d]| [f64::max(a, c), f64::max(b, d)])
    }
}

/// The largest turn from node to node over their distance, times half the height.
fn most_turned(beam: &PlanarBeam, point: &Solution) -> f64 {
    let (order, ends) = (beam.chain.order(), &point.at.mesh.boundaries);
    let rotations: Vec<f64> =
        beam.nodes(&point.at.values).iter().skip(beam.rotation).step_by(beam.fields()).copied().collect();
    let inside = |pair: (&[f64], &[f64])| {
        let (ends, rotations) = pair;
        let (length, half) = (ends[1] - ends[0], 0.5 * beam.height_at(ends[0]));
        let part = |rank: usize| length * (beam.chain.node_fraction(rank + 1) - beam.chain.node_fraction(rank));
        let turns = rotations.windows(2).enumerate().map(|(rank, pair)| (pair[1] - pair[0]).abs() / part(rank));
        half * turns.fold(0.0, f64::max)
    };
    let elements = ends.windows(2).zip((0..).map(|element: usize| &rotations[element * order..=(element + 1) * order]));
    elements.map(inside).fold(0.0, f64::max)
}
