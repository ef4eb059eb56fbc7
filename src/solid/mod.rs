//! Solids that adhere: a spatula in space as a [`crate::solve::System`].

pub(crate) mod front;
pub mod spatula;
