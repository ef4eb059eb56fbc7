//! The server: who may ask, what, how much, and what is refused.

pub(crate) mod connections;
pub(crate) mod limits;
pub(crate) mod origin;
pub(crate) mod refusal;
pub(crate) mod request;
pub(crate) mod routes;
pub(crate) mod server;
