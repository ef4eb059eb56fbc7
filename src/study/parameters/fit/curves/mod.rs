//! Measured curves, and those of the model.

pub(in crate::study) mod machine_curve;
pub(in crate::study) mod measured_curve;
pub(in crate::study) mod pulled_curve;
