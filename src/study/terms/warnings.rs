//! Where a peel leaves what its model can be trusted with: said with numbers, and without changing one.

use crate::adhesion::spatial_section::section::SectionShape;
use crate::beam::planar::chain::NodeState;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::section::Section;
use crate::beam::spatial::rotation::{Quaternion, conjugate, logarithm, product};
use crate::beam::spatial::section::kinematics::SPATIAL_FIELDS;
use crate::beam::spatial::section_state::{SpatialSectionPlace, SpatialSectionState};
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::beam::torsion::torsion_strain;
use crate::model::problem::beam_problem::Beam;
use crate::solve::newton::Solution;
use crate::study::peel::contact::SMALLEST_RADIUS;
use crate::study::peel::result::Peel;
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
    /// Largest |κ3| b/2 of a strip in space on the path, of bending about the height.
    FoldedSideways,
    /// Length over height.
    ShortBeam,
    /// Largest strain on the path: of the faces, |Γ1| + |κ - κ0| h/2, without Γ1 where its law is one of large strains, or of shear, |Γ2|. In space of the corners, |Γ1| + |κ2| h/2 + |κ3| b/2,
    /// or of shear with that of torsion.
    LargeStrain,
    /// Largest axial force of a film that yields and does not harden, over that at which it yields all through.
    FlowingFilm,
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
            Self::FoldedSideways => "folded-sideways",
            Self::ShortBeam => "short-beam",
            Self::LargeStrain => "large-strain",
            Self::FlowingFilm => "flowing-film",
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
            WarningKind::FoldedSideways => write!(
                f,
                "|κ3| b/2 comes to {value:.3} on the path, more than {limit}: bent sideways, the outline folds through itself"
            ),
            WarningKind::ShortBeam => {
                write!(f, "the beam is {value:.3} times as long as it is high, less than {limit}: it is hardly a beam")
            }
            WarningKind::LargeStrain => write!(
                f,
                "strains come to {value:.3} on the path, more than {limit}: the material is taken to be linear"
            ),
            WarningKind::FlowingFilm => write!(
                f,
                "the axial force comes to {value:.3} of that at which the film yields all through, more than {limit}: it does not harden, and \
                 stretches without end before it peels"
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

/// Least process zone over height, least length over height, most curvature times half the height, largest strain, largest axial force over that at
/// which a film flows, largest height of the ground over r0.
const ZONE: f64 = 1.0;
const SLENDER: f64 = 5.0;
const FOLDED: f64 = 1.0;
const STRAINED: f64 = 0.1;
const FLOWING: f64 = 0.95;
const HIGH: f64 = 1.0;

impl Peel {
    /// What of its model is not to be trusted with this peel. Bending and strains are those where elements end, of a peel that has its solutions:
    /// at the point of the path at which neighbouring nodes turn most against each other, and at that of the largest force.
    pub fn warnings(&self) -> Vec<Warning> {
        let model = &self.model;
        let height = model.free_end().1 * model.thickness_over_height();
        let below = |kind, value: f64, limit: f64| (value < limit).then_some(Warning { kind, value, limit });
        let above = |kind, value: f64, limit: f64| (value > limit).then_some(Warning { kind, value, limit });
        let Largest { folded, folded_sideways, strained } = self.largest_bend_and_strain();
        let hardens = model.material().tangent_modulus.is_some();
        let flowing = self.yielded().filter(|_| !hardens).map_or(0.0, |yielded| yielded.axial_share);
        let ground = model.ground.substrate.peak_to_valley() / model.line_law().gap_scale();
        let radius = self.contact(0).and_then(|contact| contact.sharp());
        let start = self.relaxed_start.map_or(0.0, |start| start.negative as f64);
        [
            below(WarningKind::ShortProcessZone, model.process_length() / height, ZONE),
            above(WarningKind::FoldedOutline, folded, FOLDED),
            above(WarningKind::FoldedSideways, folded_sideways, FOLDED),
            below(WarningKind::ShortBeam, model.length() / height, SLENDER),
            above(WarningKind::LargeStrain, strained, STRAINED),
            above(WarningKind::FlowingFilm, flowing, FLOWING),
            above(WarningKind::HighGround, if ground.is_finite() { ground } else { 0.0 }, HIGH),
            radius.and_then(|radius| below(WarningKind::SharpGround, radius, SMALLEST_RADIUS)),
            above(WarningKind::RelaxedStart, start, 0.0),
        ]
        .into_iter()
        .flatten()
        .filter(|warning| warning.value.is_finite())
        .collect()
    }

    fn largest_bend_and_strain(&self) -> Largest {
        let Some(trace) = &self.trace else { return Largest::default() };
        let bent = |point: &Solution| match &trace.problem.beam {
            Beam::Planar(beam) => most_turned(beam, point),
            Beam::Spatial(beam) => most_turned_in_space(beam, point),
        };
        let at_most = |size: &dyn Fn(&Solution) -> f64| {
            let sizes = trace.points.iter().map(|point| size(point)).enumerate();
            sizes.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
        };
        let points = [at_most(&bent), at_most(&|point| point.observables.force.abs())];
        let points = points.into_iter().flatten();
        match &trace.problem.beam {
            Beam::Planar(beam) => {
                let nodes = points.flat_map(|index| self.sections(index));
                nodes.map(|node| self.of_node(beam, &node)).fold(Largest::default(), Largest::or)
            }
            Beam::Spatial(beam) => {
                let outline = self.model.space.map_or(SectionShape::Rectangle, |space| space.section);
                let sections = points.flat_map(|index| self.sections_in_space(index));
                sections.map(|section| of_section(beam, outline, &section)).fold(Largest::default(), Largest::or)
            }
        }
    }

    fn of_node(&self, beam: &PlanarBeam, node: &NodeState) -> Largest {
        let (Section { shear, bending, .. }, _, height) = self.model.section_at(node.position);
        let (sin, cos) = node.values[beam.rotation].sin_cos();
        let [horizontal, vertical] = [node.section.horizontal_force, node.section.vertical_force];
        let stretch = node.section.horizontal_slope * cos + node.section.vertical_slope * sin - 1.0;
        // a law of large strains holds for them
        let stretch = if self.model.material().stretch.is_linear() { stretch.abs() } else { 0.0 };
        let slide = ((vertical * cos - horizontal * sin) / shear).abs();
        // of layers the upper face is not as far from the axis as the lower one
        let farther = (self.model.thickness_over_height() - 0.5).max(0.5);
        let turned = if self.model.yields() { node.section.curvature } else { node.section.moment / bending };
        let bent = turned.abs() * farther * height;
        let folded = node.section.curvature.abs() * 0.5 * height;
        Largest { folded, folded_sideways: 0.0, strained: slide.max(stretch + bent) }
    }
}

/// The largest bending and strain of some sections.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Largest {
    /// |κ| h/2, in space |κ2| h/2
    folded: f64,
    /// |κ3| b/2
    folded_sideways: f64,
    strained: f64,
}

