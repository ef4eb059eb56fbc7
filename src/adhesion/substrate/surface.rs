//! What is asked of the ground.

use crate::adhesion::levels::curved::BodyShape;
use std::fmt::Debug;
use std::sync::Arc;

/// The nearest point of a substrate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestPoint {
    /// d, nm; negative within the solid
    pub distance: f64,
    /// Where it is along x, nm
    pub place: f64,
    /// sin φ and cos φ of the substrate there
    pub sin: f64,
    /// cos φ
    pub cos: f64,
    /// κ, 1/nm; positive in a valley
    pub curvature: f64,
    /// κ', 1/nm²
    pub curvature_slope: f64,
    /// Distance of the next nearest of the candidates, nm; infinite where there is one alone.
    ///
    /// Where it equals `distance` the energy of a section is continuous and its force jumps from T n₁ to T n₂. That happens
    /// no nearer than the radius of the valley between the two, ρ, so that the jump is at most 2 T(ρ - h/2), to be compared
    /// with the largest attraction T(5^(-1/6) r0): 6e-7 of it for the valleys of the paper's sinusoid, ρ = 63.3 nm, under a
    /// strip 10 nm high.
    pub second_distance: f64,
}

impl ClosestPoint {
    /// Level ground with this height above it.
    pub(super) fn level(place: f64, distance: f64) -> Self {
        let second_distance = f64::INFINITY;
        Self { distance, place, sin: 0.0, cos: 1.0, curvature: 0.0, curvature_slope: 0.0, second_distance }
    }
}

/// A shape of the ground: a curve in the plane of the beam, with the solid below it. Lengths in nm.
pub trait Surface: Debug + Send + Sync {
    /// What a scene calls it.
    fn name(&self) -> &'static str;

    /// The keys of a scene that belong to it, besides that of the shape itself: its `numbers` and what else it takes.
    fn keys(&self) -> &'static [&'static str];

    /// The nearest point of (x, y). NaN where a coordinate is.
    fn project(&self, x: f64, y: f64) -> ClosestPoint;

    /// About how far (x, y) is above it: along y, or from the centre of a circle.
    fn clearance(&self, x: f64, y: f64) -> f64;

    /// The highest point between two places.
    fn top(&self, from: f64, to: f64) -> f64;

    /// How high it may rise above where a beam lies on it: from valley to crest; zero where it has no valley.
    fn peak_to_valley(&self) -> f64 {
        0.0
    }

    /// The length in which it changes: no element may be much longer. Infinite where it is the same everywhere.
    fn feature_length(&self) -> f64;

    /// The convex body that a crest is like.
    fn crest(&self) -> BodyShape {
        BodyShape::Cylinder
    }

    /// The number that a scene gives by this key.
    fn number(&mut self, _key: &str) -> Option<&mut f64> {
        None
    }

    /// What of its numbers do not fit each other.
    fn misfit(&self) -> Option<Misfit> {
        None
    }
}

/// The keys of a shape with one crest.
pub(super) const ONE_CREST: &[&str] = &["radius", "offset", "start"];

/// The number of a shape with one crest that a scene gives by this key: the radius of the crest or its place along x.
pub(super) fn of_one_crest<'s>(key: &str, radius: &'s mut f64, offset: &'s mut f64) -> Option<&'s mut f64> {
    match key {
        "radius" => Some(radius),
        "offset" => Some(offset),
        _ => None,
    }
}

/// A name by which a scene takes a shape, and what makes one of which no number is given yet.
pub(super) type Named<S> = (&'static str, fn() -> S);

/// Numbers that do not fit each other: the path of the key of one in a scene, what was found, and what would be right.
#[derive(Clone, Debug, PartialEq)]
pub struct Misfit {
    /// The path of the key, as `ground.wavelength`
    pub key: &'static str,
    /// Completes "`key` ..."
    pub found: String,
    /// A sentence of its own
    pub remedy: &'static str,
}

/// One that is shared; its numbers are fixed.
impl<S: Surface> Surface for Arc<S> {
    fn name(&self) -> &'static str {
        (**self).name()
    }
    fn keys(&self) -> &'static [&'static str] {
        (**self).keys()
    }
    fn project(&self, x: f64, y: f64) -> ClosestPoint {
        (**self).project(x, y)
    }
    fn clearance(&self, x: f64, y: f64) -> f64 {
        (**self).clearance(x, y)
    }
    fn top(&self, from: f64, to: f64) -> f64 {
        (**self).top(from, to)
    }
    fn peak_to_valley(&self) -> f64 {
        (**self).peak_to_valley()
    }
    fn feature_length(&self) -> f64 {
        (**self).feature_length()
    }
    fn crest(&self) -> BodyShape {
        (**self).crest()
    }
    fn misfit(&self) -> Option<Misfit> {
        (**self).misfit()
    }
}
