//! The solver, held against systems that are no beams.
mod dense_truss;
mod linear;
mod sensitivity;
mod truss;
mod waypoints;