impl Largest {
    fn or(self, other: Self) -> Self {
        Self {
            folded: self.folded.max(other.folded),
            folded_sideways: self.folded_sideways.max(other.folded_sideways),
            strained: self.strained.max(other.strained),
        }
    }
}

/// Of a section in space.
fn of_section(beam: &SpatialBeam, outline: SectionShape, state: &SpatialSectionState) -> Largest {
    let SpatialSectionPlace { arc_length, width, height, .. } = state.section;
    let ([axial, across, up], [twist, about_width, about_height]) = (state.stretch, state.curvature);
    let [_, rest_about_width, rest_about_height] = beam.chain.density.profile.at::<f64>(arc_length).rest_curvature;
    let (bent, bent_sideways) = (about_width.abs() * 0.5 * height, about_height.abs() * 0.5 * width);
    let faces = match outline {
        SectionShape::Rectangle => bent + bent_sideways,
        SectionShape::Ellipse => bent.hypot(bent_sideways),
    };
    let sheared = across.hypot(up) + twist.abs() * torsion_strain(outline, width, height);
    Largest {
        folded: (about_width + rest_about_width).abs() * 0.5 * height,
        folded_sideways: (about_height + rest_about_height).abs() * 0.5 * width,
        strained: sheared.max(axial.abs() + faces),
    }
}

/// The largest turn from node to node over their distance, times half the height.
fn most_turned(beam: &PlanarBeam, point: &Solution) -> f64 {
    let rotations: Vec<f64> =
        beam.nodes(&point.at.values).iter().skip(beam.rotation).step_by(beam.fields()).copied().collect();
    let turn = |first: usize, place: f64| 0.5 * beam.height_at(place) * (rotations[first + 1] - rotations[first]).abs();
    most_from_node_to_node(&point.at.mesh.boundaries, beam.chain.order(), |rank| beam.chain.node_fraction(rank), turn)
}

/// The same in space, about the width times half the height or about the height times half the width.
fn most_turned_in_space(beam: &SpatialBeam, point: &Solution) -> f64 {
    let nodes: Vec<Quaternion> = beam
        .configuration(&point.at)
        .fields
        .chunks_exact(SPATIAL_FIELDS)
        .map(|node| [node[3], node[4], node[5], node[6]])
        .collect();
    let turn = |first: usize, place: f64| {
        let station = beam.chain.density.profile.at::<f64>(place);
        let [_, about_width, about_height] = logarithm(product(conjugate(nodes[first]), nodes[first + 1]));
        (0.5 * station.height * about_width.abs()).max(0.5 * station.width * about_height.abs())
    };
    most_from_node_to_node(&point.at.mesh.boundaries, beam.chain.order(), |rank| beam.chain.node_fraction(rank), turn)
}

/// The most of what `turn` says of neighbouring nodes, by the number of the first and where its element begins, over their distance.
fn most_from_node_to_node(
    boundaries: &[f64],
    order: usize,
    fraction: impl Fn(usize) -> f64,
    turn: impl Fn(usize, f64) -> f64,
) -> f64 {
    let inside = |(element, ends): (usize, &[f64])| {
        let part = |rank: usize| (ends[1] - ends[0]) * (fraction(rank + 1) - fraction(rank));
        (0..order).map(|rank| turn(element * order + rank, ends[0]) / part(rank)).fold(0.0, f64::max)
    };
    boundaries.windows(2).enumerate().map(inside).fold(0.0, f64::max)
}
