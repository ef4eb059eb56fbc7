//! Adhesive tapes and films.

use super::Sampler;

impl Sampler {
    /// With a shear strength in this range, over the strength, if there is one.
    pub(super) fn tape(&mut self, shear_over_strength: Option<(f64, f64)>) {
        let height = self.log_uniform((5.0, 500.0));
        let length = height * self.log_uniform((20.0, 500.0));
        self.line(&format!("[strip]\nheight = \"{height:.6e} um\"\nlength = \"{length:.6e} um\""));
        self.quantity("width", (1.0, 30.0), "mm");
        self.quantity("youngs_modulus", (0.1, 5000.0), "MPa");
        let ratio = self.pick(&["0.3", "0.4", "0.49"]);
        self.line(&format!("poissons_ratio = {ratio}\n[adhesion]"));
        let law = self.pick(&["bilinear", "exponential", "dugdale", "trapezoidal"]);
        self.line(&format!("law = \"{law}\""));
        self.quantity("work", (0.02, 300.0), "J/m2");
        let strength = self.log_uniform((0.02, 10.0));
        self.line(&format!("strength = \"{strength:.6e} MPa\""));
        if let Some(range) = shear_over_strength {
            let shear = strength * self.log_uniform(range);
            self.line(&format!("shear_strength = \"{shear:.6e} MPa\""));
        }
        self.quantity("equilibrium_distance", (0.5, 20.0), "nm");
        let rotation = self.pick(&["free", "fixed"]);
        self.line(&format!("[grip]\nrotation = \"{rotation}\""));
        if self.pick(&["up", "angle"]) == "angle" {
            self.pull_between(20.0, 160.0);
        }
    }
}
