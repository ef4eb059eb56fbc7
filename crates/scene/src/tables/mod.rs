//! The tables of a scene beside its body: each knows its keys, what goes together in it, and what it makes of them.

pub(crate) mod bounds;
pub(crate) mod fit;
pub(crate) mod optimisation;
pub(crate) mod rate;
pub(crate) mod seta;
pub(crate) mod tips;
pub(crate) mod uncertainty;
