//! What the page may ask: its requests, how much of them, and what is refused.

pub(crate) mod limits;
pub(crate) mod refusal;
pub(crate) mod request;
