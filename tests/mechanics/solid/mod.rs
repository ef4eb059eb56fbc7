//! Solids that adhere.

mod spatula;
