//! Strips that are pulled at a rate.

use super::Sampler;

impl Sampler {
    pub(super) fn strip_at_a_rate(&mut self) {
        self.usual_strip([(50.0, 500.0), (4.0, 20.0), (0.3, 10.0)]);
        self.half_space();
        self.line("[time]\ndensity = \"1300 kg/m3\"");
        self.quantity("rate", (1e-6, 1.0), "m/s");
        if self.pick(&["elastic", "kelvin-voigt"]) == "kelvin-voigt" {
            self.line("material = \"kelvin-voigt\"");
            self.quantity("retardation_time", (1e-9, 1e-3), "s");
        }
    }
}
