//! A tip that follows the curve of its spatula's normal pull.
//!
//!   E(r) = E0 + ∫ P(u) du + ½ k (x² + z²) while it adheres, u = y;   E = 0 while it is detached
//!
//! P(u) is the curve of equilibria of the spatula pulled along the normal, from where it is pressed to its first displacement limit point, where
//! it snaps off. Between points it is a cubic with the slopes of the curve at both, so that E is twice differentiable; before the first point
//! and behind the last one it goes on straight. x and z are how far the tip was taken along the ground: free, k = 0, or held by a spring. The
//! tip turns freely.

use super::tip_law::{TipBranch, TipLaw};
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::tree::branching_beam::EndResponse;
use serde::{Deserialize, Serialize};

/// A point of the curve of a normal pull.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CurvePoint {
    /// u, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// dP/du, nN/nm
    pub slope: f64,
}

/// The curve of a spatula's normal pull, from pressed to snap-off.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PullCurve {
    points: Vec<CurvePoint>,
    /// ∫ P du from u = 0 to each point, aJ
    works: Vec<f64>,
    /// E at u = 0 against being detached, aJ
    energy_at_rest: f64,
}

/// Why a curve is none.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum PullCurveError {
    #[error("the curve of a tip has {0} points: give at least two")]
    TooFew(usize),
    #[error(
        "point {point} of the curve of a tip is at u = {displacement} nm with P = {force} nN and dP/du = {slope} nN/nm: all have to be finite, and u has to grow from point to point"
    )]
    Point { point: usize, displacement: f64, force: f64, slope: f64 },
    #[error(
        "the curve of a tip goes from u = {first} to {last} nm: u = 0, where the tip is at rest, has to lie between them"
    )]
    NoRest { first: f64, last: f64 },
    #[error("a tip at rest has the energy {energy} aJ against being detached: where it adheres that is below zero")]
    Energy { energy: f64 },
}

/// P, dP/du and the work from u = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pulled {
    force: f64,
    slope: f64,
    work: f64,
}

impl PullCurve {
    /// Of points with u ascending; `energy_at_rest` (aJ) is that of the spatula at u = 0 less that of a detached one.
    ///
    /// # Errors
    /// Points that are no curve, or no energy of adhesion.
    pub fn new(points: Vec<CurvePoint>, energy_at_rest: f64) -> Result<Self, PullCurveError> {
        if points.len() < 2 {
            return Err(PullCurveError::TooFew(points.len()));
        }
        let mut before = f64::NEG_INFINITY;
        for (point, &CurvePoint { displacement, force, slope }) in points.iter().enumerate() {
            if !(displacement > before && displacement.is_finite() && force.is_finite() && slope.is_finite()) {
                return Err(PullCurveError::Point { point, displacement, force, slope });
            }
            before = displacement;
        }
        let (first, last) = (points[0].displacement, before);
        if !(first <= 0.0 && last > 0.0) {
            return Err(PullCurveError::NoRest { first, last });
        }
        if !(energy_at_rest < 0.0 && energy_at_rest.is_finite()) {
            return Err(PullCurveError::Energy { energy: energy_at_rest });
        }
        let mut curve = Self { works: vec![0.0; points.len()], points, energy_at_rest };
        for k in 1..curve.points.len() {
            curve.works[k] = curve.works[k - 1] + curve.within(k - 1, curve.points[k].displacement).work;
        }
        let offset = curve.at(0.0).work;
        curve.works.iter_mut().for_each(|work| *work -= offset);
        Ok(curve)
    }

    /// Its points, with u ascending.
    pub fn points(&self) -> &[CurvePoint] {
        &self.points
    }

    /// E at u = 0 against being detached, aJ.
    pub fn energy_at_rest(&self) -> f64 {
        self.energy_at_rest
    }

    /// Where the spatula snaps off: u of the last point, nm.
    pub fn snap_off(&self) -> f64 {
        self.points[self.points.len() - 1].displacement
    }

    /// P (nN) and dP/du (nN/nm) at u (nm).
    pub fn force(&self, displacement: f64) -> (f64, f64) {
        let Pulled { force, slope, .. } = self.at(displacement);
        (force, slope)
    }

    /// E at u (nm) against being detached, aJ.
    pub fn energy(&self, displacement: f64) -> f64 {
        self.energy_at_rest + self.at(displacement).work
    }

    fn at(&self, u: f64) -> Pulled {
        let last = self.points.len() - 1;
        // and what is no number stays none
        if u.is_nan() || u < self.points[0].displacement {
            return self.straight(0, u);
        }
        if u >= self.points[last].displacement {
            return self.straight(last, u);
        }
        let k = self.points.partition_point(|point| point.displacement <= u) - 1;
        let own = self.within(k, u);
        Pulled { work: self.works[k] + own.work, ..own }
    }

    /// On the straight line through an end point.
    fn straight(&self, k: usize, u: f64) -> Pulled {
        let CurvePoint { displacement, force, slope } = self.points[k];
        let ahead = u - displacement;
        let work = self.works[k] + ahead * (force + 0.5 * slope * ahead);
        Pulled { force: force + slope * ahead, slope, work }
    }

    /// On the cubic from point k to the next one, with the work from point k.
    fn within(&self, k: usize, u: f64) -> Pulled {
        let [a, b] = [self.points[k], self.points[k + 1]];
        let length = b.displacement - a.displacement;
        let t = (u - a.displacement) / length;
        let rise = b.force - a.force;
        let (c1, c2, c3) = (
            length * a.slope,
            3.0 * rise - length * (2.0 * a.slope + b.slope),
            length * (a.slope + b.slope) - 2.0 * rise,
        );
        Pulled {
            force: a.force + t * (c1 + t * (c2 + t * c3)),
            slope: (c1 + t * (2.0 * c2 + t * 3.0 * c3)) / length,
            work: length * t * (a.force + t * (c1 / 2.0 + t * (c2 / 3.0 + t * c3 / 4.0))),
        }
    }
}

/// How a tip is held along the ground while it adheres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sideways {
    /// It slides without friction.
    Free,
    /// By a spring of this stiffness, nN/nm, to the place where it began to adhere.
    Held(f64),
}

/// A tip that follows the curve of a normal pull, whatever its rotation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NormalPull {
    /// Of its spatula
    pub curve: PullCurve,
    /// Along the ground
    pub sideways: Sideways,
    /// u at which a detached tip adheres again, nm: it jumps into contact there.
    pub contact_height: f64,
}

impl TipLaw for NormalPull {
    fn response(&self, on: TipBranch, [x, y, z]: [f64; 3], _: Quaternion) -> EndResponse {
        let mut out = EndResponse::default();
        if !on.adheres() {
            return out;
        }
        let Pulled { force, slope, work } = self.curve.at(y);
        let k = match self.sideways {
            Sideways::Free => 0.0,
            Sideways::Held(k) => k,
        };
        out.energy = self.curve.energy_at_rest + work + 0.5 * k * (x * x + z * z);
        out.gradient = [k * x, force, k * z, 0.0, 0.0, 0.0];
        out.hessian[0][0] = k;
        out.hessian[1][1] = slope;
        out.hessian[2][2] = k;
        out
    }

    fn branch(&self, before: TipBranch, [_, y, _]: [f64; 3], _: Quaternion) -> TipBranch {
        let adheres = if before.adheres() { y < self.curve.snap_off() } else { y <= self.contact_height };
        match adheres {
            false => TipBranch::Detached,
            true if self.curve.at(y).slope < 0.0 && y > 0.0 => TipBranch::Detaching,
            true => TipBranch::Attached,
        }
    }
}
