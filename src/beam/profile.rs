//! What a density asks of a beam at one place: stiffness, outline, and how it lies when free of stress.

use super::Section;
use crate::number::Real;

/// A beam at one place, or at four side by side.
#[derive(Clone, Copy, Debug)]
pub struct Station<T> {
    pub section: Section<T>,
    /// Adhering width b, nm
    pub width: T,
    /// Height h of the section, nm
    pub height: T,
    /// h'/2: how much faster the axis rises than the gap below the underside
    pub rise: T,
    /// κ0, the curvature of the axis that is free of stress, 1/nm
    pub curvature: T,
}

/// A beam from place to place.
pub trait Profile: Send + Sync {
    /// The beam at S, nm.
    fn at<T: Real>(&self, place: T) -> Station<T>;
}

/// A straight beam that is the same everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Uniform {
    pub section: Section,
    /// Adhering width b, nm
    pub width: f64,
    /// nm
    pub height: f64,
}

impl Profile for Uniform {
    #[inline(always)]
    fn at<T: Real>(&self, _: T) -> Station<T> {
        Station {
            section: self.section.splat(),
            width: T::splat(self.width),
            height: T::splat(self.height),
            rise: T::splat(0.0),
            curvature: T::splat(0.0),
        }
    }
}
