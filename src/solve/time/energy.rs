//! Where the work goes that is done on a structure in motion.

/// Energies at one time, and what went in and out since the beginning, aJ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnergyBalance {
    /// Work of the grip since the beginning
    pub work: f64,
    /// Elastic energy, with that of springs in series with dashpots
    pub stored: f64,
    /// Energy of adhesion, negative
    pub adhesion: f64,
    /// Of the machine's spring
    pub spring: f64,
    /// Kinetic energy
    pub kinetic: f64,
    /// Dissipated by the material since the beginning
    pub dissipated: f64,
}

impl EnergyBalance {
    /// What is in the structure: stored, of adhesion, of the spring and kinetic.
    pub fn total(&self) -> f64 {
        self.stored + self.adhesion + self.spring + self.kinetic
    }

    /// Work less what the structure has more than at the `start`, less what it dissipated: zero, but for the errors of the steps.
    pub fn defect(&self, start: &Self) -> f64 {
        self.work - (self.total() - start.total()) - self.dissipated
    }
}
