//! Strips on wavy ground.

use super::Sampler;

impl Sampler {
    pub(super) fn strip_on_waves(&mut self) {
        self.usual_strip([(50.0, 1000.0), (3.0, 20.0), (0.2, 10.0)]);
        self.half_space();
        self.line("[substrate]\nshape = \"sinusoid\"");
        self.quantity("height", (0.5, 15.0), "nm");
        self.quantity("wavelength", (40.0, 300.0), "nm");
        let rotation = self.pick(&["free", "fixed"]);
        self.line(&format!("[grip]\nrotation = \"{rotation}\""));
        if self.pick(&["up", "angle"]) == "angle" {
            self.pull_between(30.0, 150.0);
        }
    }
}
