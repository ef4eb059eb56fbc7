//! How a beam lies on ground that is not flat: how much of it adheres, how deep it penetrates, and how far the ground is from
//! the half space that stands for it.

use super::equilibrium_path::path_end::Followed;
use super::result::{PathEnd, Peel};
use super::solution_history::{DeformedShape, LimitPoint};
use crate::adhesion::levels::curved::CurvedBody;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::substrate::Substrate;
use crate::adhesion::substrate::sinusoid::Sinusoid;
use crate::beam::mesh::MeshKind;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::ground::{Ground, Start};
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::beam_problem::{Beam, BeamProblem};
use crate::model::problem::build::Discretisation;
use crate::solve::points::search::LimitPointKind;
use crate::solve::state::State;
use crate::study::asked::accuracy::ORDER;
use crate::study::asked::stop_criteria::{Bound, FollowedUntil};
use crate::study::initial::prepared::prepared;
use serde::{Deserialize, Serialize};

/// How a beam lies at one point of its path. From samples, six an element. A strip lies on flat ground with all its length; of a spatula and
/// other beams it is where that lies on flat ground without a force with which they are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Length whose lower edge is nearer than 2 r0, over that on flat ground.
    pub adhered_fraction: f64,
    /// Adhesion energy over that of the same beam on flat ground.
    pub energy_fraction: f64,
    /// Least and largest distance of the lower edge of what lies on flat ground from this, nm
    pub least_gap: f64,
    /// The largest of them, nm
    pub largest_gap: f64,
    /// How far below the crests the lower edge comes, over how far the ground does: 0 on the crests, 1 on the bottom of the
    /// deepest valley; both less the gap at rest. None on ground that has no valley below what lies on flat ground.
    pub penetration: Option<f64>,
    /// Smallest radius of curvature of crests and of valleys where the beam adheres, nm; none where there is no such.
    pub crest_radius: Option<f64>,
    /// Of valleys, nm
    pub valley_radius: Option<f64>,
    /// Relative error of the largest traction in front of the smallest of these crests, and of these valleys, by taking the
    /// half space for the body: eq. (10) in front of the exact cylinder or sphere over that of the half space, less one, at
    /// the gap 5^(-1/6) r0. A valley is taken to gain what a crest of its radius loses, which is so to first order.
    pub crest_error: Option<f64>,
    /// In valleys, relative
    pub valley_error: Option<f64>,
}

/// Radius of curvature down to which eq. (9) is very good by Sauer and Wriggers (2009), nm.
pub const SMALLEST_RADIUS: f64 = 8.0;
/// A ground that falls by less than this below its crests has no valley, nm.
const LEVEL: f64 = 1e-6;

impl Contact {
    /// The smallest radius where it is below [`SMALLEST_RADIUS`], nm.
    pub fn sharp(&self) -> Option<f64> {
        let radii = [self.crest_radius, self.valley_radius].into_iter().flatten();
        radii.reduce(f64::min).filter(|&radius| radius < SMALLEST_RADIUS)
    }
}

impl Peel {
    /// How the beam lies at `points[index]`; none on flat ground, or where there is no such point.
    pub fn contact(&self, index: usize) -> Option<Contact> {
        let substrate = &self.model.ground.substrate;
        let trace = self.trace.as_ref()?;
        let front = trace.points.get(index)?.observables.monitors[FRONT];
        let shape = self.shape(index);
        let law = self.model.line_law();
        let material = law.half_space;
        if substrate.is_flat() || shape.x.len() < 2 {
            return None;
        }
        let samples = samples(substrate, &shape);
        let near = law.adhering_distance();
        let whole = Whole::of(&self.model, &samples, near)?;
        let lying = &samples[..whole.samples];
        let gaps = || lying.iter().map(|sample| sample.gap);
        let (from, to) = lying.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), s| (a.min(s.x), b.max(s.x)));
        let top = substrate.top(from, to);
        let bottom = lying.iter().map(|sample| sample.ground).fold(f64::INFINITY, f64::min);
        let lowest = lying.iter().map(|sample| sample.edge).fold(f64::INFINITY, f64::min);
        let sharpest = |sign: f64| {
            let touched = samples.iter().filter(|sample| sample.gap < near).map(|sample| sign * sample.curvature);
            touched.reduce(f64::max).filter(|&curvature| curvature * to.abs() > LEVEL).map(f64::recip)
        };
        let (crest_radius, valley_radius) = (sharpest(-1.0), sharpest(1.0));
        Some(Contact {
            adhered_fraction: adhered(&samples, near) / whole.length,
            energy_fraction: front / whole.front,
            least_gap: gaps().fold(f64::INFINITY, f64::min),
            largest_gap: gaps().fold(f64::NEG_INFINITY, f64::max),
            penetration: (top - bottom > LEVEL).then(|| (top + law.rest_gap() - lowest) / (top - bottom)),
            crest_radius,
            valley_radius,
            crest_error: crest_radius.map(|radius| curvature_error(substrate, &material, radius)),
            valley_error: valley_radius.map(|radius| -curvature_error(substrate, &material, radius)),
        })
    }

    /// The largest force at any point of the path, nN, also beyond the snap-off: where the path goes up to a maximum or ends.
    pub fn largest_force(&self) -> Option<f64> {
        let turns =
            self.limit_points.iter().filter(|point| point.kind == LimitPointKind::Load).map(|point| point.force);
        turns
            .chain(self.points.last().map(|point| point.force))
            .chain(self.largest_computed_force.map(|largest| largest.force))
            .reduce(f64::max)
    }
}

