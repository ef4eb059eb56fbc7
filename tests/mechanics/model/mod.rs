//! Models as data: which can be computed, and how they are written.

mod check;
mod refused;
mod written;
