//! Strips and spatulae in the plane.

use super::Sampler;
use crate::sampled::kind::SampleKind;

/// The laws besides that of the half space's body force.
const LAWS: [&str; 5] = ["surface-traction", "bilinear", "exponential", "dugdale", "trapezoidal"];
const LINE_LOADS: [&str; 3] = ["full", "force-only", "axis-gap"];

impl Sampler {
    pub(super) fn strip(&mut self, kind: SampleKind) {
        self.line("[strip]");
        self.quantity("length", (20.0, 2e4), "nm");
        self.quantity("height", (2.0, 50.0), "nm");
        self.quantity("youngs_modulus", (0.01, 100.0), "GPa");
        let factor = self.log_uniform((1e-4, 1e4));
        self.line(&format!("bending_stiffness_factor = {factor:.6e}"));
        self.line("[adhesion]");
        self.quantity("hamaker_constant", (1e-21, 1e-18), "J");
        self.quantity("equilibrium_distance", (0.1, 2.0), "nm");
        let far_face = self.pick(&["true", "false"]);
        self.line(&format!("far_face = {far_face}"));
        if kind == SampleKind::Law {
            let law = self.pick(&LAWS);
            let load = self.pick(&LINE_LOADS);
            self.line(&format!("law = \"{law}\"\nline_load = \"{load}\""));
        }
        self.grip();
        if kind == SampleKind::Angle {
            let angle = self.uniform(10.0, 170.0);
            self.line(&format!("[drive]\nangle = \"{angle:.3} deg\""));
        }
    }

    pub(super) fn spatula(&mut self) {
        self.line("[spatula]");
        self.quantity("pad_length", (60.0, 600.0), "nm");
        self.quantity("pad_thickness", (5.0, 20.0), "nm");
        let angle = self.uniform(5.0, 90.0);
        let rounding = self.pick(&["0", "30"]);
        self.line(&format!("shaft_angle = \"{angle:.3} deg\"\ntip_rounding_length = \"{rounding} nm\""));
        self.quantity("youngs_modulus", (0.1, 20.0), "GPa");
        self.line("[adhesion]");
        self.quantity("hamaker_constant", (1e-20, 4e-19), "J");
        self.quantity("equilibrium_distance", (0.2, 0.8), "nm");
        let far_face = self.pick(&["true", "false"]);
        self.line(&format!("far_face = {far_face}"));
        self.grip();
    }
}