/// What of a beam lies on flat ground without a force.
struct Whole {
    /// How many of the samples
    samples: usize,
    /// Length that is nearer than 2 r0, nm
    length: f64,
    /// Adhesion energy over that of a unit length of the free end, nm
    front: f64,
}

impl Whole {
    fn of(model: &PeelModel, samples: &[Sample], near: f64) -> Option<Self> {
        if model.is_uniform() {
            let length = steps(samples).sum();
            return Some(Self { samples: samples.len(), length, front: model.length() });
        }
        let level = Substrate::Sinusoid(Sinusoid { height: 0.0, wavelength: model.length(), offset: 0.0 });
        let ground = Ground { substrate: level, start: Start::Conformed };
        let how = Discretisation::moving(Form::ThreeField, ORDER).on(MeshKind::Graded);
        let problem = prepared(&PeelModel { ground, steps: Vec::new(), ..model.clone() }, how, None).ok()?.problem;
        let (beam, at) = (&problem.beam, problem.start.known()?);
        let length = adhered(&self::samples(beam.substrate(), &DeformedShape::of(beam, at)), near);
        let front = beam.planar()?.front_of(at);
        let lying = steps(samples).scan(0.0, |sum, step| {
            *sum += step;
            Some(*sum)
        });
        Some(Self { samples: 1 + lying.take_while(|&place| place <= length).count(), length, front })
    }
}

/// Lengths of the axis from sample to sample, nm.
fn steps(samples: &[Sample]) -> impl Iterator<Item = f64> + '_ {
    samples.windows(2).map(|pair| (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y))
}

/// Length whose lower edge is `near` to the ground, nm; between two samples the gap is linear.
fn adhered(samples: &[Sample], near: f64) -> f64 {
    let share = |pair: &[Sample]| {
        let (least, largest) = (pair[0].gap.min(pair[1].gap), pair[0].gap.max(pair[1].gap));
        if largest < near { 1.0 } else { ((near - least) / (largest - least)).max(0.0) }
    };
    samples.windows(2).map(share).zip(steps(samples)).map(|(share, step)| share * step).sum()
}

/// One place of a beam.
pub(super) struct Sample {
    /// Of the axis, nm
    pub x: f64,
    pub y: f64,
    /// Distance of the lower edge from the ground, and of the upper one, nm
    pub gap: f64,
    pub far_gap: f64,
    /// Height of the lower edge, and of the ground along y below the axis, nm
    pub edge: f64,
    pub ground: f64,
    /// Of the ground, 1/nm
    pub curvature: f64,
}

pub(super) fn samples(substrate: &Substrate, shape: &DeformedShape) -> Vec<Sample> {
    let places = shape.x.iter().zip(&shape.y).zip(shape.rotation.iter().zip(&shape.height));
    let sample = |((&x, &y), (&rotation, &height)): ((&f64, &f64), (&f64, &f64))| {
        let foot = substrate.project(x, y);
        let tilt = rotation - foot.sin.atan2(foot.cos);
        Sample {
            x,
            y,
            gap: foot.distance - 0.5 * height * tilt.cos().abs(),
            far_gap: foot.distance + 0.5 * height * tilt.cos().abs(),
            edge: y - 0.5 * height * rotation.cos().abs(),
            ground: y - substrate.clearance(x, y),
            curvature: foot.curvature,
        }
    };
    places.map(sample).collect()
}

/// Traction in front of a convex body of this radius over that of the half space, less one.
fn curvature_error(substrate: &Substrate, material: &HalfSpace, radius: f64) -> f64 {
    let shape = substrate.crest();
    let gap = material.strongest_gap();
    CurvedBody { shape, radius }.traction(material, gap) / material.traction(gap) - 1.0
}

// -- What of a beam adheres: its face, the edge of its free end, the face of that end, or nothing --

/// What of a beam adheres, that is, is nearer to the substrate than 2 r0, or than what stands for that under a cohesive law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Adhering {
    /// Its face, along a length of at least the height of the free end, or away from that end.
    Pad,
    /// The edge of its free end alone.
    Edge,
    /// The face of its free end, which stands on the substrate with both its edges.
    EndFace,
    /// No point.
    Nothing,
}

