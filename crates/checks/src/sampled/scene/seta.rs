//! Setae: a shaft that forks into up to 64 tips.

use super::Sampler;

impl Sampler {
    pub(super) fn seta(&mut self) {
        self.line("[seta]");
        let forks = self.pick(&["1", "2", "3", "4", "5", "6"]);
        self.line(&format!("forks = {forks}"));
        self.quantity("shaft_diameter", (1.0, 6.0), "um");
        self.quantity("youngs_modulus", (0.5, 10.0), "GPa");
        self.quantity("height_scatter", (10.0, 300.0), "nm");
        self.line("[spatula]");
        self.half_space();
        let (angle, azimuth) = (self.uniform(30.0, 150.0), self.uniform(0.0, 90.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
    }
}
