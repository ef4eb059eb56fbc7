//! The shape of the substrate: where it is nearest, eq. (8), and how it lies there.
//!
//! A substrate is a curve in the plane of the beam, with the solid below it. Its crests are at y = 0, but for a measured
//! profile, whose heights are its own. At the nearest point of (x, y), with t = (cos φ, sin φ) along the curve, the normal
//! n = (-sin φ, cos φ) away from the solid, κ = dφ/dσ (σ the length along the curve; positive in a valley), κ' = dκ/dσ and
//! μ = κ/(1 - κd):
//!
//!   ∇d = n,   ∇φ = μ t,   ∇∇d = -μ t⊗t,   ∇∇φ = κ'/(1 - κd)³ t⊗t + μ² (t⊗n + n⊗t).
//!
//! They follow from p = c(σ) + d n, whose change is dp = t (1 - κd) dσ + n dd, and dt = n dφ, dn = -t dφ.
//!
//! Several points of the curve may be near, and the nearest counts. Where two are equally near (above a valley, farther from
//! it than its centre of curvature) the distance is continuous and its gradient is not. What that costs is stated in
//! [`ClosestPoint::second_distance`].
//!
//! A shape is a file here with a type that is a [`Surface`], and a line of the list below.

mod closest;
mod flat;
pub(super) mod self_affine;
pub(crate) mod surface;
use super::levels::curved::BodyShape;
use flat::Flat;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use surface::{ClosestPoint, Misfit, Surface};

/// Makes the list of substrates from lines `/// what it is` and `Name(type) = file`. A file has a [`Surface`] and `NAMED`: the names by which a
/// scene takes it, each with what makes one of which no number is given yet.
macro_rules! substrates {
    ($($(#[$what:meta])* $shape:ident($surface:ty) = $file:ident,)*) => {
        $(
            pub(crate) mod $file;
        )*

        /// What a beam lies on.
        #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum Substrate {
            /// y = 0.
            #[default]
            Flat,
            $($(#[$what])* $shape($surface),)*
        }

        impl Substrate {
            /// What it is asked for.
            fn surface(&self) -> &dyn Surface {
                match self {
                    Self::Flat => &Flat,
                    $(Self::$shape(surface) => surface,)*
                }
            }

            /// The number that a scene gives by this key, if it has one.
            pub fn number(&mut self, key: &str) -> Option<&mut f64> {
                match self {
                    Self::Flat => None,
                    $(Self::$shape(surface) => surface.number(key),)*
                }
            }

            /// What a scene may name, each with a substrate of which no number is given yet: NaN, or its default.
            pub fn all() -> Vec<(&'static str, Self)> {
                let mut all = vec![(Flat.name(), Self::Flat)];
                $(all.extend($file::NAMED.iter().map(|&(name, new)| (name, Self::$shape(new().into()))));)*
                all
            }
        }
    };
}

substrates! {
    /// A sphere or a cylinder across the beam: for a beam in their plane of symmetry both are a circle.
    Round(round::Round) = round,
    /// y = H/2 (cos(2π (x - x0)/λ) - 1).
    Sinusoid(sinusoid::Sinusoid) = sinusoid,
    /// Heights by a table.
    Profile(Arc<heights::Heights>) = heights,
    /// y = -(x - x0)²/(2R).
    Ridge(ridge::Ridge) = ridge,
}

impl Substrate {
    /// Whether it is plane and level.
    pub fn is_flat(&self) -> bool {
        matches!(self, Self::Flat)
    }

    /// What a scene calls it.
    pub fn name(&self) -> &'static str {
        self.surface().name()
    }

    /// The keys of a scene that belong to it, besides that of the shape itself.
    pub fn keys(&self) -> &'static [&'static str] {
        self.surface().keys()
    }

    /// Makes it one of the shape that a scene calls so; where both shapes have the same keys, what was given stays. Whether there is one.
    pub fn take_shape(&mut self, name: &str) -> bool {
        let Some((_, mut shape)) = Self::all().into_iter().find(|(known, _)| *known == name) else { return false };
        if shape.name() == self.name() {
            return true;
        }
        if shape.keys() == self.keys() {
            for key in self.keys() {
                if let (Some(given), Some(place)) = (self.number(key).copied(), shape.number(key)) {
                    *place = given;
                }
            }
        }
        *self = shape;
        true
    }

    /// The nearest point of (x, y), nm. NaN where a coordinate is.
    #[inline(never)]
    pub fn project(&self, x: f64, y: f64) -> ClosestPoint {
        self.surface().project(x, y)
    }

    /// About how far (x, y) is above the substrate, nm: along y, or from the centre of a circle.
    pub(crate) fn clearance(&self, x: f64, y: f64) -> f64 {
        self.surface().clearance(x, y)
    }

    /// The highest point between two places, nm.
    pub fn top(&self, from: f64, to: f64) -> f64 {
        self.surface().top(from, to)
    }

    /// How high it may rise above where a beam lies on it, nm: from valley to crest; zero where it has no valley.
    pub(crate) fn peak_to_valley(&self) -> f64 {
        self.surface().peak_to_valley()
    }

    /// The length in which it changes, nm: no element may be much longer. Infinite where it is the same everywhere.
    pub(crate) fn feature_length(&self) -> f64 {
        self.surface().feature_length()
    }

    /// The convex body that a crest is like.
    pub(crate) fn crest(&self) -> BodyShape {
        self.surface().crest()
    }

    /// What of its numbers do not fit each other.
    pub(crate) fn misfit(&self) -> Option<Misfit> {
        self.surface().misfit()
    }
}

// -- The line that keeps a distance to the ground --

impl Substrate {
    /// The place at this distance above x, nm: the y that is `distance` from the substrate.
    pub fn above(&self, x: f64, distance: f64) -> f64 {
        let mut y = self.top(x - distance, x + distance) + distance;
        // the distance is concave along a line on a convex body and at most as steep as the line: the steps stay above
        for _ in 0..MOST_LEVELLING {
            let off = self.project(x, y).distance - distance;
            y -= off;
            if off.abs() <= LEVELLED * distance {
                break;
            }
        }
        y
    }

    /// The line that keeps this distance to the substrate, from above x = 0 on: x, y and φ at each of the ascending lengths
    /// `places` along it, nm. Valleys narrower than the distance are passed over, as by a ball that rolls.
    pub fn along(&self, distance: f64, places: &[f64]) -> Vec<[f64; 3]> {
        let (mut x, mut y, mut here) = (0.0, self.above(0.0, distance), 0.0);
        let step = (0.02 * distance).min(0.005 * self.feature_length());
        let line = places.iter().map(|&place| {
            let steps = ((place - here) / step).ceil().clamp(0.0, MOST_A_PLACE);
            for _ in 0..steps as usize {
                let length = (place - here) / steps;
                let from = self.project(x, y);
                // the middle of the step, its direction, and back to the distance
                let middle = self.project(x + 0.5 * length * from.cos, y + 0.5 * length * from.sin);
                (x, y) = (x + length * middle.cos, y + length * middle.sin);
                let to = self.project(x, y);
                (x, y) = (x + (to.distance - distance) * to.sin, y - (to.distance - distance) * to.cos);
            }
            here = place;
            let foot = self.project(x, y);
            [x, y, foot.sin.atan2(foot.cos)]
        });
        line.collect()
    }
}

/// Steps that lower a point to a distance, and how near they come, relative.
const MOST_LEVELLING: usize = 200;
const LEVELLED: f64 = 1e-13;

/// Steps along a line from place to place.
const MOST_A_PLACE: f64 = 1e3;

#[cfg(test)]
mod tests;
