//! The state of a beam or a seta in an equilibrium: fields along the beam, joints, branches and tips.

pub(super) mod along_beam;
pub(super) mod fields;
pub(super) mod seta_state;
