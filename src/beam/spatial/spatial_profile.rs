//! The sections of a beam in space, from place to place.

use super::stiffness::SpatialStiffness;
use crate::number::Real;
use std::sync::Arc;

/// What a section is at one place.
#[derive(Clone, Copy, Debug)]
pub struct Station<T = f64> {
    /// C, as in [`SpatialStiffness`]
    pub stiffness: [[T; 6]; 6],
    /// K0: twist and curvatures of the stress-free beam in the axes of its directors, 1/nm
    pub rest_curvature: [T; 3],
    /// b along d2, nm
    pub width: T,
    /// h along d3, nm
    pub height: T,
}

/// What sections are along S.
#[derive(Clone)]
pub enum SpatialProfile {
    /// The same everywhere
    Uniform(Box<Station>),
    /// From place (nm) to place
    Varying(Arc<dyn Fn(f64) -> Station + Send + Sync>),
}

impl std::fmt::Debug for SpatialProfile {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Uniform(station) => f.debug_tuple("Uniform").field(station).finish(),
            Self::Varying(_) => f.write_str("Varying(..)"),
        }
    }
}

impl SpatialProfile {
    /// Of a straight beam that is the same everywhere; `width` and `height` matter where it adheres, nm.
    pub fn uniform(SpatialStiffness(stiffness): SpatialStiffness, width: f64, height: f64) -> Self {
        Self::Uniform(Box::new(Station { stiffness, rest_curvature: [0.0; 3], width, height }))
    }

    /// The section at one place, or at several side by side.
    #[inline(always)]
    pub fn at<T: Real>(&self, place: T) -> Station<T> {
        match self {
            Self::Uniform(station) => Station {
                stiffness: station.stiffness.map(|row| row.map(T::splat)),
                rest_curvature: station.rest_curvature.map(T::splat),
                width: T::splat(station.width),
                height: T::splat(station.height),
            },
            Self::Varying(at) => {
                let numbers = place.each(|place| at(place).numbers());
                let mut stiffness = [[T::splat(0.0); 6]; 6];
                for i in 0..6 {
                    stiffness[i].copy_from_slice(&numbers[6 * i..6 * i + 6]);
                }
                let rest_curvature = [numbers[36], numbers[37], numbers[38]];
                Station { stiffness, rest_curvature, width: numbers[39], height: numbers[40] }
            }
        }
    }
}

impl Station {
    fn numbers(&self) -> [f64; 41] {
        let mut numbers = [0.0; 41];
        for i in 0..6 {
            numbers[6 * i..6 * i + 6].copy_from_slice(&self.stiffness[i]);
        }
        numbers[36..39].copy_from_slice(&self.rest_curvature);
        (numbers[39], numbers[40]) = (self.width, self.height);
        numbers
    }
}
