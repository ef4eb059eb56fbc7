//! The stress-free body: sections along an axis, which go from a rectangle to an ellipse.
//!
//! With S along the axis, ζ from -1 (the underside) to 1 through the thickness and t from 0 (the plane of symmetry) to 1 (the free edge),
//!
//!   X = axis(S) + n (h/2) ζ',  z = (b/2) t',  n = (-sin θ0, cos θ0),
//!   ζ' = ζ ((1-q) + q √(1 - t²/2)),  t' = t ((1-q) + q √(1 - ζ²/2)),
//!
//! the elliptical map of the square to the disc, blended by the roundness q. The axis starts half a height above the gap at rest, in the
//! direction θ0 = φ + atan(h'/2), which keeps the underside of a flat piece flat.

use crate::beam::varying::{BeamGeometry, SectionGeometry};
use crate::number::gauss::Rule;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// A body of varying outline, with its underside's beginning at this height.
#[derive(Clone, Debug)]
pub(super) struct SolidGeometry {
    outline: Arc<dyn BeamGeometry>,
    /// Height of the axis over the ground at S = 0, nm
    start: f64,
}

/// A point of the plane of symmetry's coordinates, and its derivative by S: those of x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct InPlane {
    /// nm
    pub place: [f64; 2],
    /// 1
    pub slope: [f64; 2],
}

/// z and its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AcrossPlane {
    /// z, nm
    pub place: f64,
    /// ∂z/∂S
    pub along: f64,
    /// ∂z/∂ζ, nm
    pub through: f64,
    /// ∂z/∂t, nm
    pub across: f64,
}

/// How much of the way of a square's coordinate is left where the other one is this, and its derivative.
fn rounded(other: f64) -> (f64, f64) {
    let root = (1.0 - 0.5 * other * other).sqrt();
    (root, -0.5 * other / root)
}

/// Points of the integral of the axis from station to station.
const AXIS_POINTS: NonZeroUsize = NonZeroUsize::new(16).expect("sixteen is not zero");

impl SolidGeometry {
    /// Of an outline, at rest at this gap over the ground, nm.
    pub(crate) fn new(outline: Arc<dyn BeamGeometry>, gap: f64) -> Self {
        let start = gap + 0.5 * outline.at(0.0).height[0];
        Self { outline, start }
    }

    /// θ0 of a section, rad.
    fn rotation(section: &SectionGeometry) -> f64 {
        (0.5 * section.height[1]).atan() + section.underside[0]
    }

    /// θ0 of the section at a place, rad.
    pub(crate) fn rotation_at(&self, place: f64) -> f64 {
        Self::rotation(&self.outline.at(place))
    }

    /// x and y of the axis at these places, which ascend from 0, nm.
    pub(crate) fn axis(&self, stations: &[f64]) -> Vec<[f64; 2]> {
        let rule = Rule::new(AXIS_POINTS);
        let mut at = [0.0, self.start];
        let mut axis = vec![at];
        for ends in stations.windows(2) {
            for (place, weight) in rule.over(ends[0], ends[1]) {
                let (sin, cos) = Self::rotation(&self.outline.at(place)).sin_cos();
                (at[0], at[1]) = (at[0] + weight * cos, at[1] + weight * sin);
            }
            axis.push(at);
        }
        axis
    }

    /// x and y of (ζ, t) at a place whose axis is there.
    pub(crate) fn in_plane(&self, place: f64, axis: [f64; 2], zeta: f64, t: f64) -> InPlane {
        let section = self.outline.at(place);
        let [_, roundness] = self.outline.slopes(place);
        let [height, slope, bend] = section.height;
        let (left, _) = rounded(t);
        let lateral = zeta * (1.0 + section.roundness * (left - 1.0));
        let off = 0.5 * height * lateral;
        let widened = 0.5 * slope * lateral + 0.5 * height * zeta * roundness * (left - 1.0);
        let turning = 0.5 * bend / (1.0 + 0.25 * slope * slope) + section.underside[1];
        let (sin, cos) = Self::rotation(&section).sin_cos();
        let stretched = 1.0 - turning * off;
        InPlane {
            place: [axis[0] - sin * off, axis[1] + cos * off],
            slope: [cos * stretched - sin * widened, sin * stretched + cos * widened],
        }
    }

