//! What every body is asked.

use crate::beam::section::Material;
use crate::beam::varying::BeamGeometry;
use std::sync::Arc;

/// What a model asks of its body. A body is a file here with a type that is one, and a line of each list of [`crate::model::Body`].
pub trait Geometry: BeamGeometry {
    /// The table of a scene that gives it.
    fn name(&self) -> &'static str;

    /// What it is made of.
    fn material(&self) -> Material;

    /// Its outline, to be kept by a beam.
    fn shared(&self) -> Arc<dyn BeamGeometry>;

    /// Its thickness over the height h of its sections: 1, but of layers, whose h is twice the distance of the adhering face from the axis.
    fn thickness_over_height(&self) -> f64 {
        1.0
    }

    /// Whether it is straight in its stress-free configuration, and its section the same everywhere.
    fn is_uniform(&self) -> bool {
        false
    }
}
