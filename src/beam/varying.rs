//! A beam from place to place: the same everywhere, or of a section and a stress-free direction that vary along it.
//!
//! In the stress-free configuration its underside lies in the direction φ(S), and the axis half a height above it, in the direction
//! θ0 = φ + atan(h'/2). So a beam of varying height with φ = 0 lies flat on a flat substrate.

use super::material::stretch_law::StretchLaw;
use super::section::{Material, Section, SectionAt};
use crate::number::Real;
use std::fmt::Debug;
use std::sync::Arc;

/// The outline of a beam at one place, with derivatives along S.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionGeometry {
    /// b, nm
    pub width: f64,
    /// h, h' and h'': nm, 1, 1/nm
    pub height: [f64; 3],
    /// From 0, a rectangle, to 1, an ellipse: how round the section is
    pub roundness: f64,
    /// φ and φ', the direction of the underside: rad, rad/nm
    pub underside: [f64; 2],
}

/// Step of a difference over the length of a beam.
const DIFFERENCE: f64 = 1e-6;

/// The outline of a beam from S = 0 to its length.
pub trait BeamGeometry: Send + Sync + Debug {
    /// L, nm
    fn length(&self) -> f64;
    /// Places between 0 and L where a formula ends and the next begins, ascending, nm. Elements end there. The height and the
    /// direction of the underside are continuous, with the slope of the height.
    fn breaks(&self) -> Vec<f64>;
    /// S beyond which nothing adheres, as behind the tip of a crack, nm.
    fn adhering_length(&self) -> f64 {
        self.length()
    }
    /// The outline at a place, nm.
    fn at(&self, place: f64) -> SectionGeometry;
    /// b' and q' at a place that is no break, 1 and 1/nm: what a solid of this outline needs beside [`BeamGeometry::at`]. By central differences
    /// where a body has no formula.
    fn slopes(&self, place: f64) -> [f64; 2] {
        let step = DIFFERENCE * self.length();
        let [before, after] = [place - step, place + step].map(|place| self.at(place));
        [after.width - before.width, after.roundness - before.roundness].map(|change| change / (2.0 * step))
    }
    /// How much of this width adheres at a place, nm.
    fn adhering(&self, place: f64, width: f64) -> f64 {
        if place <= self.adhering_length() { width } else { 0.0 }
    }
}

/// A beam of varying outline, of one material.
#[derive(Clone, Debug)]
pub struct Varying {
    contour: Arc<dyn BeamGeometry>,
    material: Material,
}

impl Varying {
    /// Of a contour and a material.
    pub fn new(contour: Arc<dyn BeamGeometry>, material: Material) -> Self {
        Self { contour, material }
    }

    /// Its outline.
    pub(crate) fn contour(&self) -> &dyn BeamGeometry {
        &*self.contour
    }

    /// What it is made of.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// θ0, the direction of the stress-free axis, rad.
    pub fn rotation(&self, place: f64) -> f64 {
        let outline = self.contour.at(place);
        (0.5 * outline.height[1]).atan() + outline.underside[0]
    }

    /// The beam at S, nm.
    #[inline(always)]
    pub fn at<T: Real>(&self, place: T) -> SectionAt<T> {
        let [axial, shear, bending, along, across, width, height, rise, curvature] = place.each(|place| {
            let SectionAt { section, compliance: [along, across], width, height, rise, curvature, .. } =
                self.station(place);
            [section.axial, section.shear, section.bending, along, across, width, height, rise, curvature]
        });
        let (section, compliance) = (Section { axial, shear, bending }, [along, across]);
        SectionAt { section, compliance, width, height, rise, curvature, stretch: self.material.stretch }
    }

    fn station(&self, place: f64) -> SectionAt<f64> {
        let station = self.section_of(&self.contour.at(place));
        SectionAt { width: self.contour.adhering(place, station.width), ..station }
    }

    /// The beam where its outline is this one.
    pub(crate) fn section_of(&self, outline: &SectionGeometry) -> SectionAt<f64> {
        let SectionGeometry { width, height: [height, slope, bend], roundness, underside } = *outline;
        let rise = 0.5 * slope;
        let section = self.material.section(width, height, roundness);
        SectionAt {
            section,
            compliance: [section.axial.recip(), section.shear.recip()],
            width,
            height,
            rise,
            curvature: 0.5 * bend / (1.0 + rise * rise) + underside[1],
            stretch: self.material.stretch,
        }
    }
}

/// A beam from place to place: one type, so that the elements are compiled once.
#[derive(Clone, Debug)]
pub enum Profile {
    /// Straight, and the same everywhere.
    Uniform(SectionAt<f64>),
    /// Of varying outline.
    Varying(Varying),
}

impl Profile {
    /// A straight beam of this section, adhering width and height, nm, in which N = EA Γ1.
    pub fn uniform(section: Section, width: f64, height: f64) -> Self {
        Self::stretched(section, StretchLaw::Linear, width, height)
    }

    /// The same of another law of its stretch.
    pub(crate) fn stretched(section: Section, stretch: StretchLaw, width: f64, height: f64) -> Self {
        let compliance = [section.axial.recip(), section.shear.recip()];
        Self::Uniform(SectionAt { section, compliance, width, height, rise: 0.0, curvature: 0.0, stretch })
    }

    /// The beam at S, nm.
    #[inline(always)]
    pub fn at<T: Real>(&self, place: T) -> SectionAt<T> {
        match self {
            Self::Uniform(station) => SectionAt {
                section: station.section.splat(),
                compliance: station.compliance.map(T::splat),
                width: T::splat(station.width),
                height: T::splat(station.height),
                rise: T::splat(0.0),
                curvature: T::splat(0.0),
                stretch: station.stretch,
            },
            Self::Varying(beam) => beam.at(place),
        }
    }
}
