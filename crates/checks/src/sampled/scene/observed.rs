//! Strips in a displacement-controlled test.

use super::Sampler;

impl Sampler {
    pub(super) fn tested_strip(&mut self) {
        self.usual_strip([(50.0, 1500.0), (3.0, 25.0), (0.1, 20.0)]);
        self.half_space();
        if self.pick(&["up", "angle"]) == "angle" {
            self.pull_between(20.0, 160.0);
        }
    }
}