    /// z of (ζ, t) at a place.
    pub(crate) fn across(&self, place: f64, zeta: f64, t: f64) -> AcrossPlane {
        let SectionGeometry { width, roundness, .. } = self.outline.at(place);
        let [narrowing, rounding] = self.outline.slopes(place);
        let (left, falling) = rounded(zeta);
        let share = 1.0 + roundness * (left - 1.0);
        AcrossPlane {
            place: 0.5 * width * t * share,
            along: 0.5 * t * (narrowing * share + width * rounding * (left - 1.0)),
            through: 0.5 * width * t * roundness * falling,
            across: 0.5 * width * share,
        }
    }
}

/// How much higher the underside is at these places, which ascend from 0, than at the first one, in the plane of symmetry, nm.
pub(crate) fn rise(outline: Arc<dyn BeamGeometry>, places: &[f64]) -> Vec<f64> {
    let geometry = SolidGeometry::new(outline, 0.0);
    let axis = geometry.axis(places);
    let heights = places.iter().zip(axis).map(|(&place, axis)| geometry.in_plane(place, axis, -1.0, 0.0).place[1]);
    let heights: Vec<f64> = heights.collect();
    heights.iter().map(|height| height - heights[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// Widens, thickens, gets round and turns, smoothly.
    #[derive(Clone, Debug)]
    struct Horn;

    impl BeamGeometry for Horn {
        fn length(&self) -> f64 {
            800.0
        }
        fn breaks(&self) -> Vec<f64> {
            Vec::new()
        }
        fn at(&self, place: f64) -> SectionGeometry {
            let (sin, cos) = (place / 200.0).sin_cos();
            SectionGeometry {
                width: 80.0 + 20.0 * sin,
                height: [20.0 - 6.0 * cos, 6.0 * sin / 200.0, 6.0 * cos / 200f64.powi(2)],
                roundness: 0.5 + 0.4 * sin,
                underside: [0.3 * sin, 0.3 * cos / 200.0],
            }
        }
    }

    /// (8 (f(d) - f(-d)) - (f(2d) - f(-2d)))/12d
    fn slope(of: impl Fn(f64) -> f64, d: f64) -> f64 {
        (8.0 * (of(d) - of(-d)) - (of(2.0 * d) - of(-2.0 * d))) / (12.0 * d)
    }

    #[test]
    fn derivatives_are_those_of_the_places() {
        let geometry = SolidGeometry::new(Arc::new(Horn), 0.25);
        for place in [13.0, 120.0, 255.0, 340.0, 700.0] {
            let d = 0.2;
            let around: Vec<f64> = (-2..=2).map(|k| place + d * f64::from(k)).collect();
            let stations: Vec<f64> = std::iter::once(0.0).chain(around.clone()).collect();
            let axis = geometry.axis(&stations);
            let axis_at = |s: f64| axis[1 + around.iter().position(|&at| at == s).unwrap()];
            for (zeta, t) in [(-1.0, 0.0), (-1.0, 0.7), (0.4, 0.9), (1.0, 0.3)] {
                let at = |s: f64| around[(s / d + 2.5) as usize];
                let own = geometry.in_plane(place, axis_at(at(0.0)), zeta, t);
                for i in 0..2 {
                    let found = slope(|s| geometry.in_plane(at(s), axis_at(at(s)), zeta, t).place[i], d);
                    assert_abs_diff_eq!(found, own.slope[i], epsilon = 1e-7);
                }
                let z = geometry.across(place, zeta, t);
                assert_abs_diff_eq!(slope(|s| geometry.across(place + s, zeta, t).place, d), z.along, epsilon = 1e-7);
                assert_abs_diff_eq!(
                    slope(|s| geometry.across(place, zeta + s, t).place, 1e-3),
                    z.through,
                    epsilon = 1e-8
                );
                assert_abs_diff_eq!(
                    slope(|s| geometry.across(place, zeta, t + s).place, 1e-3),
                    z.across,
                    epsilon = 1e-8
                );
            }
        }
    }
}