impl Adhering {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Pad => "pad",
            Self::Edge => "edge",
            Self::EndFace => "end face",
            Self::Nothing => "nothing",
        }
    }

    /// Of a beam in a state; what is nearer than `near`, nm, adheres ([`crate::adhesion::LineLaw::adhering_distance`]).
    pub(in crate::study) fn of(beam: &Beam, at: &State, near: f64) -> Self {
        let shape = DeformedShape::of(beam, at);
        let end_height = shape.height.first().copied().unwrap_or(0.0);
        Self::of_samples(&samples(beam.substrate(), &shape), near, end_height)
    }

    fn of_samples(samples: &[Sample], near: f64, end_height: f64) -> Self {
        let is_near = |sample: &Sample| sample.gap < near;
        let Some(first) = samples.iter().position(is_near) else { return Self::Nothing };
        let last = samples.iter().rposition(is_near).unwrap_or(first);
        let length = |from: usize, to: usize| -> f64 {
            samples[from..=to].windows(2).map(|pair| (pair[1].x - pair[0].x).hypot(pair[1].y - pair[0].y)).sum()
        };
        if length(first, last) >= end_height || length(0, first) >= end_height {
            Self::Pad
        } else if samples[0].far_gap < near {
            Self::EndFace
        } else {
            Self::Edge
        }
    }
}

// -- The folds of a path behind which the pad, and behind which nothing of the beam, adheres any more --

impl Peel {
    /// Looks for them, on a path that was followed to where it ends by itself, or to where nothing adheres: elsewhere it may come back.
    pub(super) fn find_detachment(&mut self, problem: &BeamProblem, followed: &Followed) {
        let is_off = matches!(self.end, PathEnd::Detached | PathEnd::Bound(Bound::Until(FollowedUntil::Detachment)));
        let comes_off = is_off || self.end == PathEnd::Pivoting;
        if !comes_off || followed.trouble.is_some() || problem.system.step_dependence().exists() {
            return;
        }
        let near = self.model.line_law().adhering_distance();
        let of = |at| Adhering::of(&problem.beam, at, near);
        let turns_back = |&&index: &&usize| {
            let at = &self.limit_points[index];
            at.kind == LimitPointKind::Displacement && followed.points[at.after].slope.displacement > 0.0
        };
        let indices: Vec<usize> = (0..self.limit_points.len()).collect();
        let mut folds: Vec<usize> = indices.iter().filter(turns_back).copied().collect();
        let place = |index: usize| self.limit_points[index].displacement;
        folds.sort_by(|&a, &b| place(b).total_cmp(&place(a)));
        // what adheres on the path behind a fold where the grip is further away
        let behind = |index: usize| {
            let LimitPoint { after, displacement, .. } = self.limit_points[index];
            let beyond = followed.points[after + 1..].iter();
            beyond.filter(move |s| s.observables.displacement > displacement).map(|s| of(&s.at))
        };
        let pad = folds.iter().copied().find(|&index| of(&followed.turns[index].2.solution.at) == Adhering::Pad);
        let pad = pad.filter(|&index| behind(index).all(|adhering| adhering != Adhering::Pad));
        let last = folds.first().copied().filter(|_| is_off);
        let last = last.filter(|&index| behind(index).all(|adhering| adhering == Adhering::Nothing));
        self.pad_detachment = pad.map(|index| self.limit_points[index]);
        self.detachment = last.map(|index| self.limit_points[index]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A straight beam 100 nm long and 10 nm high that leaves the ground at this angle (degrees) from a gap of 0.4 nm.
    fn leaving(angle: f64) -> Vec<Sample> {
        let (sin, cos) = angle.to_radians().sin_cos();
        (0..=1000)
            .map(|k| {
                let s = 0.1 * k as f64;
                let (x, y) = (s * cos, 0.4 + 5.0 * cos.abs() + s * sin);
                let half = 5.0 * cos.abs();
                Sample { x, y, gap: y - half, far_gap: y + half, edge: y - half, ground: 0.0, curvature: 0.0 }
            })
            .collect()
    }

    #[test]
    fn a_beam_adheres_by_its_pad_its_edge_or_its_end() {
        let of = |samples: &[Sample]| Adhering::of_samples(samples, 0.8, 10.0);
        assert_eq!(of(&leaving(0.0)), Adhering::Pad);
        assert_eq!(of(&leaving(1.0)), Adhering::Pad, "0.4 nm over sin 1 degree, 23 nm, are nearer than 2 r0");
        assert_eq!(of(&leaving(30.0)), Adhering::Edge);
        assert_eq!(of(&leaving(90.0)), Adhering::EndFace);
        assert_eq!(of(&leaving(150.0)), Adhering::Edge, "turned over");
        let mut lifted = leaving(30.0);
        lifted.iter_mut().for_each(|sample| sample.gap += 1.0);
        assert_eq!(of(&lifted), Adhering::Nothing);
        let mut bent = leaving(0.0);
        bent[..300].iter_mut().for_each(|sample| sample.gap += 5.0);
        bent[330..].iter_mut().for_each(|sample| sample.gap += 5.0);
        assert_eq!(of(&bent), Adhering::Pad, "it touches away from its end");
    }
}
