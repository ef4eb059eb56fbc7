//! What a shape says at one opening.

/// At the opening t = δ/δ_r: ∫ s from t on, s, and its slope.
pub(in crate::adhesion) type At = [f64; 3];
