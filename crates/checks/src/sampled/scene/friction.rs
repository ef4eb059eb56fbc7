//! Strips that friction holds along the substrate.

use super::Sampler;

impl Sampler {
    pub(super) fn strip_with_friction(&mut self) {
        self.usual_strip([(50.0, 800.0), (4.0, 20.0), (0.3, 10.0)]);
        self.half_space();
        self.line("[friction]");
        self.quantity("strength", (1.0, 100.0), "MPa");
        self.pull_between(20.0, 150.0);
    }
}
