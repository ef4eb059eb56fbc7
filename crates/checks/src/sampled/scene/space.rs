//! Strips in space.

use super::Sampler;

impl Sampler {
    pub(super) fn strip_in_space(&mut self) {
        self.line("space = true\n[strip]");
        self.quantity("length", (50.0, 200.0), "nm");
        let height = self.log_uniform((4.0, 14.0));
        let width = height * self.log_uniform((1.0, 8.0));
        self.line(&format!("height = \"{height:.6e} nm\"\nwidth = \"{width:.6e} nm\""));
        self.quantity("youngs_modulus", (0.5, 20.0), "GPa");
        let section = self.pick(&["rectangle", "rectangle", "rectangle", "ellipse"]);
        self.line(&format!("section = \"{section}\"\n[adhesion]"));
        self.quantity("hamaker_constant", (2e-20, 4e-19), "J");
        self.quantity("equilibrium_distance", (0.2, 0.8), "nm");
        self.grip();
        for hold in ["roll", "yaw", "lateral"] {
            let held = self.pick(&["free", "free", "free", "fixed"]);
            self.line(&format!("{hold} = \"{held}\""));
        }
        let (angle, azimuth) = (self.uniform(15.0, 90.0), self.uniform(-170.0, 170.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
    }

    /// Of widths that are no multiple of the height, in a grip that holds nothing, pulled flatter and to one side.
    pub(super) fn oblique_strip(&mut self) {
        self.line("space = true\n[strip]");
        self.quantity("length", (60.0, 400.0), "nm");
        self.quantity("height", (4.0, 15.0), "nm");
        self.quantity("width", (5.0, 60.0), "nm");
        self.quantity("youngs_modulus", (0.5, 5.0), "GPa");
        self.half_space();
        self.line("[grip]\nhorizontal = \"free\"");
        let (angle, azimuth) = (self.uniform(20.0, 90.0), self.uniform(5.0, 175.0));
        self.line(&format!("[drive]\nangle = \"{angle:.3} deg\"\nazimuth = \"{azimuth:.3} deg\""));
    }
}
