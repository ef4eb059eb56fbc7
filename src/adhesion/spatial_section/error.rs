//! Why there is no energy of a section in space.

use thiserror::Error;

/// What of a section or of its law has no energy per length of a beam in space.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SpatialSectionError {
    /// The beam in space takes its forces and moments from one energy.
    #[error(
        "a beam in space requires an adhesion law with a potential; {law} has none. Use the full line load of the \
         body force, a cohesive law, or the load \"axis-gap\""
    )]
    NoPotential {
        /// What has none
        law: String,
    },
    /// A tree of beams takes the forces of its branches from one energy.
    #[error(
        "slip takes a work of its own there, so that the load has no potential, and a tree of beams requires one; remove \
         adhesion.shear_work and adhesion.mixing_exponent"
    )]
    TwoWorks,
    /// What a law does is said of the faces of a rectangle.
    #[error(
        "an elliptical section is computed for the body force with the upper surface and the full line load; {law} \
         requires a rectangle"
    )]
    RequiresRectangle {
        /// What requires it
        law: String,
    },
    /// A width or a height that is no length.
    #[error("the {what} of a section in space is {value} nm; it must be above zero and finite")]
    NoLength {
        /// "width" or "height"
        what: &'static str,
        /// What was given, nm
        value: f64,
    },
}
