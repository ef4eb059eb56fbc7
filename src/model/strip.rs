//! A uniform strip on a flat half space, lifted at its right end.

use crate::adhesion::LineLoad;

/// Geometry and material of a uniform strip of rectangular section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// nm
    pub length: f64,
    /// nm
    pub height: f64,
    /// nm
    pub width: f64,
    /// GPa = nN/nm²
    pub youngs_modulus: f64,
    pub poissons_ratio: f64,
    pub shear_correction: f64,
    /// Multiplies EI alone.
    pub bending_stiffness_factor: f64,
}

/// The adhesion between the strip and the half space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adhesion {
    /// nN·nm = aJ
    pub hamaker_constant: f64,
    /// r0 of the pair potential, nm
    pub equilibrium_distance: f64,
    pub line_load: LineLoad,
    /// Whether the top face counts (the r2 terms).
    pub far_face: bool,
}

/// What the grip does with one degree of freedom of the right end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    Free,
    Fixed,
}

/// The grip at S = L. Its vertical displacement is what is driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grip {
    pub rotation: Hold,
    pub horizontal: Hold,
}

/// A strip, its adhesion and its grip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripModel {
    pub strip: Strip,
    pub adhesion: Adhesion,
    pub grip: Grip,
}
