//! What the tables of a scene ask of the library, and whether it can be computed: they are read by name, and so know every key.

pub(crate) mod fit;
pub(crate) mod optimise;
pub(crate) mod parameters;
pub(crate) mod uncertainty;
mod whole;
