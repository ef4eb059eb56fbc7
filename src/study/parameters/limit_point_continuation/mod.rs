//! A limit point followed in a parameter of the model, and where two of them meet.
mod confirmation;
mod continuation;
pub(in crate::study) mod cusp;
pub(in crate::study) mod result;
mod strand;
pub(in crate::study) mod sweep;
mod values;
