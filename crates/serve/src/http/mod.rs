//! The server: who may ask, and what is answered.

pub(crate) mod connections;
pub(crate) mod origin;
pub(crate) mod routes;
pub(crate) mod server;
