//! What a fit is reported with besides its result: its scene, its file and how long it took.

use peelkit::study::{Fit, MeasuredCurve};
use peelkit_scene::{Key, Scene, find_key};

/// A fit with where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct FitReport<'a> {
    /// The scene with the parameters at which the search began
    pub scene: &'a Scene,
    /// The file of the measured curve, as it was named
    pub file: &'a str,
    /// What was read from it
    pub measured: &'a MeasuredCurve,
    /// What was found
    pub fit: &'a Fit,
    /// Seconds that it took
    pub solve_s: f64,
}

impl FitReport<'_> {
    /// The scene with the parameters that were found.
    pub fn fitted_scene(&self) -> Scene {
        let numbers = self.fit.parameters.iter().map(|parameter| (parameter.key.as_str(), parameter.value));
        self.scene.with_numbers(numbers)
    }

    /// The unit of a parameter; empty where it has none.
    pub fn unit(&self, index: usize) -> &'static str {
        find_key(&self.fit.parameters[index].key).map_or("", Key::unit)
    }
}
