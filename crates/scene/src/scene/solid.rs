//! A solid, as data: the table `solid`.

use peelkit::model::SolidSettings;
use peelkit::solid::{Grading, Plane, SolidContact, SolidElement, SolidGrip, SolidMaterial};

/// How the body of a scene is computed as a solid.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidTable {
    /// The element
    pub element: SolidElement,
    /// Whether bilinear elements off the contact row have incompatible modes
    pub modes: bool,
    /// Length of an element, nm; none: that of the process zone
    pub along: Option<f64>,
    /// Rows of elements through the thickness
    pub through: usize,
    /// Elements across the half width of a spatula or a profile
    pub across: usize,
    /// What holds across the plane
    pub plane: Plane,
    /// The elastic energy
    pub material: SolidMaterial,
    /// What the ground acts on
    pub contact: SolidContact,
    /// What the grip does with the end face
    pub grip: SolidGrip,
    /// Where elements are finer
    pub grading: Grading,
}

impl Default for SolidTable {
    fn default() -> Self {
        let SolidSettings { element, modes, through, across, plane, material, contact, grip, grading, .. } =
            SolidSettings::default();
        Self { element, modes, along: None, through, across, plane, material, contact, grip, grading }
    }
}
